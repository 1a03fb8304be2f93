/* How fast the surface of a rail falls along the track. */
#ifndef VX_PROFILE_FALL_H
#define VX_PROFILE_FALL_H

#include "tools/profile/outline.h"

/* fall[n] of o becomes (z at s + h - z at s - h)/2h at each of its y, from the outlines of the same body h (m) behind and ahead; one-sided
 * where only one of them reaches y, that of the nearest point where neither does, 0 where the body has no neighbour (n = 0). */
void fall_between(const struct outline *behind, const struct outline *ahead, double h, struct outline *o);

#endif
