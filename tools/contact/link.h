/* Which contacts of neighbouring nodes of a table are the same one. */
#ifndef VX_CONTACT_LINK_H
#define VX_CONTACT_LINK_H

#include "formats/ctab.h"

#define LINK_FALL_MOST 0.03   /* a flank that runs aslant falls by more, which says nothing of the next section; ramps fall by less */

/* How a row's contact falls along the track where that may hold to the next station, else 0: 1. */
static inline double link_fall(const float *row)
{
    double fall = row[CTAB_HEIGHT_S];

    return fall < LINK_FALL_MOST && fall > -LINK_FALL_MOST ? fall : 0;
}

/* Links of all rows of t into link[rows][CTAB_LINKS]. */
void link_rows(const struct ctab *t, uint8_t *link);

#endif
