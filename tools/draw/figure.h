/* The figures there are: which kinds of file each takes, and how files become its chart. */
#ifndef VX_DRAW_FIGURE_H
#define VX_DRAW_FIGURE_H

#include "formats/columns.h"
#include "formats/vxf.h"
#include "tools/draw/chart.h"
#include "tools/draw/contact.h"
#include "tools/draw/runs.h"

struct figure_input {
    struct vxf *file;                /* or NULL: */
    const struct columns *table;     /* a table as text */
    const char *name;                /* of the operand, without its folder */
    const char *label;               /* in the legend; NULL: what the file says, its name where several runs are drawn */
};

struct figure_options {
    double from, to;                 /* window along x in its SI unit; infinite: the data */
    double shape;                    /* width over height of the picture */
    struct contact_place at;
    int pairs, stations;             /* most of them shown */
    int frame;                       /* of a sequence, alone; -1 is the sheet */
    struct runs_choice runs;
};

struct figure {
    const char *name;
    const char *kinds;               /* of the inputs, in order; a last "..." means more of the one before */
    const char *shows;
    /* Fills c, begun, from in [n], which live until it is drawn. */
    const char *(*make)(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o);
    runs_add *runs;                  /* of a figure of runs */
};

extern const struct figure figures[];    /* up to one with name NULL */

int figure_known(const char *name);

/* The first figure called name (any where NULL) that takes in [n], or NULL and why not. */
const struct figure *figure_choose(const char *name, int n, const struct figure_input *in, const char **why);

/* Fills c, begun; behind the last frame of a sequence c stays without a panel. */
const char *figure_make(const struct figure *f, struct chart *c, int n, const struct figure_input *in,
                        const struct figure_options *o);

#endif
