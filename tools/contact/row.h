/* One contact found as a row of the table, ctab(5).
 *
 * x forward, y to the right, z down; of the right side, where row_mirror has not been. */
#ifndef VX_CONTACT_ROW_H
#define VX_CONTACT_ROW_H

#include "formats/ctab.h"
#include "tools/contact/search.h"
#include "tools/contact/strip.h"

/* Of the search s, the wheel yawed (rad) and moved right by u (m); radius, material and reference load of t.  Patches are Hertz's, or
 * those of law under that load where it is not NULL. */
void row_make(const struct search_contact *c, const struct search *s, const struct ctab *t, double yaw, double u, const struct strip_law *law,
              float row[CTAB_ALL]);

/* The same contact of the other side. */
void row_mirror(float row[CTAB_ALL]);

#endif
