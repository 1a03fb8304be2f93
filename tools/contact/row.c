/* The wheel hangs at H = min over x, y of z_rail(x, y) - z_wheel(x - x_0, y - u), so dH/du is the slope, and dH/dx_0 the fall, where they
 * touch.  Roll turns a wheel point (y, z), counted from the running circle's lowest point, to (y - z roll, z + y roll):
 * dH/d(roll) = -(y + slope z), and the contact moves by d(y)/d(roll) = (1 + slope^2 + z_wheel'' z)/(z_rail'' - z_wheel'').  Yaw moves
 * it by (-y, x), counted from the wheelset's centre, and the wheel itself, which stays over its station, back by its own part
 * of that.  Between the yaws of thesis.h heights go straight. */
#include "tools/contact/row.h"

#include <math.h>

#include "tools/contact/hertz.h"
#include "tools/contact/locus.h"
#include "tools/contact/patch.h"

#define ROLL_Y_MOST 5.0       /* m/rad: flatter than 0.2 1/m the contact runs away and its rate says nothing */
#define END_CURVATURE 1e3     /* 1/m: an end of a rail section is taken as an edge of 1 mm radius */

/* rad, between the direction the wheel rolls in at the point and the rail's, (1, 0, fall). */
static double row_twist(const struct locus_point *p, double fall, double yaw)
{
    double cosine = (cos(p->turn) * cos(yaw) - sin(p->turn) * fall) / sqrt(1 + fall * fall);

    return cosine < 1 ? acos(cosine) : 0;
}

void row_make(const struct search_contact *c, const struct search *s, const struct ctab *t, double yaw, double u, const struct strip_law *law,
              float row[CTAB_ALL])
{
    const struct gap_minimum *m = &c->at;
    struct locus_point p;
    struct hertz h;
    double A, B, z = m->z - m->gap, t2 = 1 + m->slope * m->slope, bend = t2 * sqrt(t2);
    double rail_k = m->end ? END_CURVATURE : m->rail_k, wheel_k = -m->wheel_k, both = (rail_k + wheel_k) * bend;
    double x = m->x - s->wheel_position * sin(yaw), y = m->y - u + s->rail_position;      /* from the wheelset's centre */

    if (c->cut)
        thesis_invert(x, y, z, m->slope, s->wheel_position, t->radius, yaw, c->cut, &p);
    else
        locus_invert(x, y, z, m->slope, t->radius, yaw, &p);
    hertz_curvatures(wheel_k, 1 / (p.r * sqrt(1 + p.rate * p.rate)), rail_k, row_twist(&p, s->method == SEARCH_EXACT ? m->fall : 0, c->cut ? 0 : yaw), &A, &B);
    hertz_contact(A, B, t->shear_modulus, t->poisson, &h);
    double shape = patch_deviation(&c->pair, m, B, &h, t->load);
    if (law)
        patch_hertz(&c->pair, m, B, t->load, law, &h);
    double roll_y = both > 0 ? (t2 - wheel_k * bend * z) / both : ROLL_Y_MOST;
    double value[CTAB_ALL] = {
        [CTAB_HEIGHT] = m->gap,
        [CTAB_RAIL_Y] = m->y,
        [CTAB_RAIL_Z] = m->z,
        [CTAB_WHEEL_Y] = p.a - s->wheel_position,
        [CTAB_X] = x,
        [CTAB_ANGLE] = atan(m->slope),
        [CTAB_RADIUS] = p.r,
        [CTAB_RAIL_K] = rail_k,
        [CTAB_WHEEL_K] = wheel_k,
        [CTAB_HERTZ_C] = h.C,
        [CTAB_HERTZ_A] = h.a1,
        [CTAB_HERTZ_B] = h.b1,
        [CTAB_HEIGHT_U] = m->slope,
        [CTAB_HEIGHT_YAW] = c->cut ? 0 : m->slope * x + m->fall * (s->wheel_position * cos(yaw) - y),
        [CTAB_HEIGHT_S] = m->fall,
        [CTAB_HEIGHT_ROLL] = -(y - s->wheel_position + m->slope * z),
        [CTAB_ROLL_Y] = m->end ? 0 : fmax(0, fmin(roll_y, ROLL_Y_MOST)),
        [CTAB_SHAPE] = shape,
        [CTAB_BODY] = c->body,
    };
    for (int i = 0; i < CTAB_ALL; i++)
        row[i] = (float)value[i];
}

void row_mirror(float row[CTAB_ALL])
{
    static const enum ctab_column turned[] = {
        CTAB_RAIL_Y, CTAB_WHEEL_Y, CTAB_ANGLE, CTAB_HEIGHT_U, CTAB_HEIGHT_YAW, CTAB_HEIGHT_ROLL,
    };

    for (size_t i = 0; i < sizeof turned / sizeof *turned; i++)
        row[turned[i]] = -row[turned[i]];
}
