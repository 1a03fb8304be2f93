/* Steady rolling of an elliptic contact by Kalker's exact theory: an elastic half-space, Coulomb's law in every element.
 *
 * Lengths over c = sqrt(a b), stresses over mu N/c^2: creepages come as xi G c^2/(mu N), eta G c^2/(mu N), phi G c^3/(mu N), forces go as
 * Fx, Fy over mu N and Mz over mu N c.  Axes and signs as in creep/fastsim.h. */
#ifndef VX_CREEP_EXACT_H
#define VX_CREEP_EXACT_H

enum { EXACT_MOST = 48 };

/* One ratio of the semi-axes, set by exact_begin; the tractions are where the next solution starts. */
struct exact {
    int m;                  /* elements across the ellipse, each way */
    double step, width;     /* of an element, along x and y */
    double *bound;          /* [m][m] mu p, 0 outside the ellipse; row by row along x */
    double *px, *py;        /* [m][m] traction on the rail */
    double *ux, *uy;        /* [m][m+1] shift of the surfaces, one column ahead of the ellipse too */
    double *wasx, *wasy;    /* [m][m+1] the same one step ago */
    double *axx, *axy, *ayy;/* [2m-1][2m] shift i, j elements ahead and aside of one of unit traction */
    void *store;
};

/* NULL or the reason why not.  Semi-axes' ratio a/b, Poisson's ratio nu; 2 <= m <= EXACT_MOST. */
const char *exact_begin(struct exact *e, int m, double ratio, double nu);
void exact_free(struct exact *e);

/* Tractions as exact_begin leaves them, none. */
void exact_clear(struct exact *e);

/* force[3] of creep[3].  Returns the steps taken, or 0 where they did not suffice. */
int exact_force(struct exact *e, const double creep[3], double force[3]);

#endif
