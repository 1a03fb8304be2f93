/* Forces of all couplings of a vehicle: springs, dampers, stops, rods, friction.
 *
 * x forward, y to the right, z down; displacements count from rest, in one straight frame common to the bodies. */
#ifndef VX_VEHICLE_COUPLINGS_H
#define VX_VEHICLE_COUPLINGS_H

#include "formats/veh.h"
#include "tools/vehicle/couplings_memory.h"

/* Adds to f[6 bodies] force N and moment N m on each body, about its displaced centre of gravity, of every coupling.
 * q, qd [6 bodies]: displacements m, rad from rest and their rates; x y z roll pitch yaw of each body.  The pitch of a wheelset is
 * its spin, which its bearings hide from the couplings: they neither see nor drive it.  m->now is set, and nothing else: the forces of
 * one step may be asked for as often as needed.  Without memory, m NULL, they are those of one move from rest. */
void couplings_force(const struct veh *v, struct couplings_memory *m, const double *q, const double *qd, double *f);

/* Force N of stop c, odd, at deflection e m along its axis. */
double couplings_stop(const struct veh *v, int64_t c, double e);

#endif
