/* The grid's step is such that the displacement is a whole number of nodes. */
#include "tools/contact/spot.h"

#include <math.h>

#include "formats/reason.h"
#include "tools/contact/row.h"
#include "tools/contact/search.h"
#include "tools/contact/table.h"

#define STEP 1e-4            /* m, at most */

/* The first contact of the search as a row, and its patch. */
static const char *spot_make(const struct search *s, const struct spot_place *at, const struct ctab *t, double yaw, int64_t shift,
                             struct spot *o)
{
    struct search_contact c[SEARCH_MOST];
    struct strip_law law;
    int yaw_index = yaw > 0;

    if (search_contacts(s, yaw_index, shift, c) == 0)
        return reason("wheel and rail do not touch at u = %g m", at->u);
    row_make(&c[0], s, t, yaw, (double)shift * s->gap.step, NULL, o->row);
    struct hertz h = {.C = o->row[CTAB_HERTZ_C], .a1 = o->row[CTAB_HERTZ_A], .b1 = o->row[CTAB_HERTZ_B]};
    double B = 0.5 * (o->row[CTAB_RAIL_K] + o->row[CTAB_WHEEL_K]);
    strip_law(at->shear_modulus, at->poisson, &law);
    o->strips = patch_strips(&c[0].pair, &c[0].at, B, &h, at->load, &law, PATCH_ALL, o->strip, &o->patch);
    return o->strips ? NULL : "the contact is the end of a rail: it has no patch";
}

/* Strips from left to right again after the other side's. */
static void spot_mirror(struct spot *o)
{
    row_mirror(o->row);
    o->patch.y = -o->patch.y;
    for (int64_t i = 0, j = o->strips - 1; i <= j; i++, j--) {
        struct strip one = o->strip[i];
        o->strip[i] = o->strip[j];
        o->strip[j] = one;
        o->strip[j].y = -o->strip[j].y;
        if (i != j)
            o->strip[i].y = -o->strip[i].y;
    }
}

const char *spot_find(const struct prof *wheel, const struct prof *rail, const struct spot_place *at, struct spot *o)
{
    const char *why = table_pair(wheel, rail);
    const double yaws[2] = {-fabs(at->yaw), fabs(at->yaw)};
    int64_t shift = (int64_t)ceil(fabs(at->u) / STEP - 1e-9);
    double step = shift > 0 ? fabs(at->u) / (double)shift : STEP;
    struct search s = {0};

    if (why)
        return why;
    const struct ctab t = {.shear_modulus = at->shear_modulus, .poisson = at->poisson, .radius = wheel->radius, .load = at->load};
    int mirror = wheel->side == 'l';
    shift = (at->u < 0) != mirror ? -shift : shift;
    if (!(why = search_begin(&s, wheel, rail, yaws, 2, SEARCH_EXACT, step)) &&
        !(why = search_section(&s, rail, prof_nearest(rail, at->s))) &&
        !(why = spot_make(&s, at, &t, mirror ? -at->yaw : at->yaw, shift, o)) && mirror)
        spot_mirror(o);
    search_free(&s);
    return why;
}

void spot_report(const struct spot *o, double load, const struct report_printer *out)
{
    static const struct column total[] = {
        {"rail_y", "m", 6}, {"angle", "rad", 6}, {"shape", "1", 4}, {"parts", "1", 3},
        {"approach", "m", 5}, {"hertz_approach", "m", 5}, {"area", "m^2", 5}, {"hertz_area", "m^2", 5},
        {"pressure", "Pa", 5}, {"hertz_pressure", "Pa", 5}, {"a", "m", 5}, {"b", "m", 5}, {"force_y", "m", 5},
    };
    static const struct column strip[] = {{"y", "m", 6}, {"half_length", "m", 6}, {"pressure", "Pa", 6}};
    const int totals = sizeof total / sizeof *total;
    const struct strip_patch *p = &o->patch;
    double area = M_PI * o->row[CTAB_HERTZ_A] * o->row[CTAB_HERTZ_B] * cbrt(load * load);

    out->header(total, totals);
    out->row(total, totals, (double[]){o->row[CTAB_RAIL_Y], o->row[CTAB_ANGLE], o->row[CTAB_SHAPE], p->parts, p->approach,
                                   pow(load / o->row[CTAB_HERTZ_C], 2.0 / 3), p->area, area, p->pressure, 1.5 * load / area, p->a, p->b, p->y});
    out->header(strip, 3);
    for (int64_t i = 0; i < o->strips; i++)
        if (o->strip[i].half > 0)
            out->row(strip, 3, (double[]){o->strip[i].y, o->strip[i].half, o->strip[i].pressure});
}
