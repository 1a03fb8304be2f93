/* Contacts, wheelsets at rest and their sweeps as rows of numbers to print. */
#ifndef VX_CONTACT_ROWS_H
#define VX_CONTACT_ROWS_H

#include "formats/columns.h"
#include "tools/contact/parameters.h"
#include "tools/contact/wheelset.h"

/* A contact's row; that of a wheelset's contact has its side, displacement and force before, up to ROWS_CONTACT; along a
 * path the station stands before, in ROWS_PATH. */
enum { ROWS_SIDE, ROWS_U, ROWS_FORCE, ROWS_CONTACT, ROWS_PATH = ROWS_FORCE, ROWS_GAP = ROWS_CONTACT + 15, ROWS_N };
enum { ROWS_REST = 3, ROWS_SWEEP = 10, ROWS_PARAMETERS = 6 };

void rows_columns(struct column c[ROWS_N]);
extern const struct column rows_rest[ROWS_REST], rows_sweep[ROWS_SWEEP], rows_parameters[ROWS_PARAMETERS];

/* From ROWS_CONTACT on; `first` is the height of the contact that touches first (m). */
void rows_contact(const struct contact *c, double first, double row[ROWS_N]);
/* The k-th contact of a side. */
void rows_wheelset(const struct wheelset *w, int side, int k, double row[ROWS_N]);
void rows_wheelset_rest(const struct wheelset *w, double row[ROWS_REST]);
void rows_wheelset_point(const struct wheelset_point *p, double row[ROWS_SWEEP]);
void rows_wheelset_parameters(double amplitude, const struct parameters *p, double row[ROWS_PARAMETERS]);

#endif
