/* The three views of a vehicle and the outlines of its bodies in them.
 *
 * From the right (x forward, heights up), from above (x, y down the page) and from behind (y, heights).  A body, of which a file
 * knows no shape, is the box of uniform density that has its mass and inertias: L_x^2 = 6 (J_y + J_z - J_x)/m. */
#ifndef VX_DRAW_VIEWS_H
#define VX_DRAW_VIEWS_H

#include "formats/veh.h"
#include "tools/draw/chart.h"

enum view { VIEW_SIDE, VIEW_TOP, VIEW_END, VIEWS };

struct view_axes {
    int axis[2], turn;               /* VEH_X.. across and up or down the page, VEH_ROLL.. about the third */
    double sign[2];                  /* of the page's coordinates against them: -1 makes z a height */
    const char *words, *label[2];
};

extern const struct view_axes view_axes[VIEWS];

/* A point (x, y, z) in m on the page. */
void view_place(enum view view, const double p[3], double xy[2]);

/* Half the sides, m, of the box; 0 where no body of uniform density has these inertias. */
void view_box(const struct veh *v, int64_t body, double half[3]);

/* A chart of this view: axes alike, y down where seen from above. */
struct chart_panel *view_begin(struct chart *c, enum view view);

/* A line through n points xy [n][2], which are copied. */
struct chart_series *view_line(struct chart *c, struct chart_panel *p, int n, const double *xy, unsigned colour, double width);

/* The box of a body as an outline and, where tint is not 0, filled with it; displaced by q [6] (NULL: at rest), with a pointer to its front
 * or right. */
void view_body(struct chart *c, struct chart_panel *p, enum view view, const struct veh *v, int64_t body, const double *q, unsigned colour,
               unsigned tint);

/* The wheels of wheelset i: circles, or their treads and the axle. */
void view_wheels(struct chart *c, struct chart_panel *p, enum view view, const struct veh *v, int64_t i, unsigned colour);

#endif
