#include "tools/draw/receptance.h"

#include <math.h>
#include <string.h>

enum { PEAKS = 6 };
static const double prominence = 1.15;     /* falls to both sides of a peak whose frequency is written */

int receptance_peaks(int64_t n, const double *a, double ratio, int most, int64_t *peak)
{
    int found = 0, rising = 1;
    int64_t top = 0, bottom = 0;

    for (int64_t i = 1; i < n && found < most; i++) {
        if (a[i] > a[top])
            top = i;
        if (a[i] < a[bottom])
            bottom = i;
        if (rising && a[top] > ratio * a[i]) {
            if (top > 0)
                peak[found++] = top;
            rising = 0;
            bottom = i;
        } else if (!rising && a[i] > ratio * a[bottom]) {
            rising = 1;
            top = i;
        }
    }
    return found;
}

void receptance_begin(struct chart *c, int quantity)
{
    static const char *const label[FRF_QUANTITIES] = {"receptance (m/N)", "mobility (m/(N s))", "accelerance (m/(N s²))"};

    c->x = (struct chart_axis){.label = "frequency (Hz)", .log = 1};
    struct chart_panel *magnitude = chart_add_panel(c, label[quantity], 1);
    magnitude->y.log = 1;
    magnitude->share = 2.4;
    struct chart_panel *phase = chart_add_panel(c, "phase (°)", 180 / M_PI);
    phase->y.step = 90;
}

/* Magnitude and phase of h, the phase of a receptance in -3/2 pi .. pi/2, of a mobility a quarter and of an accelerance half a
 * turn above: where that of a passive structure does not jump. */
static void polar(int quantity, double re, double im, double *magnitude, double *phase)
{
    const double top = M_PI / 2 * (1 + quantity), angle = atan2(im, re);

    *magnitude = hypot(re, im);
    *phase = angle > top ? angle - 2 * M_PI : angle <= top - 2 * M_PI ? angle + 2 * M_PI : angle;
}

/* The pen is lifted where phase [n] jumps. */
static void lift(int64_t n, double *phase)
{
    double before = NAN;

    for (int64_t i = 0; i < n; i++) {
        const double here = phase[i];
        if (fabs(here - before) > M_PI)
            phase[i] = NAN;
        before = here;
    }
}

static const char *rail_words(const char *on)
{
    return !strcmp(on, "both") ? "both rails" : !strcmp(on, "left") ? "left rail" : !strcmp(on, "right") ? "right rail" : "sleeper";
}

/* "both rails loaded, above a sleeper", "left rail loaded at 1.20 m, motion of right rail at 1.80 m"; what is sideways says so. */
static const char *label_of(struct chart *c, const struct frf *r)
{
    const struct frf_place *f = &r->force, *m = &r->motion;
    const char *rails = rail_words(f->on), *force = f->lateral ? " sideways" : "", *motion = m->lateral ? " sideways" : "";

    if (f->x == m->x && f->lateral == m->lateral && (!strcmp(f->on, m->on) || !strcmp(f->on, "both")) && strcmp(f->at, "station")) {
        const char *where = !strcmp(f->at, "midspan") ? ", between sleepers" : strcmp(f->on, "sleeper") ? ", above a sleeper" : "";
        return chart_words(c, "%s loaded%s%s", rails, force, where);
    }
    return chart_words(c, "%s loaded%s at %.2f m, motion%s of %s at %.2f m", rails, force, f->x, motion, rail_words(m->on), m->x);
}

static const struct chart_series *add_curve(struct chart *c, const struct frf *r, const double *h, const char *label, int hermite)
{
    double *magnitude = chart_numbers(c, r->n), *phase = chart_numbers(c, r->n);

    if (!magnitude || !phase)
        return NULL;
    for (int64_t i = 0; i < r->n; i++)
        polar(r->quantity, h[2 * i], h[2 * i + 1], &magnitude[i], &phase[i]);
    lift(r->n, phase);
    struct chart_series *s = chart_add_series(c, &c->panel[0], label, r->n, r->frequency, magnitude);
    struct chart_series *below = chart_add_series(c, &c->panel[1], NULL, r->n, r->frequency, phase);
    if (hermite) {
        s->colour = CHART_GREY;
        s->dash = CANVAS_DASHED;
    }
    below->colour = s->colour;
    below->dash = s->dash;
    return s;
}

/* Below the phase, in the panel that the first of them opens. */
static void add_coherence(struct chart *c, const struct frf *r, unsigned colour)
{
    if (c->panels < 3) {
        struct chart_panel *p = chart_add_panel(c, "coherence", 1);
        p->y.lo = 0;
        p->y.hi = 1.05;
        p->share = 1;
    }
    chart_add_series(c, &c->panel[2], NULL, r->n, r->frequency, r->coherence)->colour = colour;
}

const char *receptance_add(struct chart *c, const struct frf *r, const char *label)
{
    int64_t peak[PEAKS];
    const struct chart_series *s = add_curve(c, r, r->H, label ? label : label_of(c, r), 0);
    int peaks = s ? receptance_peaks(s->n, s->y, prominence, PEAKS, peak) : 0;

    for (int k = 0; k < peaks; k++) {
        double at = r->frequency[peak[k]];
        chart_add_note(c, &c->panel[0], at, s->y[peak[k]], chart_words(c, "%.0f Hz", at))->colour = s->colour;
    }
    if (s && r->coherences == r->n && r->n > 0)
        add_coherence(c, r, s->colour);
    if (r->hermites == r->n && r->n > 0)
        add_curve(c, r, r->hermite, "by Hermite interpolation", 1);
    return c->why;
}

const char *receptance_add_measured(struct chart *c, const struct columns *t, int quantity, const char *label)
{
    double *y[2] = {chart_numbers(c, t->rows), chart_numbers(c, t->rows)};

    if (t->n < 3 || columns_find(t, "frequency") != 0)
        return "not a table of frequency, real and imaginary part";
    if (!y[0] || !y[1])
        return c->why;
    for (int64_t i = 0; i < t->rows; i++)
        polar(quantity, t->value[1][i], t->value[2][i], &y[0][i], &y[1][i]);
    for (int k = 0; k < 2; k++) {
        struct chart_series *s = chart_add_series(c, &c->panel[k], k ? NULL : label ? label : "measured", t->rows, t->value[0], y[k]);
        s->colour = CHART_BLACK;
        s->width = 0;
        s->mark = CANVAS_DISC;
        s->size = 2.5;
    }
    return c->why;
}
