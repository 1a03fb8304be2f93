/* A picture drawn off screen: lines, filled outlines and marks, smooth by drawing four times finer in each direction.
 *
 * Coordinates are pixels of the finished picture, x to the right and y down from its upper left corner.  The one place that
 * knows OpenGL: OSMesa here, which newer Mesa has dropped; a surfaceless EGL context would fit behind the same functions. */
#ifndef VX_DRAW_CANVAS_H
#define VX_DRAW_CANVAS_H

enum { CANVAS_LEAST = 200, CANVAS_MOST = 4096 };       /* px, side of a picture */

enum canvas_dash { CANVAS_SOLID, CANVAS_DASHED, CANVAS_DOTTED, CANVAS_DASHDOT, CANVAS_DASHES };
enum canvas_mark { CANVAS_NO_MARK, CANVAS_DISC, CANVAS_RING, CANVAS_SQUARE, CANVAS_TRIANGLE, CANVAS_CROSS };

struct canvas {
    int width, height;         /* px */
    double point;              /* px per typographic point where the picture is printed 16 cm wide */
    unsigned char *rgb;        /* [height][width][3] the picture, once canvas_end has been called */
    unsigned char *fine;       /* [4 height][4 width][4] what OpenGL draws into */
    void *context;
};

/* A white canvas; canvas_free accepts a zeroed or failed one. */
const char *canvas_new(struct canvas *c, int width, int height);
void canvas_free(struct canvas *c);

void canvas_colour(struct canvas *c, unsigned rgb);                          /* 0xRRGGBB, of what follows */
void canvas_clip(struct canvas *c, double x, double y, double w, double h);  /* px, until canvas_unclip */
void canvas_unclip(struct canvas *c);

/* A line through xy [n][2], round at its corners. */
void canvas_line(struct canvas *c, int n, const double *xy, double width, enum canvas_dash dash);
/* The inside of the closed outline xy [n][2], of any shape, by the even-odd rule. */
void canvas_fill(struct canvas *c, int n, const double *xy);
void canvas_mark(struct canvas *c, enum canvas_mark mark, double x, double y, double size);

/* Averages the fine picture into rgb; nothing is drawn after it. */
void canvas_end(struct canvas *c);

#endif
