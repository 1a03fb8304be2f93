#include "tools/draw/layout.h"

#include <math.h>
#include <string.h>

#include "tools/draw/limits.h"

const double layout_sample = 20;
static const double edge = 6, gap = 4, end = 14; /* pt, around the picture, between its parts, right of the boxes */
static const double headroom = 0.06;             /* of the range of the data */
static const double near_zero = 0.3;             /* of its largest value: the axis begins at zero */
static const double row = 13;                   /* pt, of a legend */
static const double between = 14;               /* pt, entries of a legend */
static const double tick_room_x = 44, tick_room_y = 13;   /* pt, for one number */

static int steps(double px, double point, double room)
{
    int n = (int)(px / (point * room));

    return n < 2 ? 2 : n > 8 ? 8 : n;
}

/* The legend above an earlier panel has this entry already. */
static int repeated(const struct layout *l, const struct chart_series *s)
{
    for (int k = 0; k < l->entries; k++)
        if (l->entry[k].series->colour == s->colour && l->entry[k].series->dash == s->dash &&
            !strcmp(l->entry[k].series->label, s->label))
            return 1;
    return 0;
}

/* Sets the entries of a panel in rows from y = 0 down, within left..right; returns their height. */
static double legend(struct layout *l, const struct chart_panel *p, const struct text *t, double left, double right)
{
    double x = left, y = row / 2 * l->point;
    int any = 0;

    for (const struct chart_series *s = p->series; s; s = s->next) {
        if (!s->label || l->entries == LAYOUT_ENTRIES || repeated(l, s))
            continue;
        double w = l->point * (layout_sample + gap + between) + text_width(t, s->label, LAYOUT_LEGEND * l->point, TEXT_BOOK);
        if (any && x + w - between * l->point > right) {
            x = left;
            y += row * l->point;
        }
        l->entry[l->entries++] = (struct layout_entry){s, x, y};
        x += w;
        any = 1;
    }
    return any ? y + row / 2 * l->point : 0;
}

/* Room beyond the extremes of the data: to round numbers where logarithmic or in steps given, else a little, and down to
 * zero where that is near. */
static void air(double *lo, double *hi, const struct chart_axis *a, int most)
{
    if (a->log || a->step > 0) {
        scale_widen(lo, hi, a->log, a->step, most);
        return;
    }
    double part = headroom * (*hi - *lo);
    *lo = *lo >= 0 && *lo < near_zero * *hi ? 0 : *lo - part;
    *hi = *hi <= 0 && *hi > near_zero * *lo ? 0 : *hi + part;
}

static void scale_axis(struct scale *s, const struct chart_axis *a, double lo, double hi, int widen, int most)
{
    double factor = chart_factor(a);

    lo *= factor;
    hi *= factor;
    if (widen)
        air(&lo, &hi, a, most);
    scale_set(s, lo, hi, a->log, a->whole ? fmax(scale_step(hi - lo, most), 1) : a->step, most);
}

/* A metre of y as long as a metre of x: the shorter range grows about its middle. */
static void equalise(struct layout *l, const struct chart *c)
{
    struct scale *x = &l->x, *y = &l->y[0];
    double unit_x = l->box[0].w / (x->hi - x->lo) * chart_factor(&c->x);
    double unit_y = l->box[0].h / (y->hi - y->lo) * chart_factor(&c->panel[0].y);
    struct scale *s = unit_x > unit_y ? x : y;
    double grow = fmax(unit_x, unit_y) / fmin(unit_x, unit_y);
    double middle = (s->lo + s->hi) / 2, half = grow * (s->hi - s->lo) / 2;

    scale_set(s, middle - half, middle + half, 0, 0,
              s == x ? steps(l->box[0].w, l->point, tick_room_x) : steps(l->box[0].h, l->point, tick_room_y));
}

