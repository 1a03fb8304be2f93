/* .run: the history of one passage: run(5).
 *
 * Track axes: x forward, y to the right, z down.  Q, Y and T are the forces of the wheel on the rail: vertical, lateral and
 * longitudinal.  Sides are 0 left, 1 right.  Series are sampled; the tail holds extremes over every step. */
#ifndef VX_FORMATS_RUN_H
#define VX_FORMATS_RUN_H

#include "formats/vxf.h"

enum { RUN_CONTACTS = 3 };             /* contacts recorded per wheel, the most loaded first */

/* What a prescribed force acts on, and whose motion is recorded. */
enum run_on { RUN_ON_LEFT, RUN_ON_RIGHT, RUN_ON_BOTH, RUN_ON_SLEEPER };

/* Groups of series, chosen by the case. */
enum run_group { RUN_WHEELS, RUN_BODIES, RUN_PADS, RUN_BALLAST, RUN_SLEEPERS, RUN_RAILS, RUN_GROUPS };
extern const char *const run_group_name[RUN_GROUPS + 1];

/* Every series of a run: its group, name, unit, element type and shape.  Dims are named by what they count. */
enum run_dim { RUN_END, RUN_PER_WHEELSET, RUN_PER_SIDE, RUN_PER_CONTACT, RUN_PER_BODY, RUN_PER_DOF, RUN_PER_SLEEPER,
               RUN_PER_NODE, RUN_PER_BALLAST, RUN_PER_FORCE, RUN_PER_PROBE };
enum run_channel {
    RUN_TIME, RUN_STATION,
    RUN_Q, RUN_Y, RUN_T, RUN_CHECK, RUN_MX, RUN_RAIL_Y, RUN_RAIL_Z,
    RUN_N, RUN_CONTACT_Y, RUN_CONTACT_WHEEL_Y, RUN_CONTACT_X, RUN_ANGLE, RUN_XI, RUN_ETA, RUN_PHI, RUN_TX, RUN_TY, RUN_BODY,
    RUN_BODY_Q, RUN_BODY_V, RUN_BODY_A, RUN_BODY_OFFSET, RUN_BODY_HEADING,
    RUN_PAD, RUN_BALLAST_F,
    RUN_SLEEPER_Z, RUN_SLEEPER_ROLL, RUN_SLEEPER_A,
    RUN_NODE_Z, RUN_NODE_A, RUN_NODE_M,
    RUN_FORCE, RUN_PROBE,
    RUN_CHANNELS
};
struct run_channel_info {
    const char *name, *unit;
    enum run_group group;              /* RUN_GROUPS: always there */
    enum vxf_type type;                /* VXF_F64 or VXF_F32 */
    enum run_dim dim[4];               /* up to RUN_END */
    const char *meaning;
};
extern const struct run_channel_info run_channels[RUN_CHANNELS];

/* Tail arrays: extremes over every step of the run. */
enum run_extreme { RUN_MAX_Q, RUN_MIN_Q, RUN_MAX_Y, RUN_AT_MAX_Q, RUN_SLEEPER_MAX_Q, RUN_SLEEPER_MAX_Y, RUN_MAX_PAD,
                   RUN_MAX_PAD_COMPRESSION, RUN_MAX_BALLAST, RUN_MAX_SLEEPER_A, RUN_MAX_NODE_M, RUN_EXTREMES };
extern const struct run_channel_info run_extremes[RUN_EXTREMES];

struct run {
    char name[64];
    char route[16];                    /* through or diverging */
    char direction[16];                /* facing or trailing */
    char filter[128];                  /* of the samples: none, or what it is */
    double speed;                      /* m/s */
    double step;                       /* s */
    double friction;                   /* 1 */
    double gravity;                    /* m/s2 */
    double rail_spacing;               /* m */
    int complete;
    int64_t records, wheelsets, bodies, sleepers, nodes, zones, curves;
    int64_t forces, probes;            /* a prescribed force or none, and places whose motion is kept */
    const double *wheelset_x;          /* m [wheelsets] from the front one, so 0 first, then negative */
    const double *static_q;            /* N [wheelsets][2] wheel loads at rest */
    const double *radius;              /* m [wheelsets] */
    const int64_t *wheelset;           /* [wheelsets] body of each */
    const double *mass;                /* kg [bodies] */
    const double *inertia;             /* kg m2 [bodies][3] */
    const double *cg;                  /* m [bodies][3] at rest, x from the front wheelset, y, z = -height */
    const char (*body_name)[32];       /* [bodies] */
    const double *sleeper_x;           /* m [sleepers] station */
    const int64_t *sleeper_number;     /* [sleepers] 1 is the first of the turnout */
    const double *node_x;              /* m [nodes] */
    const char (*zone_name)[32];       /* [zones] */
    const int64_t *pad_zone;           /* [2][sleepers] from 1; 0 in none */
    const double *curve_x, *curvature; /* m, 1/m [curves] as in the track */
    const double *force_x;             /* m [forces] */
    const int64_t *force_on;           /* [forces] RUN_ON_LEFT, RUN_ON_RIGHT or RUN_ON_BOTH: each rail with the whole force */
    const double *probe_x;             /* m [probes] */
    const int64_t *probe_on;           /* [probes] RUN_ON_LEFT, RUN_ON_RIGHT or RUN_ON_SLEEPER */
    const double *probe_held;          /* m/N [probes] of the deflection over the force, what the element gives with held ends */
    const void *channel[RUN_CHANNELS]; /* [records][dims], double or float by run_channels; NULL where not recorded */
    const double *extreme[RUN_EXTREMES]; /* NULL in a run that is not complete */
};

/* Points into f, which must outlive r. */
const char *run_read(struct run *r, struct vxf *f);

/* Elements of one record of a channel or of a tail array with this many of everything. */
int64_t run_count(const struct run *r, const struct run_channel_info *c);

/* Keys and arrays of r, and the announcement of the channels recorded[c] != 0 and of all extremes. */
void run_put(const struct run *r, const int *recorded, struct vxf_out *o);

#endif
