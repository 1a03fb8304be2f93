/* Messages and the end of the program.  What was printed and not yet written when a program dies is
 * dropped: a failure leaves nothing on standard output. */
#include "tools/cli/cli.h"
#include "tools/cli/cli_private.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const char *cli_name = "veksel";
int cli_failure = EXIT_FAILURE;

/* One line, whatever a path or a value holds. */
VX_PRINTF(1, 0)
static void say(const char *format, va_list ap)
{
    char text[1024];

    vsnprintf(text, sizeof text, format, ap);
    for (char *p = text; *p; p++)
        if (iscntrl((unsigned char)*p))
            *p = '?';
    fprintf(stderr, "%s: %s\n", cli_name, text);
}

void cli_die(const char *format, ...)
{
    va_list ap;

    va_start(ap, format);
    say(format, ap);
    va_end(ap);
    cli_remove_outputs();
    _exit(cli_failure);
}

void cli_misuse(const char *format, ...)
{
    va_list ap;

    va_start(ap, format);
    say(format, ap);
    va_end(ap);
    cli_remove_outputs();
    _exit(2);
}

void cli_note(const char *format, ...)
{
    va_list ap;

    va_start(ap, format);
    say(format, ap);
    va_end(ap);
}

void cli_check(const char *name, const char *why)
{
    size_t length = strlen(name);

    if (why && strncmp(why, name, length) == 0 && why[length] == ':')      /* a reader of text that names file and line itself */
        cli_die("%s", why);
    if (why)
        cli_die("%s: %s", name, why);
}

void cli_open(struct vxf *f, const char *path, const char *kind)
{
    const char *name = strcmp(path, "-") == 0 ? "standard input" : path;

    cli_check(name, vxf_open(f, path));
    if (kind)
        cli_check(name, vxf_is(f, kind));
}

int cli_end(void)
{
    errno = 0;
    if (ferror(stdout) || fclose(stdout) != 0)
        cli_die("standard output: %s", errno ? strerror(errno) : "write error");
    cli_forget();
    return EXIT_SUCCESS;
}
