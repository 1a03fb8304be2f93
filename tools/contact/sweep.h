/* The contact that touches, over the displacement of the wheel, of several tables side by side. */
#ifndef VX_CONTACT_SWEEP_H
#define VX_CONTACT_SWEEP_H

#include "formats/columns.h"
#include "formats/ctab.h"

enum { SWEEP_TABLES = 8, SWEEP_EACH = 7, SWEEP_N = 1 + SWEEP_TABLES * SWEEP_EACH, SWEEP_NAME = 32 };

/* Columns of n tables: u, then SWEEP_EACH of each, "name_method"; returns how many. */
int sweep_columns(const struct ctab *t, int n, char name[SWEEP_N][SWEEP_NAME], struct column column[SWEEP_N]);

/* The row at u (m), station s (m) and yaw (rad); 0 where a table has no contact. */
int sweep_row(const struct ctab *t, int n, double s, double yaw, double u, double row[SWEEP_N]);

#endif
