/* .trk: a track as masses, beams, springs and dampers, and as sparse matrices: trk(5).
 *
 * Track axes: x forward (station s), y to the right, z down, roll about x, pitch about y, right-hand rule.  A rail node has
 * deflection w (down) and pitch t = -dw/dx; a sleeper has z and roll.  Degrees of freedom are ordered by node and bay,
 * [wl tl wr tr] at a rail node, then [z roll] of the sleeper where there is one, which gives half bandwidth 7 with one
 * element a bay.
 *
 * A moving mass, the track of one wheelset, is one sleeper and one node: its pitch, and its roll where sleeper_inertia is 0, are held,
 * alone in their rows with a natural frequency of 1 MHz. */
#ifndef VX_FORMATS_TRK_H
#define VX_FORMATS_TRK_H

#include "formats/vxf.h"

enum { TRK_LEFT, TRK_RIGHT, TRK_RAILS };
enum { TRK_BALLAST = 3 };              /* springs under a sleeper: left, middle, right */
enum { TRK_BONDED, TRK_CLOSED, TRK_OPEN }; /* ballast: holds both ways; pushes alone, and does or does not under the track's own weight */

struct trk {
    char name[64];
    double rail_spacing;               /* m, between the contact lines; rails load sleepers at its halves */
    int64_t nodes;                     /* along each rail */
    int64_t sleepers;
    int64_t dofs;                      /* 4 nodes + 2 sleepers */
    int64_t knots;                     /* of the bending stiffness */
    int64_t curves;
    int64_t cants;                     /* knots of the cant; 0: level */
    int64_t zones;
    int64_t checks;                    /* knots of the check rail's play; 0: no check rail */
    const double *x;                   /* m [nodes] station, increasing */
    const double *bending_x;           /* m [knots] stations, increasing */
    const double *bending;             /* N m2 [2][knots] of each rail; straight between the knots, constant beyond */
    const double *rail_shear;          /* 1/N [2][nodes - 1] 1/(kappa G A) of the element behind each node; 0: Euler-Bernoulli */
    const double *rail_mass;           /* kg [2][nodes] lumped at the node */
    const double *rail_inertia;        /* kg m2 [2][nodes] in pitch, likewise */
    const double *rail_density;        /* kg/m [2][nodes - 1] along the element, beside the lumped mass */
    const double *rail_rotary;         /* kg m [2][nodes - 1] pitch inertia of a metre, likewise */
    const double *sleeper_x;           /* m [sleepers] */
    const int64_t *sleeper_node;       /* [sleepers] the rail node above it */
    const int64_t *sleeper_number;     /* [sleepers] 1 is the first of the turnout; run-in counts down from 0 */
    const double *sleeper_mass;        /* kg [sleepers] */
    const double *sleeper_inertia;     /* kg m2 [sleepers] in roll; 0: held, of a moving mass */
    const double *sleeper_y;           /* m [sleepers] lateral position of its centre */
    const double *pad_k, *pad_c;       /* N/m, N s/m [2][sleepers] */
    const double *ballast_k, *ballast_c; /* N/m, N s/m [3][sleepers] left, middle, right */
    const double *ballast_y;           /* m [3][sleepers] from the sleeper's centre */
    const double *ballast_gap;         /* m [3][sleepers] void between it and the unloaded sleeper */
    const int64_t *ballast_state;      /* [3][sleepers] TRK_BONDED, ...; TRK_OPEN is not in K and C */
    const double *lateral_m;           /* kg [1] of each rail moving sideways with a wheel, or of a moving mass with a wheelset */
    const double *lateral_k, *lateral_c; /* N/m, N s/m [1] between it and the ground; k = 0: rails that do not yield sideways */
    const double *sleeper_lateral_k, *sleeper_lateral_c; /* N/m, N s/m [1] of a moving mass, sleeper to ground: its rails then move sideways
                                          each by itself, against the sleeper; k = 0: rails and sleeper as one, against the ground */
    const double *running_m;           /* kg [1] of each rail of a moving mass under a wheel; 0: none, its pad in series with the contact */
    const int64_t *check_rail;         /* [1] side of the check rail, TRK_LEFT or TRK_RIGHT */
    const double *check_k, *check_c;   /* N/m, N s/m [1] lateral, against the ground */
    const double *check_x;             /* m [checks] stations, increasing; there is no check rail beyond the ends */
    const double *check_play;          /* m [checks] free play of the back of the flange, wheelset centred; straight between */
    const double *curve_x;             /* m [curves] station from which the curvature holds, to the next or the end */
    const double *curvature;           /* 1/m [curves] positive to the right; 0 before the first */
    const double *cant_x;              /* m [cants] stations, increasing */
    const double *cant;                /* m [cants] of the left rail over the right one, at rail_spacing; straight between, constant beyond */
    const char (*zone_name)[32];       /* [zones] */
    const int64_t *pad_zone;           /* [2][sleepers] zone of the railpad, from 1; 0 in none */
    const int64_t *node_dof;           /* [nodes] number of wl; tl, wr, tr follow */
    const int64_t *sleeper_dof;        /* [sleepers] number of z; roll follows */
    const int64_t *Ap, *Ai;            /* [dofs + 1], [Ap[dofs]] pattern of K, C and M: full, symmetric, by column */
    const double *Kx, *Cx, *Mx;        /* [Ap[dofs]] SI: N/m, N, N m; and so on */
    void *store;                       /* what trk_room gave, a chain */
};

const char *trk_read(struct trk *t, const struct vxf *f);
const char *trk_put(const struct trk *t, struct vxf_out *o);
void trk_free(struct trk *t);

/* Zeroed room for n items that lives as long as the track, for who builds one; NULL when out of memory. */
void *trk_room(struct trk *t, int64_t n, size_t size);

#endif
