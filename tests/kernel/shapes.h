/* Profiles by formula for the contact tests: S1002 (EN 13715, zones A to H) and 60E1 (EN 13674-1, head arcs), arcs and lines. */
#ifndef VX_SHAPES_H
#define VX_SHAPES_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/prof.h"

enum { SHAPE_POINTS = 4000 };

struct shape {
    struct prof prof;
    double y[SHAPE_POINTS], z[SHAPE_POINTS], slope[SHAPE_POINTS], curvature[SHAPE_POINTS], fall[SHAPE_POINTS], station[1];
    int64_t poly_section[1], poly_body[1], poly_first[2];
    char body[1][PROF_NAME];
};

static inline void shape_point(struct shape *s, double y, double z, double slope, double curvature)
{
    int64_t i = s->prof.points++;
    s->y[i] = y;
    s->z[i] = z;
    s->slope[i] = slope;
    s->curvature[i] = curvature;
}

static inline struct shape *shape_new(char part, double position, double radius)
{
    struct shape *s = calloc(1, sizeof *s);
    s->prof = (struct prof){.side = 'r', .part = part, .position = position, .radius = radius, .sections = 1, .bodies = 1, .polys = 1};
    return s;
}

/* Points the prof at its arrays; a left side is the mirror image. */
static inline struct shape *shape_end(struct shape *s, char side)
{
    struct prof *p = &s->prof;
    int64_t n = p->points;
    p->side = side;
    if (side == 'l') {
        p->position = -p->position;
        for (int64_t i = 0, j = n - 1; i <= j; i++, j--) {
            double y = s->y[i], z = s->z[i], slope = s->slope[i], curvature = s->curvature[i];
            s->y[i] = -s->y[j]; s->z[i] = s->z[j]; s->slope[i] = -s->slope[j]; s->curvature[i] = s->curvature[j];
            s->y[j] = -y; s->z[j] = z; s->slope[j] = -slope; s->curvature[j] = curvature;
        }
    }
    snprintf(s->body[0], sizeof s->body[0], "rail");
    s->poly_first[1] = n;
    p->station = s->station;
    p->body = (const char (*)[PROF_NAME])s->body;
    p->poly_section = s->poly_section;
    p->poly_body = s->poly_body;
    p->poly_first = s->poly_first;
    p->y = s->y;
    p->z = s->z;
    p->slope = s->slope;
    p->curvature = s->curvature;
    p->fall = s->fall;
    return s;
}

/* Arc z = cz -+ sqrt(R^2 - (y - cy)^2), sign -1 with its centre below the points (convex up). */
static inline void shape_arc_point(struct shape *s, double y, double cy, double cz, double R, int sign)
{
    double root = sqrt(R * R - (y - cy) * (y - cy));
    shape_point(s, y, cz + sign * root, -sign * (y - cy) / root, -sign / R);
}

/* S1002 in m, at y toward the field side; 1 mm is 1e-3 here. */
static inline void shape_s1002_point(struct shape *o, double y)
{
    static const double B[] = {0, -3.358537058e-2, 1.565681624e-3, -2.810427944e-5, 5.844240864e-8, -1.562379023e-8, 5.309217349e-15,
                               -5.957839843e-12, 2.646656573e-13};
    static const double C[] = {-4.320221063e3, -1.038384026e3, -1.065501873e2, -6.051367875, -2.054332446e-1, -4.169739389e-3,
                               -4.687195829e-5, -2.252755540e-7};
    double s = y * 1e3;
    if (s > 32.15796) {
        shape_point(o, y, (1.364323640 - 0.066666667 * s) * 1e-3, -0.066666667, 0);
    } else if (s > -35) {
        const double *c = s > -26 ? B : C;
        int n = s > -26 ? 9 : 8;
        double z = 0, d = 0, dd = 0;
        for (int i = n - 1; i >= 0; i--) {
            dd = dd * s + 2 * d;
            d = d * s + z;
            z = z * s + c[i];
        }
        shape_point(o, y, z * 1e-3, d, dd * 1e3 / pow(1 + d * d, 1.5));
    } else if (s > -38.426669071) {
        shape_arc_point(o, y, -26.210665e-3, 16.446e-3, 13e-3, -1);
    } else if (s > -39.764473993) {
        shape_point(o, y, (-93.576667419 - 2.747477419 * s) * 1e-3, -2.747477419, 0);
    } else if (s > -49.662510381) {
        shape_arc_point(o, y, -58.558326413e-3, 8.834924130e-3, 20e-3, 1);
    } else if (s > -62.764705882) {
        shape_arc_point(o, y, -55e-3, 16e-3, 12e-3, 1);
    } else {
        shape_arc_point(o, y, -49.5e-3, 9.519259302e-3, 20.5e-3, 1);
    }
}

static inline struct shape *shape_s1002(char side)
{
    struct shape *s = shape_new('w', 0.75, 0.46);
    for (int i = -1390; i <= 1200; i++)
        shape_s1002_point(s, i * 50e-6);
    return shape_end(s, side);
}

/* Half head of 60E1 (m) at arc length l from the top's centre: y, z, tangent's angle, curvature. */
static inline void shape_60e1_half(double l, double *y, double *z, double *angle, double *curvature)
{
    static const double R[3] = {0.3, 0.08, 0.013}, to[3] = {10.228e-3, 26.0265e-3, 36e-3},
                        cy[3] = {0, 7.500533e-3, 23.016030e-3}, cz[3] = {0.3, 80.127896e-3, 14.949147e-3};
    double from = 0;
    for (int i = 0; i < 3; i++) {
        double a0 = asin((from - cy[i]) / R[i]), a1 = asin((to[i] - cy[i]) / R[i]), length = R[i] * (a1 - a0);
        if (l <= length) {
            *angle = a0 + l / R[i];
            *y = cy[i] + R[i] * sin(*angle);
            *z = cz[i] - R[i] * cos(*angle);
            *curvature = 1 / R[i];
            return;
        }
        l -= length;
        from = to[i];
        if (i == 2) {
            *angle = atan(20);
            *y = to[i] + l * cos(*angle);
            *z = cz[i] - R[i] * cos(a1) + l * sin(*angle);
            *curvature = 0;
        }
    }
}

/* 60E1 leaning inwards by `cant` (slope), top at z = 0, gauge face 14 mm below it at 0.7175 m from the track's centre line. */
static inline struct shape *shape_60e1(char side, double cant)
{
    struct shape *s = shape_new('r', 0, 0);
    double lean = -atan(cant), top = 0, face = 0;
    for (int i = -1000; i <= 1000; i++) {
        double y, z, a, k;
        shape_60e1_half(abs(i) * 50e-6, &y, &z, &a, &k);
        y = i < 0 ? -y : y;
        a = (i < 0 ? -a : a) + lean;
        if (fabs(a) < 1.53)
            shape_point(s, y * cos(lean) - z * sin(lean), z * cos(lean) + y * sin(lean), tan(a), k);
    }
    for (int64_t i = 0; i < s->prof.points; i++)
        top = s->z[i] < top ? s->z[i] : top;
    for (int64_t i = 0; i < s->prof.points; i++)
        s->z[i] -= top;
    for (int64_t i = 0; s->z[i + 1] > 14e-3 || i == 0; i++)
        face = s->y[i + 1] + (s->y[i + 2] - s->y[i + 1]) * (14e-3 - s->z[i + 1]) / (s->z[i + 2] - s->z[i + 1]);
    s->prof.position = 0.7175 - face;
    return shape_end(s, side);
}

#endif
