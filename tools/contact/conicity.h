/* Equivalent conicity by Klingel's motion, after EN 15302. */
#ifndef VX_CONTACT_CONICITY_H
#define VX_CONTACT_CONICITY_H

#include <stdint.h>

struct conicity {
    double conicity;                 /* 1 */
    double wavelength;               /* m; 0 where there is none, the conicity then 0 */
    double middle;                   /* m, of the motion */
};

/* Rolling radius differences dr (m, right minus left) at displacements y (m) [n], increasing; amplitude (m), distance e of the
 * contact points (m), rolling radius r0 (m).  Refuses a motion that leaves the range of y. */
const char *conicity_klingel(const double *y, const double *dr, int64_t n, double amplitude, double e, double r0, struct conicity *c);

#endif
