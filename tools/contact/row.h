/* One contact found as a row of the table, ctab(5).
 *
 * x forward, y to the right, z down; of the right side, where row_mirror has not been. */
#ifndef VX_CONTACT_ROW_H
#define VX_CONTACT_ROW_H

#include "formats/ctab.h"
#include "tools/contact/search.h"

/* Of the search s, the wheel yawed (rad) and moved right by u (m); radius and material of t. */
void row_make(const struct search_contact *c, const struct search *s, const struct ctab *t, double yaw, double u, float row[CTAB_N]);

/* The same contact of the other side. */
void row_mirror(float row[CTAB_N]);

#endif
