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

void receptance_begin(struct chart *c)
{
    c->x = (struct chart_axis){.label = "frequency (Hz)", .log = 1};
    struct chart_panel *magnitude = chart_add_panel(c, "receptance (m/N)", 1);
    magnitude->y.log = 1;
    magnitude->share = 2.4;
    struct chart_panel *phase = chart_add_panel(c, "phase (°)", 180 / M_PI);
    phase->y.step = 90;
}

/* Magnitude and phase of h [n][2], the phase in -3/2 pi .. pi/2, where that of a passive structure does not jump. */
static void polar(int64_t n, const double *h, double *magnitude, double *phase)
{
    for (int64_t i = 0; i < n; i++) {
        magnitude[i] = hypot(h[2 * i], h[2 * i + 1]);
        phase[i] = atan2(h[2 * i + 1], h[2 * i]);
        if (phase[i] > M_PI / 2)
            phase[i] -= 2 * M_PI;
    }
}

static const struct chart_series *add_curve(struct chart *c, int64_t n, const double *f, const double *h, const char *label,
                                            int hermite)
{
    double *magnitude = chart_numbers(c, n), *phase = chart_numbers(c, n);

    if (!magnitude || !phase)
        return NULL;
    polar(n, h, magnitude, phase);
    struct chart_series *s = chart_add_series(c, &c->panel[0], label, n, f, magnitude);
    struct chart_series *below = chart_add_series(c, &c->panel[1], NULL, n, f, phase);
    if (hermite) {
        s->colour = CHART_GREY;
        s->dash = CANVAS_DASHED;
    }
    below->colour = s->colour;
    below->dash = s->dash;
    return s;
}

const char *receptance_add(struct chart *c, const struct frf *r, const char *label)
{
    const char *where = !strcmp(r->at, "midspan") ? "between sleepers" : "above a sleeper";
    const char *rails = !strcmp(r->excite, "both") ? "both rails loaded" : !strcmp(r->excite, "left") ? "left rail loaded"
                                                                                                     : "right rail loaded";
    int64_t peak[PEAKS];

    if (!label)
        label = chart_words(c, "%s, %s", rails, where);
    const struct chart_series *s = add_curve(c, r->n, r->frequency, r->receptance, label, 0);
    int peaks = s ? receptance_peaks(s->n, s->y, prominence, PEAKS, peak) : 0;
    for (int k = 0; k < peaks; k++) {
        double at = r->frequency[peak[k]];
        chart_add_note(c, &c->panel[0], at, s->y[peak[k]], chart_words(c, "%.0f Hz", at))->colour = s->colour;
    }
    if (r->hermites == r->n && r->n > 0)
        add_curve(c, r->n, r->frequency, r->hermite, "by Hermite interpolation", 1);
    return c->why;
}
