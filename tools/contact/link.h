/* Which contacts of neighbouring nodes of a table are the same one. */
#ifndef VX_CONTACT_LINK_H
#define VX_CONTACT_LINK_H

#include "formats/ctab.h"

/* How a row's contact falls along the track where that may hold to the next station, else 0: 1. */
double link_fall(const float *row);

/* Links of all rows of t into link[rows][CTAB_LINKS]. */
void link_rows(const struct ctab *t, uint8_t *link);

#endif
