/* The thesis' yawed wheel: the profile itself at yaw 0, a cone of known advance, S1002 against its silhouette, and the way back. */
#include "tools/contact/thesis.h"

#include <string.h>

#include "tests/kernel/shapes.h"
#include "tests/kernel/tap.h"

#define R0 0.46
#define AT 0.75

static double ly[SHAPE_POINTS], lz[SHAPE_POINTS], ls[SHAPE_POINTS], lx[SHAPE_POINTS], lr[SHAPE_POINTS];
static double ey[SHAPE_POINTS], ez[SHAPE_POINTS], es[SHAPE_POINTS], ex[SHAPE_POINTS], er[SHAPE_POINTS];
static const struct locus mine = {ly, lz, ls, lx, lr}, silhouette = {ey, ez, es, ex, er};

/* y of the flange's face at depth z (m), between the points; the flange's tip lies at i = 0 or beyond. */
static double face_at(const double *y, const double *z, int64_t n, double depth)
{
    int64_t tip = 0;
    for (int64_t i = 1; i < n; i++)
        tip = z[i] > z[tip] ? i : tip;
    for (int64_t i = tip; i + 1 < n; i++)
        if (z[i] >= depth && z[i + 1] < depth)
            return y[i] + (z[i] - depth) / (z[i] - z[i + 1]) * (y[i + 1] - y[i]);
    return (double)NAN;
}

static struct locus_wheel wheel_of(const struct prof *p)
{
    return (struct locus_wheel){p->points, p->y, p->z, p->slope, p->curvature, AT, R0};
}

static void turned(const struct prof *p, double yaw, struct thesis_cut *cut)
{
    const struct locus_wheel w = wheel_of(p);
    const char *why = thesis_section(&w, yaw, cut);
    ok(why == NULL, "yaw %g: a section is found%s%s", yaw, why ? ": " : "", why ? why : "");
    thesis_profile(&w, yaw, cut, &mine);
    locus_silhouette(&w, yaw, &silhouette);
}

static void yaw_zero(const struct prof *p)
{
    struct thesis_cut cut;
    double worst = 0;
    turned(p, 0, &cut);
    for (int64_t i = 0; i < p->points; i++)
        worst = fmax(worst, fmax(fabs(ly[i] - AT - p->y[i]), fmax(fabs(lz[i] - p->z[i]), fabs(ls[i] - p->slope[i]))));
    ok(worst < 1e-15 && cut.dy == 0 && cut.dz == 0, "at yaw 0 it is the profile and nothing is removed (%.1e)", worst);
}

static void s1002(const struct prof *p, double yaw)
{
    struct thesis_cut cut, back;
    double worst = 0, tread = 0;
    int64_t kept = 0, removed = 0, steps = 0;
    turned(p, yaw, &cut);
    ok(cut.dy > 0 && cut.dz > 0 && cut.y < -30e-3 && cut.y > -39e-3, "yaw %g: %.3f mm removed in the flange's root, from y = %.2f mm on",
       yaw, cut.dy * 1e3, cut.y * 1e3);
    for (int64_t i = 0; i < p->points; i++) {
        struct locus_point q;
        if (p->y[i] < cut.y && p->y[i] + cut.dy > cut.y) {
            removed++;
            continue;
        }
        kept++;
        steps += i > 0 && (ly[i] < ly[i - 1] || fabs(lz[i] - lz[i - 1]) > 3.0 * fabs(p->slope[i]) * 50e-6 + 50e-6);
        thesis_invert(lx[i] - AT * sin(yaw), ly[i], lz[i], ls[i], AT, R0, yaw, &cut, &q);
        worst = fmax(worst, fmax(fabs(q.a - AT - p->y[i]), fabs(q.r - R0 - p->z[i])));
        worst = fmax(worst, fmax(fabs(q.rate - p->slope[i]) / (1 + fabs(p->slope[i])), fabs(q.turn)));
        if (p->y[i] > cut.y)
            tread = fmax(tread, fmax(fabs(ly[i] - (AT + p->y[i]) * cos(yaw)), fabs(lz[i] - p->z[i])));
    }
    ok(llabs(removed - (int64_t)(cut.dy / 50e-6)) <= 1, "yaw %g: %lld points removed, %lld kept", yaw, (long long)removed, (long long)kept);
    ok(steps == 0, "yaw %g: what is left is closed, y nowhere goes back", yaw);
    ok(tread < 1e-15, "yaw %g: the tread is only turned (%.1e m)", yaw, tread);
    ok(worst < 1e-14, "yaw %g: inverted to the wheel's own point, below the axle (%.1e)", yaw, worst);

    double before = face_at(p->y, p->z, p->points, 11e-3) + AT, here = face_at(ly, lz, p->points, 11e-3);
    double exact = face_at(ey, ez, p->points, 11e-3);
    printf("# yaw %g: face at a depth of 11 mm moves by %.4f mm, silhouette %.4f mm\n", yaw, (here - before) * 1e3, (exact - before) * 1e3);
    near(here, exact, 0.1 * fabs(exact - before * cos(yaw)),
         "the flange's face stands where the silhouette's does, within a tenth of what the projection misses");
    const struct locus_wheel w = wheel_of(p);
    thesis_section(&w, -yaw, &back);
    ok(memcmp(&back, &cut, sizeof cut) == 0, "the same section for the other sense of yaw");
}

/* Tread level, root of 50 degrees, face of 60 degrees, all straight: the advance is that of the formula. */
static void straight(void)
{
    enum { N = 400 };
    double y[N], z[N], slope[N], k[N] = {0}, yaw = 0.01, m = sqrt(3), root = tan(50 * M_PI / 180);
    struct thesis_cut cut;
    for (int i = 0; i < N; i++) {
        y[i] = (i - 300) * 1e-4;
        double s = -0.02 - y[i];
        z[i] = s < 0 ? 0 : s < 5e-3 ? root * s : root * 5e-3 + m * (s - 5e-3);
        slope[i] = s < 0 ? 0 : s < 5e-3 ? -root : -m;
    }
    const struct locus_wheel w = {N, y, z, slope, k, AT, R0};
    ok(thesis_section(&w, yaw, &cut) == NULL, "straight pieces");
    thesis_profile(&w, yaw, &cut, &mine);
    double r = R0 + z[0], delta = 0.5 * r * m * tan(yaw) * tan(yaw);
    double moved = face_at(ly, lz, N, 8e-3) / cos(yaw) - AT - face_at(y, z, N, 8e-3);
    ok(fabs(moved / delta - 1) < 0.02, "face advances by r m tan(yaw)^2/2 = %.4f mm (%.4f)", delta * 1e3, moved * 1e3);
    ok(thesis_section(&w, 0.2, &cut) != NULL, "no room in the root for 0.2 rad: refused");
    for (int i = 0; i < N; i++)
        slope[i] = fmax(slope[i], -0.5);
    ok(thesis_section(&w, yaw, &cut) != NULL && cut.dy == 0, "a wheel without a flange: refused");
}

int main(void)
{
    struct shape *w = shape_s1002('r');

    yaw_zero(&w->prof);
    s1002(&w->prof, 0.005);
    s1002(&w->prof, 0.012);
    s1002(&w->prof, 0.024);
    straight();
    near(thesis_yaw(6.6e-3), 7.333e-3, 1e-6, "bogie of 1.8 m, 6.6 mm to either side: 7.3 mrad");
    free(w);
    return done();
}
