/* The exact theory in elements of constant traction.
 *
 * Traction p on the rail and its opposite on the wheel shift the two surfaces against each other by u = A p, of Boussinesq and Cerruti,
 *
 *   A = 1/(pi G) int [(1 - nu)/r + nu x^2/r^3, nu x y/r^3; nu x y/r^3, (1 - nu)/r + nu y^2/r^3] dx dy,
 *
 * in closed form over a rectangle.  Matter runs towards -x, so over one element the slip is
 *
 *   s = (xi - phi y, eta + phi x) + (u(x + step) - u(x))/step,    |p| <= mu p_n,   s = 0 or p = mu p_n s/|s|.
 *
 * Elements are solved in turn from the leading edge, each with the others held, until none moves: Vollebregt, A Gauss-Seidel type solver
 * for special convex programs, with application to frictional contact mechanics, J. Optim. Theory Appl. 87 (1995).  The pressure is that
 * of Hertz, made to sum to N. */
#include "tools/creep/exact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/contact/clones.h"

enum { STEPS_MOST = 500, SWEEPS_MOST = 20, SECULAR_MOST = 50 };
#define TOLERANCE 1e-5      /* what no traction moves by in a step when done; the mean bound is 1/pi */
#define LAG 0.125           /* elements that slip is taken ahead and traction behind the middle: C23 is right within 2 per cent then */
#define SETTLED 0.3         /* sweeps go on until traction moves by this share of what it moved first in the step */

/* Integrals of x^2/r^3, x y/r^3, y^2/r^3 over the rectangle from the origin to x, y, up to terms that cancel in differences. */
static void corner(double x, double y, double sign, double I[3])
{
    double r = hypot(x, y);

    I[0] += sign*y*log(x + r);
    I[1] -= sign*r;
    I[2] += sign*x*log(y + r);
}

/* A[3], xx, xy, yy, of the shift at x, y from the middle of an element under unit traction. */
static void influence(double x, double y, double step, double width, double nu, double A[3])
{
    double I[3] = {0};

    corner(x + step/2, y + width/2, 1, I);
    corner(x - step/2, y + width/2, -1, I);
    corner(x + step/2, y - width/2, -1, I);
    corner(x - step/2, y - width/2, 1, I);
    A[0] = (I[0] + (1 - nu)*I[2])/M_PI;
    A[1] = nu*I[1]/M_PI;
    A[2] = ((1 - nu)*I[0] + I[2])/M_PI;
}

static void fill_influence(struct exact *e, double nu)
{
    const int m = e->m, w = 2*m;

    for (int j = 0; j < 2*m - 1; j++)
        for (int i = 0; i < w; i++) {
            double A[3];
            influence((i - m + 1)*e->step, (j - m + 1)*e->width, e->step, e->width, nu, A);
            e->axx[j*w + i] = A[0];
            e->axy[j*w + i] = A[1];
            e->ayy[j*w + i] = A[2];
        }
}

/* Place of element i of m over the semi-axis. */
static double place(int i, int m)
{
    return (2*i + 1.0)/m - 1;
}

/* The elements whose middle lies within the ellipse, of a size that gives them its area. */
static void fill_bound(struct exact *e, double ratio)
{
    double sum = 0;
    int inside = 0;

    for (int k = 0; k < e->m*e->m; k++) {
        double x = place(k % e->m, e->m), y = place(k/e->m, e->m);
        e->bound[k] = sqrt(fmax(0, 1 - x*x - y*y));
        sum += e->bound[k];
        inside += e->bound[k] > 0;
    }
    e->step = sqrt(M_PI*ratio/inside);
    e->width = sqrt(M_PI/ratio/inside);
    for (int k = 0; k < e->m*e->m; k++)
        e->bound[k] /= sum*e->step*e->width;
}

const char *exact_begin(struct exact *e, int m, double ratio, double nu)
{
    const size_t n = (size_t)m*(size_t)m, u = n + (size_t)m, w = (size_t)(2*m - 1)*(size_t)(2*m);

    *e = (struct exact){.m = m, .store = calloc(3*n + 4*u + 3*w, sizeof(double))};
    if (!(e->bound = e->store))
        return REASON_MEMORY;
    e->px = e->bound + n;
    e->py = e->px + n;
    e->ux = e->py + n;
    e->uy = e->ux + u;
    e->wasx = e->uy + u;
    e->wasy = e->wasx + u;
    e->axx = e->wasy + u;
    e->axy = e->axx + w;
    e->ayy = e->axy + w;
    fill_bound(e, ratio);
    fill_influence(e, nu);
    return NULL;
}

