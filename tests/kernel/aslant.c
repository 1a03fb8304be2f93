/* Rails whose surface falls or runs aslant along the track: inclined plane by closed form; a rail turned in plan by alpha touches a wheel
 * yawed by psi as the straight rail touches one yawed by psi - alpha. */
#include "tests/kernel/shapes.h"
#include "tests/kernel/tap.h"
#include "tools/contact/lookup.h"
#include "tools/contact/table.h"

#define R0 0.46
#define AT 0.75

static const struct table_grid grid = {.u_max = 10e-3, .u_step = 1e-4, .yaw_max = 0.04, .yaws = 41, .shear_modulus = 82e9, .poisson = 0.28};

/* A wheel of transverse radius 0.3 m on a plane that falls by e: x = -r e/sqrt(1 + e^2), height = -r(sqrt(1 + e^2) - 1). */
static void inclined_plane(double e)
{
    struct shape *wheel = shape_new('w', AT, R0), *rail = shape_new('r', AT, 0);
    struct ctab t;
    struct contact c[CONTACT_MAX];
    double root = sqrt(1 + e * e), r = 0.3;

    for (int i = -200; i <= 200; i++) {
        double y = i * 1e-4, z = sqrt(r * r - y * y) - r;
        shape_point(wheel, y, z, -y / (z + r), -1 / r);
        shape_point(rail, 2 * y, 0, 0, 0);
        rail->fall[rail->prof.points - 1] = e;
    }
    shape_end(wheel, 'r');
    shape_end(rail, 'r');
    if (!ok(!table_fill(&t, &wheel->prof, &rail->prof, TABLE_EXACT, &grid), "a plane that falls by %g", e))
        return;
    contact_lookup(&t, 0, 0, 0, 0, c);
    near(c[0].row[CTAB_X], -R0 * e / root, R0 * fabs(e * e * e), "contact lies r e behind");
    near(c[0].height, -R0 * (root - 1), R0 * e * e * e * e, "the wheel rides higher by r e^2/2");
    near(c[0].row[CTAB_RADIUS], R0, R0 * e * e * e * e + 1e-7, "on the same circle");
    near(c[0].row[CTAB_HEIGHT_S], e, 1e-7, "and falls with the plane");
    ctab_free(&t);
    free(wheel);
    free(rail);
}

/* The section of a straight rail that is turned to the right by alpha. */
static struct shape *rail_aslant(double alpha)
{
    struct shape *s = shape_60e1('r', 1 / 40.0);

    for (int64_t i = 0; i < s->prof.points; i++) {
        double slope = s->slope[i], bend = s->curvature[i] * pow(1 + slope * slope, 1.5) * cos(alpha) * cos(alpha);
        s->fall[i] = -slope * sin(alpha);
        s->y[i] /= cos(alpha);
        s->slope[i] *= cos(alpha);
        s->curvature[i] = bend / pow(1 + s->slope[i] * s->slope[i], 1.5);
    }
    return s;
}

/* Contacts of angles up to `steepest` (rad): heights within h_most, places ahead within x_most (m). */
static void aslant(const struct prof *wheel, double alpha, double steepest, double h_most, double x_most)
{
    struct shape *straight = shape_60e1('r', 1 / 40.0), *turned = rail_aslant(alpha);
    struct ctab t, o;
    double height = 0, ahead = 0, along = 0, flange = 0;

    if (!ok(!table_fill(&t, wheel, &straight->prof, TABLE_EXACT, &grid) && !table_fill(&o, wheel, &turned->prof, TABLE_EXACT, &grid),
            "tables of a rail turned by %g rad", alpha))
        return;
    for (int iy = -6; iy <= 6; iy++)
        for (int iu = -80; iu <= 80; iu++) {
            double psi = iy * 1e-3 + alpha / 2, yaw = psi - alpha, u = iu * 1e-4;
            double d = AT * cos(yaw) + u - straight->prof.position;    /* from the straight rail to the wheel's centre */
            double u_turned = d / cos(alpha) - AT * cos(psi) + straight->prof.position;
            struct contact a[CONTACT_MAX], b[CONTACT_MAX];
            int n = contact_lookup(&t, 0, yaw, u, 0, a), m = contact_lookup(&o, 0, psi, u_turned, 0, b);
            if (n < 1 || m < 1 || a[0].weight < 1 || b[0].weight < 1 || fabs(a[0].row[CTAB_ANGLE]) > steepest ||
                fabs(a[0].row[CTAB_WHEEL_Y] - b[0].row[CTAB_WHEEL_Y]) > 1e-3)
                continue;
            double x = a[0].row[CTAB_X] + AT * sin(yaw), y = a[0].row[CTAB_RAIL_Y] - d;   /* from the wheel's centre */
            double turned_x = b[0].row[CTAB_X] + AT * sin(psi);
            height = fmax(height, fabs(a[0].height - b[0].height));
            ahead = fmax(ahead, fabs(turned_x - (x * cos(alpha) - y * sin(alpha))));
            along = fmax(along, fabs(turned_x));
            flange = fmax(flange, fabs(a[0].row[CTAB_ANGLE]));
        }
    printf("# alpha %g: heights within %.2g m, x within %.2g m of %.2g, angles to %.2g rad\n", alpha, height, ahead, along, flange);
    ok(height < h_most && flange > 0.9 * fmin(steepest, 1.2), "turned by %g rad: as high as the straight rail holds a wheel of that yaw", alpha);
    ok(ahead < x_most && x_most < 0.15 * along, "turned by %g rad: as far ahead", alpha);
    ctab_free(&t);
    ctab_free(&o);
    free(straight);
    free(turned);
}

int main(void)
{
    struct shape *wheel = shape_s1002('r');

    inclined_plane(0.01);
    inclined_plane(-0.04);
    aslant(&wheel->prof, 0.005, 1.5, 1e-6, 0.05e-3);
    aslant(&wheel->prof, -0.015, 1.5, 20e-6, 2e-3);
    aslant(&wheel->prof, 0.03, 0.5, 0.5e-6, 0.2e-3);
    aslant(&wheel->prof, 0.067, 0.1, 0.5e-7, 1e-5);
    free(wheel);
    return done();
}
