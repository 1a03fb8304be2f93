#include "tools/profile/head.h"

#include <math.h>
#include <stdlib.h>

#include "formats/reason.h"
#include "tools/profile/curve.h"
#include "tools/profile/gauge.h"
#include "tools/profile/opening.h"
#include "tools/profile/resample.h"

#define STEP 2.5e-5          /* m, of y while cutting */
#define CROWN_SLOPE 0.2      /* the crown of a head is where it is flatter: beyond, the parabola that continues it */
#define ROUND_SHARE 0.4      /* largest edge radius, of the width */
#define THINNEST 1e-3        /* m */
#define BESIDE 1e-4          /* m, that the faces of an outline go on straight beside it, so that its discs end at faces and not at the cut */

/* Height of an outline at y, its faces going on straight beside it; INFINITY further off. */
static double outline_height(const struct outline *o, double y)
{
    int64_t lo = 0, hi = o->n - 1;

    if (y < o->y[0] || y > o->y[hi]) {
        int64_t end = y < o->y[0] ? 0 : hi;
        return fabs(y - o->y[end]) > BESIDE ? INFINITY : o->z[end] + o->slope[end] * (y - o->y[end]);
    }
    while (hi - lo > 1) {
        int64_t middle = (lo + hi) / 2;
        if (o->y[middle] <= y)
            lo = middle;
        else
            hi = middle;
    }
    return o->z[lo] + (o->z[hi] - o->z[lo]) * (y - o->y[lo]) / (o->y[hi] - o->y[lo]);
}

/* The crown on the gauge side of y = 0 and beyond its edge; the rail itself on the field side. */
static double crown_height(const struct outline *o, double y)
{
    int64_t i = 0;

    while (i < o->n - 1 && o->slope[i] < -CROWN_SLOPE)
        i++;
    double d = y - o->y[i], second = o->curvature[i] * pow(1 + o->slope[i] * o->slope[i], 1.5);
    return d >= 0 ? outline_height(o, y) : o->z[i] + d * (o->slope[i] + d * second / 2);
}

/* z[n] from y on becomes a smooth outline; what lies deeper than the rail's outline is left out. */
static const char *head_outline(int64_t n, double y, const double *z, double depth, const struct head_options *o,
                                double r, struct outline *out)
{
    struct points p = {0};
    struct curve curve = {0};
    struct clean_count count;
    int64_t room = 0;
    const char *why = NULL;

    for (int64_t i = 0; !why && i < n; i++)
        if (z[i] <= depth)
            why = points_add(&p, &room, y + (double)i * STEP, z[i], 1);
    if (!why && !(why = clean_points(&p, &count)) && !(why = curve_fit(&curve, &p, fmin(o->smoothing, 2 * r))))
        if (!(why = resample_curve(&curve, o->spacing, out)))
            why = clean_outline(out);
    curve_free(&curve);
    points_free(&p);
    return why;
}

const char *head_blade(const struct section *rail, double thickness, double lowering, const struct head_options *o,
                       struct outline *blade)
{
    const struct outline *plain = &rail->outline;
    double r = fmin(o->edge_radius, ROUND_SHARE * thickness), depth = plain->z[0], from = plain->y[0] - BESIDE, face;
    const char *why;

    *blade = (struct outline){0};
    if (thickness < THINNEST)
        return reason("a blade %.3g mm thick is too thin to cut, at least %g mm", 1e3 * thickness, 1e3 * THINNEST);
    /* The back stands upright where the stock rail's gauge face is as deep as the rounded edge. */
    if ((why = gauge_face(plain, fmin(lowering + r, depth), &face)))
        return why;
    face = fmin(face, rail->gauge_face);
    double back = face + thickness, high = crown_height(plain, fmin(back, 0));
    int64_t n = (int64_t)((back - from) / STEP) + 1;
    double *z = calloc((size_t)n * 3, sizeof *z);
    if (!z)
        return REASON_MEMORY;
    for (int64_t i = 0; i < n; i++) {
        double y = from + (double)i * STEP;
        z[i] = fmax(outline_height(plain, y), lowering - high + crown_height(plain, y));
    }
    opening_round(n, STEP, back - from, r, z, z + n);
    why = head_outline(n, from, z, depth, o, r, blade);
    free(z);
    return why;
}

