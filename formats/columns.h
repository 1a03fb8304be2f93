/* Tables as text: a header line of names, then numbers, between blanks, tabs or commas: what vxcontact --rolling-radius,
 * vxdump --csv and the like print. */
#ifndef VX_FORMATS_COLUMNS_H
#define VX_FORMATS_COLUMNS_H

#include <stdint.h>

/* A column to be printed. */
struct column {
    const char *name;
    const char *unit;        /* NULL where it holds letters, not numbers */
    int digits;              /* significant ones */
};

enum { COLUMNS_MOST = 64, COLUMNS_NAME = 48 };

struct columns {
    int n;
    int64_t rows;
    char name[COLUMNS_MOST][COLUMNS_NAME];   /* [n] without the unit */
    char unit[COLUMNS_MOST][COLUMNS_NAME];   /* [n] of "name[unit]" or "name (unit)", else empty */
    double *value[COLUMNS_MOST];             /* [n][rows] */
    int64_t *line;                           /* [rows] in the text, from 1 */
};

/* path "-" is standard input.  Lines that begin with # are comments. */
const char *columns_read(struct columns *t, const char *path);
void columns_free(struct columns *t);

/* Index of the column of this name, -1 where there is none. */
int columns_find(const struct columns *t, const char *name);

#endif
