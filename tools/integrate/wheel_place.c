#include "tools/integrate/wheel_place.h"

/* The element, by the node behind, under station x.  Nodes stand evenly or nearly so: guess, then walk. */
static int64_t element_under(const struct trk *t, double x)
{
    const double *node = t->x;
    int64_t last = t->nodes - 2, i = (int64_t)((x - node[0]) / (node[last + 1] - node[0]) * (double)(last + 1));

    i = i < 0 ? 0 : i > last ? last : i;
    while (i > 0 && x < node[i])
        i--;
    while (i < last && x >= node[i + 1])
        i++;
    return i;
}

struct wheel_place wheel_place_find(const struct trk *t, const struct beam *beam, double x)
{
    struct wheel_place p = {.node = element_under(t, x)};
    const struct beam *b = &beam[p.node];
    const double a = x - b->from;

    beam_shape(b, a, p.shape);
    beam_slope(b, a, p.slope);
    p.compliance = beam_compliance(b, a);
    return p;
}
