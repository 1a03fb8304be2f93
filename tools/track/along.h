/* Tables of the track input along the track: over station, or over the number of the sleeper. */
#ifndef VX_TRACK_ALONG_H
#define VX_TRACK_ALONG_H

#include "formats/trk_text.h"

/* Sleeper number as a continuous function of the station: 1 in the middle of the first bay from first_sleeper; whole on each sleeper. */
double along_number(const struct trk_text *in, double x);

/* The station where a table has its knot `at`. */
double along_station(const struct yaml_table *table, const struct trk_text *in, double at);

/* The table at station x. */
double along_at(const struct yaml_table *table, const struct trk_text *in, double x);

#endif
