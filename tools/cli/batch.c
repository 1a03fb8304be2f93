#include "tools/cli/batch.h"
#include "formats/lines.h"
#include "tools/cli/cli.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { JOBS_MOST = 64 };

/* Children that run, for the handler; 0 where none. */
static volatile sig_atomic_t children[JOBS_MOST];

/* ---- reading ---- */

static const char *take_words(struct batch_line *line)
{
    static const char blanks[] = " \t\r\n";
    const size_t most = strlen(line->text) / 2 + 1;
    char *rest = NULL;

    if (!(line->word = calloc(most, sizeof *line->word)))
        return REASON_MEMORY;
    for (char *word = strtok_r(line->text, blanks, &rest); word && *word != '#'; word = strtok_r(NULL, blanks, &rest)) {
        if (line->n && strcmp(line->word[line->n - 1], "-o") == 0)
            line->out = word;
        line->word[line->n++] = word;
    }
    return line->n && !line->out ? "wants an output of its own, -o FILE" : NULL;
}

static const char *add_line(void *to, long number, char *text)
{
    struct batch *b = to;
    struct batch_line *more = realloc(b->line, (size_t)(b->n + 1) * sizeof *more), *line;
    const char *why;

    if (!more)
        return REASON_MEMORY;
    b->line = more;
    line = &b->line[b->n++];
    *line = (struct batch_line){.number = number, .text = strdup(text)};
    if (!line->text)
        return REASON_MEMORY;
    if ((why = take_words(line)))
        return why;
    for (int i = 0; i + 1 < b->n && line->n; i++)
        if (strcmp(b->line[i].out, line->out) == 0)
            return reason("%s is the output of line %ld too", line->out, b->line[i].number);
    if (!line->n) {
        free(line->text);
        free(line->word);
        b->n--;
    }
    return NULL;
}

void batch_read(struct batch *b, const char *path)
{
    *b = (struct batch){.path = strcmp(path, "-") == 0 ? "standard input" : path};
    cli_check(b->path, lines_read(path, add_line, b));
    if (!b->n)
        cli_die("%s: has no variant", b->path);
}

void batch_free(struct batch *b)
{
    for (int i = 0; i < b->n; i++) {
        free(b->line[i].text);
        free(b->line[i].word);
    }
    free(b->line);
    *b = (struct batch){0};
}

/* ---- running ---- */

/* Whoever ends the batch ends its lines. */
static void pass_on(int signal)
{
    for (int k = 0; k < JOBS_MOST; k++)
        if (children[k] > 0)
            kill(children[k], signal);
    raise(signal);
}

static void set_handler(void (*handler)(int))
{
    static const int signals[] = {SIGHUP, SIGINT, SIGTERM};
    struct sigaction action = {.sa_handler = handler, .sa_flags = (int)SA_RESETHAND};

    for (size_t k = 0; k < sizeof signals / sizeof *signals; k++)
        sigaction(signals[k], &action, NULL);
}

/* Waits for one child and frees its slot. */
static int wait_for_one(const struct batch *b, const int *line)
{
    int status, slot = 0;
    pid_t pid;

    while ((pid = wait(&status)) < 0)
        if (errno != EINTR)
            cli_die("%s: %s", b->path, strerror(errno));
    while (children[slot] != pid)
        slot++;
    children[slot] = 0;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return 0;
    cli_note("%s: line %ld: failed", b->path, b->line[line[slot]].number);
    return 1;
}

const struct batch_line *batch_run(const struct batch *b, int64_t jobs, int *failed)
{
    int line[JOBS_MOST] = {0}, running = 0;
    const int most = jobs < JOBS_MOST ? (int)jobs : JOBS_MOST;

    *failed = 0;
    set_handler(pass_on);
    for (int i = 0; i < b->n || running > 0;) {
        if (i == b->n || running == most) {
            *failed += wait_for_one(b, line);
            running--;
            continue;
        }
        int slot = 0;
        while (children[slot])
            slot++;
        line[slot] = i;
        pid_t pid = fork();
        if (pid < 0)
            cli_die("%s: %s", b->path, strerror(errno));
        if (pid == 0) {
            set_handler(SIG_DFL);
            return &b->line[i];
        }
        children[slot] = pid;
        running++;
        i++;
    }
    set_handler(SIG_DFL);
    return NULL;
}

/* Words that argv[i] takes with it where it is one of the options; 0 where it is none. */
static int words_of(const char *const *option, const char *word)
{
    for (; *option; option++) {
        const size_t n = strlen(*option);
        if (strncmp(word, *option, n) == 0 && (word[n] == 0 || word[n] == '='))
            return word[n] ? 1 : 2;
    }
    return 0;
}

char **batch_command(const struct batch_line *line, int argc, char **argv, int operand, const char *const *left_out, int *n)
{
    char **all = calloc((size_t)(argc + line->n) + 1, sizeof *all);
    const int options_end = operand > 1 && strcmp(argv[operand - 1], "--") == 0 ? operand - 1 : operand;

    if (!all)
        cli_die(REASON_MEMORY);
    *n = 0;
    for (int i = 0; i < options_end; i++) {
        const int words = i ? words_of(left_out, argv[i]) : 0;
        if (words)
            i += words - 1;
        else
            all[(*n)++] = argv[i];
    }
    for (int i = 0; i < line->n; i++)
        all[(*n)++] = line->word[i];
    for (int i = options_end; i < argc; i++)
        all[(*n)++] = argv[i];
    return all;
}
