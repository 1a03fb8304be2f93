#include "tools/integrate/sideways.h"
#include "formats/reason.h"

#include <stdlib.h>

const char *sideways_new(struct sideways *s, int64_t wheelsets)
{
    const size_t n = 3 * (size_t)wheelsets;

    *s = (struct sideways){.wheelsets = wheelsets, .y = calloc(3 * n + 1, sizeof *s->y)};
    if (!s->y)
        return REASON_MEMORY;
    s->v = s->y + n;
    s->a = s->v + n;
    return NULL;
}

void sideways_free(struct sideways *s)
{
    free(s->y);
    *s = (struct sideways){0};
}

/* (m + h (c + D) + h^2 k) y'' = Y - k (y + h y') - c y' */
static double alone(const struct trk *t, double h, double Y, double D, double y, double v)
{
    const double k = *t->lateral_k, c = *t->lateral_c;

    return (Y - k * (y + h * v) - c * v) / (*t->lateral_m + h * (c + D) + h * h * k);
}

/* Rails and sleeper on one spring. */
static void accelerate_one(struct sideways *s, const struct trk *t, double h, const struct wheel_output *w, int64_t i)
{
    const double Y = w[0].Y - w[0].check + w[1].Y - w[1].check, D = w[0].creep_damping + w[1].creep_damping;

    s->a[2 * i] = s->a[2 * i + 1] = alone(t, h, Y, D, s->y[2 * i], s->v[2 * i]);
}

/* Rails r against the sleeper s, with f the force between them at the end of the step but for the accelerations, g = h c + h^2 k:
 *   (m + h D + g) y_r'' - g y_s'' = Y - f_r,   (M + h c_s + h^2 k_s) y_s'' + sum g (y_s'' - y_r'') = sum f_r - k_s (y_s + h y_s') - c_s y_s'. */
static void accelerate_two(struct sideways *s, const struct trk *t, double h, const struct wheel_output *w, int64_t i)
{
    const int64_t sleeper = 2 * s->wheelsets + i;
    const double k = *t->lateral_k, c = *t->lateral_c, g = h * c + h * h * k;
    const double ys = s->y[sleeper], vs = s->v[sleeper], ks = *t->sleeper_lateral_k, cs = *t->sleeper_lateral_c;
    double mass = *t->sleeper_mass + h * cs + h * h * ks, force = -ks * (ys + h * vs) - cs * vs, diagonal[2], right[2];

    for (int side = 0; side < 2; side++) {
        const double y = s->y[2 * i + side] - ys, v = s->v[2 * i + side] - vs, f = k * (y + h * v) + c * v;
        diagonal[side] = *t->lateral_m + h * w[side].creep_damping + g;
        right[side] = w[side].Y - w[side].check - f;
        mass += g - g * g / diagonal[side];
        force += f + g * right[side] / diagonal[side];
    }
    s->a[sleeper] = force / mass;
    for (int side = 0; side < 2; side++)
        s->a[2 * i + side] = (right[side] + g * s->a[sleeper]) / diagonal[side];
}

void sideways_accelerate(struct sideways *s, const struct trk *t, int follows, double h, const struct wheel_output *w)
{
    for (int64_t i = 0; i < s->wheelsets && *t->lateral_k > 0; i++)
        if (follows && *t->sleeper_lateral_k > 0)
            accelerate_two(s, t, h, w + 2 * i, i);
        else if (follows)
            accelerate_one(s, t, h, w + 2 * i, i);
        else
            for (int64_t k = 2 * i; k < 2 * i + 2; k++)
                s->a[k] = alone(t, h, w[k].Y - w[k].check, w[k].creep_damping, s->y[k], s->v[k]);
}

void sideways_move(struct sideways *s, double h)
{
    for (int64_t k = 0; k < 3 * s->wheelsets; k++) {
        s->v[k] += h * s->a[k];
        s->y[k] += h * s->v[k];
    }
}
