#include "tools/contact/clearance.h"

#include <math.h>

#include "formats/reason.h"
#include "tools/contact/search.h"

#define FLANGE (-1.0)         /* slope of the contact plane, right side */

const char *clearance_find(const struct prof *wheel, const struct prof *rail, double u_max, double u_step, double *clearance)
{
    const double straight[1] = {0};
    struct search s = {0};
    struct search_contact c[SEARCH_MOST];
    const char *why = search_begin(&s, wheel, rail, straight, 1, SEARCH_PLANE, u_step);

    if (!why)
        why = search_section(&s, rail, 0);
    *clearance = (double)NAN;
    for (int64_t i = 0; !why && isnan(*clearance) && (double)i * u_step <= u_max; i++)
        if (search_contacts(&s, 0, i, c) > 0 && c[0].at.slope <= FLANGE)
            *clearance = (double)i * u_step;
    search_free(&s);
    if (!why && isnan(*clearance))
        why = reason("no flange touches up to u = %g m: give the largest yaw", u_max);
    return why;
}
