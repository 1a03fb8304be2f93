#include "tools/contact/sweep.h"

#include <stdio.h>

#include "tools/contact/lookup.h"

/* After the contact's weight. */
static const enum ctab_column swept[SWEEP_EACH - 1] = {CTAB_HEIGHT, CTAB_WHEEL_Y, CTAB_RAIL_Y, CTAB_X, CTAB_ANGLE, CTAB_RADIUS};

int sweep_columns(const struct ctab *t, int n, char name[SWEEP_N][SWEEP_NAME], struct column column[SWEEP_N])
{
    int at = 0;

    column[at++] = (struct column){"u", "m", 7};
    for (int i = 0; i < n; i++)
        for (int k = 0; k < SWEEP_EACH; k++, at++) {
            const char *what = k ? ctab_columns[swept[k - 1]].name : "weight", *unit = k ? ctab_columns[swept[k - 1]].unit : "1";
            snprintf(name[at], SWEEP_NAME, "%s_%s", what, t[i].yaw_method);
            column[at] = (struct column){name[at], unit, 7};
        }
    return at;
}

int sweep_row(const struct ctab *t, int n, double s, double yaw, double u, double row[SWEEP_N])
{
    struct contact c[CONTACT_MAX];

    *row++ = u;
    for (int i = 0; i < n; i++) {
        if (contact_lookup(&t[i], s, yaw, u, 0, c) < 1)
            return 0;
        *row++ = c[0].weight;
        for (int k = 0; k < SWEEP_EACH - 1; k++)
            *row++ = c[0].row[swept[k]];
    }
    return 1;
}
