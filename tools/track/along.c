/* Stations are sums of many bays: what is left over of a whole number is their rounding, and no part of the next sleeper's value. */
#include "tools/track/along.h"

#include <math.h>

static const double WHOLE = 1e-6;

double along_number(const struct trk_text *in, double x)
{
    const double number = (x - in->first_sleeper) / in->sleeper.spacing + 0.5, whole = floor(number + 0.5);

    return fabs(number - whole) < WHOLE ? whole : number;
}

double along_station(const struct yaml_table *table, const struct trk_text *in, double at)
{
    return table->by_number ? in->first_sleeper + (at - 0.5) * in->sleeper.spacing : at;
}

double along_at(const struct yaml_table *table, const struct trk_text *in, double x)
{
    return yaml_table_at(table, x, along_number(in, x));
}