static void scale_panels(struct layout *l, const struct chart *c)
{
    double lo, hi, ylo[CHART_PANELS], yhi[CHART_PANELS], least = INFINITY, most = -INFINITY;

    limits_x(c, &lo, &hi);
    scale_axis(&l->x, &c->x, lo, hi, 0, steps(l->box[0].w, l->point, tick_room_x));
    for (int p = 0; p < c->panels; p++) {
        limits_y(&c->panel[p], &c->x, lo, hi, &ylo[p], &yhi[p]);
        least = fmin(least, ylo[p]);
        most = fmax(most, yhi[p]);
    }
    for (int p = 0; p < c->panels; p++) {
        const struct chart_axis *a = &c->panel[p].y;
        scale_axis(&l->y[p], a, c->alike ? least : ylo[p], c->alike ? most : yhi[p], a->lo == a->hi && !c->bare,
                   steps(l->box[p].h, l->point, tick_room_y));
    }
    if (c->equal && c->panels == 1)
        equalise(l, c);
}

/* Height of the words of the vertical lines. */
static double strip(const struct chart *c, double point)
{
    for (const struct chart_line *v = c->line; v; v = v->next)
        if (v->label)
            return (LAYOUT_NOTE + gap) * point;
    return 0;
}

/* Boxes from `left` px on, within the sheet. */
static void set_boxes(struct layout *l, const struct chart *c, const struct text *t, double left)
{
    const struct box *sheet = &l->sheet;
    double pt = l->point, right = sheet->x + sheet->w - (c->bare ? edge : end) * pt, top = sheet->y + edge * pt;
    double bottom = sheet->y + sheet->h - (c->bare ? edge * pt : (edge + 2 * gap) * pt + text_height((LAYOUT_LABEL + LAYOUT_NUMBER) * pt));
    double head[CHART_PANELS] = {0}, shares = 0;
    int first[CHART_PANELS + 1] = {0};

    l->entries = 0;
    if (c->title) {
        l->title = top + text_height(LAYOUT_TITLE * pt);
        top = l->title + 1.5 * gap * pt;
    }
    double rest = bottom - top - strip(c, pt);
    for (int p = 0; p < c->panels; p++) {
        head[p] = legend(l, &c->panel[p], t, left, right) + (p == 0 ? 0.5 : 2.5) * gap * pt;
        first[p + 1] = l->entries;
        rest -= head[p];
        shares += c->panel[p].share;
    }
    for (int p = 0; p < c->panels; p++) {
        for (int k = first[p]; k < first[p + 1]; k++)
            l->entry[k].y += top + (p == 0 ? 0 : 2 * gap * pt);
        top += head[p] + (p == 0 ? strip(c, pt) : 0);
        l->box[p] = (struct box){left, top, right - left, rest * c->panel[p].share / shares};
        top += l->box[p].h;
    }
    l->words = l->box[0].y - gap * pt;
}

/* Room for the numbers and the label of y. */
static double margin(const struct layout *l, const struct chart *c, const struct text *t)
{
    double widest = 0;

    if (c->bare)
        return edge * l->point;
    for (int p = 0; p < c->panels; p++)
        for (int k = 0; k < l->y[p].ticks; k++)
            widest = fmax(widest, text_width(t, l->y[p].label[k], LAYOUT_NUMBER * l->point, TEXT_BOOK));
    return widest + (edge + LAYOUT_LABEL + gap + gap) * l->point;
}

void layout_make(struct layout *l, const struct chart *c, const struct text *t, int width, int height)
{
    const struct chart_area *a = &c->area;

    *l = (struct layout){.point = width / (16 / 2.54 * 72), .sheet = {0, 0, width, height}};
    if (a->w > 0)
        l->sheet = (struct box){a->x * width, a->y * height, a->w * width, a->h * height};
    if (c->type > 0)
        l->point *= c->type;
    double left = l->sheet.x + 50 * l->point;
    for (int pass = 0; pass < 2; pass++) {
        set_boxes(l, c, t, left);
        scale_panels(l, c);
        left = l->sheet.x + margin(l, c, t);
    }
    set_boxes(l, c, t, left);
    scale_panels(l, c);
}

void layout_place(const struct layout *l, const struct chart *c, int panel, double x, double y, double px[2])
{
    const struct box *b = &l->box[panel];
    const struct chart_axis *a = &c->panel[panel].y;
    double along = scale_place(&l->x, x * chart_factor(&c->x)), up = scale_place(&l->y[panel], y * chart_factor(a));

    px[0] = b->x + b->w * along;
    px[1] = b->y + b->h * (a->down ? up : 1 - up);
}
