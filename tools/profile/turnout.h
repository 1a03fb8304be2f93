#ifndef VX_TURNOUT_H
#define VX_TURNOUT_H

#include "formats/prof_text.h"
#include "tools/profile/section.h"
#include "tools/profile/set.h"

const char *turnout_sections(const struct turnout_text *t, double gauge, double spacing, double smoothing, char side,
                             struct section *rail, struct set *set);
#endif
