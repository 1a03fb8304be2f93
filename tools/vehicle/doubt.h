/* What is possible but hardly meant: numbers of a vehicle that look like another unit, another order or another place. */
#ifndef VX_VEHICLE_DOUBT_H
#define VX_VEHICLE_DOUBT_H

#include "formats/veh.h"

enum { DOUBT_WORDS = 160 };

struct doubts {
    int64_t n, room;                     /* found; those beyond room are counted alone */
    char (*words)[DOUBT_WORDS];          /* [room] */
};

/* Adds what is doubtful in v: masses, inertias and wheel radii out of a railway's range, inertias of no body, a body that would bounce by itself
 * below 0.3 or above 200 Hz or whose box reaches below the rails, springs that pull at rest, are bent by more than 0.5 m or lie beyond their table,
 * stiffness and damping out of range or of each other's, couplings far from their bodies, wheel loads apart.
 * Where v was not brought to rest, its matrices and loads 0, what follows from these is left out. */
void doubt_find(const struct veh *v, struct doubts *d);

/* Hz, of body i alone, all others held; 0 where it has no stiffness along z. */
double doubt_bounce(const struct veh *v, int64_t i);

#endif
