/* .trk: a track as masses, beams, springs and dampers, and as sparse matrices: trk(5).
 *
 * Track axes: x forward (station s), y to the right, z down, roll about x, pitch about y, right-hand rule.  A rail node has
 * deflection w (down) and pitch t = -dw/dx; a sleeper has z and roll.  Degrees of freedom are ordered by node and bay,
 * [wl tl wr tr] at a rail node, then [z roll] of the sleeper where there is one, which gives half bandwidth 7 with one
 * element a bay.
 *
 * A spatial track also moves sideways: a rail node has [w pitch y yaw twist], those of the left rail, of the right rail and, where it
 * runs, of the check rail, then come [z roll y yaw] of the sleeper; half bandwidth 18 with one element a bay, 23 along a check rail.
 * They are the motion of the rail's centroid, which counts as its shear centre too, and of the sleeper's centre, turns right-handed about
 * x, y and z: a point h above the centroid, as the running surface, moves sideways by y + h twist, and a lateral force there brings the
 * moment h Y in twist with it.  Lengthwise nothing moves.
 *
 * A moving mass, the track of one wheelset, is one sleeper and one node: its pitch, and its roll where sleeper_inertia is 0, are held,
 * alone in their rows with a natural frequency of 1 MHz. */
#ifndef VX_FORMATS_TRK_H
#define VX_FORMATS_TRK_H

#include "formats/vxf.h"

enum { TRK_LEFT, TRK_RIGHT, TRK_RAILS, TRK_CHECK = TRK_RAILS };
enum { TRK_BALLAST = 3 };              /* springs under a sleeper: left, middle, right */
enum { TRK_BONDED, TRK_CLOSED, TRK_OPEN }; /* ballast: holds both ways; pushes alone, and does or does not under the track's own weight */
enum { TRK_W, TRK_PITCH, TRK_Y, TRK_YAW, TRK_TWIST, TRK_SPATIAL_RAIL };     /* of a rail at a node; the first two: of a vertical track */
enum { TRK_Z, TRK_ROLL, TRK_SLEEPER_Y, TRK_SLEEPER_YAW, TRK_SPATIAL_SLEEPER };   /* of a sleeper, likewise */
enum { TRK_VERTICAL_RAIL = TRK_Y, TRK_VERTICAL_SLEEPER = TRK_SLEEPER_Y };

struct trk {
    char name[64];
    double rail_spacing;               /* m, between the contact lines; rails load sleepers at its halves */
    int64_t nodes;                     /* along each rail */
    int64_t sleepers;
    int64_t rail_dofs;                 /* of a rail at a node: TRK_VERTICAL_RAIL or, of a spatial track, TRK_SPATIAL_RAIL */
    int64_t sleeper_dofs;              /* of a sleeper, likewise */
    int64_t dofs;                      /* rail_dofs (2 nodes + check_nodes) + sleeper_dofs sleepers */
    int64_t knots;                     /* of the bending stiffness */
    int64_t curves;
    int64_t cants;                     /* knots of the cant; 0: level */
    int64_t zones;
    int64_t checks;                    /* knots of the check rail's play; 0: no check rail */
    int64_t lateral_knots;             /* of the lateral bending stiffness; 0: a vertical track */
    int64_t check_nodes;               /* of a check rail that is a beam; 0: none is */
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
    const double *check_k, *check_c;   /* N/m, N s/m [1] lateral, against the ground, or the beam that it is */
    const double *check_x;             /* m [checks] stations, increasing; there is no check rail beyond the ends */
    const double *check_play;          /* m [checks] free play of the back of the flange, wheelset centred; straight between */
    const double *curve_x;             /* m [curves] station from which the curvature holds, to the next or the end */
    const double *curvature;           /* 1/m [curves] positive to the right; 0 before the first */
    const double *cant_x;              /* m [cants] stations, increasing */
    const double *cant;                /* m [cants] of the left rail over the right one, at rail_spacing; straight between, constant beyond */
    const char (*zone_name)[32];       /* [zones] */
    const int64_t *pad_zone;           /* [2][sleepers] zone of the railpad, from 1; 0 in none */
    const int64_t *node_dof;           /* [nodes] number of the left rail's w; its others follow, then the right rail's */
    const int64_t *sleeper_dof;        /* [sleepers] number of z; its others follow */
    const int64_t *Ap, *Ai;            /* [dofs + 1], [Ap[dofs]] pattern of K, C and M: full, symmetric, by column */
    const double *Kx, *Cx, *Mx;        /* [Ap[dofs]] SI: N/m, N, N m; and so on */

