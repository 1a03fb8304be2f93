/* Pseudo-transient continuation (Kelley and Keyes 1998, SIAM J. Numer. Anal. 35, 508): every unknown moves as a dashpot under what is not
 * balanced,  x' = r(x),  by implicit steps (1/dt - J) dx = r,  dt growing as r falls: a relaxation at first, Newton's method at last. */
#include "tools/integrate/steady.h"
#include "formats/reason.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { ITERATIONS_MOST = 300, SHORTER_MOST = 12 };
#define TOLERANCE 1e-8        /* of a wheel load: 1e-3 N, N m */
#define MOVE_MOST 0.5         /* scales a step */
#define BODY_SHARE 0.1        /* of that move counts for a body on springs */
#define FASTER 1.5            /* growth of the time step while the residual falls, at least */
#define SLOWER 0.3            /* and where it rises */
#define TIME_MOST 1e10

static double norm(int64_t n, const double *r)
{
    double sum = 0;

    for (int64_t j = 0; j < n; j++)
        sum += r[j] * r[j];
    return sqrt(sum);
}

/* An unknown that stays. */
static void hold(struct steady *s, int64_t j)
{
    for (int64_t k = 0; k < s->n; k++)
        s->J[k * s->n + j] = k == j ? -1 : 0;
}

/* (1/time - J) move = r, drawn back to MOVE_MOST; 0 where it has no solution. */
static int find_move(struct steady *s, double time)
{
    const lapack_int n = (lapack_int)s->n;
    double most = 0;

    for (int64_t k = 0; k < s->n * s->n; k++)
        s->A[k] = -s->J[k];
    for (int64_t j = 0; j < s->n; j++)
        s->A[j * s->n + j] += 1 / time;
    memcpy(s->move, s->r, (size_t)s->n * sizeof *s->move);
    if (LAPACKE_dgesv(LAPACK_ROW_MAJOR, n, 1, s->A, n, s->pivot, s->move, 1) != 0)
        return 0;
    for (int64_t j = 0; j < s->n; j++)
        most = fmax(most, fabs(s->move[j]) * (s->unknown[j].wheelset < 0 ? BODY_SHARE : 1));
    for (int64_t j = 0; j < s->n && most > MOVE_MOST; j++)
        s->move[j] *= MOVE_MOST / most;
    return isfinite(most);
}

/* One accepted step, shorter where a wheel would leave its table; s->r follows. */
static const char *step(struct steady *s, double *time)
{
    const char *why = NULL;

    for (int64_t j = 0; j < s->n; j++)
        s->old[j] = *s->unknown[j].x;
    for (int k = 0; k < SHORTER_MOST; k++) {
        const int found = find_move(s, *time);
        for (int64_t j = 0; j < s->n && found; j++)
            *s->unknown[j].x = s->old[j] + s->move[j] * s->unknown[j].scale;
        why = found ? steady_residual(s, s->next) : "its equations have no solution";
        if (!why)
            break;
        *time *= 0.1;
    }
    if (!why)
        memcpy(s->r, s->next, (size_t)s->n * sizeof *s->r);
    return why;
}

/* Which body, and how, is least balanced. */
static const char *say(const struct steady *s, const char *more)
{
    static const char *const name[] = {"forward", "sideways", "down", "in roll", "in pitch", "in yaw"};
    int64_t worst = 0;

    for (int64_t j = 0; j < s->n; j++)
        if (s->unknown[j].body >= 0 && !(fabs(s->r[j]) <= fabs(s->r[worst])))
            worst = j;
    const struct steady_unknown *u = &s->unknown[worst];
    return reason("no quasi-static equilibrium found: %s is still pushed %s by %.3g %s%s%s", s->p->vehicle->body_name[u->body], name[u->dof],
                  s->r[worst] * s->load, u->dof < VEH_ROLL ? "N" : "N m", more ? ": " : "", more ? more : "");
}

/* The columns of all unknowns, or of bodies on springs alone: the others then stay. */
static const char *differ_all(struct steady *s)
{
    const char *why = NULL;

    for (int64_t j = 0; j < s->n && !why; j++)
        if (!s->held || s->unknown[j].wheelset < 0)
            why = steady_differ(s, j);
        else
            hold(s, j);
    return why;
}

static const char *relax(struct steady *s, int held)
{
    double time = 1, size, first;
    const char *why;

    s->held = held;
    why = steady_residual(s, s->r);
    size = first = norm(s->n, s->r);
    for (int k = 0; k < ITERATIONS_MOST && size > TOLERANCE && !why; k++) {
        if ((why = differ_all(s)) || (why = step(s, &time)))
            break;
        const double now = norm(s->n, s->r);
        time = now < size ? fmin(time * fmax(size / now, FASTER), TIME_MOST) : fmax(SLOWER * time, first / now);
        size = now;
    }
    return size <= TOLERANCE && !why ? NULL : say(s, why);
}

/* Bodies first come to rest on their wheelsets. */
const char *steady_find(struct steady *s)
{
    const char *why = relax(s, 1);

    return why ? why : relax(s, 0);
}
