/* A chart: one panel or several below one another over the same x, each with lines, marks and notes.
 *
 * The caller fills it from plain arrays in SI units, which must live until it is drawn; an axis shows its numbers times a
 * factor (1e3 shows metres as millimetres).  What is added belongs to the chart and goes with chart_free.  Adding never
 * fails visibly: the first failure is kept and told by chart_draw.
 *
 * A sheet is a chart with others beside it, each with axes of its own on its part of the picture. */
#ifndef VX_DRAW_CHART_H
#define VX_DRAW_CHART_H

#include <stdint.h>

#include "formats/reason.h"
#include "tools/draw/canvas.h"

/* Colours that stay apart for every kind of colour vision, after Okabe and Ito 2008, darkest contrast first. */
enum { CHART_BLUE = 0x0072b2, CHART_RED = 0xd55e00, CHART_GREEN = 0x009e73, CHART_BLACK = 0x000000, CHART_PURPLE = 0xcc79a7,
       CHART_SKY = 0x56b4e9, CHART_ORANGE = 0xe69f00,
       CHART_WINE = 0x882255, CHART_GREY = 0x707070 };
enum { CHART_COLOURS = 7 };
unsigned chart_colour(int k);              /* the k-th of the seven, in turn */
unsigned chart_tint(unsigned colour);      /* a fifth of it over white, for what it fills */

struct chart_axis {
    const char *label;                     /* with its unit: "wheel force Q (kN)" */
    double factor;                         /* number shown per SI number; 0 is 1 */
    double lo, hi;                         /* SI; where equal, from the data */
    double step;                           /* between the labels, as shown; 0 is chosen */
    int log;
    int whole;                             /* counts something: its labels are whole numbers */
    int down;                              /* grows downwards, as z does */
};

struct chart_series {
    const char *label;                     /* in the legend; NULL is not in it */
    int64_t n;
    const double *x, *y;                   /* SI [n]; a NaN lifts the pen */
    unsigned colour;
    double width;                          /* pt; 0 draws no line */
    enum canvas_dash dash;
    enum canvas_mark mark;                 /* at each point */
    double size;                           /* pt, of the mark */
    int filled;                            /* the outline is closed and filled, under all lines of the panel */
    struct chart_series *next;
};

/* Words at a point of a panel: put where they cover least, or fixed at `across` and `up` as in text.h. */
struct chart_note {
    const char *words;
    double x, y;                           /* SI */
    unsigned colour;
    int fixed;
    double across, up;
    struct chart_note *next;
};

struct chart_line {
    const char *label;                     /* above the chart; may be NULL */
    double x;                              /* SI */
    struct chart_line *next;
};

struct chart_panel {
    struct chart_axis y;
    double share;                          /* of the height, relative to the other panels */
    int colours;                           /* used so far */
    struct chart_series *series, **series_end;
    struct chart_note *note, **note_end;
};

enum { CHART_PANELS = 8 };

struct chart_area { double x, y, w, h; };  /* fractions of the picture from its upper left corner; w = 0: all of it */

struct chart {
    const char *title;                     /* NULL: none */
    struct chart_axis x;
    int equal;                             /* a metre is as long along y as along x */
    int alike;                             /* y has the same limits in all panels */
    int bare;                              /* no axes: a drawing */
    struct chart_area area;
    double type;                           /* size of type and lines against those of a chart; 0 is 1 */
    struct chart *beside;                  /* the next of a sheet */
    int panels;
    struct chart_panel panel[CHART_PANELS];
    struct chart_line *line, **line_end;   /* vertical, through all panels */
    const char *why;                       /* first failure */
    struct chart_store *store;             /* what was added */
    struct chart_panel spare_panel;        /* returned after a failure */
    struct chart_series spare_series;
    struct chart_note spare_note;
};

void chart_begin(struct chart *c);         /* the chart must stay where it is until chart_free */
void chart_free(struct chart *c);

/* Another chart on the picture of c, begun, which goes with it. */
struct chart *chart_add_beside(struct chart *c, const struct chart_area *area);
struct chart_panel *chart_add_panel(struct chart *c, const char *label, double factor);
/* A solid line in the next colour. */
struct chart_series *chart_add_series(struct chart *c, struct chart_panel *p, const char *label, int64_t n, const double *x,
                                      const double *y);
struct chart_note *chart_add_note(struct chart *c, struct chart_panel *p, double x, double y, const char *words);
void chart_add_line(struct chart *c, double x, const char *label);

double *chart_numbers(struct chart *c, int64_t n);                               /* [n] zeroed, or NULL after a failure */
const char *chart_words(struct chart *c, const char *format, ...) VX_PRINTF(2, 3);

/* The factor of an axis, 1 where none is set. */
double chart_factor(const struct chart_axis *a);

/* Draws c on a new canvas, which then is complete. */
const char *chart_draw(const struct chart *c, struct canvas *canvas);

#endif
