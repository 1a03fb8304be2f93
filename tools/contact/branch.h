/* Branches of a table's cells: the rows at the eight corners of a cell that links join are one contact. */
#ifndef VX_CONTACT_BRANCH_H
#define VX_CONTACT_BRANCH_H

#include "formats/ctab.h"

/* Fills cell and branch of t, whose rows, links and axes stand, in t->store.  Cells of the same branches share them. */
const char *branch_cells(struct ctab *t);

#endif
