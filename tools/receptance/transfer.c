/* FFTW (Frigo and Johnson 2005, Proc. IEEE 93, 216), plans by estimate: the same numbers every time. */
#include "tools/receptance/transfer.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <fftw3.h>

#include "formats/reason.h"

static const double WHOLE = 1e-6;      /* a multiple may be off by this part of a bin */
static const double EXCITED = 1e-4;    /* of the largest power of the force: below, it is what leaks from elsewhere */

/* Spectra summed over segments, at the bins wanted. */
struct spectra {
    double *FF, *zz;       /* [n] */
    double *re, *im;       /* [n] of conj(F) z */
};

struct work {
    double *f, *z;         /* [segment + 2] in place */
    fftw_plan plan_f, plan_z;
};

static const char *work_new(struct work *w, int64_t segment)
{
    *w = (struct work){.f = fftw_alloc_real((size_t)segment + 2), .z = fftw_alloc_real((size_t)segment + 2)};
    if (w->f && w->z) {
        w->plan_f = fftw_plan_dft_r2c_1d((int)segment, w->f, (fftw_complex *)w->f, FFTW_ESTIMATE);
        w->plan_z = fftw_plan_dft_r2c_1d((int)segment, w->z, (fftw_complex *)w->z, FFTW_ESTIMATE);
    }
    return w->plan_f && w->plan_z ? NULL : REASON_MEMORY;
}

static void work_free(struct work *w)
{
    fftw_destroy_plan(w->plan_f);
    fftw_destroy_plan(w->plan_z);
    fftw_free(w->f);
    fftw_free(w->z);
}

/* The segment from `first` on into the sums, at bins from, from + every, ... */
static void add_segment(const struct transfer *t, int64_t first, struct work *w, int64_t from, int64_t every, int64_t n, struct spectra *s)
{
    const fftw_complex *F = (const fftw_complex *)w->f, *z = (const fftw_complex *)w->z;

    for (int64_t i = 0; i < t->segment; i++) {
        const double taper = t->window == TRANSFER_HANN ? 0.5 * (1 - cos(2 * M_PI * (double)i / (double)t->segment)) : 1;
        w->f[i] = taper * t->F[first + i];
        w->z[i] = taper * t->z[first + i];
    }
    fftw_execute(w->plan_f);
    fftw_execute(w->plan_z);
    for (int64_t k = 0; k < n; k++) {
        const double *a = F[from + k * every], *b = z[from + k * every];
        s->FF[k] += a[0] * a[0] + a[1] * a[1];
        s->zz[k] += b[0] * b[0] + b[1] * b[1];
        s->re[k] += a[0] * b[0] + a[1] * b[1];
        s->im[k] += a[0] * b[1] - a[1] * b[0];
    }
}

/* The frequencies [n] that the force excites come first; returns how many. */
static int64_t divide(const struct transfer *t, const struct spectra *s, int64_t n, double *frequency, double *H, double *hermite,
                      double *coherence)
{
    double most = 0;
    int64_t kept = 0;

    for (int64_t k = 0; k < n; k++)
        most = fmax(most, s->FF[k]);
    for (int64_t k = 0; k < n; k++)
        if (s->FF[k] > EXCITED * most) {
            frequency[kept] = frequency[k];
            H[2 * kept] = s->re[k] / s->FF[k];
            H[2 * kept + 1] = s->im[k] / s->FF[k];
            hermite[2 * kept] = H[2 * kept] - t->held;
            hermite[2 * kept + 1] = H[2 * kept + 1];
            coherence[kept++] = s->zz[k] > 0 ? fmin(1, (s->re[k] * s->re[k] + s->im[k] * s->im[k]) / (s->FF[k] * s->zz[k])) : 0;
        }
    return kept;
}

/* A force on a node leaves nothing, but for rounding, to the element beside it. */
static int differs(const double *H, const double *hermite, int64_t n)
{
    int any = 0;

    for (int64_t k = 0; k < 2 * n; k++)
        any |= H[k] != hermite[k];
    return any;
}

/* The bin of a frequency, or -1 where it lies between two. */
static int64_t bin_of(const struct transfer *t, double frequency)
{
    const double bin = frequency * (double)t->segment * t->step;

    return fabs(bin - rint(bin)) < WHOLE * fmax(1, bin) ? (int64_t)rint(bin) : -1;
}

static const char *check(const struct transfer *t, const struct sweep *s)
{
    const double resolution = 1 / ((double)t->segment * t->step);

    if (t->segment < 2 || t->segment > t->n || t->segment > INT_MAX - 2)
        return reason("a segment of %lld samples is not within the %lld of the history", (long long)t->segment, (long long)t->n);
    if (bin_of(t, s->from) < 0 || bin_of(t, s->step) < 1)
        return reason("frequencies from %g Hz by %g Hz are not multiples of %.6g Hz, one over the segment", s->from, s->step, resolution);
    if (s->to > 0.5 / t->step)
        return reason("%g Hz lies beyond half the sampling rate, %g Hz", s->to, 0.5 / t->step);
    return NULL;
}

static const char *sum_segments(const struct transfer *t, const struct sweep *s, int64_t n, struct spectra *sum, int64_t *segments)
{
    const int64_t hop = t->window == TRANSFER_HANN ? t->segment / 2 : t->segment;
    struct work w;
    const char *why = work_new(&w, t->segment);

    *segments = 0;
    for (int64_t first = 0; !why && first + t->segment <= t->n; first += hop) {
        add_segment(t, first, &w, bin_of(t, s->from), bin_of(t, s->step), n, sum);
        ++*segments;
    }
    work_free(&w);
    return why;
}

const char *transfer_estimate(struct frf *r, const struct transfer *t, const struct sweep *s)
{
    const int64_t n = (int64_t)floor((s->to - s->from) / s->step + 1e-9) + 1;
    const char *why = check(t, s);
    int64_t segments;

    if (why)
        return why;
    double *frequency = calloc((size_t)n, 10 * sizeof *frequency);
    if (!frequency)
        return REASON_MEMORY;
    double *H = frequency + n, *hermite = frequency + 3 * n, *coherence = frequency + 5 * n, *spare = frequency + 6 * n;
    struct spectra sum = {spare, spare + n, spare + 2 * n, spare + 3 * n};
    for (int64_t k = 0; k < n; k++)
        frequency[k] = s->from + (double)k * s->step;
    why = sum_segments(t, s, n, &sum, &segments);
    const int64_t kept = why ? 0 : divide(t, &sum, n, frequency, H, hermite, coherence);
    if (kept == 0) {
        free(frequency);
        return why ? why : reason("from %g to %g Hz the force excites nothing", s->from, s->to);
    }
    r->store = frequency;
    r->n = kept;
    r->frequency = frequency;
    r->H = H;
    r->hermite = hermite;
    r->hermites = differs(H, hermite, kept) ? kept : 0;
    r->coherence = coherence;
    r->coherences = segments > 1 ? kept : 0;
    return NULL;
}
