#include "tools/track/cant.h"

#include "formats/reason.h"
#include "tools/track/along.h"

/* A constant is one knot, at the beginning of the track. */
static double station_of(const struct trk_text *in, int64_t k)
{
    return in->cant.n == 1 ? in->from : along_station(&in->cant, in, in->cant.at[k]);
}

const char *cant_lay(struct trk *t, const struct trk_text *in)
{
    const int64_t n = in->cant.n == 1 && in->cant.value[0] == 0 ? 0 : in->cant.n;
    double *x = trk_room(t, n, sizeof *x), *cant = trk_room(t, n, sizeof *cant);

    if (!x || !cant)
        return REASON_MEMORY;
    for (int64_t k = 0; k < n; k++) {
        x[k] = station_of(in, k);
        cant[k] = in->cant.value[k];
    }
    t->cants = n;
    t->cant_x = x;
    t->cant = cant;
    return NULL;
}
