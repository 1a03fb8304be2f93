/* Dry friction that sticks as a spring. */
#ifndef VX_VEHICLE_FRICTION_H
#define VX_VEHICLE_FRICTION_H

/* F[3] N (or N m) on the second body, from that before to that after the relative displacement de[3] m (rad): elastic by k[3] up to
 * the size `limit`, beyond which it slides. */
void friction_step(const double k[3], double limit, const double de[3], double F[3]);

#endif
