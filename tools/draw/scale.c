/* Round numbers: 1, 2 and 5 times powers of ten. */
#include "tools/draw/scale.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double tiny = 1e-9;          /* relative slack of a comparison of round numbers */
static const double mantissa[] = {1, 2, 5, 10};

double scale_step(double range, int most)
{
    double raw = range / most, unit = pow(10, floor(log10(raw)));

    for (size_t k = 0; k < sizeof mantissa / sizeof *mantissa; k++)
        if (mantissa[k] * unit >= raw * (1 - tiny))
            return mantissa[k] * unit;
    return 10 * unit;
}

/* The largest m 10^k <= v, or the smallest >= v, with m of 1, 2, 5. */
static double round_log(double v, int up)
{
    double unit = pow(10, floor(log10(v) + tiny)), got = unit;

    for (size_t k = 0; k < sizeof mantissa / sizeof *mantissa; k++) {
        double at = mantissa[k] * unit;
        if (up && at >= v * (1 - tiny))
            return at;
        if (!up && at <= v * (1 + tiny))
            got = at;
    }
    return got;
}

void scale_widen(double *lo, double *hi, int log, double step, int most)
{
    if (log) {
        *lo = round_log(*lo, 0);
        *hi = round_log(*hi, 1);
        if (*hi <= *lo * (1 + tiny)) {
            *lo /= 2;
            *hi *= 2;
        }
        return;
    }
    if (*hi - *lo <= tiny * fmax(fabs(*lo), fabs(*hi))) {
        double half = *lo == 0 ? 1 : 0.1 * fabs(*lo);
        *lo -= half;
        *hi += half;
    }
    if (step <= 0)
        step = scale_step(*hi - *lo, most);
    *lo = step * floor(*lo / step + tiny);
    *hi = step * ceil(*hi / step - tiny);
}

/* Appends n as superscript digits. */
static void superscript(char *label, int n)
{
    static const char *const digit[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char plain[16];

    snprintf(plain, sizeof plain, "%d", n);
    for (const char *p = plain; *p; p++)
        strncat(label, *p == '-' ? "⁻" : digit[*p - '0'], SCALE_LABEL - strlen(label) - 1);
}

static int decimals(double step)
{
    int n = (int)ceil(-log10(step) - tiny);

    return n > 0 ? n : 0;
}

void scale_format(char label[SCALE_LABEL], double v, double step, double largest)
{
    const char *sign = v < 0 ? "−" : "";
    int places = decimals(step);

    if (fabs(v) < step * tiny) {
        snprintf(label, SCALE_LABEL, "0");
        return;
    }
    if (largest < 1e5 && places <= 4) {
        snprintf(label, SCALE_LABEL, "%s%.*f", sign, places, fabs(v));
        return;
    }
    int power = (int)floor(log10(largest) + tiny);
    double unit = pow(10, power), m = fabs(v) / unit;
    places = decimals(step / unit);
    if (places == 0 && fabs(m - 1) < tiny)
        snprintf(label, SCALE_LABEL, "%s10", sign);
    else
        snprintf(label, SCALE_LABEL, "%s%.*f×10", sign, places, m);
    superscript(label, power);
}

static void set_linear(struct scale *s, double step, int most)
{
    if (step <= 0 || (s->hi - s->lo) / step > SCALE_TICKS - 2)
        step = scale_step(s->hi - s->lo, most);
    double first = ceil(s->lo / step - tiny), last = floor(s->hi / step + tiny);
    double largest = fmax(fabs(s->lo), fabs(s->hi));
    for (double k = first; k <= last && s->ticks < SCALE_TICKS; k++) {
        scale_format(s->label[s->ticks], k * step, step, largest);
        s->tick[s->ticks++] = k * step;
    }
}

/* Powers of ten, where there are many only some of them; 2 and 5 too where there are few. */
static void set_log(struct scale *s, int most)
{
    double first = floor(log10(s->lo) + tiny), last = ceil(log10(s->hi) - tiny);
    double span = log10(s->hi / s->lo);
    int fives = 3 * span <= most, every = (int)ceil(span / most);

    for (double k = first; k <= last; k++)
        for (int m = 1; m < 10; m++) {
            double v = m * pow(10, k);
            int labelled = fives ? m == 1 || m == 2 || m == 5 : m == 1 && fmod(k - first, every) == 0;
            if (v < s->lo * (1 - tiny) || v > s->hi * (1 + tiny))
                continue;
            if (labelled && s->ticks < SCALE_TICKS) {
                scale_format(s->label[s->ticks], v, v / m, v);
                s->tick[s->ticks++] = v;
            } else if (!labelled && s->minors < SCALE_MINORS)
                s->minor[s->minors++] = v;
        }
}

void scale_set(struct scale *s, double lo, double hi, int log, double step, int most)
{
    *s = (struct scale){.log = log, .lo = lo, .hi = hi};
    if (most < 1)
        most = 1;
    if (log)
        set_log(s, most);
    else
        set_linear(s, step, most);
}

double scale_place(const struct scale *s, double v)
{
    if (s->log)
        return v > 0 ? log(v / s->lo) / log(s->hi / s->lo) : NAN;
    return (v - s->lo) / (s->hi - s->lo);
}
