/* Figure of a wheel on its way over the rail bodies of a turnout: station after station, as a sheet of cells at one scale. */
#ifndef VX_DRAW_SEQUENCE_H
#define VX_DRAW_SEQUENCE_H

#include "formats/ctab.h"
#include "formats/prof.h"
#include "tools/draw/chart.h"
#include "tools/draw/contact.h"

enum { SEQUENCE_MOST = 60 };      /* cells of a sheet, or frames */

/* Numbers of at most n stations of the table in from .. to (m), evenly thinned, into pick [SEQUENCE_MOST]; how many. */
int sequence_stations(const struct ctab *t, double from, double to, int n, int64_t *pick);

struct sequence_choice {
    double from, to;              /* m */
    int stations;                 /* at most */
    int frame;                    /* the one alone from 0 on, as large as it goes; -1 all on a sheet */
};

/* The wheel at the yaw and u of the table nearest to `at`; shape is width over height of the picture.  Behind the last frame the chart
 * stays without a panel. */
const char *sequence_chart(struct chart *c, const struct prof *wheel, const struct prof *rail, const struct ctab *t,
                           const struct contact_place *at, const struct sequence_choice *choice, double shape);

#endif
