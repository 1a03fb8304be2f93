/* Columns of the table come in an order of their own: where, how, how stiff. */
#include "tools/contact/rows.h"

#include <math.h>
#include <string.h>

static const enum ctab_column printed[ROWS_GAP - ROWS_CONTACT - 1] = {
    CTAB_HEIGHT, CTAB_RAIL_Y, CTAB_RAIL_Z, CTAB_X, CTAB_WHEEL_Y, CTAB_ANGLE, CTAB_RADIUS, CTAB_RAIL_K, CTAB_WHEEL_K,
    CTAB_HERTZ_C, CTAB_HERTZ_A, CTAB_HERTZ_B, CTAB_SHAPE, CTAB_BODY,
};
enum { PRINTED = sizeof printed / sizeof *printed };

const struct column rows_rest[ROWS_REST] = {{"z", "m", 10}, {"roll", "rad", 10}, {"radius_difference", "m", 10}};
const struct column rows_sweep[ROWS_SWEEP] = {
    {"y", "m", 6}, {"z", "m", 9}, {"radius_difference", "m", 9}, {"roll", "rad", 9},
    {"rail_y_left", "m", 9}, {"rail_y_right", "m", 9}, {"wheel_y_left", "m", 9}, {"wheel_y_right", "m", 9},
    {"angle_left", "rad", 9}, {"angle_right", "rad", 9},
};
const struct column rows_parameters[ROWS_PARAMETERS] = {
    {"amplitude", "m", 6}, {"conicity", "1", 6}, {"wavelength", "m", 6}, {"middle", "m", 6},
    {"contact_angle_parameter", "1", 6}, {"roll_parameter", "1", 6},
};

void rows_columns(struct column c[ROWS_N])
{
    c[ROWS_SIDE] = (struct column){"side", NULL, 0};
    c[ROWS_U] = (struct column){"u", "m", 10};
    c[ROWS_FORCE] = (struct column){"force", "N", 8};
    c[ROWS_CONTACT] = (struct column){"weight", "1", 6};
    for (int i = 0; i < PRINTED; i++)
        c[ROWS_CONTACT + 1 + i] = (struct column){ctab_columns[printed[i]].name, ctab_columns[printed[i]].unit, 10};
    c[ROWS_GAP] = (struct column){"gap", "m", 6};
}

void rows_contact(const struct contact *c, double first, double row[ROWS_N])
{
    row[ROWS_CONTACT] = c->weight;
    for (int i = 0; i < PRINTED; i++)
        row[ROWS_CONTACT + 1 + i] = c->row[printed[i]];
    row[ROWS_GAP] = c->height - first;
}

void rows_wheelset(const struct wheelset *w, int side, int k, double row[ROWS_N])
{
    const struct wheelset_side *one = &w->side[side];

    row[ROWS_SIDE] = side == WHEELSET_LEFT ? 'l' : 'r';
    row[ROWS_U] = one->u;
    row[ROWS_FORCE] = one->force[k];
    rows_contact(&one->contact[k], one->contact[0].height, row);
}

void rows_wheelset_rest(const struct wheelset *w, double row[ROWS_REST])
{
    memcpy(row, (double[ROWS_REST]){w->z, w->roll, w->radius_difference}, ROWS_REST * sizeof *row);
}

void rows_wheelset_point(const struct wheelset_point *p, double row[ROWS_SWEEP])
{
    const double all[ROWS_SWEEP] = {p->y, p->z, p->radius_difference, p->roll, p->rail_y[0], p->rail_y[1], p->wheel_y[0], p->wheel_y[1],
                                    p->angle[0], p->angle[1]};

    memcpy(row, all, sizeof all);
}

void rows_wheelset_parameters(double amplitude, const struct parameters *p, double row[ROWS_PARAMETERS])
{
    const double middle = nearbyint(p->klingel.middle * 1e9) / 1e9 + 0.0;        /* to the nanometre, without a minus before 0 */
    const double all[ROWS_PARAMETERS] = {amplitude, p->klingel.conicity, p->klingel.wavelength, middle, p->contact_angle, p->roll};

    memcpy(row, all, sizeof all);
}
