/* Figure of a wheelset on its rails: rolling radius of both wheels and their difference over its lateral displacement. */
#ifndef VX_DRAW_RADIUS_H
#define VX_DRAW_RADIUS_H

#include "formats/ctab.h"
#include "tools/draw/chart.h"

/* From the tables of both sides at the nodes nearest to station and yaw, the wheelset without roll and the rails at rest. */
const char *radius_chart(struct chart *c, const struct ctab *left, const struct ctab *right, double station, double yaw);

#endif
