/* Tables of creep forces from a theory. */
#ifndef VX_CREEP_TABULATE_H
#define VX_CREEP_TABULATE_H

#include "formats/creep.h"

enum creep_theory { CREEP_FASTSIM, CREEP_EXACT, CREEP_THEORIES };
extern const char *const creep_theories[CREEP_THEORIES + 1];

/* Fills *t, which creep_free releases: by FASTSIM on grid x grid cells, or the exact theory with grid elements across. */
const char *tabulate(struct creep *t, enum creep_theory theory, int grid, double nu);

#endif
