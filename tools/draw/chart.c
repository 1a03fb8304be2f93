/* Filling a chart: lists that grow at their end, all memory in one list of blocks; and drawing it, part by part. */
#include "tools/draw/chart.h"

#include <ctype.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

#include "tools/draw/axes.h"
#include "tools/draw/curves.h"
#include "tools/draw/layout.h"
#include "tools/draw/notes.h"

struct chart_store {
    struct chart_store *next;
    max_align_t data[];
};

unsigned chart_colour(int k)
{
    static const unsigned colour[CHART_COLOURS] = {CHART_BLUE,   CHART_RED, CHART_GREEN, CHART_BLACK,
                                                   CHART_PURPLE, CHART_SKY, CHART_ORANGE};

    return colour[k % CHART_COLOURS];
}

unsigned chart_tint(unsigned colour)
{
    unsigned pale = 0;

    for (int shift = 0; shift <= 16; shift += 8)
        pale |= (255 - (255 - (colour >> shift & 255)) / 5) << shift;
    return pale;
}

double chart_factor(const struct chart_axis *a)
{
    return a->factor == 0 ? 1 : a->factor;
}

void chart_begin(struct chart *c)
{
    *c = (struct chart){0};
    c->line_end = &c->line;
}

void chart_free(struct chart *c)
{
    if (c->beside)
        chart_free(c->beside);
    while (c->store) {
        struct chart_store *next = c->store->next;
        free(c->store);
        c->store = next;
    }
    *c = (struct chart){0};
}

/* Zeroed memory of the chart. */
static void *room(struct chart *c, size_t size)
{
    struct chart_store *s = size < SIZE_MAX - sizeof *s ? calloc(1, sizeof *s + size) : NULL;

    if (!s) {
        c->why = REASON_MEMORY;
        return NULL;
    }
    s->next = c->store;
    c->store = s;
    return s->data;
}

struct chart *chart_add_beside(struct chart *c, const struct chart_area *area)
{
    struct chart *other = room(c, sizeof *other);

    if (!other)
        return c;
    chart_begin(other);
    other->area = *area;
    other->beside = c->beside;
    c->beside = other;
    return other;
}

double *chart_numbers(struct chart *c, int64_t n)
{
    if (n < 0 || (uint64_t)n > SIZE_MAX / sizeof(double)) {
        c->why = REASON_MEMORY;
        return NULL;
    }
    return room(c, (size_t)n * sizeof(double));
}

/* A hyphen before a number that begins a word becomes a minus sign. */
static void set_minus(char *to, size_t size, const char *from)
{
    size_t n = 0;

    for (const char *p = from; *p && n + 4 < size; p++) {
        if (*p == '-' && isdigit((unsigned char)p[1]) && (p == from || p[-1] == ' '))
            n += (size_t)snprintf(to + n, size - n, "−");
        else
            to[n++] = *p;
    }
    to[n] = '\0';
}

const char *chart_words(struct chart *c, const char *format, ...)
{
    char plain[TEXT_MOST];
    char *words = room(c, TEXT_MOST);
    va_list ap;

    va_start(ap, format);
    vsnprintf(plain, sizeof plain, format, ap);
    va_end(ap);
    if (!words)
        return "";
    set_minus(words, TEXT_MOST, plain);
    return words;
}

static void panel_begin(struct chart_panel *p, const char *label, double factor)
{
    *p = (struct chart_panel){.y = {.label = label, .factor = factor}, .share = 1};
    p->series_end = &p->series;
    p->note_end = &p->note;
}

struct chart_panel *chart_add_panel(struct chart *c, const char *label, double factor)
{
    struct chart_panel *p = &c->spare_panel;

    if (c->panels < CHART_PANELS)
        p = &c->panel[c->panels++];
    else
        c->why = "too many panels for one chart";
    panel_begin(p, label, factor);
    return p;
}

struct chart_series *chart_add_series(struct chart *c, struct chart_panel *p, const char *label, int64_t n, const double *x,
                                      const double *y)
{
    struct chart_series *s = room(c, sizeof *s);

    if (!s)
        return &c->spare_series;
    *s = (struct chart_series){.label = label, .n = n, .x = x, .y = y, .width = 1.2, .size = 5};
    s->mark = n == 1 ? CANVAS_DISC : CANVAS_NO_MARK;         /* no line shows one point */
    s->colour = chart_colour(p->colours++);
    *p->series_end = s;
    p->series_end = &s->next;
    return s;
}

struct chart_note *chart_add_note(struct chart *c, struct chart_panel *p, double x, double y, const char *words)
{
    struct chart_note *note = room(c, sizeof *note);

    if (!note)
        return &c->spare_note;
    *note = (struct chart_note){.words = words, .x = x, .y = y};
    *p->note_end = note;
    p->note_end = &note->next;
    return note;
}

void chart_add_line(struct chart *c, double x, const char *label)
{
    struct chart_line *line = room(c, sizeof *line);

    if (!line)
        return;
    *line = (struct chart_line){.x = x, .label = label};
    *c->line_end = line;
    c->line_end = &line->next;
}

static const char *draw_one(const struct chart *c, struct canvas *canvas, struct text *text)
{
    struct layout l;

    if (c->why)
        return c->why;
    if (c->panels == 0)
        return "a chart without a panel";
    layout_make(&l, c, text, canvas->width, canvas->height);
    axes_draw(&l, c, canvas, text);
    const char *why = curves_draw(&l, c, canvas);
    axes_legend(&l, canvas, text);
    notes_draw(&l, c, text);
    return why;
}

const char *chart_draw(const struct chart *c, struct canvas *canvas)
{
    struct text text = {0};
    const char *why = text_open(&text);

    for (const struct chart *k = c; k && !why; k = k->beside)
        why = draw_one(k, canvas, &text);
    if (!why) {
        canvas_end(canvas);
        why = text_paint(&text, canvas);
    }
    text_free(&text);
    return why;
}
