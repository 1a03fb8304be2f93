/* Comparison of arrays: to the bit, relative, absolute, root mean square. */
#include "formats/vxf_compare.h"

#include <string.h>

#include "tests/kernel/tap.h"

static struct vxf_difference d;

static int differ(enum vxf_type type, int64_t n, const void *x, const void *y, double relative, double absolute, double rms)
{
    struct vxf_array a = {.name = "a", .unit = "m", .type = type, .ndim = 1, .dim = {n}, .data = x}, b = a;

    b.data = y;
    return vxf_compare(&a, &b, &(struct vxf_tolerance){relative, absolute, rms}, &d);
}

static void shapes(void)
{
    struct vxf_array a = {.unit = "m", .type = VXF_F64, .ndim = 2, .dim = {3, 4}}, b = a;
    const char *why;

    ok(!vxf_compare_shape(&a, &b), "the same shape");
    b.dim[1] = 5;
    ok((why = vxf_compare_shape(&a, &b)) && strcmp(why, "is 3x4 and 3x5") == 0, "another dim");
    b = a;
    b.ndim = 1;
    ok(vxf_compare_shape(&a, &b) != NULL, "another number of dims");
    b = a;
    b.type = VXF_F32;
    ok((why = vxf_compare_shape(&a, &b)) && strcmp(why, "is f64 and f32") == 0, "another type");
    b = a;
    memcpy(b.unit, "mm", 3);
    ok((why = vxf_compare_shape(&a, &b)) && strcmp(why, "has unit m and mm") == 0, "another unit");
}

int main(void)
{
    const double x[4] = {1, 100, -1000, 0}, y[4] = {1.001, 100, -1000.5, 0};
    const double zero[1] = {0}, minus[1] = {-0.0}, nan_[1] = {NAN}, infinite[1] = {INFINITY};
    const int64_t i[2] = {5, INT64_MAX}, j[2] = {5, INT64_MAX - 1};
    const double p[2] = {3, 4}, q[2] = {3, 4.5};

    shapes();
    ok(!differ(VXF_F64, 4, x, x, 0, 0, 0), "an array is the same as itself");
    ok(differ(VXF_F64, 4, x, y, 0, 0, 0) && d.off == 2 && d.at == 2, "to the bit: two differ, the third most");
    near(d.largest, 0.5, 1e-12, "the largest difference");
    near(d.rms, sqrt((0.001 * 0.001 + 0.25) / 4), 1e-12, "the root mean square is over all elements");
    ok(differ(VXF_F64, 4, x, y, 6e-4, 0, 0) && d.off == 1 && d.at == 0, "relative 6e-4 leaves the first");
    ok(differ(VXF_F64, 4, x, y, 0, 0.01, 0) && d.off == 1 && d.at == 2, "absolute 0.01 leaves the third");
    ok(!differ(VXF_F64, 4, x, y, 6e-4, 0.01, 0), "the larger of both tolerances holds");
    ok(!differ(VXF_F64, 4, x, y, 0, 0.01, 0.3) && d.off == 1, "an element off passes where the root mean square does not");
    ok(differ(VXF_F64, 4, x, y, 0, 0.01, 0.2), "and fails where both do");
    ok(differ(VXF_F64, 1, zero, minus, 0, 0, 0) && !differ(VXF_F64, 1, zero, minus, 0, 1e-300, 0),
       "-0 has other bits, and is 0 within any tolerance");
    ok(differ(VXF_F64, 1, zero, nan_, 1, 1e300, 1e300) && isnan(d.largest), "NaN differs from a number within any tolerance");
    ok(!differ(VXF_F64, 1, nan_, nan_, 0, 0, 0), "the same NaN is the same");
    ok(differ(VXF_F64, 1, zero, infinite, 1e-3, 1e300, 0), "infinity differs from a number");
    ok(differ(VXF_I64, 2, i, j, 1, 1e9, 1e9) && d.at == 1, "whole numbers are compared exactly, beyond 2^53 too");
    ok(differ(VXF_C128, 1, p, q, 0.05, 0, 0) && !differ(VXF_C128, 1, p, q, 0.1, 0, 0), "a complex number by the magnitude of the difference");
    ok(!differ(VXF_F64, 0, NULL, NULL, 0, 0, 0), "nothing is the same as nothing");
    return done();
}
