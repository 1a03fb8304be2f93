/* Matrices about rest: they are the derivatives of the forces, symmetric, and give the known motions of the Manchester coach. */
#include "tools/vehicle/linear.h"

#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

#include "formats/veh_text.h"
#include "tests/kernel/tap.h"
#include "tools/vehicle/couplings.h"
#include "tools/vehicle/vehicle.h"

static const char *load(struct veh *v, const char *path)
{
    struct veh_text in;
    uint64_t hash;

    memset(v, 0, sizeof *v);
    const char *why = veh_text_read(&in, path, NULL, 0, &hash);
    if (why)
        return why;
    why = vehicle_build(v, &in);
    veh_text_free(&in);
    return why;
}

static double largest(const double *A, int64_t n)
{
    double most = 0;
    for (int64_t i = 0; i < n; i++)
        most = fmax(most, fabs(A[i]));
    return most;
}

static void test_symmetry(const struct veh *v, const char *name, const double *A)
{
    int64_t n = VEH_DOFS*v->bodies;
    double most = 0;

    for (int64_t i = 0; i < n; i++)
        for (int64_t j = 0; j < i; j++)
            most = fmax(most, fabs(A[n*i + j] - A[n*j + i]));
    ok(most < 1e-12*largest(A, n*n), "%s: %s is symmetric to %.1e of its largest entry", v->name, name, most/largest(A, n*n));
}

/* Against central differences, exact but for round-off and the third order: by 1e-5 m and rad, rates by 1. */
static void test_derivatives(const struct veh *v)
{
    int64_t n = VEH_DOFS*v->bodies;
    double *q = calloc((size_t)n, sizeof *q), *zero = calloc((size_t)n, sizeof *zero);
    double *up = calloc((size_t)n, sizeof *up), *down = calloc((size_t)n, sizeof *down), wrong[2] = {0};

    for (int rate = 0; rate < 2; rate++)
        for (int64_t j = 0; j < n; j++) {
            double h = rate ? 1 : 1e-5;
            memset(up, 0, (size_t)n*sizeof *up);
            memset(down, 0, (size_t)n*sizeof *down);
            q[j] = h;
            couplings_force(v, NULL, rate ? zero : q, rate ? q : zero, up);
            q[j] = -h;
            couplings_force(v, NULL, rate ? zero : q, rate ? q : zero, down);
            q[j] = 0;
            for (int64_t i = 0; i < n; i++)
                wrong[rate] = fmax(wrong[rate], fabs((rate ? v->C : v->K)[n*i + j] + (up[i] - down[i])/(2*h)));
        }
    ok(wrong[0] < 1e-9*largest(v->K, n*n), "%s: K is -df/dq (central differences of 1e-5) to %.1e", v->name, wrong[0]/largest(v->K, n*n));
    ok(wrong[1] < 1e-12*largest(v->C, n*n), "%s: C is -df/dq' to %.1e", v->name, wrong[1]/largest(v->C, n*n));
    free(q);
    free(zero);
    free(up);
    free(down);
}

/* Undamped frequencies Hz[6] of the bodies before the wheelsets, those held, and shapes in the columns of A. */
static int64_t held_modes(const struct veh *v, double **hz, double **A)
{
    int64_t n = VEH_DOFS*v->bodies, m = n - VEH_DOFS*v->wheelsets;

    *hz = calloc((size_t)m, sizeof **hz);
    *A = calloc((size_t)(m*m), sizeof **A);
    for (int64_t i = 0; i < m; i++)
        for (int64_t j = 0; j < m; j++)
            (*A)[m*i + j] = v->K[n*i + j]/sqrt(v->M[n*i + i]*v->M[n*j + j]);
    LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'V', 'U', (lapack_int)m, *A, (lapack_int)m, *hz);
    for (int64_t k = 0; k < m; k++)
        (*hz)[k] = sqrt((*hz)[k])/(2*M_PI);
    return m;
}

/* The frequency of the mode with the largest share of these degrees of freedom, moving with these signs. */
static double mode_like(const double *hz, const double *A, int64_t m, const int64_t *dof, const double *sign, int count)
{
    double best = 0, at = 0;

    for (int64_t k = 0; k < m; k++) {
        double share = 0;
        for (int i = 0; i < count; i++)
            share += sign[i]*A[m*dof[i] + k];
        if (fabs(share) > best) {
            best = fabs(share);
            at = hz[k];
        }
    }
    return at;
}

static void test_modes(const struct veh *v)
{
    static const int64_t bounce[] = {VEH_Z}, pitch[] = {VEH_PITCH}, bogies[] = {VEH_DOFS + VEH_Z, 2*VEH_DOFS + VEH_Z};
    static const double plus[] = {1, 1};
    double *hz, *A;
    int64_t m = held_modes(v, &hz, &A);

    if (!strcmp(v->name, "manchester-passenger")) {
        near(mode_like(hz, A, m, bounce, plus, 1), 1.074, 0.005*1.074, "the coach: carbody bounce 1.074 Hz");
        near(mode_like(hz, A, m, pitch, plus, 1), 1.299, 0.005*1.299, "carbody pitch 1.299 Hz");
        near(mode_like(hz, A, m, bogies, plus, 2), 7.47, 0.005*7.47, "bogie bounce 7.47 Hz");
    }
    if (!strcmp(v->name, "passenger-19t"))
        near(mode_like(hz, A, m, bounce, plus, 1), 1.074, 0.005*1.074, "the heavier coach keeps its bounce frequency");
    free(hz);
    free(A);
}

int main(void)
{
    static const char *const vehicle[] = {"manchester-passenger", "passenger-19t", "freight-y25-22t5", "freight-y25-22t5-linear",
                                         "freight-y25-tare", "wheelset"};

    for (size_t i = 0; i < sizeof vehicle/sizeof *vehicle; i++) {
        char path[64];
        struct veh v;
        snprintf(path, sizeof path, "data/vehicles/%s.yaml", vehicle[i]);
        const char *why = load(&v, path);
        if (ok(!why, "%s: %s", path, why ? why : "stands")) {
            test_symmetry(&v, "K", v.K);
            test_symmetry(&v, "C", v.C);
            test_derivatives(&v);
            test_modes(&v);
        }
        veh_free(&v);
    }
    return done();
}
