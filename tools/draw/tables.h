/* Figures of tables of numbers. */
#ifndef VX_DRAW_TABLES_H
#define VX_DRAW_TABLES_H

#include "formats/columns.h"
#include "tools/draw/chart.h"

/* The first column along x, the others as lines, a panel for each unit.  t must live until the chart is drawn. */
const char *tables_chart(struct chart *c, const struct columns *t);

/* The table of vxcontact --rolling-radius: rolling radius difference, and where the contacts are on both rails. */
const char *tables_rolling_radius(struct chart *c, const struct columns *t);

/* The table of vxcontact --conicity: the parameters of linear wheelset models over the amplitude, a panel each. */
const char *tables_conicity(struct chart *c, const struct columns *t);

/* The table of vxfreq --stiffness: what each rail gives alone, and where both are loaded alike. */
const char *tables_stiffness(struct chart *c, const struct columns *t);

/* The table of vxfreq --static --axles: deflection of both rails, downwards. */
const char *tables_bowl(struct chart *c, const struct columns *t);

#endif