void exact_free(struct exact *e)
{
    free(e->store);
    *e = (struct exact){0};
}

/* u += A d of traction d = (dx, dy) more on element k. */
CLONES static void spread(int m, int k, double dx, double dy, const double *restrict axx, const double *restrict axy,
                          const double *restrict ayy, double *restrict ux, double *restrict uy)
{
    for (int j = 0; j < m; j++) {
        int from = (j - k/m + m - 1)*2*m + m - 1 - k % m;
        for (int i = 0; i <= m; i++) {
            ux[j*(m + 1) + i] += axx[from + i]*dx + axy[from + i]*dy;
            uy[j*(m + 1) + i] += axy[from + i]*dx + ayy[from + i]*dy;
        }
    }
}

/* p of s - diag(bx, by) p = lambda p with the smallest lambda >= 0 for which |p| <= g: 1/|p| is nearly straight over lambda. */
static void coulomb(double sx, double sy, double bx, double by, double g, double p[2])
{
    double lambda = 0;

    for (int i = 0; i < SECULAR_MOST; i++) {
        p[0] = sx/(bx + lambda);
        p[1] = sy/(by + lambda);
        double square = p[0]*p[0] + p[1]*p[1], size = sqrt(square);
        if (size <= g*(1 + 1e-12))
            return;
        lambda += (size/g - 1)*square/(p[0]*p[0]/(bx + lambda) + p[1]*p[1]/(by + lambda));
    }
}

/* One turn over all elements; the largest move of a traction. */
static double sweep(struct exact *e, const double creep[3])
{
    const int m = e->m, own = (m - 1)*2*m + m - 1;
    const double ax = e->axx[own], ay = e->ayy[own];
    double most = 0;

    for (int k = m*m - 1; k >= 0; k--) {
        double x = (k % m - 0.5*(m - 1) + LAG)*e->step, y = (k/m - 0.5*(m - 1))*e->width, p[2];
        int at = k + k/m;
        if (e->bound[k] <= 0)
            continue;
        coulomb((creep[0] - creep[2]*y)*e->step + e->wasx[at + 1] - e->ux[at] + ax*e->px[k],
                (creep[1] + creep[2]*x)*e->step + e->wasy[at + 1] - e->uy[at] + ay*e->py[k], ax, ay, e->bound[k], p);
        double dx = p[0] - e->px[k], dy = p[1] - e->py[k], move = fmax(fabs(dx), fabs(dy));
        if (move < 0.1*TOLERANCE)
            continue;
        e->px[k] = p[0];
        e->py[k] = p[1];
        spread(m, k, dx, dy, e->axx, e->axy, e->ayy, e->ux, e->uy);
        most = fmax(most, move);
    }
    return most;
}

void exact_clear(struct exact *e)
{
    const size_t m = (size_t)e->m;

    memset(e->px, 0, 2*m*m*sizeof *e->px);          /* py follows, */
    memset(e->ux, 0, 2*m*(m + 1)*sizeof *e->ux);    /* uy follows */
}

int exact_force(struct exact *e, const double creep[3], double force[3])
{
    const int m = e->m;
    const size_t size = (size_t)m*(size_t)(m + 1)*sizeof *e->ux;
    int steps = 0;
    double move = 1;

    while (move > TOLERANCE && ++steps < STEPS_MOST) {
        memcpy(e->wasx, e->ux, size);
        memcpy(e->wasy, e->uy, size);
        move = sweep(e, creep);
        for (int i = 1; i < SWEEPS_MOST && sweep(e, creep) > SETTLED*move; i++)
            ;
    }
    force[0] = force[1] = force[2] = 0;
    for (int k = 0; k < m*m; k++) {
        double x = (k % m - 0.5*(m - 1) - LAG)*e->step, y = (k/m - 0.5*(m - 1))*e->width, area = e->step*e->width;
        force[0] += area*e->px[k];
        force[1] += area*e->py[k];
        force[2] += area*(x*e->py[k] - y*e->px[k]);
    }
    return steps < STEPS_MOST ? steps : 0;
}
