#include "tools/draw/notes.h"

#include <math.h>
#include <stdlib.h>

static const double clear = 4, inside = 2;   /* pt, from the point to its words, from them to the frame */
enum { PLACES = 18 };                        /* tried, near ones first */
static const int word_cost = 1000, frame_cost = 500;   /* against one for each piece of line covered */

/* The straight piece from a to b meets the box (Liang and Barsky 1984). */
static int meets(const struct box *r, const double *a, const double *b)
{
    double from = 0, to = 1, d[2] = {b[0] - a[0], b[1] - a[1]};
    const double lo[2] = {r->x, r->y}, hi[2] = {r->x + r->w, r->y + r->h};

    for (int k = 0; k < 2; k++) {
        if (d[k] == 0) {
            if (a[k] < lo[k] || a[k] > hi[k])
                return 0;
            continue;
        }
        double in = (lo[k] - a[k]) / d[k], out = (hi[k] - a[k]) / d[k];
        from = fmax(from, fmin(in, out));
        to = fmin(to, fmax(in, out));
    }
    return from <= to;
}

static int overlap(const struct box *a, const struct box *b)
{
    return a->x < b->x + b->w && b->x < a->x + a->w && a->y < b->y + b->h && b->y < a->y + a->h;
}

/* How much words in r would cover: pieces of line of panel p, words placed before, the frame. */
static int cost(const struct layout *l, const struct chart *c, int p, const struct box *r, int placed, const struct box *before)
{
    const double in = inside * l->point;
    const struct box *f = &l->box[p], b = {f->x + in, f->y + in, f->w - 2 * in, f->h - 2 * in};
    int sum = 0;

    for (int k = 0; k < placed; k++)
        sum += overlap(r, &before[k]) ? word_cost : 0;
    if (r->x < b.x || r->y < b.y || r->x + r->w > b.x + b.w || r->y + r->h > b.y + b.h)
        sum += frame_cost;
    for (const struct chart_series *s = c->panel[p].series; s; s = s->next) {
        double last[2] = {NAN, NAN}, px[2];
        for (int64_t i = 0; i < s->n && !s->filled; i++) {
            layout_place(l, c, p, s->x[i], s->y[i], px);
            if (isfinite(px[0] + px[1] + last[0] + last[1]))
                sum += meets(r, last, px);
            last[0] = px[0];
            last[1] = px[1];
        }
    }
    return sum;
}

/* The box of words w wide and h high about (x, y), pushed out in the k-th direction. */
static struct box aside(double x, double y, double w, double h, double away, int k)
{
    static const double place[PLACES][3] = {{0, -1, 1}, {0, 1, 1},  {1, 0, 1},  {-1, 0, 1}, {1, -1, 1},  {-1, -1, 1},
                                        {1, 1, 1},  {-1, 1, 1}, {0, -1, 4}, {0, 1, 4},  {1, -1, 3},  {-1, -1, 3},
                                            {1, 1, 3},  {-1, 1, 3}, {0, -1, 8}, {0, 1, 8},  {1, -1, 6},  {-1, -1, 6}};
    double dx = place[k][0] * (w / 2 + away * place[k][2]), dy = place[k][1] * (h / 2 + away * place[k][2]);

    return (struct box){x + dx - w / 2, y + dy - h / 2, w, h};
}

static void place_note(const struct layout *l, const struct chart *c, int p, const struct chart_note *note, int placed,
                       struct box *boxes, struct text *t)
{
    struct text_style style = {.size = LAYOUT_NOTE * l->point, .colour = note->colour, .across = note->across, .up = note->up};
    double px[2], w = text_width(t, note->words, style.size, TEXT_BOOK), h = text_height(style.size);
    int least = 0;

    layout_place(l, c, p, note->x, note->y, px);
    if (!isfinite(px[0]) || !isfinite(px[1]))
        return;
    boxes[placed] = (struct box){px[0] - note->across * w, px[1] - (1 - note->up) * h, w, h};
    for (int k = 0; k < PLACES && !note->fixed; k++) {
        struct box r = aside(px[0], px[1], w, h, clear * l->point, k);
        int covers = cost(l, c, p, &r, placed, boxes);
        if (k == 0 || covers < least) {
            least = covers;
            boxes[placed] = r;
        }
        if (covers == 0)
            break;
    }
    style.across = style.up = 0;
    text_add(t, boxes[placed].x, boxes[placed].y + h, &style, note->words);
}

void notes_draw(const struct layout *l, const struct chart *c, struct text *t)
{
    for (int p = 0; p < c->panels; p++) {
        size_t n = 0;
        for (const struct chart_note *note = c->panel[p].note; note; note = note->next)
            n++;
        struct box *boxes = calloc(n + 1, sizeof *boxes);
        if (!boxes) {
            t->why = REASON_MEMORY;
            return;
        }
        int placed = 0;
        for (const struct chart_note *note = c->panel[p].note; note; note = note->next)
            place_note(l, c, p, note, placed++, boxes, t);
        free(boxes);
    }
}
