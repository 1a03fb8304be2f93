/* The wheelset turned by psi about its centre and projected on the track's cross-section: y = a cos(psi), z unchanged.  This alone draws
 * wheel and flange away from the rail, by a (1 - cos(psi)).  What it misses is that a flange touches ahead of the axle or behind it: a
 * circle of the face, radius r and slope m = -dr/da, stands out furthest at sin(t) = m tan(psi) and there, at a given depth below the axle, by
 *
 *     delta = r m tan(psi)^2/2
 *
 * The thesis does not say how long its section is; here delta says it, so that the flange's place agrees with the silhouette by construction.
 * A section of the profile between points A (tread side) and B (flange side) taken out and the flange's part closed up to A advances a
 * face of slope m by (y_A - y_B) - (z_B - z_A)/m.  A is where the profile stands at 45 degrees; B follows from the advance being delta. */
#include "tools/contact/thesis.h"

#include <math.h>
#include <stddef.h>

#include "formats/reason.h"

#define ROOT 1.0              /* slope between tread and flange, where the section begins */
#define BASE 1.8              /* m, between the wheelsets of a Y25 bogie, the shortest of data/vehicles: a choice */

/* Between the flange's tip and the running circle: the steepest point. */
static int64_t steepest(const struct locus_wheel *w)
{
    int64_t tip = 0, at;

    for (int64_t i = 1; i < w->n && w->y[i] < 0; i++)
        tip = w->z[i] > w->z[tip] ? i : tip;
    at = tip;
    for (int64_t i = tip; i < w->n && w->y[i] < 0; i++)
        at = w->slope[i] < w->slope[at] ? i : at;
    return at;
}

const char *thesis_section(const struct locus_wheel *w, double yaw, struct thesis_cut *cut)
{
    const double *y = w->y, *z = w->z;

    *cut = (struct thesis_cut){0};
    if (yaw == 0)
        return NULL;

    int64_t face = steepest(w), a = face;
    double m = -w->slope[face], delta = 0.5 * (w->radius + z[face]) * m * tan(yaw) * tan(yaw), before = 0;
    if (!(m > ROOT))
        return "the wheel's profile has no flange steeper than 45 degrees";
    while (a < w->n - 1 && w->slope[a] <= -ROOT)
        a++;
    for (int64_t b = a - 1; b >= face; b--) {
        double advance = y[a] - y[b] - (z[b] - z[a]) / m;
        if (advance >= delta) {
            double t = (delta - before) / (advance - before);      /* from b + 1 to b */
            cut->y = y[a];
            cut->dy = y[a] - y[b + 1] + t * (y[b + 1] - y[b]);
            cut->dz = z[b + 1] - z[a] + t * (z[b] - z[b + 1]);
            return NULL;
        }
        before = advance;
    }
    return reason("the section that a yaw of %g rad removes is longer than the flange's root", yaw);
}

void thesis_profile(const struct locus_wheel *w, double yaw, const struct thesis_cut *cut, const struct locus *o)
{
    double c = cos(yaw), s = sin(yaw);

    for (int64_t i = w->n - 1; i >= 0; i--) {
        int beyond = cut->dy > 0 && w->y[i] < cut->y;
        if (beyond && w->y[i] + cut->dy > cut->y) {                /* removed */
            o->y[i] = o->y[i + 1];
            o->z[i] = o->z[i + 1];
            o->slope[i] = o->slope[i + 1];
            o->x[i] = o->x[i + 1];
            o->bend[i] = o->bend[i + 1];
            continue;
        }
        o->y[i] = (w->position + w->y[i] + beyond * cut->dy) * c;
        o->z[i] = w->z[i] - beyond * cut->dz;
        o->slope[i] = w->slope[i] / c;
        o->x[i] = -w->y[i] * s;
        o->bend[i] = 1 / (w->radius + w->z[i]);
    }
}

void thesis_invert(double x, double y, double z, double slope, double position, double radius, double yaw, const struct thesis_cut *cut,
                   struct locus_point *p)
{
    double c = cos(yaw), beyond = y / c - position < cut->y && cut->dy > 0;

    p->a = y / c - beyond * cut->dy;
    double ahead = x + p->a * sin(yaw), down = radius + z + beyond * cut->dz;
    p->r = hypot(ahead, down);
    p->turn = atan2(ahead, down);
    p->rate = slope * c * down / p->r;                             /* z = sqrt(r(a)^2 - ahead^2) */
}

/* The leading wheelset of a bogie at one rail, the trailing one at the other. */
double thesis_yaw(double clearance)
{
    return 2 * clearance / BASE;
}
