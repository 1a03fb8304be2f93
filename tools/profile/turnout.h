/* The rails of a turnout that one wheel of a route meets, section by section, in the frame of that route.
 *
 * Stock rail: the plain rail, which leaves the route outwards.  Switch rail: a blade along the running edge, then the closure rail, behind
 * the throat the wing rail, which leaves outwards too, its flangeway opening at its end.  Nose: along the running edge again, then the
 * plain rail.  The other side has one plain rail and, where it is a body, the check rail inside it.
 * Outlines of a right rail, origin at the top of the plain rail on the running edge; set_prof mirrors them where the side is
 * the left one. */
#ifndef VX_PROFILE_TURNOUT_H
#define VX_PROFILE_TURNOUT_H

#include "formats/prof_text.h"
#include "tools/profile/head.h"
#include "tools/profile/plan.h"
#include "tools/profile/set.h"

/* Of the side with switch and crossing; then those of the other one. */
enum { TURNOUT_STOCK, TURNOUT_SWITCH, TURNOUT_NOSE, TURNOUT_BODIES, TURNOUT_PLAIN = TURNOUT_BODIES, TURNOUT_CHECK };

struct plan turnout_plan(const struct turnout_text *t, double gauge);

/* The side ('l' or 'r') that carries switch rail and nose. */
char turnout_switch_side(const struct turnout_text *t);

/* m, of the wing rail's edge outwards from the running edge; negative before the throat. */
double turnout_wing(const struct turnout_text *t, const struct plan *plan, double s);

/* The outline of a body at station s; n = 0 where it is not there or out of reach. */
const char *turnout_body(const struct turnout_text *t, const struct plan *plan, const struct section *rail, double smoothing,
                         double spacing, int body, double s, struct outline *o);

/* fall of its outline o at s, by differences over h (m) behind and ahead. */
const char *turnout_fall(const struct turnout_text *t, const struct plan *plan, const struct section *rail, double smoothing,
                         double spacing, int body, double s, double h, struct outline *o);

/* All sections of one side. */
const char *turnout_sections(const struct turnout_text *t, double gauge, double smoothing, double spacing, char side,
                             const struct section *rail, struct set *set);

#endif
