/* Every column is as wide as its title or its longest number. */
#include "tools/cli/table.h"

#include <stdio.h>

#define BESIDE_DIGITS 7      /* sign, point and exponent of a number, -1.5e-308 */

enum { TITLE = 64 };

/* Returns the column's width. */
static int column_title(const struct column *c, char title[TITLE])
{
    int n = c->unit ? snprintf(title, TITLE, "%s[%s]", c->name, c->unit) : snprintf(title, TITLE, "%s", c->name);
    int number = c->digits + BESIDE_DIGITS;

    return c->unit && number > n ? number : n;
}

void cli_header(const struct column *c, int n)
{
    char title[TITLE];

    for (int i = 0; i < n; i++) {
        int width = column_title(&c[i], title);
        printf("%s%*s", i ? " " : "", width, title);
    }
    putchar('\n');
}

void cli_row(const struct column *c, int n, const double *value)
{
    char title[TITLE];

    for (int i = 0; i < n; i++) {
        int width = column_title(&c[i], title);
        if (c[i].unit)
            printf("%s%*.*g", i ? " " : "", width, c[i].digits, value[i]);
        else
            printf("%s%*c", i ? " " : "", width, (int)value[i]);
    }
    putchar('\n');
}
