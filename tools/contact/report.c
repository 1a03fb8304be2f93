/* Columns of the table come in an order of their own: where, how, how stiff. */
#include "tools/contact/report.h"

#include <math.h>
#include <stdlib.h>

#include "formats/reason.h"
#include "tools/contact/parameters.h"
#include "tools/contact/sweep.h"
#include "tools/contact/wheelset.h"

#define RADIUS_STEP 5e-5         /* m, of y for rolling radii */
#define KLINGEL_STEP 1e-5        /* m, of y for conicity, which a leap of contact moves by as much */
#define TAPE_LINE 1.5            /* m, distance of the contact points, EN 15302 */
#define NANOMETRE 1e-9

enum { SWEEP_MOST = 4801 };

static const enum ctab_column printed[] = {
    CTAB_HEIGHT, CTAB_RAIL_Y, CTAB_RAIL_Z, CTAB_X, CTAB_WHEEL_Y, CTAB_ANGLE, CTAB_RADIUS, CTAB_RAIL_K, CTAB_WHEEL_K,
    CTAB_HERTZ_C, CTAB_HERTZ_A, CTAB_HERTZ_B, CTAB_SHAPE, CTAB_BODY,
};
enum { PRINTED = sizeof printed / sizeof *printed };

/* A contact's row; that of a wheelset's contact has its side, displacement and force before, up to CONTACT; along a path the station
 * stands before, in STATION. */
enum { SIDE, U, FORCE, CONTACT, STATION = FORCE, GAP = CONTACT + PRINTED + 1, ALL };

static void contact_columns(struct column c[ALL])
{
    c[SIDE] = (struct column){"side", NULL, 0};
    c[U] = (struct column){"u", "m", 10};
    c[FORCE] = (struct column){"force", "N", 8};
    c[CONTACT] = (struct column){"weight", "1", 6};
    for (int i = 0; i < PRINTED; i++)
        c[CONTACT + 1 + i] = (struct column){ctab_columns[printed[i]].name, ctab_columns[printed[i]].unit, 10};
    c[GAP] = (struct column){"gap", "m", 6};
}

/* From CONTACT on; `first` is the height of the contact that touches first (m). */
static void contact_row(const struct ctab *t, struct contact *c, double first, double row[ALL])
{
    contact_complete(t, c);
    row[CONTACT] = c->weight;
    for (int i = 0; i < PRINTED; i++)
        row[CONTACT + 1 + i] = c->row[printed[i]];
    row[GAP] = c->height - first;
}

/* The lookup would hold it at the end; a table of one yaw answers for any. */
static const char *check_yaw(const struct ctab *t, double yaw)
{
    if (t->yaws == 1 || (yaw >= t->yaw[0] && yaw <= t->yaw[t->yaws - 1]))
        return NULL;
    return reason("yaw %g rad is beyond the table, %g to %g", yaw, t->yaw[0], t->yaw[t->yaws - 1]);
}

static const char *look_up(const struct ctab *t, double s, double yaw, double u, double roll, struct contact *c, int *n)
{
    const char *why = check_yaw(t, yaw);

    *n = contact_lookup(t, s, yaw, u, roll, c);
    return why ? why : *n >= 0 ? NULL : reason("u = %g m is beyond the table, %g to %g", u, t->u[0], t->u[t->us - 1]);
}

const char *report_query(const struct ctab *t, double s, double yaw, double u, double roll, const struct report_printer *out)
{
    struct contact c[CONTACT_MAX];
    struct column column[ALL];
    double row[ALL];
    int n;
    const char *why = look_up(t, s, yaw, u, roll, c, &n);

    if (why)
        return why;
    contact_columns(column);
    out->header(column + CONTACT, ALL - CONTACT);
    for (int i = 0; i < n; i++) {
        contact_row(t, &c[i], c[0].height, row);
        out->row(column + CONTACT, ALL - CONTACT, row + CONTACT);
    }
    return NULL;
}

const char *report_path(const struct ctab *t, double from, double to, double step, double yaw, double u, double roll,
                        const struct report_printer *out)
{
    struct contact c[CONTACT_MAX];
    struct column column[ALL];
    double row[ALL];
    int n;
    const char *why = look_up(t, from, yaw, u, roll, c, &n);

    if (why)
        return why;
    if (from > to)
        return reason("from %g m to %g m: stations must increase", from, to);
    contact_columns(column);
    column[STATION] = (struct column){"station", "m", 10};
    out->header(column + STATION, GAP - STATION);
    for (int64_t i = 0; from + (double)i * step <= to + 1e-9 * step; i++) {
        row[STATION] = from + (double)i * step;
        if (contact_lookup(t, row[STATION], yaw, u, roll, c) < 1)
            continue;
        contact_row(t, &c[0], c[0].height, row);
        out->row(column + STATION, GAP - STATION, row + STATION);
    }
    return NULL;
}

