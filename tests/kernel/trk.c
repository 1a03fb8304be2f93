/* A track written and read again is the same; what a reader relies on is refused where it does not hold. */
#include "formats/trk.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tests/kernel/straight.h"
#include "tests/kernel/table1.h"
#include "tests/kernel/tap.h"

/* Opens a temporary file with what `put` gathered in o. */
static const char *reopen(struct vxf_out *o, struct vxf *f)
{
    char path[] = "/tmp/veksel-trk-XXXXXX";
    int fd = mkstemp(path);
    FILE *stream = fd < 0 ? NULL : fdopen(fd, "wb");
    const char *why = stream ? vxf_write(o, stream) : "no temporary file";

    if (stream)
        fclose(stream);
    if (!why)
        why = vxf_open(f, path);
    unlink(path);
    return why;
}

static void round_trip(const struct trk *t)
{
    struct vxf_out o;
    struct vxf f;
    struct trk back;

    vxf_out_begin(&o, "trk");
    ok(trk_put(t, &o) == NULL, "a track can be put");
    const char *why = reopen(&o, &f);
    if (!ok(why == NULL, "and written%s%s", why ? ": " : "", why ? why : ""))
        return;
    why = trk_read(&back, &f);
    if (!ok(why == NULL, "and read%s%s", why ? ": " : "", why ? why : ""))
        return;
    ok(strcmp(back.name, t->name) == 0 && back.nodes == t->nodes && back.sleepers == t->sleepers && back.dofs == t->dofs &&
           back.zones == t->zones && back.curves == t->curves,
       "with name and sizes");
    const int64_t entries = t->Ap[t->dofs];
    ok(memcmp(back.Ai, t->Ai, (size_t)entries * sizeof *t->Ai) == 0 && memcmp(back.Kx, t->Kx, (size_t)entries * sizeof *t->Kx) == 0 &&
           memcmp(back.Cx, t->Cx, (size_t)entries * sizeof *t->Cx) == 0 && memcmp(back.Mx, t->Mx, (size_t)entries * sizeof *t->Mx) == 0,
       "the same matrices");
    ok(trk_is_spatial(&back) == trk_is_spatial(t) && back.lateral_knots == t->lateral_knots && back.check_nodes == t->check_nodes,
       "as many directions and nodes of a check rail");
    ok(back.rail_spacing == t->rail_spacing && memcmp(back.pad_k, t->pad_k, 2 * (size_t)t->sleepers * sizeof *t->pad_k) == 0,
       "and the same pads");
    trk_free(&back);
    vxf_close(&f);
    vxf_out_free(&o);
}

/* A copy of n numbers from x with the k-th replaced, kept by the track. */
static const double *with(struct trk *t, const double *x, int64_t n, int64_t k, double value)
{
    double *copy = trk_room(t, n, sizeof *copy);

    memcpy(copy, x, (size_t)n * sizeof *copy);
    copy[k] = value;
    return copy;
}

static const int64_t *with_integer(struct trk *t, const int64_t *x, int64_t n, int64_t k, int64_t value)
{
    int64_t *copy = trk_room(t, n, sizeof *copy);

    memcpy(copy, x, (size_t)n * sizeof *copy);
    copy[k] = value;
    return copy;
}

static void refused(const struct trk *t, const char *word, const char *what)
{
    struct vxf_out o;

    vxf_out_begin(&o, "trk");
    const char *why = trk_put(t, &o);
    ok(why && strstr(why, word), "refused: %s (%s)", what, why ? why : "not refused");
    vxf_out_free(&o);
}

#define TAMPER(member, n, k, value, word, what) \
    do { \
        struct trk bad = *t; \
        bad.member = with(t, t->member, n, k, value); \
        refused(&bad, word, what); \
    } while (0)

#define TAMPER_INTEGER(member, n, k, value, word, what) \
    do { \
        struct trk bad = *t; \
        bad.member = with_integer(t, t->member, n, k, value); \
        refused(&bad, word, what); \
    } while (0)

