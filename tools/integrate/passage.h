/* One passage: train and track moving together, step by step.
 *
 * A step moves the train (train.h) and the track (way.h), each by the scheme it has; then come all forces at the new positions and rates,
 * those between wheels and rails together with what they move (couple.h), and from them the accelerations of the bodies.
 * x forward, y to the right, z down; Q, Y, T are forces of the wheel on the rail. */
#ifndef VX_INTEGRATE_PASSAGE_H
#define VX_INTEGRATE_PASSAGE_H

#include "formats/case_text.h"
#include "tools/integrate/alignment.h"
#include "tools/integrate/couple.h"
#include "tools/integrate/energy.h"
#include "tools/integrate/excitation.h"
#include "tools/integrate/exciter.h"
#include "tools/integrate/follow.h"
#include "tools/integrate/run_in.h"
#include "tools/integrate/sideways.h"
#include "tools/integrate/train.h"
#include "tools/integrate/way.h"
#include "tools/integrate/wheel.h"

struct passage_options {
    double speed;                   /* m/s */
    double start, end;              /* m, stations of the front wheelset; trailing, times -1, so that end is beyond start */
    int trailing;                   /* the track is run with decreasing station: facing.h */
    double step;                    /* s */
    enum way_scheme scheme;         /* of the track */
    int implicit_train;             /* 1: average acceleration for the train too */
    int account;                    /* whether its energy and its run-in are accounted for */
    struct wheel_law law;
    struct excitation_options excitation;
    const struct exciter *exciter;  /* NULL, or a prescribed force on the track: it sets the number of steps */
};

struct passage {
    struct passage_options o;
    const struct trk *facing;       /* as it is described */
    const struct trk *track;        /* as the train runs on it: that, turned, or own where it follows the train */
    struct trk turned;              /* of a trailing passage */
    struct trk own;                 /* a moving mass under each wheelset */
    int follows;
    const struct veh *vehicle;
    const struct ctab *table[2];    /* left, right, as the train has them */
    struct ctab view[2];            /* of a trailing passage */
    struct alignment alignment;
    struct excitation excitation;
    struct way rails;
    struct train train;
    struct wheel_memory *memory;    /* [wheelsets][2] */
    struct energy energy;           /* of the track */
    struct run_in run_in;           /* of the front left wheel, where there is an account */
    struct couple *couple;          /* [wheelsets][2] */
    struct wheel_output *wheel;     /* [wheelsets][2] */
    struct sideways sideways;
    double limit;                   /* s, of a stable step */
    int64_t n, steps;               /* done, and in all */
    int64_t rounds;                 /* of forces and rails, in all steps */
    double time, station;           /* s, m of the front wheelset */
};

/* Checks that train, track, tables and options fit together, and the step against its limit.  All inputs must outlive p.  A vehicle without
 * bodies leaves the track to the exciter; it has no weight then, and needs no tables. */
const char *passage_new(struct passage *p, const struct passage_options *o, const struct trk *track, const struct veh *vehicle,
                        const struct ctab *left, const struct ctab *right);
void passage_free(struct passage *p);

/* Steps from start to end. */
int64_t passage_steps(const struct passage_options *o);

/* Accounts begin with the present state. */
void passage_account(struct passage *p);

/* Whether the train's accelerations are found with the forces of this step. */
static inline int passage_implies(const struct passage *p)
{
    return p->train.S && way_yields(&p->rails);
}

/* All forces and accelerations from the present positions and rates. */
const char *passage_forces(struct passage *p);

/* One step on; fails, with station and wheelset, where a wheel leaves its rail's table or motion is not finite. */
const char *passage_step(struct passage *p);

/* m, of wheelset i */
double passage_wheel_station(const struct passage *p, int64_t i);

/* Where wheel (i, side) stands. */
struct wheel_place passage_place(const struct passage *p, int64_t i, int side);

/* What wheel (i, side) meets at the present state, standing at `place` on its rail; the rail as it is there. */
void passage_wheel_input(const struct passage *p, int64_t i, int side, const struct wheel_place *place, struct way_rail *rail,
                         struct wheel_input *in);

#endif
