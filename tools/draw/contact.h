/* Figures of the contact of one wheel on its rails, from the profiles of both and the contact table made of them.
 *
 * Rail profile axes: y to the right, z down. */
#ifndef VX_DRAW_CONTACT_H
#define VX_DRAW_CONTACT_H

#include "formats/ctab.h"
#include "formats/prof.h"
#include "tools/draw/chart.h"

struct contact_place { double station, yaw, u; };    /* m, rad, m */

/* The wheel resting on the rail bodies, at the node of the table nearest to `at`, with its contact points and normals. */
const char *contact_chart(struct chart *c, const struct prof *wheel, const struct prof *rail, const struct ctab *t,
                          const struct contact_place *at);

/* Where the contacts are as the wheel moves: rail below, wheel raised above it, and for the displacements u of the table,
 * thinned to about `pairs`, a line from the point of the wheel to the point of the rail that touch. */
const char *contact_pairs_chart(struct chart *c, const struct prof *wheel, const struct prof *rail, const struct ctab *t,
                                const struct contact_place *at, int pairs);

/* Why these three do not belong together; NULL where they may. */
const char *contact_fits(const struct prof *wheel, const struct prof *rail, const struct ctab *t);

/* Index of the member of x [n], increasing, nearest to v. */
int64_t contact_nearest(int64_t n, const double *x, double v);

#endif
