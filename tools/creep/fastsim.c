/* FASTSIM on strips, the strips in the lanes of vectors.
 *
 * In a strip the traction p of the wheel on the rail starts at zero at the leading edge and grows by the rigid slip
 *
 *   w = (xi - phi y, eta + phi x)   over its flexibility,   -dp/dx = (xi/L1 - phi y/L3, eta/L2 + phi x/L3),
 *
 * cut back to the bound g ~ (1 - x^2/a^2 - y^2/b^2)^e along its own direction.  e = 1 is the parabola of the simplified theory, 1/2 the pressure
 * of Hertz; 3/4 lies nearest to the exact theory on every grid.  p is taken at the centres of
 * the cells, the slip midway between them, so both the growth and the sums are of second order where nothing slides; the bound is
 * scaled to sum to mu N on the grid, so a sliding contact carries mu N on every grid.
 *
 * Sums over steps stay in their lane and sums over strips are made in order: every clone gives the same bits. */
#include "tools/creep/fastsim.h"

#include <assert.h>
#include <math.h>

#include "tools/contact/clones.h"
#include "tools/creep/flexibility.h"
#include "tools/creep/kalker.h"

enum { VECTOR = 8 };            /* doubles in the widest */
#define EXPONENT 0.75           /* of the bound */

void fastsim_begin(struct fastsim *f, int n)
{
    fastsim_begin_bound(f, n, EXPONENT);
}

void fastsim_begin_bound(struct fastsim *f, int n, double exponent)
{
    double sum = 0, row = 0;

    assert(1 <= n && n <= FASTSIM_MOST);
    f->n = n;
    f->lanes = (n + VECTOR - 1)/VECTOR*VECTOR;
    for (int j = 0; j < f->lanes; j++) {
        f->y[j] = ((j < n ? 2*j : 2*n - 2) + 1.0)/n - 1;
        f->s[j] = sqrt(1 - f->y[j]*f->y[j]);
        f->across[j] = pow(f->s[j], 2*exponent);
        if (j < n)
            sum += f->s[j]*f->across[j];
    }
    for (int i = 0; i < n; i++) {
        f->step[i] = i ? 1 : 0.5;
        f->from[i] = i ? 1 - 2.0*i/n : 1 - 0.5/n;
        f->at[i] = 1 - (2*i + 1.0)/n;
        f->along[i] = pow(1 - f->at[i]*f->at[i], exponent);
        row += f->along[i];
    }
    f->peak = n*n/(4*sum*row);  /* sum of across along over cells (2 s a/n)(2 b/n) */
}

/* Marches all strips from their leading edge; returns the sums over their cells of px, py and at py.
 * Per strip: ux, uy growth of px, py over a cell, vy growth of py over a cell times x/half length, g bound at its middle. */
CLONES
static void strips_march(const struct fastsim *restrict f, const double *restrict ux, const double *restrict uy,
                         const double *restrict vy, const double *restrict g, double *restrict px, double *restrict py,
                         double *restrict sx, double *restrict sy, double *restrict sm)
{
    const int n = f->n, lanes = f->lanes;
    for (int i = 0; i < n; i++) {
        double step = f->step[i], from = f->from[i], at = f->at[i], bound = f->along[i];
        for (int j = 0; j < lanes; j++) {
            double qx = px[j] + step*ux[j];
            double qy = py[j] + step*(uy[j] + from*vy[j]);
            double most = bound*g[j], q = sqrt(qx*qx + qy*qy);
            double cut = most/(q > most ? q : most);   /* a minimum with 1 would not be vectorised */
            px[j] = cut*qx;
            py[j] = cut*qy;
            sx[j] += px[j];
            sy[j] += py[j];
            sm[j] += at*py[j];
        }
    }
}

void fastsim(const struct fastsim *f, double a, double b, double N, double mu, double G, double nu, double xi, double eta,
             double phi, double force[3])
{
    double ux[FASTSIM_MOST], uy[FASTSIM_MOST], vy[FASTSIM_MOST], g[FASTSIM_MOST];
    double px[FASTSIM_MOST], py[FASTSIM_MOST], sx[FASTSIM_MOST], sy[FASTSIM_MOST], sm[FASTSIM_MOST];
    double C[KALKER_COEFFICIENTS], L[FLEXIBILITIES];

    force[0] = force[1] = force[2] = 0;
    if (!(a > 0 && b > 0 && N > 0 && mu > 0))
        return;
    kalker(a/b, nu, C);
    flexibility(a, b, N, mu, G, C, xi, eta, phi, L);

    double x1 = xi/L[FLEXIBILITY_XI], y1 = eta/L[FLEXIBILITY_ETA], r1 = phi/L[FLEXIBILITY_PHI];
    double top = f->peak*mu*N/(a*b), cell = 2*a/f->n;
    for (int j = 0; j < f->lanes; j++) {
        double s = f->s[j];
        ux[j] = cell*s*(x1 - r1*b*f->y[j]);
        uy[j] = cell*s*y1;
        vy[j] = cell*s*s*a*r1;
        g[j] = top*f->across[j];
        px[j] = py[j] = sx[j] = sy[j] = sm[j] = 0;
    }
    strips_march(f, ux, uy, vy, g, px, py, sx, sy, sm);

    double width = cell*2*b/f->n;       /* times s: the area of a cell */
    for (int j = 0; j < f->n; j++) {
        double area = width*f->s[j];
        force[0] += area*sx[j];
        force[1] += area*sy[j];
        force[2] += area*(a*f->s[j]*sm[j] - b*f->y[j]*sx[j]);
    }
}
