/* The cubic Hermite polynomial: values and slopes at both ends of an interval. */
#ifndef VX_PROFILE_HERMITE_H
#define VX_PROFILE_HERMITE_H

struct hermite { double z, slope; };

/* Values z0, z1 and slopes d0, d1 (per unit of y) at the ends of an interval of length h, at t of 0..1. */
static inline struct hermite hermite_at(double z0, double d0, double z1, double d1, double h, double t)
{
    double s = 1 - t;

    return (struct hermite){
        .z = z0 * s * s * (1 + 2 * t) + z1 * t * t * (1 + 2 * s) + h * t * s * (d0 * s - d1 * t),
        .slope = 6 * t * s * ((z1 - z0) / h) + d0 * s * (1 - 3 * t) + d1 * t * (1 - 3 * s),
    };
}

#endif
