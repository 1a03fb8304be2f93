/* Silhouette of a yawed wheel: the profile itself at yaw 0, a sphere that stays a sphere, brute force on the surface of revolution. */
#include "tools/contact/locus.h"

#include "tests/kernel/shapes.h"
#include "tests/kernel/tap.h"

#define R0 0.46
#define AT 0.75

static double ly[SHAPE_POINTS], lz[SHAPE_POINTS], ls[SHAPE_POINTS], lx[SHAPE_POINTS], lb[SHAPE_POINTS];
static const struct locus seen = {ly, lz, ls, lx, lb};

static void see(const struct prof *p, double yaw)
{
    locus_silhouette(&(struct locus_wheel){p->points, p->y, p->z, p->slope, p->curvature, AT, R0}, yaw, &seen);
}

static void yaw_zero(const struct prof *p)
{
    double worst = 0;
    see(p, 0);
    for (int64_t i = 0; i < p->points; i++)
        worst = fmax(worst, fmax(fabs(ly[i] - AT - p->y[i]), fmax(fabs(lz[i] - p->z[i]), fabs(ls[i] - p->slope[i]))));
    ok(worst < 1e-15, "at yaw 0 the silhouette is the profile (%.1e)", worst);
}

/* A sphere about the axle's point at AT appears as a circle of the same radius about AT cos(yaw). */
static void sphere(void)
{
    double y[41], z[41], slope[41], k[41], worst = 0, bent = 0, yaw = 0.02;
    for (int i = 0; i < 41; i++) {
        y[i] = (i - 20) * 5e-3;
        z[i] = sqrt(R0 * R0 - y[i] * y[i]) - R0;
        slope[i] = -y[i] / (z[i] + R0);
        k[i] = -1 / R0;
    }
    locus_silhouette(&(struct locus_wheel){41, y, z, slope, k, AT, R0}, yaw, &seen);
    for (int i = 0; i < 41; i++) {
        double across = ly[i] - AT * cos(yaw), down = lz[i] + R0;
        worst = fmax(worst, fabs(hypot(across, down) - R0));
        worst = fmax(worst, fabs(ls[i] + across / down));
        worst = fmax(worst, fabs(lx[i]));
        bent = fmax(bent, fabs(lb[i] * down - 1));
    }
    ok(worst < 1e-15, "a sphere's silhouette is a circle about its turned centre, beside it (%.1e)", worst);
    ok(bent < 1e-13, "in every cut along the track it is a circle (%.1e)", bent);
}

/* The lowest point of the whole surface in a cut y = const, by search over a. */
static double lowest_in_cut(const struct prof *p, double cut, double yaw)
{
    double low = -1;
    for (int64_t i = 0; i + 1 < p->points; i++)
        for (int k = 0; k < 20; k++) {
            double f = k / 20.0, a = AT + p->y[i] + f * (p->y[i + 1] - p->y[i]), r = R0 + p->z[i] + f * (p->z[i + 1] - p->z[i]);
            double sin_t = (cut - a * cos(yaw)) / (r * sin(yaw));     /* y = a cos + r sin(t) sin(yaw) */
            if (fabs(sin_t) < 1)
                low = fmax(low, r * sqrt(1 - sin_t * sin_t) - R0);
        }
    return low;
}

static void brute_force(const struct prof *p, double yaw)
{
    double worst = 0, slope = 0, back = 0;
    see(p, yaw);
    for (int64_t i = 600; i < p->points - 100; i += 37) {            /* from the flange's tread side outwards */
        worst = fmax(worst, fabs(lowest_in_cut(p, ly[i], yaw) - lz[i]));
        struct locus_point q;
        locus_invert(lx[i] - AT * sin(yaw), ly[i], lz[i], ls[i], R0, yaw, &q);
        back = fmax(back, fmax(fabs(q.a - AT - p->y[i]), fabs(q.r - R0 - p->z[i])));
        if (fabs(p->slope[i]) < 0.2)                                  /* where the trapezoid is exact enough */
            slope = fmax(slope, fabs((lz[i + 1] - lz[i]) / (ly[i + 1] - ly[i]) - 0.5 * (ls[i] + ls[i + 1])));
    }
    ok(worst < 5e-8, "yaw %g: lowest of the turned surface in every cut (%.1e m)", yaw, worst);
    ok(slope < 1e-6, "yaw %g: slope is that of the silhouette (%.1e)", yaw, slope);
    ok(back < 1e-14, "yaw %g: inverted to the wheel's own point (%.1e m)", yaw, back);
}

int main(void)
{
    struct shape *w = shape_s1002('r');
    const struct prof *p = &w->prof;

    yaw_zero(p);
    sphere();
    brute_force(p, 0.012);
    brute_force(p, -0.02);

    /* Flange root, z' = -0.299 at local radius 463 mm, 12 mrad: 1.65 mm ahead of the axle's own line. */
    double at[1] = {-0.028}, z[1] = {3e-3}, root[1] = {-0.299}, steep[1] = {100}, k[1] = {0};
    locus_silhouette(&(struct locus_wheel){1, at, z, root, k, AT, R0}, 0.012, &seen);
    near(lx[0] + at[0] * sin(0.012), 1.65e-3, 0.02e-3, "flange root at 12 mrad: 1.65 mm ahead of the axle");

    locus_silhouette(&(struct locus_wheel){1, at, z, steep, k, AT, R0}, 0.02, &seen);
    ok(isnan(ly[0]) && isnan(lz[0]), "a face seen edge on is not on the silhouette");
    free(w);
    return done();
}
