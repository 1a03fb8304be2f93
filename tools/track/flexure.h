/* The beam element by its flexibility: any bending stiffness along it, and shear.  What beam.h says, for its callers. */
#ifndef VX_TRACK_FLEXURE_H
#define VX_TRACK_FLEXURE_H

#include "tools/track/beam.h"

void flexure_stiffness(const struct beam *b, double K[4][4]);
void flexure_mass(const struct beam *b, double M[4][4]);
void flexure_shape(const struct beam *b, double a, double N[4]);
void flexure_slope(const struct beam *b, double a, double D[4]);
double flexure_between(const struct beam *b, double x, double a);

#endif
