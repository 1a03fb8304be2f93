/* Tables as text: a line of names and units, then rows, aligned. */
#ifndef VX_CLI_TABLE_H
#define VX_CLI_TABLE_H

#include "formats/columns.h"

void cli_header(const struct column *c, int n);

/* The values [n] of one row; a letter is its character. */
void cli_row(const struct column *c, int n, const double *value);

/* A table whole: x [rows] in the first column, value [rows][n - 1] beside it. */
void cli_table(const struct column *c, int n, int64_t rows, const double *x, const double *value);

#endif
