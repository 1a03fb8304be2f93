/* Creep force of an elliptic contact from a table, creep(5).  Axes, signs and arguments as in creep/fastsim.h. */
#ifndef VX_CREEP_TABLE_H
#define VX_CREEP_TABLE_H

#include "formats/creep.h"

/* force[3]: Fx, Fy N and Mz N m of the wheel on the rail, |F| <= mu N.  A contact more slender than the table has the shape of its edge,
 * with its own coefficients of the linear theory. */
void creep_table(const struct creep *t, double a, double b, double N, double mu, double G, double nu, double xi, double eta, double phi,
                 double force[3]);

/* Scale of the spin's axis by coefficients C[4], where b is `shorter` times sqrt(a b): C23, and across a wide contact its slip along x. */
double creep_spin(const double C[4], double shorter);

/* The part of the forces that is not tabulated, before it falls with size: linear[3] of x, y, s. */
void creep_linear(const double C[4], double x, double y, double s, double linear[3]);

#endif
