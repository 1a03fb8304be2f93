/* The command line as the CMD line of a header: quoted as a shell would need it, without where the output went. */
#include "tools/cli/cli.h"
#include "tools/cli/cli_private.h"

#include <stdlib.h>
#include <string.h>

static char *command;

static char *add_char(char *to, char c)
{
    *to = c;
    return to + 1;
}

/* Plain words stay as they are; others stand in single quotes. */
static char *add_word(char *to, const char *word)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=+:,@%";
    size_t n = strlen(word);

    if (n && strspn(word, plain) == n) {
        memcpy(to, word, n);
        return to + n;
    }
    to = add_char(to, '\'');
    for (; *word; word++) {
        if (*word == '\'') {
            memcpy(to, "'\\'", 3);
            to += 3;
        }
        to = add_char(to, *word);
    }
    return add_char(to, '\'');
}

void cli_remember(int argc, char **argv)
{
    size_t room = 16 + strlen(cli_name);
    char *to;

    for (int i = 1; i < argc; i++)
        room += 4 * strlen(argv[i]) + 3;
    cli_forget();
    to = command = calloc(room, 1);
    if (!command)
        cli_die(REASON_MEMORY);
    to = add_word(to, cli_name);
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "-o") == 0)
            i++;
        else if (strncmp(argv[i], "-o", 2) != 0)
            to = add_word(add_char(to, ' '), argv[i]);
    }
}

const char *cli_command(void)
{
    return command;
}

void cli_forget(void)
{
    free(command);
    command = NULL;
}
