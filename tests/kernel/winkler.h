/* A beam on closely spaced fixed springs, and the beam on a Winkler foundation it stands for.  With w ~ exp(i (omega t + kappa s)), s counted
 * from the load moving at v, J the pitch inertia over length,
 *   H(omega) = 1/(2 pi) integral dkappa / (EI kappa^4 + k + i c W - (m + J kappa^2) W^2),   W = omega - kappa v. */
#ifndef VX_WINKLER_H
#define VX_WINKLER_H

#include <complex.h>
#include <math.h>

#define EI 6.11e6      /* N m2 */
#define MASS 60.0      /* kg/m */
#define FOUNDATION 1e8 /* N/m2 */
#define DAMPING 124e3  /* N s/m2, 0.8 of critical: transients must die within the beam */

/* Pads of 15 kN/mm on sleepers that do not give: the foundation's 1e8 N/m2. */
static const char *const winkler_beam[] = {"sleeper.spacing=0.15", "railpad.stiffness=1.5e7", "railpad.damping=18600", "ballast.stiffness=1e12",
                                           "ballast.damping=0", "from=-30", "length=60", "rail.elements_per_bay=1", "rail.mass_model=consistent"};

/* m/N, by the trapezoidal rule in steps of 1/m, whose error on a smooth integrand falls off as no power does. */
static inline double complex winkler_receptance(double omega, double v, double damping, double J, double step)
{
    const double far = 60, bend = EI - J * v * v;
    double complex sum = 0;

    for (double kappa = -far; kappa <= far; kappa += step) {
        const double W = omega - kappa * v;
        sum += 1 / (EI * kappa * kappa * kappa * kappa + FOUNDATION - (MASS + J * kappa * kappa) * W * W + I * damping * W);
    }
    return sum * step / (2 * M_PI) + 2 / (6 * M_PI * bend * far * far * far);
}

#endif
