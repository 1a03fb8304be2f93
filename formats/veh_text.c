/* The schema of a vehicle input and the checks between its keys. */
#include "formats/veh_text.h"

#include <string.h>

#include "formats/reason.h"

enum { LETTERS = 31, SIDE_LETTERS = 2 };    /* of a name in veh(5), and of -l or -r after it */

#define AT(type, member) offsetof(struct type, member)

static const char *const AXES[] = {"x", "y", "z", NULL};

static const struct yaml_field BODY_FIELDS[] = {
    {"name", YAML_TEXT, AT(veh_text_body, name), 0, 0, "", NULL, "of the body, up to 31 letters", NULL, NULL},
    {"mass", YAML_NUM, AT(veh_text_body, mass), YAML_POSITIVE, 1e7, "kg", NULL, "of the body", NULL, NULL},
    {"inertia", YAML_NUMS, AT(veh_text_body, inertia), YAML_POSITIVE, 1e10, "kg m2", NULL,
     "about x, y and z through the centre of gravity", NULL, NULL},
    {"x", YAML_NUM, AT(veh_text_body, x), -1e3, 1e3, "m", NULL, "centre of gravity, from the first wheelset, negative behind it", NULL,
     NULL},
    {"y", YAML_NUM, AT(veh_text_body, y), -5, 5, "m", "0", "centre of gravity, to the right", NULL, NULL},
    {"height", YAML_NUM, AT(veh_text_body, height), 0, 10, "m", NULL, "centre of gravity, above rail level", NULL, NULL},
    {0}};

static const struct yaml_field WHEELSET_FIELDS[] = {
    {"name", YAML_TEXT, AT(veh_text_wheelset, name), 0, 0, "", NULL, "of the wheelset, up to 31 letters", NULL, NULL},
    {"mass", YAML_NUM, AT(veh_text_wheelset, mass), YAML_POSITIVE, 1e5, "kg", NULL, "with axleboxes", NULL, NULL},
    {"inertia", YAML_NUMS, AT(veh_text_wheelset, inertia), YAML_POSITIVE, 1e6, "kg m2", NULL, "about x, y and z; y is the axle", NULL,
     NULL},
    {"x", YAML_NUM, AT(veh_text_wheelset, x), -1e3, 0, "m", NULL, "from the first wheelset, which is at 0", NULL, NULL},
    {"radius", YAML_NUM, AT(veh_text_wheelset, radius), 0.1, 2, "m", NULL, "nominal rolling radius, the height of the axle", NULL, NULL},
    {0}};

static const struct yaml_field COUPLING_FIELDS[] = {
    {"name", YAML_TEXT, AT(veh_text_coupling, name), 0, 0, "", NULL, "up to 31 letters, 29 with mirror", NULL, NULL},
    {"from", YAML_TEXT, AT(veh_text_coupling, from), 0, 0, "", NULL, "body or wheelset", NULL, NULL},
    {"to", YAML_TEXT, AT(veh_text_coupling, to), 0, 0, "", NULL, "body or wheelset", NULL, NULL},
    {"at", YAML_NUMS, AT(veh_text_coupling, at), -1e3, 1e3, "m", NULL, "x, y and height of its point", NULL, NULL},
    {"mirror", YAML_BOOL, AT(veh_text_coupling, mirror), 0, 0, "", "false", "a twin at -y; names end in -r and -l", NULL, NULL},
    {"stiffness", YAML_NUMS, AT(veh_text_coupling, stiffness), 0, 1e12, "N/m", NULL, "along x, y and z", NULL, NULL},
    {"damping", YAML_NUMS, AT(veh_text_coupling, damping), 0, 1e10, "N s/m", YAML_ABSENT, "along x, y and z", NULL, NULL},
    {"rotation", YAML_NUMS, AT(veh_text_coupling, rotation), 0, 1e12, "N m/rad", YAML_ABSENT, "stiffness about x, y and z", NULL, NULL},
    {"rotation_damping", YAML_NUMS, AT(veh_text_coupling, rotation_damping), 0, 1e10, "N m s/rad", YAML_ABSENT, "about x, y and z", NULL,
     NULL},
    {0}};

static const struct yaml_field STOP_FIELDS[] = {
    {"name", YAML_TEXT, AT(veh_text_stop, name), 0, 0, "", NULL, "up to 31 letters, 29 with mirror", NULL, NULL},
    {"from", YAML_TEXT, AT(veh_text_stop, from), 0, 0, "", NULL, "body or wheelset", NULL, NULL},
    {"to", YAML_TEXT, AT(veh_text_stop, to), 0, 0, "", NULL, "body or wheelset", NULL, NULL},
    {"at", YAML_NUMS, AT(veh_text_stop, at), -1e3, 1e3, "m", NULL, "x, y and height of its point", NULL, NULL},
    {"mirror", YAML_BOOL, AT(veh_text_stop, mirror), 0, 0, "", "false", "a twin at -y; names end in -r and -l", NULL, NULL},
    {"axis", YAML_CHOICE, AT(veh_text_stop, axis), 0, 0, "", NULL, "along which it acts", NULL, AXES},
    {"table", YAML_PAIRS, AT(veh_text_stop, table), 0, 1e9, "m, N", NULL,
     "deflection and force, rising from the clearance with force 0; odd, beyond its end the last slope", NULL, NULL},
    {0}};

static const struct yaml_schema BODY = {"body", sizeof(struct veh_text_body), BODY_FIELDS};
static const struct yaml_schema WHEELSET = {"wheelset", sizeof(struct veh_text_wheelset), WHEELSET_FIELDS};
static const struct yaml_schema COUPLING = {"coupling", sizeof(struct veh_text_coupling), COUPLING_FIELDS};
static const struct yaml_schema STOP = {"stop", sizeof(struct veh_text_stop), STOP_FIELDS};

