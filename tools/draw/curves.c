#include "tools/draw/curves.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

static const double near = 0.2;         /* px, too near to the last point to show */
static const double far = 1e5;          /* px, far outside any picture */

int curves_piece(const struct layout *l, const struct chart *c, int panel, const struct chart_series *s, int64_t *from,
                 double *xy)
{
    int n = 0;

    for (; *from < s->n; ++*from) {
        double px[2];
        layout_place(l, c, panel, s->x[*from], s->y[*from], px);
        if (!isfinite(px[0]) || !isfinite(px[1])) {
            if (n > 0)
                return n;
            continue;
        }
        px[0] = fmax(-far, fmin(far, px[0]));
        px[1] = fmax(-far, fmin(far, px[1]));
        if (n > 0 && hypot(px[0] - xy[2 * n - 2], px[1] - xy[2 * n - 1]) < near)
            continue;
        xy[2 * n] = px[0];
        xy[2 * n + 1] = px[1];
        n++;
    }
    return n;
}

static int visible(const struct box *b, const double *px, double slack)
{
    return px[0] >= b->x - slack && px[0] <= b->x + b->w + slack && px[1] >= b->y - slack && px[1] <= b->y + b->h + slack;
}

static void draw_series(const struct layout *l, const struct chart *c, int p, const struct chart_series *s, int fill,
                        double *xy, struct canvas *canvas)
{
    int n;

    canvas_colour(canvas, s->colour);
    for (int64_t from = 0; (n = curves_piece(l, c, p, s, &from, xy)) > 0;) {
        if (fill)
            canvas_fill(canvas, n, xy);
        else if (s->width > 0)
            canvas_line(canvas, n, xy, s->width * l->point, s->dash);
        for (int i = 0; i < n && !fill && s->mark != CANVAS_NO_MARK; i++)
            if (visible(&l->box[p], xy + 2 * i, 0.5))
                canvas_mark(canvas, s->mark, xy[2 * i], xy[2 * i + 1], s->size * l->point);
    }
}

const char *curves_draw(const struct layout *l, const struct chart *c, struct canvas *canvas)
{
    for (int p = 0; p < c->panels; p++) {
        const struct box *b = &l->box[p];
        int64_t most = 1;
        for (const struct chart_series *s = c->panel[p].series; s; s = s->next)
            most = s->n > most ? s->n : most;
        double *xy = most < INT_MAX ? calloc((size_t)most, 2 * sizeof *xy) : NULL;
        if (!xy)
            return REASON_MEMORY;
        canvas_clip(canvas, b->x, b->y, b->w, b->h);
        for (int fill = 1; fill >= 0; fill--)
            for (const struct chart_series *s = c->panel[p].series; s; s = s->next)
                if (s->filled == fill)
                    draw_series(l, c, p, s, fill, xy, canvas);
        canvas_unclip(canvas);
        free(xy);
    }
    return NULL;
}
