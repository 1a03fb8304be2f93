/* FASTSIM: creep force of an elliptic contact by the simplified theory (Kalker 1982) with blended flexibilities.
 *
 * Axes of the contact: x forward, y lateral along the contact plane, z normal into the rail.  Creepages are those of the wheel against the
 * rail, (wheel velocity - rail velocity)/v, the spin is about z; forces are those of the wheel on the rail, so they have the sign
 * of the creepages. */
#ifndef VX_CREEP_FASTSIM_H
#define VX_CREEP_FASTSIM_H

enum { FASTSIM_MOST = 256 };

/* The grid, set once: strips along x at y = b y[j], each n steps from its leading edge to its trailing edge.  Read only after. */
struct fastsim {
    int n;                      /* strips, and steps of a strip */
    int lanes;                  /* n rounded up to whole vectors; beyond n the last strip again, not summed */
    double peak;                /* bound at the centre of the grid so that all of it sums to mu N, times a b/(mu N) */
    double y[FASTSIM_MOST];     /* 1 [lanes] lateral position of the strips over b */
    double s[FASTSIM_MOST];     /* 1 [lanes] half length over a: sqrt(1 - y^2) */
    double across[FASTSIM_MOST];/* 1 [lanes] bound in the middle of the strips over that at the centre */
    double along[FASTSIM_MOST]; /* 1 [n] bound in the cells of a strip over that in its middle */
    double step[FASTSIM_MOST];  /* 1 [n] from the point before, over the length of a cell */
    double from[FASTSIM_MOST];  /* 1 [n] where that step sees the slip, over the half length */
    double at[FASTSIM_MOST];    /* 1 [n] centre of the cell over the half length, where the traction is bounded and summed */
};

/* 1 <= n <= FASTSIM_MOST; 10 is the choice of the time step. */
void fastsim_begin(struct fastsim *f, int n);

/* The same with a bound of another shape: 1 is the parabola of Kalker, 1/2 the ellipse. */
void fastsim_begin_bound(struct fastsim *f, int n, double exponent);

/* force[3]: Fx, Fy N and Mz N m of the wheel on the rail.  Semi-axes a (along x), b m, normal force N, friction mu, shear modulus G Pa,
 * Poisson's ratio nu, creepages xi, eta, spin phi 1/m.  No force without a, b, N and mu. */
void fastsim(const struct fastsim *f, double a, double b, double N, double mu, double G, double nu, double xi, double eta,
             double phi, double force[3]);

#endif
