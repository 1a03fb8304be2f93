/* A track that follows the train: a copy of a moving mass under each wheelset.
 *
 * Copies share nothing and have no history of the way: the copy under wheelset i is node and sleeper i of the track made here, whose number is that of
 * the wheelset.  Their rails have the running mass; 0 leaves pad and contact in series. */
#ifndef VX_INTEGRATE_FOLLOW_H
#define VX_INTEGRATE_FOLLOW_H

#include "formats/trk.h"
#include "formats/veh.h"
#include "tools/integrate/wheel_place.h"

/* Whether a track is the one node of a moving mass. */
static inline int follow_is(const struct trk *one)
{
    return one->nodes == 1;
}

/* Two copies at least, so that a single wheelset leaves one idle.  What does not move, curves and the check rail, stays that of `one`, which must outlive
 * t; trk_free takes t. */
const char *follow_train(struct trk *t, const struct trk *one, const struct veh *v);

/* Under wheelset i of n copies. */
struct wheel_place follow_find(int64_t n, int64_t i);

#endif
