#include "tools/integrate/run_in.h"

#include <math.h>

static int64_t bay_at(const struct run_in *r, double station)
{
    return (int64_t)floor((station - r->x0) / r->bay);
}

void run_in_begin(struct run_in *r, double x0, double bay, double load, double station)
{
    *r = (struct run_in){.x0 = x0, .bay = bay, .load = load, .settled = NAN, .mean_before = NAN, .most_before = NAN};
    r->at = bay_at(r, station);
    r->steps = -1; /* the first bay is not whole */
}

/* The present bay has ended; the next one begins at the station. */
static void end_bay(struct run_in *r, double station)
{
    const double mean = r->sum / (double)r->steps, begun = r->x0 + r->bay * (double)r->at;

    if (fmax(fabs(mean - r->mean_before), fabs(r->most - r->most_before)) <= RUN_IN_TOLERANCE * r->load)
        r->alike++;
    else
        r->alike = 0; /* also with none before it */
    if (r->alike == 1)
        r->since = begun;
    if (r->alike == RUN_IN_BAYS)
        r->settled = r->since;
    r->mean_before = r->steps > 0 ? mean : NAN;
    r->most_before = r->most;
    r->at = bay_at(r, station);
    r->steps = 0;
    r->sum = r->most = 0;
}

void run_in_step(struct run_in *r, double station, double Q)
{
    if (!isnan(r->settled))
        return;
    if (bay_at(r, station) != r->at)
        end_bay(r, station);
    if (r->steps < 0)
        return;
    r->steps++;
    r->sum += Q;
    r->most = fmax(r->most, Q);
}
