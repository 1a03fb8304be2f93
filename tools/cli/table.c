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

static void put_value(const struct column *c, double value, const char *before)
{
    char title[TITLE];
    int width = column_title(c, title);

    if (c->unit)
        printf("%s%*.*g", before, width, c->digits, value);
    else
        printf("%s%*c", before, width, (int)value);
}

void cli_row(const struct column *c, int n, const double *value)
{
    for (int i = 0; i < n; i++)
        put_value(&c[i], value[i], i ? " " : "");
    putchar('\n');
}

void cli_table(const struct column *c, int n, int64_t rows, const double *x, const double *value)
{
    cli_header(c, n);
    for (int64_t i = 0; i < rows; i++) {
        put_value(&c[0], x[i], "");
        for (int k = 1; k < n; k++)
            put_value(&c[k], value[i * (n - 1) + k - 1], " ");
        putchar('\n');
    }
}
