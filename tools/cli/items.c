/* Options that take a list of KEY=NUMBER, or of numbers, separated by commas. */
#include "tools/cli/cli.h"

#include <stdlib.h>
#include <string.h>

/* *end stays at the text where that is no decimal number up to a comma or the end. */
static double number_before_comma(const char *text, const char **end)
{
    char *stop;
    double value = strtod(text, &stop);

    *end = strspn(text, "+-.0123456789eE") < (size_t)(stop - text) || (*stop && *stop != ',') ? text : stop;
    return value;
}

void cli_items(const char *option, const char *text, const struct cli_item *item, int n)
{
    unsigned seen = 0;

    for (const char *p = text; ; p++) {
        size_t length = strcspn(p, "=,");
        int i = 0;
        const char *end;
        while (i < n && !(strlen(item[i].key) == length && strncmp(item[i].key, p, length) == 0))
            i++;
        if (i == n && p[length] == '=')
            cli_misuse("--%s: unknown key %.*s; see -h for the keys", option, (int)length, p);
        if (i == n || p[length] != '=')
            cli_misuse("--%s: \"%s\" must be KEY=NUMBER,...; see -h for the keys", option, p);
        if (seen >> i & 1)
            cli_misuse("--%s: %s is given twice", option, item[i].key);
        const char *number = p + length + 1;
        double value = number_before_comma(number, &end);
        if (end == number)
            cli_misuse("--%s: %s=%s is not a number", option, item[i].key, number);
        if (!(value >= item[i].lo && value <= item[i].hi))
            cli_misuse("--%s: %s is %g, must be %g to %g", option, item[i].key, value, item[i].lo, item[i].hi);
        *item[i].value = value;
        seen |= 1u << i;
        p = end;
        if (!*p)
            break;
    }
    for (int i = 0; i < n; i++)
        if (item[i].needed && !(seen >> i & 1))
            cli_misuse("--%s needs %s=", option, item[i].key);
}

int cli_numbers(const char *option, const char *text, double lo, double hi, double *value, int most)
{
    int n = 0;

    for (const char *p = text; ; p++) {
        const char *end;
        double number = number_before_comma(p, &end);
        if (end == p)
            cli_misuse("--%s: \"%s\" must be NUMBER,...", option, p);
        if (!(number >= lo && number <= hi))
            cli_misuse("--%s: %g must be %g to %g", option, number, lo, hi);
        if (n == most)
            cli_misuse("--%s: more than %d numbers", option, most);
        value[n++] = number;
        p = end;
        if (!*p)
            return n;
    }
}
