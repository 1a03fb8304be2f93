/* Figure of a wheel's path along the rails of a turnout: its height, where it touches, and how far ahead, over the station. */
#ifndef VX_DRAW_PATH_H
#define VX_DRAW_PATH_H

#include "formats/ctab.h"
#include "tools/draw/chart.h"
#include "tools/draw/contact.h"

enum { PATH_VALUES = 3 };

/* Height of the wheel, y on the rail and x ahead (m) of the contact that touches first, a part (0 to 1) of the way from station i to the
 * next, at the yaw j and displacement k of the table; NAN where there is none. */
void path_between(const struct ctab *t, int64_t i, int64_t j, int64_t k, double part, double value[PATH_VALUES]);

/* At the yaw nearest to `at` and five displacements 2 mm apart about its u, from one station to another (m). */
const char *path_chart(struct chart *c, const struct ctab *t, const struct contact_place *at, double from, double to);

#endif
