/* Bodies of one kind (bogie1, bogie2) count together; the kind and the direction with the most kinetic energy x.Mx give the name.
 * Roll about a low pole is called lower sway, about a high one upper sway: above the centre of gravity y - z roll with z < 0, so
 * lateral motion and roll of one sign put the pole below. */
#include "tools/receptance/name.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double SWAY = 0.1;        /* least share of lateral motion and of roll in a sway */

static const char *const DIRECTION[VEH_DOFS] = {"longitudinal", "lateral", "bounce", "roll", "pitch", "yaw"};

/* Letters of the name that all bodies of a kind share: up to a digit, dash, underscore or space. */
static int kind_length(const char *body)
{
    return (int)strcspn(body, "0123456789-_ ");
}

static int same_kind(const char *a, const char *b)
{
    return kind_length(a) == kind_length(b) && strncmp(a, b, (size_t)kind_length(a)) == 0;
}

static double energy(const struct veh *v, const double *shape, int64_t dof)
{
    const int64_t n = VEH_DOFS * v->bodies;
    double Mx = 0;

    for (int64_t j = 0; j < n; j++)
        Mx += v->M[dof * n + j] * shape[j];
    return fmax(shape[dof] * Mx, 0);
}

/* part [6]: energy of all bodies of the kind of `body`, by direction; returns the sum. */
static double kind_energy(const struct veh *v, const double *shape, int64_t body, double part[VEH_DOFS])
{
    double sum = 0;

    for (int d = 0; d < VEH_DOFS; d++) {
        part[d] = 0;
        for (int64_t b = 0; b < v->bodies; b++)
            if (same_kind(v->body_name[b], v->body_name[body]))
                part[d] += energy(v, shape, VEH_DOFS * b + d);
        sum += part[d];
    }
    return sum;
}

/* Whether two bodies of a kind move with or against each other; nothing where it is one body. */
static const char *phase(const struct veh *v, const double *shape, int64_t body, int direction)
{
    for (int64_t b = body + 1; b < v->bodies; b++)
        if (same_kind(v->body_name[b], v->body_name[body])) {
            const double one = shape[VEH_DOFS * body + direction], other = shape[VEH_DOFS * b + direction];
            return one * other < 0 ? ", antiphase" : ", in phase";
        }
    return "";
}

void name_mode(const struct veh *v, const double *shape, char name[32])
{
    double part[VEH_DOFS], most = -1;
    int64_t body = 0;
    int way = 0;

    for (int64_t b = 0; b < v->bodies; b++) {
        double sum = kind_energy(v, shape, b, part);
        if (sum > most) {
            most = sum;
            body = b;
        }
    }
    kind_energy(v, shape, body, part);
    for (int d = 1; d < VEH_DOFS; d++)
        if (part[d] > part[way])
            way = d;
    const char *what = DIRECTION[way];
    const double *x = &shape[VEH_DOFS * body];
    if (part[VEH_Y] > SWAY * most && part[VEH_ROLL] > SWAY * most && (way == VEH_Y || way == VEH_ROLL))
        what = x[VEH_Y] * x[VEH_ROLL] > 0 ? "lower sway" : "upper sway";
    snprintf(name, 32, "%.*s %s%s", kind_length(v->body_name[body]) < 10 ? kind_length(v->body_name[body]) : 10, v->body_name[body], what,
             phase(v, shape, body, way));
}
