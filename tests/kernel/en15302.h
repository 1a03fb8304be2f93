/* Wheels A, B, C, H, I and rail A of EN 15302:2021, annex I, and what its annexes J and K say of them. */
#ifndef VX_EN15302_H
#define VX_EN15302_H

#include "tests/kernel/shapes.h"

/* Zones (mm): z = c - sqrt(R^2 - (y - m)^2), or c + m y where R = 0; up to `to`. */
struct zone { double to, c, m, R; };

static inline void zone_point(struct shape *s, const struct zone *zone, double at)
{
    if (zone->R > 0)
        shape_arc_point(s, at * 1e-3, zone->m * 1e-3, zone->c * 1e-3, zone->R * 1e-3, -1);
    else
        shape_point(s, at * 1e-3, (zone->c + zone->m * at) * 1e-3, zone->m, 0);
}

/* Points every 0.05 mm, and where two zones meet. */
static inline struct shape *zones(char part, const struct zone *zone, double from, double radius, char side)
{
    struct shape *s = shape_new(part, 0.75, radius);
    for (; zone->to != 0; from = zone++->to) {
        int n = (int)ceil((zone->to - from) / 0.05);
        for (int i = 0; i < n; i++)
            zone_point(s, zone, from + (zone->to - from) * i / n);
    }
    return shape_end(s, side);
}

static const struct zone rail_a[] = {
    {-23.2401, 15.899044, -19.63949, 13}, {-7.8749, 80.277908, -1.0825, 80}, {13.0989, 299.48349, 17.5966, 300},
    {28.6709, 79.508225, 14.29829, 80}, {39.2, 13.598369, 26.33535, 13}, {0, 0, 0, 0},
};
static const struct zone wheel_a[] = {
    {-38.7372, -93.57685, -2.7475, 0}, {-29.4591, 17.64215, -25.5816, 14}, {-10.8749, 97.16493, -2.6594, 96.76055},
    {18.4173, 344.50806, 18.4173, 345}, {30, -0.49194, 0, 0}, {60, 1.50804, -0.066666, 0}, {0, 0, 0, 0},
};
static const struct zone wheel_b[] = {
    {-38.7879, -93.5767, -2.7475, 0}, {-29.3505, 17.7814, -25.6322, 14}, {-0.4787, 119.9745, 2.5204, 120}, {30, 0, -0.025, 0},
    {60, 0.75, -0.05, 0}, {0, 0, 0, 0},
};
static const struct zone wheel_c[] = {
    {-41.0534, 11.96051 - 2.47508685 * 41.05339, -2.47508685, 0}, {-32.3621, 16.830365, -29, 13}, {-17.587, 100.870534, -6.5, 100},
    {19, 329.45258, 19, 330}, {29, -0.54742374, 0, 0}, {59, -0.54742374 + 2.9, -0.1, 0}, {0, 0, 0, 0},
};
static const struct zone wheel_h[] = {
    {-38.722, -93.5767, -2.7475, 0}, {-28.3119, 17.6003, -25.5663, 14}, {-10.2297, -1.7902, -0.2, 0}, {30, 0, -0.025, 0},
    {60, 1.251, -0.0667, 0}, {0, 0, 0, 0},
};
static const struct zone wheel_i[] = {
    {-39.0486, -93.5767, -2.7475, 0}, {-29.9231, 18.49733, -25.8929, 14}, {5, 119.895788, 5, 120}, {30, -0.104212, 0, 0},
    {60, 1.89679, -0.0667, 0}, {0, 0, 0, 0},
};

/* Radius differences (mm) at 1 .. 6 mm, conicities at amplitudes 1 .. 7 mm. */
static const struct reference {
    const char *name;
    const struct zone *wheel;
    double from;                     /* mm, first point of the wheel */
    double limit;                    /* mm, of dr: more where a contact at a whole millimetre lies where two arcs meet */
    double dr[6], conicity[7];
} reference[] = {
    {"A", wheel_a, -39.7, 5e-3, {0.259, 0.667, 1.243, 1.913, 2.936, 4.327}, {0.125, 0.155, 0.188, 0.216, 0.254, 0.303, 0.505}},
    {"B", wheel_b, -39.7, 1e-3, {0.05, 0.1, 1.948, 2.515, 3.16, 3.886}, {0.025, 0.025, 0.030, 0.236, 0.280, 0.300, 0.484}},
    {"C", wheel_c, -43.8, 1e-3, {1.024, 1.271, 1.402, 1.533, 1.665, 1.801}, {0.515, 0.365, 0.271, 0.221, 0.191, 0.170, 0.156}},
    {"H", wheel_h, -39.7, 1e-3, {0.05, 0.1, 2.492, 2.717, 2.942, 3.167}, {0.025, 0.025, 0.260, 0.323, 0.307, 0.284, 0.448}},
    {"I", wheel_i, -39.7, 5e-3, {0, 2.475, 3.134, 3.875, 4.696, 5.025}, {0, 0.301, 0.493, 0.488, 0.476, 0.448, 0.490}},
};
/* The same of the pairs that are not alike: wheel A on the right with B on the left, and right wheels 1 mm larger in radius. */
static const double ab_conicity[7] = {0.136, 0.104, 0.124, 0.222, 0.270, 0.306, 0.490};
static const double larger_conicity[5][7] = {
    {0.280, 0.272, 0.261, 0.269, 0.307, 0.395, 0.491}, {0.667, 0.377, 0.278, 0.228, 0.289, 0.407, 0.472}, {0},
    {0.713, 0.380, 0.270, 0.223, 0.278, 0.423, 0.443}, {0.781, 0.418, 0.454, 0.481, 0.459, 0.498, 0.564},
};

/* Radius difference (mm) of wheel I on rail A at 0, 0.1, ... 7.1 mm, whole: annex J.6.  Conicities at 1, 1.2, ... 7 mm: annex K.6, and
 * K.10 for its right wheel larger by 1 mm. */
static const double dr_i[72] = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2.353, 2.414, 2.475, 2.538, 2.601, 2.665, 2.729, 2.795, 2.861, 2.928, 2.996, 3.065,
    3.134, 3.205, 3.276, 3.348, 3.421, 3.494, 3.569, 3.644, 3.720, 3.797, 3.875, 3.953, 4.033, 4.113, 4.194, 4.276, 4.358, 4.442, 4.526,
    4.612, 4.696, 4.728, 4.761, 4.793, 4.826, 4.859, 4.892, 4.925, 4.958, 4.992, 5.025, 5.059, 5.092, 5.126, 5.160, 5.194, 5.469, 6.075,
    6.878, 7.922, 9.288, 11.150,
};
static const double conicity_i[31] = {
    0, 0, 0, 0, 0.131, 0.301, 0.400, 0.450, 0.475, 0.488, 0.493, 0.495, 0.494, 0.493, 0.490, 0.488, 0.485, 0.483, 0.481, 0.479, 0.476, 0.472,
    0.467, 0.461, 0.454, 0.448, 0.441, 0.435, 0.434, 0.450, 0.490,
};
static const double conicity_i_larger[26] = {
    0.781, 0.663, 0.576, 0.509, 0.459, 0.418, 0.384, 0.355, 0.331, 0.423, 0.454, 0.469, 0.477, 0.480, 0.482, 0.481, 0.479, 0.475, 0.470, 0.464,
    0.459, 0.454, 0.448, 0.455, 0.473, 0.498,
};

#endif