static const struct yaml_field VEHICLE_FIELDS[] = {
    {"name", YAML_TEXT, AT(veh_text, name), 0, 0, "", NULL, "of the vehicle, up to 63 letters", NULL, NULL},
    {"gravity", YAML_NUM, AT(veh_text, gravity), 0, 100, "m/s2", "9.81", "acceleration of free fall", NULL, NULL},
    {"body", YAML_LIST, AT(veh_text, body), 0, 0, "", YAML_ABSENT, "rigid bodies above the wheelsets", &BODY, NULL},
    {"wheelset", YAML_LIST, AT(veh_text, wheelset), 0, 0, "", NULL, "from the front", &WHEELSET, NULL},
    {"coupling", YAML_LIST, AT(veh_text, coupling), 0, 0, "", YAML_ABSENT, "spring and damper between two bodies", &COUPLING, NULL},
    {"stop", YAML_LIST, AT(veh_text, stop), 0, 0, "", YAML_ABSENT, "piecewise-linear spring along one axis", &STOP, NULL},
    {0}};

const struct yaml_schema veh_text_schema = {"vehicle", sizeof(struct veh_text), VEHICLE_FIELDS};

/* Name of the i-th of the bodies and wheelsets, as one list. */
static const char *body_name(const struct veh_text *in, int64_t i)
{
    const struct veh_text_body *b = in->body.item;
    const struct veh_text_wheelset *w = in->wheelset.item;
    return i < in->body.n ? b[i].name : w[i - in->body.n].name;
}

static const char *check_name(const char *what, const char *name, int most)
{
    if (!name[0])
        return reason("%s: a name is empty", what);
    if (strlen(name) > (size_t)most)
        return reason("%s %s: its name has more than %d letters", what, name, most);
    return NULL;
}

static const char *check_three(const char *what, const char *name, const char *key, const struct yaml_nums *x, int may_lack)
{
    if (x->n == 3 || (may_lack && x->n == 0))
        return NULL;
    return reason("%s %s: %s must be three numbers, not %lld", what, name, key, (long long)x->n);
}

static const char *check_bodies(const struct veh_text *in)
{
    const struct veh_text_body *b = in->body.item;
    const struct veh_text_wheelset *w = in->wheelset.item;
    int64_t n = in->body.n + in->wheelset.n;
    const char *why = NULL;

    for (int64_t i = 0; i < n && !why; i++) {
        why = check_name("body", body_name(in, i), LETTERS);
        for (int64_t k = 0; k < i && !why; k++)
            if (!strcmp(body_name(in, i), body_name(in, k)))
                why = reason("body %s: two bodies have this name", body_name(in, i));
    }
    for (int64_t i = 0; i < in->body.n && !why; i++)
        why = check_three("body", b[i].name, "inertia", &b[i].inertia, 0);
    for (int64_t i = 0; i < in->wheelset.n && !why; i++)
        why = check_three("wheelset", w[i].name, "inertia", &w[i].inertia, 0);
    return why;
}

static const char *check_end(const struct veh_text *in, const char *what, const char *name, const char *key, const char *body)
{
    for (int64_t i = 0; i < in->body.n + in->wheelset.n; i++)
        if (!strcmp(body, body_name(in, i)))
            return NULL;
    return reason("%s %s: %s: there is no body or wheelset %s", what, name, key, body);
}

static const char *check_place(const struct veh_text *in, const char *what, const char *name, const char *from, const char *to,
                               const struct yaml_nums *at, int mirror)
{
    const char *why;

    if ((why = check_name(what, name, mirror ? LETTERS - SIDE_LETTERS : LETTERS)) ||
        (why = check_end(in, what, name, "from", from)) || (why = check_end(in, what, name, "to", to)) ||
        (why = check_three(what, name, "at", at, 0)))
        return why;
    return mirror && at->x[1] == 0 ? reason("%s %s: mirror needs a y other than 0", what, name) : NULL;
}

static const char *check(const struct veh_text *in)
{
    const struct veh_text_coupling *c = in->coupling.item;
    const struct veh_text_stop *s = in->stop.item;
    const char *why;

    if (strlen(in->name) > 63)
        return reason("name: \"%s\" is longer than 63 letters", in->name);
    if (in->wheelset.n < 1)
        return "wheelset: a vehicle needs one";
    if ((why = check_bodies(in)))
        return why;
    for (int64_t i = 0; i < in->coupling.n; i++)
        if ((why = check_place(in, "coupling", c[i].name, c[i].from, c[i].to, &c[i].at, c[i].mirror)) ||
            (why = check_three("coupling", c[i].name, "stiffness", &c[i].stiffness, 0)) ||
            (why = check_three("coupling", c[i].name, "damping", &c[i].damping, 1)) ||
            (why = check_three("coupling", c[i].name, "rotation", &c[i].rotation, 1)) ||
            (why = check_three("coupling", c[i].name, "rotation_damping", &c[i].rotation_damping, 1)))
            return why;
    for (int64_t i = 0; i < in->stop.n; i++)
        if ((why = check_place(in, "stop", s[i].name, s[i].from, s[i].to, &s[i].at, s[i].mirror)))
            return why;
    return NULL;
}

const char *veh_text_read(struct veh_text *in, const char *path, char *const *set, int sets, uint64_t *hash)
{
    const char *why = yaml_read(path, &veh_text_schema, set, sets, in, hash);
    if (why)
        return why;
    why = check(in);
    if (why) {
        why = reason("%s: error: %s", strcmp(path, "-") ? path : "standard input", why);
        veh_text_free(in);
    }
    return why;
}

void veh_text_free(struct veh_text *in)
{
    yaml_release(&veh_text_schema, in);
}
