/* A short spatial track for tests, of Table 1 and 60E1 sideways, with a check rail beside the right rail; overrides by key.  Written to a
 * temporary file, for the reader takes a path. */
#ifndef VX_STRAIGHT_H
#define VX_STRAIGHT_H

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "tests/kernel/table1.h"

static const char STRAIGHT[] =
    "track:\n"
    "  name: straight\n"
    "  dofs: spatial\n"
    "  from: -3.6\n"
    "  length: 7.2\n"
    "  rail: {bending_stiffness: 6.11e6, mass: 60, pitch_inertia: 1.25, shear_stiffness: 2.49e8, rotary_inertia: 0.2385,\n"
    "    lateral_bending_stiffness: 1.076e6, yaw_inertia: 1.15, lateral_shear_stiffness: 2.49e8, lateral_rotary_inertia: 0.0402,\n"
    "    torsional_stiffness: 1.51e5, polar_inertia: 0.2787, head_height: 0.0911, foot_depth: 0.0809}\n"
    "  sleeper: {spacing: 0.6, mass: 380, roll_inertia: 155.09, length: 2.6, yaw_inertia: 156.12, seat_height: 0.1}\n"
    "  railpad: {stiffness: 300e6, damping: 50e3, lateral_stiffness: 25e6, lateral_damping: 10e3, width: 0.15}\n"
    "  ballast: {stiffness: 280e6, damping: 120e3, lateral_stiffness: 30e6, lateral_damping: 270e3, longitudinal_stiffness: 30e6,\n"
    "    longitudinal_damping: 270e3}\n"
    "  check_rail:\n"
    "    - rail: right\n"
    "      play: {station: [-1, 1], value: [0, 0]}\n"
    "      stiffness: 30e6\n"
    "      beam: {from: -1.9, to: 1.9, side: 0.65, mass: 33, bending_stiffness: 6.3e5, lateral_bending_stiffness: 2.7e5,\n"
    "        torsional_stiffness: 1.6e5, polar_inertia: 0.0338, head_height: 0.036, foot_depth: 0.145, stiffness: 120e6, damping: 25e3}\n";

/* set: [sets] "key=value" */
static inline const char *straight(struct trk *t, const char *const *set, int sets)
{
    char path[] = "/tmp/veksel-straight-XXXXXX";
    const int fd = mkstemp(path);
    FILE *f = fd < 0 ? NULL : fdopen(fd, "w");

    *t = (struct trk){0};
    if (!f)
        return "no temporary file";
    fputs(STRAIGHT, f);
    fclose(f);
    const char *why = track_from(t, path, set, sets);
    unlink(path);
    return why;
}

#endif
