/* Return mapping of an elastic, perfectly plastic law (Simo and Hughes 1998, chapter 1): a trial force F - k de, drawn back along its own
 * direction to the limit.  Sliding de_s = (1 - s) F_trial/k under s F_trial takes energy, s (1 - s) sum F_trial^2/k >= 0, whatever the
 * limit did; a lower limit releases what the spring holds, a higher one gives nothing.  Without a rate there is nothing to chatter. */
#include "tools/vehicle/friction.h"

#include <math.h>

void friction_step(const double k[3], double limit, const double de[3], double F[3])
{
    for (int i = 0; i < 3; i++)
        F[i] -= k[i]*de[i];
    double size = sqrt(F[0]*F[0] + F[1]*F[1] + F[2]*F[2]);
    for (int i = 0; i < 3 && size > limit; i++)
        F[i] *= limit/size;
}
