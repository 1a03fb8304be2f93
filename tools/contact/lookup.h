/* The contacts of one wheel at any station, yaw, displacement and roll, from its table: for the time step, without allocation.
 *
 * x forward, y to the right, z down; right-handed angles, the same on both sides.  u = axle's y - roll r0 - rail's y. */
#ifndef VX_CONTACT_LOOKUP_H
#define VX_CONTACT_LOOKUP_H

#include "formats/ctab.h"

enum { CONTACT_MAX = 16 };

struct contact {
    double weight;           /* 1, share of the table's corners that hold this contact: multiplies its normal force */
    double height;           /* m, z of the running circle's lowest point, from the rail's origin, when it touches */
    double height_u;         /* 1, derivative of height by u */
    double height_s;         /* 1, by station */
    double height_yaw;       /* m/rad, by yaw, the wheelset's station held */
    double height_roll;      /* m/rad, by roll at fixed u */
    double row[CTAB_ALL];    /* as the table's columns, at the query; those of the rest by contact_complete */
    int64_t at[CTAB_CORNERS];        /* the table's rows it is between */
    double share[CTAB_CORNERS];      /* 1, of each of them; their sum is 1 */
};

/* Contacts at station s (m, constant beyond the table), yaw (rad, held within the table), u (m), roll (rad) into c[CONTACT_MAX], the
 * first to touch first.  Returns how many, or -1 where u is beyond the table. */
int contact_lookup(const struct ctab *t, double s, double yaw, double u, double roll, struct contact *c);

/* The table of the other side in a track turned half way round about z, x' = -x and y' = -y: what contact_lookup finds in it is turned likewise.  t must
 * outlive it; it owns nothing. */
struct ctab contact_turn(const struct ctab *t);

/* The columns that a time step does not need. */
void contact_complete(const struct ctab *t, struct contact *c);

#endif
