/* Options: getopt_long over the program's one table.  Abbreviations are refused, numbers are read whole. */
#include "tools/cli/cli.h"
#include "tools/cli/cli_private.h"

#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { OPTIONS_MAX = 48, FIRST_LONG = 256 };

static unsigned char given[OPTIONS_MAX];    /* by the last command line, as in the program's table */

static int count_options(const struct cli_option *option)
{
    int n = 0;

    while (option[n].name)
        n++;
    return n;
}

static int is_short(const struct cli_option *o)
{
    return !o->name[1] && !o->letter;
}

static const char *spelled(const struct cli_option *o)
{
    static char text[64];

    snprintf(text, sizeof text, "%s%s", is_short(o) ? "-" : "--", o->name);
    return text;
}

static const char *number(const char *text, double *value)
{
    char *end;

    errno = 0;
    *value = strtod(text, &end);
    if (end == text || *end || strspn(text, "0123456789+-.eE") != strlen(text))
        return "is not a number";
    return errno == ERANGE || !isfinite(*value) ? "is out of range" : NULL;
}

static void take_number(const struct cli_option *o, const char *text)
{
    double value;
    const char *why = number(text, &value);

    if (why)
        cli_misuse("%s: \"%s\" %s", spelled(o), text, why);
    if (value < o->lo || value > o->hi)
        cli_misuse("%s must be from %g to %g, not %s", spelled(o), o->lo, o->hi, text);
    if (o->type == CLI_NUM)
        *(double *)o->value = o->factor != 0 ? value * o->factor : value;
    else if (value != rint(value) || strpbrk(text, ".eE"))
        cli_misuse("%s must be a whole number, not %s", spelled(o), text);
    else
        *(int64_t *)o->value = (int64_t)value;
}

static void take_choice(const struct cli_option *o, const char *text)
{
    char all[256] = "";

    for (int k = 0; o->choice[k]; k++) {
        if (strcmp(o->choice[k], text) == 0) {
            *(int *)o->value = k;
            return;
        }
        snprintf(all + strlen(all), sizeof all - strlen(all), "%s%s", k ? ", " : "", o->choice[k]);
    }
    cli_misuse("%s must be one of %s, not \"%s\"", spelled(o), all, text);
}

static void take_item(struct cli_list *list, char *text)
{
    char **more = realloc(list->item, (size_t)(list->n + 1) * sizeof *more);

    if (!more)
        cli_die(REASON_MEMORY);
    list->item = more;
    list->item[list->n++] = text;
}

static void take(const struct cli_option *o, char *text)
{
    switch (o->type) {
    case CLI_FLAG:
        *(int *)o->value = 1;
        break;
    case CLI_NUM:
    case CLI_INT:
        take_number(o, text);
        break;
    case CLI_TEXT:
        *(const char **)o->value = text;
        break;
    case CLI_CHOICE:
        take_choice(o, text);
        break;
    case CLI_LIST:
        take_item(o->value, text);
        break;
    }
}

/* getopt_long takes any unique beginning of a long name: scripts that lean on it break when an option is added. */
static void refuse_abbreviations(const struct cli_option *option, int argc, char **argv)
{
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        size_t n = strcspn(argv[i], "=");
        int known = 0, takes = 0;
        if (strncmp(argv[i], "--", 2) != 0)
            continue;
        for (int k = 0; option[k].name && !known; k++) {
            known = !is_short(&option[k]) && strlen(option[k].name) == n - 2 && strncmp(option[k].name, argv[i] + 2, n - 2) == 0;
            takes = option[k].type != CLI_FLAG && !argv[i][n];
        }
        if (!known)
            cli_misuse("unknown option %.*s (-h shows the usage)", (int)n, argv[i]);
        i += takes;
    }
}

static void print_help(const struct cli_program *p)
{
    printf("%s\n%s\n", p->usage, p->purpose);
    exit(cli_end());
}

/* The table as getopt wants it: short options in letters, long ones by number. */
static void build(const struct cli_option *option, int n, char *letters, struct option *longs)
{
    int used = 0;

    *letters++ = ':';
    *letters++ = 'h';
    for (int k = 0; k < n; k++) {
        int takes = option[k].type != CLI_FLAG;
        if (!is_short(&option[k]))
            longs[used++] = (struct option){option[k].name, takes ? required_argument : no_argument, NULL, FIRST_LONG + k};
        else {
            *letters++ = option[k].name[0];
            if (takes)
                *letters++ = ':';
        }
    }
    *letters = 0;
    longs[used] = (struct option){0};
}

char **cli_begin(const struct cli_program *p, int argc, char **argv, int least, int most, int *operands)
{
    int n = count_options(p->option), c;
    char letters[2 * OPTIONS_MAX + 3];
    struct option longs[OPTIONS_MAX + 1];

    cli_name = p->name;
    cli_failure = p->failure ? p->failure : EXIT_FAILURE;
    cli_remember(argc, argv);
    memset(given, 0, sizeof given);
    setvbuf(stdout, NULL, _IOFBF, 1 << 20);
    refuse_abbreviations(p->option, argc, argv);
    build(p->option, n, letters, longs);
    opterr = 0;
    optind = 0;                  /* anew: a batch has a command for each line */
    while ((c = getopt_long(argc, argv, letters, longs, NULL)) != -1) {
        int k = c - FIRST_LONG;
        if (c == 'h')
            print_help(p);
        if (c == ':')
            cli_misuse("option %s needs a value", argv[optind - 1]);
        if (c == '?' && optopt >= FIRST_LONG)
            cli_misuse("option --%s takes no value", p->option[optopt - FIRST_LONG].name);
        if (c == '?')
            cli_misuse("unknown option -%c (-h shows the usage)", optopt);
        for (int j = 0; c < FIRST_LONG && j < n; j++)
            if (is_short(&p->option[j]) && p->option[j].name[0] == c)
                k = j;
        take(&p->option[k], optarg);
        given[k] = 1;
    }
    *operands = argc - optind;
    if (*operands < least)
        cli_misuse("%s (-h shows the usage)", least == 1 ? "an input is missing" : "inputs are missing");
    if (*operands > most)
        cli_misuse("one operand too many: %s (-h shows the usage)", argv[optind + most]);
    return argv + optind;
}

/* Where the form begins, a line with the program's name; what goes on in the next line is indented. */
static const char *form_text(const struct cli_program *p, int form)
{
    const char *at = p->usage;

    for (; form > 0; form--)
        do
            at = strchr(at, '\n') + 1;
        while (*at == ' ');
    return at;
}

static int form_has(const struct cli_program *p, int form, const struct cli_option *o)
{
    const char *from = form_text(p, form), *name = spelled(o), *end = from;
    const size_t n = strlen(name);

    do
        end += strcspn(end, "\n") + 1;
    while (end[-1] && *end == ' ');
    for (const char *at = from; (at = strstr(at, name)) && at < end; at++)
        if (strchr(" [", at[-1]) && strchr(" ]\n", at[n]))
            return 1;
    return 0;
}

void cli_form(const struct cli_program *p, int form, const char *what)
{
    for (int k = 0; p->option[k].name; k++)
        if (given[k] && !form_has(p, form, &p->option[k]))
            cli_misuse("%s does not go with %s", spelled(&p->option[k]), what);
}
