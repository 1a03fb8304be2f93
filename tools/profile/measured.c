#include "tools/profile/measured.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

#define SHAPE_SMOOTHING 4e-3   /* m: the direction of the surface is clear, its roundings of 5 mm still there */

static void residual_add(struct measured *m, const struct curve *c, const struct points *p, double station)
{
    struct curve_residual r = curve_compare(c, p);
    double points = (double)m->points, more = (double)p->n;

    if (r.worst > m->residual.worst) {
        m->residual.worst = r.worst;
        m->residual.worst_y = r.worst_y;
        m->worst_station = station;
    }
    m->residual.rms = sqrt((m->residual.rms * m->residual.rms * points + r.rms * r.rms * more) / (points + more));
    m->points += p->n;
}

const char *measured_add(struct measured *m, double station, struct points *p, const double *feature, double smoothing)
{
    struct measured_section s = {.station = station}, *larger;
    struct clean_count clean;
    const char *why = clean_points(p, &clean);

    if (why)
        return why;
    if (!(why = curve_fit(&s.curve, p, smoothing)))
        why = curve_fit(&s.shape, p, fmax(smoothing, SHAPE_SMOOTHING));
    if (!why && m->features && !(s.feature = calloc((size_t)m->features, sizeof *s.feature)))
        why = REASON_MEMORY;
    larger = why ? NULL : realloc(m->section, (size_t)(m->n + 1) * sizeof *larger);
    if (!larger) {
        curve_free(&s.curve);
        curve_free(&s.shape);
        free(s.feature);
        return why ? why : REASON_MEMORY;
    }
    if (m->features)
        memcpy(s.feature, feature, (size_t)m->features * sizeof *feature);
    residual_add(m, &s.curve, p, station);
    m->clean.doubles += clean.doubles;
    m->clean.zigzags += clean.zigzags;
    m->clean.longest_gap = fmax(m->clean.longest_gap, clean.longest_gap);
    m->section = larger;
    m->section[m->n++] = s;
    return NULL;
}

/* Features k and k + 1 are there in the same sections: the surface between them belongs to one body. */
static int features_joined(const struct measured *m, int64_t k)
{
    for (int64_t i = 0; i < m->n; i++)
        if ((m->section[i].feature[k] < 0) != (m->section[i].feature[k + 1] < 0))
            return 0;
    return 1;
}

/* Pieces of section i, of each run of declared features in turn. */
static const char *section_cut(const struct measured *m, int64_t i, double deepest, struct piece piece[PIECES_MOST], int *n)
{
    const struct measured_section *s = &m->section[i];
    struct piece more[PIECES_MOST];

    if (m->features == 0) {
        *n = piece_cut(&s->curve, &s->shape, 0, s->curve.length, deepest, piece);
        return NULL;
    }
    *n = 0;
    for (int64_t k = 0, end; k < m->features; k = end) {
        for (end = k + 1; end < m->features && features_joined(m, end - 1); end++)
            ;
        double from = s->feature[k], to = fmin(s->feature[end - 1], s->curve.length);
        if (end - k > PIECE_FEATURES)
            return reason("%lld declared features of one body, at most %d are read", (long long)(end - k), PIECE_FEATURES);
        int pieces = from < 0 || to <= from ? 0 : piece_cut(&s->curve, &s->shape, from, to, deepest, more);
        for (int j = 0; j < pieces && *n < PIECES_MOST; j++) {
            if (end - k > 2)
                piece_declare(&more[j], (int)(end - k), s->feature + k);
            piece[(*n)++] = more[j];
        }
    }
    return NULL;
}

static double overlap(const struct piece *a, const struct piece *b)
{
    return fmin(a->y_most, b->y_most) - fmax(a->y_least, b->y_least);
}

static const char *body_new(struct measured *m, const char *name)
{
    struct loft *larger = realloc(m->body, (size_t)(m->bodies + 1) * sizeof *larger);
    if (!larger)
        return REASON_MEMORY;
    m->body = larger;
    m->body[m->bodies] = (struct loft){0};
    snprintf(m->body[m->bodies].name, sizeof m->body->name, m->bodies ? "%s %lld" : "%s", name, (long long)m->bodies + 1);
    m->bodies++;
    return NULL;
}

/* The body whose last piece lies most under the piece, and no other piece of this section lies more: else -1. */
static int64_t body_find(const struct measured *m, int64_t i, const struct piece *piece, int n, int j)
{
    int64_t found = -1;
    double most = 0;

    for (int64_t b = 0; b < m->bodies; b++) {
        const struct loft *l = &m->body[b];
        if (l->section[l->n - 1].station != m->section[i - 1].station)
            continue;
        double over = overlap(&l->section[l->n - 1].piece, &piece[j]);
        int mine = over > most;
        for (int k = 0; k < n; k++)
            mine = mine && (k == j || overlap(&l->section[l->n - 1].piece, &piece[k]) <= over);
        if (mine) {
            found = b;
            most = over;
        }
    }
    return found;
}

const char *measured_join(struct measured *m, double deepest, const char *name)
{
    struct piece piece[PIECES_MOST];
    int64_t body[PIECES_MOST];
    const char *why;
    int n;

    for (int64_t i = 0; i < m->n; i++) {
        const struct measured_section *s = &m->section[i];
        if ((why = section_cut(m, i, deepest, piece, &n)))
            return why;
        for (int j = 0; j < n; j++)
            body[j] = i ? body_find(m, i, piece, n, j) : -1;
        for (int j = 0; j < n; j++) {
            if (body[j] < 0 && (why = body_new(m, name)))
                return why;
            if ((why = loft_add(&m->body[body[j] < 0 ? m->bodies - 1 : body[j]], s->station, &s->curve, &piece[j])))
                return why;
        }
    }
    return m->bodies ? NULL : "no section reaches above the cut depth";
}

void measured_free(struct measured *m)
{
    for (int64_t b = 0; b < m->bodies; b++)
        loft_free(&m->body[b]);
    for (int64_t i = 0; i < m->n; i++) {
        curve_free(&m->section[i].curve);
        curve_free(&m->section[i].shape);
        free(m->section[i].feature);
    }
    free(m->body);
    free(m->section);
    *m = (struct measured){0};
}
