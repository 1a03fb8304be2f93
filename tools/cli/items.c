/* Options that take a list of KEY=NUMBER, separated by commas. */
#include "tools/cli/cli.h"

#include <stdlib.h>
#include <string.h>

void cli_items(const char *option, const char *text, const struct cli_item *item, int n)
{
    unsigned seen = 0;

    for (const char *p = text; ; p++) {
        size_t length = strcspn(p, "=,");
        int i = 0;
        char *end;
        while (i < n && !(strlen(item[i].key) == length && strncmp(item[i].key, p, length) == 0))
            i++;
        if (i == n || p[length] != '=')
            cli_misuse("--%s: \"%s\" must be KEY=NUMBER,...; see -h for the keys", option, p);
        if (seen >> i & 1)
            cli_misuse("--%s: %s is given twice", option, item[i].key);
        const char *number = p + length + 1;
        double value = strtod(number, &end);
        if (end == number || strspn(number, "+-.0123456789eE") < (size_t)(end - number) || (*end && *end != ','))
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