static void refusals(struct trk *t)
{
    const int64_t n = t->nodes, s = t->sleepers, entries = t->Ap[t->dofs];
    struct trk none = *t;

    none.rail_spacing = 0;
    refused(&none, "rail.spacing", "rails upon each other");
    TAMPER(x, n, 7, t->x[6], "array x", "a station twice");
    TAMPER(bending, 2 * t->knots, 1, 0, "bending", "a rail that does not resist bending");
    TAMPER(rail_shear, 2 * (n - 1), 5, -1e-9, "rail.shear", "a rail that shears against its load");
    TAMPER(rail_density, 2 * (n - 1), 5, -1, "rail.density", "a negative mass along a rail");
    TAMPER(rail_rotary, 2 * (n - 1), 5, -1, "rail.rotary", "a negative inertia along it");
    TAMPER(rail_inertia, 2 * n, 3, -1, "rail.inertia", "a negative pitch inertia");
    TAMPER(rail_mass, 2 * n, 3, -1, "rail.mass", "a negative mass");
    TAMPER(sleeper_mass, s, 3, 0, "sleeper.mass", "a sleeper without mass");
    TAMPER(pad_k, 2 * s, 99, -1, "pad.k", "a negative stiffness");
    TAMPER(lateral_k, 1, 0, -1, "lateral.k", "rails that pull aside");
    TAMPER(check_k, 1, 0, -1, "check.k", "a check rail that pulls");
    TAMPER_INTEGER(check_rail, 1, 0, 2, "check.rail", "a third side");
    TAMPER(sleeper_x, s, 4, t->sleeper_x[4] + 0.01, "sleeper.x", "a sleeper not below its node");
    TAMPER_INTEGER(sleeper_node, s, 4, 50, "sleeper.node", "a node beyond the rail");
    TAMPER_INTEGER(sleeper_number, s, 4, 99, "sleeper.number", "numbers that jump");
    TAMPER_INTEGER(pad_zone, 2 * s, 4, 1, "pad.zone", "a zone that is not there");
    TAMPER_INTEGER(node_dof, n, 4, 0, "node.dof", "a degree of freedom used twice");
    TAMPER_INTEGER(sleeper_dof, s, 4, 1000000, "sleeper.dof", "a degree of freedom beyond the last");
    TAMPER_INTEGER(Ap, t->dofs + 1, 5, entries + 1, "A.p", "a column beyond the entries");
    TAMPER_INTEGER(Ai, entries, 5, t->dofs, "A.i", "a row beyond the last");
    TAMPER_INTEGER(Ai, entries, 5, t->Ai[5] + 1, "mirror", "a pattern that is not symmetric");
    TAMPER(Kx, entries, 1, t->Kx[1] * 1.01, "K.x", "a stiffness matrix that is not symmetric");
    TAMPER(Mx, entries, 0, 0, "M.x", "no mass on the diagonal");
}

static void spatial_refusals(struct trk *t)
{
    const int64_t n = t->nodes, s = t->sleepers, q = t->check_nodes;
    struct trk one = *t, none = *t;

    one.check_nodes = 1;
    refused(&one, "check.node", "a check rail of one node");
    none.lateral_knots = 0;
    refused(&none, "bending.lateral.x", "a rail without lateral stiffness");
    TAMPER(lateral_bending, 2 * t->lateral_knots, 1, 0, "bending.lateral", "a rail that does not resist bending sideways");
    TAMPER(rail_torsion, 2 * (n - 1), 3, 0, "rail.torsion", "a rail that twists at will");
    TAMPER(rail_yaw, 2 * n, 3, -1, "rail.yaw", "a negative yaw inertia");
    TAMPER(rail_twist, 2 * n, 3, -1, "rail.twist", "a negative inertia in twist");
    TAMPER(rail_polar, 2 * (n - 1), 3, -1, "rail.polar", "a negative inertia along it");
    TAMPER(sleeper_yaw, s, 3, 0, "sleeper.yaw", "a sleeper without yaw inertia");
    TAMPER(pad_lateral_k, 2 * s, 3, -1, "pad.lateral.k", "a railpad that pushes aside");
    TAMPER(pad_width, 1, 0, -0.1, "pad.width", "a railpad of negative width");
    TAMPER(ballast_lateral_k, s, 3, -1, "ballast.lateral.k", "ballast that pushes aside");
    TAMPER(ballast_yaw_c, s, 3, -1, "ballast.yaw.c", "ballast that drives yaw");
    TAMPER(check_bending, 2, 1, 0, "check.bending", "a check rail that does not resist bending sideways");
    TAMPER(check_density, 1, 0, 0, "check.density", "a check rail without mass");
    TAMPER_INTEGER(check_node, q, 2, t->check_node[1], "check.node", "a node of the check rail twice");
    TAMPER_INTEGER(check_node, q, q - 1, n, "check.node", "one beyond the rail");
    TAMPER_INTEGER(check_dof, q, 2, 0, "check.dof", "a degree of freedom used twice");
}

static void spatial(void)
{
    struct trk t;
    const char *why = straight(&t, NULL, 0);

    if (ok(why == NULL, "a spatial track builds%s%s", why ? ": " : "", why ? why : "")) {
        round_trip(&t);
        spatial_refusals(&t);
    }
    trk_free(&t);
}

int main(void)
{
    struct trk t;
    const char *why = table1(&t, NULL, 0);

    if (!ok(why == NULL, "the track of Table 1 builds%s%s", why ? ": " : "", why ? why : ""))
        return done();
    round_trip(&t);
    refusals(&t);
    ok(trk_room(&t, -1, 8) == NULL && trk_room(&t, INT64_MAX, 8) == NULL, "impossible room is refused");
    trk_free(&t);
    trk_free(&t);
    spatial();
    return done();
}