    /* Of a spatial track alone, else NULL. */
    const double *rail_yaw, *rail_twist;     /* kg m2 [2][nodes] lumped inertia of the node in yaw and twist */
    const double *rail_lateral_shear;  /* 1/N [2][nodes - 1] as rail_shear */
    const double *rail_lateral_rotary; /* kg m [2][nodes - 1] yaw inertia of a metre, as rail_rotary */
    const double *rail_torsion;        /* N m2 [2][nodes - 1] GJ of the element behind each node */
    const double *rail_polar;          /* kg m [2][nodes - 1] inertia in twist of a metre, beside the lumped one */
    const double *lateral_bending_x;   /* m [lateral_knots] as bending_x */
    const double *lateral_bending;     /* N m2 [2][lateral_knots] */
    const double *rail_head, *rail_foot;     /* m [1] running surface above the rail's centroid, and railpad below it */
    const double *sleeper_yaw;         /* kg m2 [sleepers] */
    const double *sleeper_seat;        /* m [1] railpads above the sleeper's centre */
    const double *pad_lateral_k, *pad_lateral_c;     /* N/m, N s/m [2][sleepers] */
    const double *pad_width, *pad_length;    /* m [1] across and along the rail: tilt k width^2/12, pitch k length^2/12, yaw of the lateral k */
    const double *ballast_lateral_k, *ballast_lateral_c;   /* N/m, N s/m [sleepers] at the sleeper's centre */
    const double *ballast_yaw_k, *ballast_yaw_c;     /* N m, N m s [sleepers] */

    /* Its check rail as a beam between two sleepers, Euler-Bernoulli, its mass along it. */
    const int64_t *check_node;         /* [check_nodes] rail nodes beside which it has its own, one after the other */
    const int64_t *check_dof;          /* [check_nodes] number of w; pitch, y, yaw and twist follow */
    const double *check_y;             /* m [1] lateral position of its centroid */
    const double *check_bending;       /* N m2 [2] vertical, lateral */
    const double *check_torsion;       /* N m2 [1] GJ */
    const double *check_density;       /* kg/m [1] */
    const double *check_polar;         /* kg m [1] inertia in twist of a metre */
    const double *check_head, *check_foot;   /* m [1] where flanges rub above its centroid, and its fastening below it */
    const double *check_pad_k, *check_pad_c; /* N/m, N s/m [2] of each fastening, on a sleeper: vertical, lateral */
    void *store;                       /* what trk_room gave, a chain */
};

static inline int trk_is_spatial(const struct trk *t)
{
    return t->rail_dofs == TRK_SPATIAL_RAIL;
}

/* Number of w of a rail, TRK_LEFT or TRK_RIGHT, at a node. */
static inline int64_t trk_rail_dof(const struct trk *t, int rail, int64_t node)
{
    return t->node_dof[node] + t->rail_dofs * rail;
}

/* m, from the centre of a sleeper to its railpad under a rail, positive to the right. */
static inline double trk_pad_arm(const struct trk *t, int rail, int64_t sleeper)
{
    return (rail == TRK_LEFT ? -0.5 : 0.5) * t->rail_spacing - t->sleeper_y[sleeper];
}

const char *trk_read(struct trk *t, const struct vxf *f);
const char *trk_put(const struct trk *t, struct vxf_out *o);
void trk_free(struct trk *t);

/* Zeroed room for n items that lives as long as the track, for who builds one; NULL when out of memory. */
void *trk_room(struct trk *t, int64_t n, size_t size);

#endif