/* Top and gauge side of a machined wing rail before its edge is rounded; y_top is where the plain rail is highest. */
static double wing_height(const struct outline *plain, double y, double y_top, double y_level, double crown_radius)
{
    double short_of = fmax(y_level - y, 0), flank = plain->z[0] + plain->slope[0] * (y - plain->y[0]);

    return y >= y_top ? outline_height(plain, y) : fmax(flank, short_of * short_of / (2 * crown_radius));
}

const char *head_wing(const struct section *rail, double share, const struct head_top *top, const struct head_options *o,
                      struct outline *wing)
{
    const struct outline *plain = &rail->outline;
    double from = plain->y[0] - BESIDE, y_level = rail->gauge_face + top->level;
    int64_t highest = 0, n = (int64_t)((plain->y[plain->n - 1] + BESIDE - from) / STEP) + 1;

    *wing = (struct outline){0};
    for (int64_t i = 1; i < plain->n; i++)
        if (plain->z[i] < plain->z[highest])
            highest = i;
    if (y_level > plain->y[highest])
        return reason("a wing rail level from %g mm behind its edge on: the rail is highest there already at %.3g mm", 1e3 * top->level,
                      1e3 * (plain->y[highest] - rail->gauge_face));
    double *z = calloc((size_t)n * 3, sizeof *z);
    if (!z)
        return REASON_MEMORY;
    for (int64_t i = 0; i < n; i++)
        z[i] = wing_height(plain, from + (double)i * STEP, plain->y[highest], y_level, top->crown_radius);
    opening_round(n, STEP, INFINITY, o->edge_radius, z, z + n);
    for (int64_t i = 0; i < n; i++)
        z[i] = share * z[i] + (1 - share) * outline_height(plain, from + (double)i * STEP);
    const char *why = head_outline(n, from, z, plain->z[0], o, o->edge_radius, wing);
    free(z);
    return why;
}

const char *head_nose(const struct section *rail, double width, double lowering, const struct head_options *o,
                      struct outline *nose)
{
    const struct outline *plain = &rail->outline;
    double r = fmin(o->edge_radius, ROUND_SHARE * width), depth = plain->z[0], from = plain->y[0] - BESIDE;

    *nose = (struct outline){0};
    if (width < THINNEST)
        return reason("a nose %.3g mm wide is too thin to cut, at least %g mm", 1e3 * width, 1e3 * THINNEST);
    double mirror = 2 * rail->gauge_face + width, high = crown_height(plain, mirror / 2);
    int64_t n = (int64_t)((mirror - 2 * from) / STEP) + 1;
    double *z = calloc((size_t)n * 3, sizeof *z);

    if (!z)
        return REASON_MEMORY;
    for (int64_t i = 0; i < n; i++) {
        double y = from + (double)i * STEP, other = mirror - y;
        double head = fmax(outline_height(plain, y), outline_height(plain, other));
        double crown = fmax(crown_height(plain, y), crown_height(plain, other));
        z[i] = fmax(head, lowering - high + crown);
    }
    opening_round(n, STEP, INFINITY, r, z, z + n);
    const char *why = head_outline(n, from, z, depth, o, r, nose);
    free(z);
    return why;
}

const char *head_check(const struct head_face *face, double deepest, double spacing, struct outline *check)
{
    double r = face->edge_radius, turn = atan(1 / face->inclination);
    double z_face = r * (1 - cos(turn)) - face->height;                                    /* where the edge becomes the face */
    double y_edge = face->inclination * (z_face - face->depth) - r * sin(turn);            /* where the top becomes the edge */
    double edge = r * turn, slant = (deepest - z_face) / sin(turn), length = face->width + edge + slant;
    int64_t n = (int64_t)ceil(length / spacing);
    const char *why;

    *check = (struct outline){0};
    if (slant <= 0)
        return reason("a check rail rounded by %.3g mm has no working face", 1e3 * r);
    if ((why = outline_new(check, n + 1)))
        return why;
    for (int64_t i = 0; i <= n; i++) {
        double along = length * (double)i / (double)n - face->width, angle = fmin(fmax(along / r, 0), turn), down = fmax(along - edge, 0);
        check->y[i] = y_edge + fmin(along, 0) + r * sin(angle) + down * cos(turn);
        check->z[i] = r * (1 - cos(angle)) - face->height + down * sin(turn);
        check->slope[i] = tan(angle);
        check->curvature[i] = along > 0 && along < edge ? 1 / r : 0;
    }
    return NULL;
}