const char *report_sweep(const struct ctab *t, int n, double s, double yaw, const struct report_printer *out)
{
    struct column column[SWEEP_N];
    char name[SWEEP_N][SWEEP_NAME];
    double row[SWEEP_N];
    int columns = sweep_columns(t, n, name, column);
    const char *why = NULL;

    for (int i = 0; i < n && !why; i++)
        if (t[i].yaws > 1 && (why = check_yaw(&t[i], yaw)))
            return why;
    out->header(column, columns);
    for (int64_t i = 0; i < t[0].us; i++)
        if (sweep_row(t, n, s, yaw, t[0].u[i], row))
            out->row(column, columns, row);
    return NULL;
}

static const char *pair_check(const struct report_pair *p)
{
    const char *why = check_yaw(p->left, p->yaw);

    return why ? why : check_yaw(p->right, p->yaw);
}

const char *report_wheelset(const struct report_pair *p, double y, double load, const struct report_printer *out)
{
    static const struct column rest[] = {{"z", "m", 10}, {"roll", "rad", 10}, {"radius_difference", "m", 10}};
    struct column column[ALL];
    double row[ALL];
    struct wheelset w;
    const char *why = pair_check(p);

    if (why || (why = wheelset_rest(p->left, p->right, p->s, p->yaw, y, load, p->roll_free, &w)))
        return why;
    out->header(rest, 3);
    out->row(rest, 3, (double[]){w.z, w.roll, w.radius_difference});
    contact_columns(column);
    out->header(column, ALL);
    for (int i = WHEELSET_LEFT; i <= WHEELSET_RIGHT; i++)
        for (int k = 0; k < w.side[i].n; k++) {
            struct wheelset_side *one = &w.side[i];
            row[SIDE] = i == WHEELSET_LEFT ? 'l' : 'r';
            row[U] = one->u;
            row[FORCE] = one->force[k];
            contact_row(i == WHEELSET_LEFT ? p->left : p->right, &one->contact[k], one->contact[0].height, row);
            out->row(column, ALL, row);
        }
    return NULL;
}

/* Rest positions, *n of them, to be freed. */
static const char *pair_sweep(const struct report_pair *p, double step, struct wheelset_point **points, int64_t *n)
{
    const char *why = pair_check(p);

    *points = calloc(SWEEP_MOST, sizeof **points);
    if (!*points)
        return REASON_MEMORY;
    return why ? why : wheelset_sweep(p->left, p->right, p->s, p->yaw, step, p->roll_free, *points, SWEEP_MOST, n);
}

const char *report_rolling_radius(const struct report_pair *pair, const struct report_printer *out)
{
    static const struct column column[] = {
        {"y", "m", 6}, {"z", "m", 9}, {"radius_difference", "m", 9}, {"roll", "rad", 9},
        {"rail_y_left", "m", 9}, {"rail_y_right", "m", 9}, {"wheel_y_left", "m", 9}, {"wheel_y_right", "m", 9},
        {"angle_left", "rad", 9}, {"angle_right", "rad", 9},
    };
    const int columns = sizeof column / sizeof *column;
    struct wheelset_point *points;
    int64_t n = 0;
    const char *why = pair_sweep(pair, RADIUS_STEP, &points, &n);

    if (!why)
        out->header(column, columns);
    for (int64_t i = 0; i < n && !why; i++) {
        const struct wheelset_point *p = &points[i];
        out->row(column, columns, (double[]){p->y, p->z, p->radius_difference, p->roll, p->rail_y[0], p->rail_y[1], p->wheel_y[0], p->wheel_y[1],
                                         p->angle[0], p->angle[1]});
    }
    free(points);
    return why;
}

const char *report_conicity(const struct report_pair *pair, const double *amplitude, int n, const struct report_printer *out)
{
    static const struct column column[] = {
        {"amplitude", "m", 6}, {"conicity", "1", 6}, {"wavelength", "m", 6}, {"middle", "m", 6},
        {"contact_angle_parameter", "1", 6}, {"roll_parameter", "1", 6},
    };
    double radius = 0.5 * (pair->left->radius + pair->right->radius), *value = calloc(4 * SWEEP_MOST, sizeof *value);
    const struct parameters_curves curves = {value, value + SWEEP_MOST, value + 2 * SWEEP_MOST, value + 3 * SWEEP_MOST};
    struct wheelset_point *points = NULL;
    struct parameters p;
    int64_t m = 0;
    const char *why = value ? pair_sweep(pair, KLINGEL_STEP, &points, &m) : REASON_MEMORY;

    if (!why)
        parameters_gather(points, m, &curves);
    for (int i = 0; i < n && !why; i++)                           /* all of them hold before a row is given */
        why = parameters_at(&curves, m, amplitude[i], TAPE_LINE, radius, &p);
    if (!why)
        out->header(column, 6);
    for (int i = 0; i < n && !why; i++) {
        parameters_at(&curves, m, amplitude[i], TAPE_LINE, radius, &p);
        double middle = nearbyint(p.klingel.middle / NANOMETRE) * NANOMETRE + 0.0;       /* without a minus before 0 */
        out->row(column, 6, (double[]){amplitude[i], p.klingel.conicity, p.klingel.wavelength, middle, p.contact_angle, p.roll});
    }
    free(points);
    free(value);
    return why;
}
