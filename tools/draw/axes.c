#include "tools/draw/axes.h"

#include <math.h>

static const unsigned grid = 0xdcdcdc, fine = 0xf0f0f0, frame = 0x202020, ink = 0x000000;
static const double hair = 0.5, stroke = 0.7;      /* pt */
static const double gap = 4;                       /* pt, from the frame to the numbers */

static void line(struct canvas *c, double x0, double y0, double x1, double y1, double width, enum canvas_dash dash)
{
    canvas_line(c, 2, (double[]){x0, y0, x1, y1}, width, dash);
}

/* The style, smaller where the string would be longer than the room. */
static struct text_style fitted(const struct text *t, struct text_style style, const char *string, double room)
{
    double width = text_width(t, string, style.size, style.weight);

    if (width > room)
        style.size *= room / width;
    return style;
}

static void grid_lines(const struct layout *l, const struct chart *c, int p, struct canvas *canvas)
{
    const struct box *b = &l->box[p];
    const struct scale *scale[2] = {&l->x, &l->y[p]};

    for (int minor = 1; minor >= 0; minor--) {
        canvas_colour(canvas, minor ? fine : grid);
        for (int k = 0; k < (minor ? scale[0]->minors : scale[0]->ticks); k++) {
            double x = b->x + b->w * scale_place(scale[0], minor ? scale[0]->minor[k] : scale[0]->tick[k]);
            line(canvas, x, b->y, x, b->y + b->h, hair * l->point, CANVAS_SOLID);
        }
        for (int k = 0; k < (minor ? scale[1]->minors : scale[1]->ticks); k++) {
            double up = scale_place(scale[1], minor ? scale[1]->minor[k] : scale[1]->tick[k]);
            double y = b->y + b->h * (c->panel[p].y.down ? up : 1 - up);
            line(canvas, b->x, y, b->x + b->w, y, hair * l->point, CANVAS_SOLID);
        }
    }
}

static void box_frame(const struct layout *l, int p, struct canvas *canvas)
{
    const struct box *b = &l->box[p];

    canvas_colour(canvas, frame);
    canvas_line(canvas, 6, (double[]){b->x, b->y, b->x + b->w, b->y, b->x + b->w, b->y + b->h, b->x, b->y + b->h, b->x, b->y,
                                      b->x + b->w, b->y}, stroke * l->point, CANVAS_SOLID);
}

/* Numbers and label of y beside panel p. */
static void words_y(const struct layout *l, const struct chart *c, int p, struct text *t)
{
    const struct box *b = &l->box[p];
    const struct chart_axis *a = &c->panel[p].y;
    const struct text_style number = {.size = LAYOUT_NUMBER * l->point, .colour = ink, .across = 1, .up = 0.5};
    const struct text_style label = {.size = LAYOUT_LABEL * l->point, .colour = ink, .across = 0.5, .up = 1, .upright = 1};

    for (int k = 0; k < l->y[p].ticks; k++) {
        double up = scale_place(&l->y[p], l->y[p].tick[k]);
        text_add(t, b->x - gap * l->point, b->y + b->h * (a->down ? up : 1 - up), &number, l->y[p].label[k]);
    }
    if (a->label) {
        const struct text_style fit = fitted(t, label, a->label, b->h);
        text_add(t, l->sheet.x + gap * l->point, b->y + b->h / 2, &fit, a->label);
    }
}

/* Numbers and label of x below the last panel. */
static void words_x(const struct layout *l, const struct chart *c, struct text *t)
{
    const struct box *b = &l->box[c->panels - 1];
    const struct text_style number = {.size = LAYOUT_NUMBER * l->point, .colour = ink, .across = 0.5, .up = 1};
    const struct text_style label = {.size = LAYOUT_LABEL * l->point, .colour = ink, .across = 0.5, .up = 1};
    double y = b->y + b->h + gap * l->point;

    for (int k = 0; k < l->x.ticks; k++)
        text_add(t, b->x + b->w * scale_place(&l->x, l->x.tick[k]), y, &number, l->x.label[k]);
    if (c->x.label)
        text_add(t, b->x + b->w / 2, y + text_height(number.size) + gap * l->point, &label, c->x.label);
}

/* The vertical lines of the chart; words that would meet those before them move to the right, or are left out at the edge. */
static void vertical_lines(const struct layout *l, const struct chart *c, struct canvas *canvas, struct text *t)
{
    const struct text_style style = {.size = LAYOUT_NOTE * l->point, .colour = CHART_GREY, .across = 0, .up = 0};
    const struct box *first = &l->box[0];
    double used = first->x;

    canvas_colour(canvas, CHART_GREY);
    for (const struct chart_line *v = c->line; v; v = v->next) {
        double place = scale_place(&l->x, v->x * chart_factor(&c->x)), x = first->x + first->w * place;
        if (!(place >= 0 && place <= 1))
            continue;
        for (int p = 0; p < c->panels; p++)
            line(canvas, x, l->box[p].y, x, l->box[p].y + l->box[p].h, stroke * l->point, CANVAS_DASHED);
        if (!v->label)
            continue;
        double width = text_width(t, v->label, style.size, TEXT_BOOK);
        double left = fmin(fmax(x - width / 2, used), first->x + first->w - width);
        if (left < used)
            continue;
        text_add(t, left, l->words, &style, v->label);
        used = left + width + gap * l->point;
    }
}

void axes_draw(const struct layout *l, const struct chart *c, struct canvas *canvas, struct text *t)
{
    const struct text_style title = {.size = LAYOUT_TITLE * l->point, .weight = TEXT_BOLD, .colour = ink};

    if (c->title) {
        const struct text_style fit = fitted(t, title, c->title, l->box[0].w);
        text_add(t, l->box[0].x, l->title, &fit, c->title);
    }
    for (int p = 0; p < c->panels && !c->bare; p++) {
        grid_lines(l, c, p, canvas);
        box_frame(l, p, canvas);
        words_y(l, c, p, t);
    }
    if (!c->bare)
        words_x(l, c, t);
    vertical_lines(l, c, canvas, t);
}

void axes_legend(const struct layout *l, struct canvas *canvas, struct text *t)
{
    const struct text_style style = {.size = LAYOUT_LEGEND * l->point, .colour = ink, .up = 0.5};
    double length = layout_sample * l->point;

    for (int k = 0; k < l->entries; k++) {
        const struct chart_series *s = l->entry[k].series;
        double x = l->entry[k].x, y = l->entry[k].y;
        canvas_colour(canvas, s->colour);
        if (s->width > 0)
            line(canvas, x, y, x + length, y, fmax(s->width, 1.5) * l->point, s->dash);
        if (s->filled)
            line(canvas, x, y, x + length, y, 7 * l->point, CANVAS_SOLID);
        canvas_mark(canvas, s->mark, x + length / 2, y, s->size * l->point);
        text_add(t, x + length + gap * l->point, y, &style, s->label);
    }
}
