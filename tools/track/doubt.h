/* What is possible but hardly meant: numbers of a track that look like another unit. */
#ifndef VX_TRACK_DOUBT_H
#define VX_TRACK_DOUBT_H

#include "formats/trk.h"

enum { DOUBT_TRACK_WORDS = 200, DOUBT_TRACK_MOST = 3 };

/* Fills words [DOUBT_TRACK_MOST] and returns how many: railpads or ballast of hardly any stiffness, lumped nodes of too much pitch inertia. */
int doubt_track(const struct trk *t, char words[DOUBT_TRACK_MOST][DOUBT_TRACK_WORDS]);

#endif
