/* Comparison within tolerances, after Ward's radcompare (Radiance): relative, absolute and root mean square. */
#include "formats/vxf_compare.h"
#include "formats/reason.h"
#include "formats/vxf_disk.h"

#include <math.h>
#include <string.h>

const char *vxf_compare_shape(const struct vxf_array *a, const struct vxf_array *b)
{
    char one[160], two[160];

    if (a->type != b->type)
        return reason("is %s and %s", vxf_type_name(a->type), vxf_type_name(b->type));
    vxf_dims_text(a, one, sizeof one);
    vxf_dims_text(b, two, sizeof two);
    if (a->ndim != b->ndim || memcmp(a->dim, b->dim, (size_t)a->ndim * sizeof a->dim[0]))
        return reason("is %s and %s", one, two);
    if (strcmp(a->unit, b->unit) != 0)
        return reason("has unit %s and %s", a->unit, b->unit);
    return NULL;
}

/* Element i as real and imaginary part; a whole number beyond 2^53 loses its last digits here, not in the comparison. */
static void element(const struct vxf_array *a, int64_t i, double x[2])
{
    x[1] = 0;
    switch (a->type) {
    case VXF_F64:
        x[0] = ((const double *)a->data)[i];
        break;
    case VXF_F32:
        x[0] = ((const float *)a->data)[i];
        break;
    case VXF_I64:
        x[0] = (double)((const int64_t *)a->data)[i];
        break;
    case VXF_I32:
        x[0] = ((const int32_t *)a->data)[i];
        break;
    case VXF_U8:
        x[0] = ((const uint8_t *)a->data)[i];
        break;
    case VXF_C128:
        x[0] = ((const double *)a->data)[2 * i];
        x[1] = ((const double *)a->data)[2 * i + 1];
        break;
    case VXF_TYPES:
        break;
    }
}

static int is_whole(const struct vxf_array *a)
{
    return a->type == VXF_I64 || a->type == VXF_I32 || a->type == VXF_U8;
}

static int is_exact(const struct vxf_array *a, const struct vxf_tolerance *t)
{
    return is_whole(a) || (t->relative == 0 && t->absolute == 0 && t->rms == 0);
}

/* NaN or infinity against a number is beyond any tolerance. */
static int is_beyond(const struct vxf_tolerance *t, double size, const double x[2], const double y[2])
{
    return !isfinite(size) || size > fmax(t->absolute, t->relative * fmax(hypot(x[0], x[1]), hypot(y[0], y[1])));
}

static void note(struct vxf_difference *d, int64_t i, double size, const double x[2], const double y[2])
{
    if (d->off++ > 0 && !(size > d->largest) && !(isnan(size) && !isnan(d->largest)))
        return;
    d->largest = size;
    d->at = i;
    memcpy(d->a, x, sizeof d->a);
    memcpy(d->b, y, sizeof d->b);
}

int vxf_compare(const struct vxf_array *a, const struct vxf_array *b, const struct vxf_tolerance *t, struct vxf_difference *d)
{
    const unsigned char *p = a->data, *q = b->data;
    size_t size = vxf_type_size(a->type);
    int64_t n = vxf_count(a);
    int exact = is_exact(a, t);
    double sum = 0, x[2], y[2];

    *d = (struct vxf_difference){0};
    for (int64_t i = 0; i < n; i++) {
        if (memcmp(p + (size_t)i * size, q + (size_t)i * size, size) == 0)
            continue;
        element(a, i, x);
        element(b, i, y);
        double distance = hypot(x[0] - y[0], x[1] - y[1]);
        sum += distance * distance;
        if (exact || is_beyond(t, distance, x, y))
            note(d, i, distance, x, y);
    }
    d->rms = n ? sqrt(sum / (double)n) : 0;
    return d->off > 0 && (exact || !(d->rms <= t->rms));
}
