/* Forces between one wheel and its rail, at one instant.
 *
 * Track axes: x forward, y to the right, z down.  Q, Y, T are forces of the wheel on the rail; force and moment are those on the
 * wheelset, about its centre. */
#ifndef VX_INTEGRATE_WHEEL_H
#define VX_INTEGRATE_WHEEL_H

#include "formats/creep.h"
#include "formats/ctab.h"
#include "formats/run.h"
#include "tools/contact/lookup.h"
#include "tools/creep/fastsim.h"
#include "tools/creep/friction.h"

enum wheel_normal { WHEEL_HERTZ, WHEEL_LINEAR };

/* What is the same for all wheels and steps. */
struct wheel_law {
    enum wheel_normal normal;
    double stiffness, damping;   /* N/m, N s/m along the normal: WHEEL_LINEAR, a spring in series condensed */
    double hertz_damping;        /* s/m, N = C d^1.5 (1 + hertz_damping d'): 0 is plain Hertz */
    double friction;             /* 1 */
    struct friction varied;      /* and how it varies by place and slip */
    double step;                 /* s */
    struct fastsim grid;
    const struct creep *creep;   /* its table instead of FASTSIM, or NULL */
};

/* Where wheelset and rail are. */
struct wheel_input {
    const struct ctab *table;
    double s, v;                 /* m, m/s station and speed */
    double curvature;            /* 1/m of the track there */
    double y, z, roll, yaw;      /* m, rad of the wheelset in its track-following frame */
    double vy, vz, vroll, vyaw;  /* their rates */
    double spin;                 /* rad/s about the axle, about -v/r0 */
    double radius;               /* m, r0 */
    double rail_y, rail_vy;      /* m, m/s of the rail's running surface to the right, and its rate */
    double rail_turn;            /* 1 slope of that along s, of a spatial rail */
    double rail_roll, rail_vroll; /* rad, rad/s of a spatial rail about its axis, under the running circle; the rate under the wheel */
    double check_y, check_vy;    /* m, m/s of a check rail that is a beam, to the right, without its force; the rate beside the wheel */
    double check_give, check_quick; /* m/N, m/(N s) what its force gives, and the rate of that */
    double rail_z;               /* m deflection of the rail, from its nodes */
    double rail_v;               /* m/s velocity of the rail's material */
    double rail_slope;           /* 1 dw/dx */
    double compliance;           /* m/N of the rail below rail_z, in series with the contact: of the loaded element, and what a step gives */
    double past, time;           /* m, s: a deflection d there has the rate (d - past)/time */
    double dip, dip_slope;       /* m, 1 irregularity: how far the rail's top lies below its place, and the slope of that along s */
    double line, line_slope;     /* m, 1 irregularity: how far the rail lies to the right of its place, and the slope of that */
};

/* Carried from step to step. */
struct wheel_memory {
    double local, before;        /* m deflection of the rail element under the wheel, between its nodes; a step before that */
    double creep_z;              /* N vertical part of the creep force, a step old while the normal force is sought */
    double Q, Q_before;          /* N on the rail a step ago, and the step before that */
    double dip, line;            /* m of the rail's irregularity there */
    double Y, Y_before;          /* N, N m on a spatial rail, likewise: struct head_force */
    double M, M_before;
    double check;                /* N on a check rail that is a beam, a step ago */
};

struct wheel_patch {
    double N, tx, ty;            /* N normal force, creep force along x and along the contact plane */
    double xi, eta, phi;         /* 1, 1, 1/m */
    double rail_y, wheel_y, x;   /* m, lateral in the profile axes of rail and wheel; ahead of the wheelset's centre */
    double angle;                /* rad, contact angle */
    double body;                 /* number of the rail body, from 0 */
};

struct wheel_output {
    double Q, Y, T;              /* N on the rail */
    double Mx;                   /* N m of Q and Y about the track axis at rail level */
    double check;                /* N of the flange's back on the check rail, part of Y: set by check_rail_add */
    double force[3], moment[3];  /* N, N m on the wheelset: x y z, about x, about the axle, about z */
    double rail_z;               /* m deflection of the rail under the wheel */
    double creep_damping;        /* N s/m, -dY/d(rail's velocity) of small creepages: its largest value */
    int patches;                 /* with N > 0, the most loaded first */
    struct wheel_patch patch[RUN_CONTACTS];
};

/* Sets stiffness and damping of the linear law: a spring (N/m) and damper (N s/m) from the wheel to a massless point, in series with a spring
 * from there to the rail.  Condensed: k = k1 k2/(k1 + k2) and, at the low frequencies it passes, c = c1 (k2/(k1 + k2))^2. */
void wheel_condense(struct wheel_law *law, double stiffness, double damping, double series);

/* Where a wheel may touch, and how hard it does. */
struct wheel_approach {
    int n;
    struct contact c[CONTACT_MAX];
    double cosg[CONTACT_MAX], sing[CONTACT_MAX]; /* 1 cosine and sine of the contact angle */
    double reach[CONTACT_MAX];   /* m how far the wheel stands below first touch, d not counted */
    double rate[CONTACT_MAX];    /* m/s */
    double N[CONTACT_MAX];       /* N of the whole contact; its share is weight N */
    double d;                    /* m deflection of what is in series with the contact */
};

/* The contacts of the wheel, in three stages.  First by the table; fails where the wheel leaves it. */
const char *wheel_meet(const struct wheel_input *in, struct wheel_approach *a);

/* Normal forces, with d sought from a->d on; rail_z, rail_v and rail_slope may have changed since.  Returns Q. */
double wheel_press(const struct wheel_law *law, const struct wheel_input *in, const struct wheel_memory *memory, struct wheel_approach *a);

/* Creep forces, and all of out; memory->creep_z follows.  A wheel off its rail has no force and no patch. */
void wheel_roll(const struct wheel_law *law, const struct wheel_input *in, const struct wheel_approach *a, struct wheel_memory *memory,
                struct wheel_output *out);

/* The three together, with a backward difference over law->step for the rate of d; memory->local follows. */
const char *wheel_force(const struct wheel_law *law, const struct wheel_input *in, struct wheel_memory *memory,
                        struct wheel_output *out);

#endif
