/* Names, bodies and coordinates: each refusal names the item and the rule, and the caller its line. */
#include "formats/veh_text_check.h"

#include <string.h>

#include "formats/reason.h"
#include "formats/veh.h"

enum { LETTERS = 31, SIDE_LETTERS = 2 };    /* of a name in veh(5), and of -l or -r after it */
enum { BODIES_MOST = 500 };                 /* its matrices are dense: 3 of 72 MB */

/* Bodies and wheelsets as one list. */
static int64_t body_count(const struct veh_text *in)
{
    return in->parts.body.n + in->parts.wheelset.n;
}

static const char *body_name(const struct veh_text *in, int64_t i, int *line)
{
    const struct yaml_list *body = &in->parts.body, *wheelset = &in->parts.wheelset;
    int is_body = i < body->n;

    i -= is_body ? 0 : body->n;
    *line = (is_body ? body : wheelset)->line[i];
    return is_body ? ((const struct veh_text_body *)body->item)[i].name : ((const struct veh_text_wheelset *)wheelset->item)[i].name;
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

static const char *check_bodies(const struct veh_text *in, int *line)
{
    const struct veh_text_body *b = in->parts.body.item;
    const struct veh_text_wheelset *w = in->parts.wheelset.item;
    const char *why = NULL;
    int other;

    if (body_count(in) > BODIES_MOST)
        return reason("body: %lld bodies and wheelsets are more than %d", (long long)body_count(in), BODIES_MOST);
    for (int64_t i = 0; i < body_count(in) && !why; i++) {
        const char *name = body_name(in, i, line);
        why = check_name("body", name, LETTERS);
        for (int64_t k = 0; k < i && !why; k++)
            if (!strcmp(name, body_name(in, k, &other)))
                why = reason("body %s: two bodies have this name", name);
        if (!why)
            why = i < in->parts.body.n ? check_three("body", name, "inertia", &b[i].inertia, 0)
                                       : check_three("wheelset", name, "inertia", &w[i - in->parts.body.n].inertia, 0);
    }
    return why;
}

static const char *check_end(const struct veh_text *in, const char *what, const char *name, const char *key, const char *body)
{
    int line;

    for (int64_t i = 0; i < body_count(in); i++)
        if (!strcmp(body, body_name(in, i, &line)))
            return NULL;
    return reason("%s %s: %s: there is no body or wheelset %s", what, name, key, body);
}

static const char *check_place(const struct veh_text *in, const char *what, const struct veh_text_place *p)
{
    const char *why;

    if ((why = check_name(what, p->name, p->mirror ? LETTERS - SIDE_LETTERS : LETTERS)) ||
        (why = check_end(in, what, p->name, "from", p->from)) || (why = check_end(in, what, p->name, "to", p->to)) ||
        (why = check_three(what, p->name, "at", &p->at, 0)) || (why = check_three(what, p->name, "end", &p->end, 1)))
        return why;
    return p->mirror && p->at.x[1] == 0 ? reason("%s %s: mirror needs a y other than 0", what, p->name) : NULL;
}

static const char *check_coupling(const void *item)
{
    const struct veh_text_coupling *c = item;
    const char *name = c->place.name, *why;

    if ((why = check_three("coupling", name, "stiffness", &c->stiffness, 0)) ||
        (why = check_three("coupling", name, "damping", &c->damping, 1)) ||
        (why = check_three("coupling", name, "rotation", &c->rotation, 1)))
        return why;
    return check_three("coupling", name, "rotation_damping", &c->rotation_damping, 1);
}

static const char *check_spring(const void *item)
{
    const struct veh_text_spring *s = item;

    if (s->axis == VEH_Z)
        return NULL;
    if (s->preload > 0)
        return reason("spring %s: a preload is vertical, its axis is not", s->place.name);
    for (int64_t k = 0; k < s->table.n; k += 2)
        if (s->table.x[k] == 0 && s->table.x[k + 1] == 0)
            return NULL;
    return reason("spring %s: it is not vertical, so its table needs a row 0, 0", s->place.name);
}

static const char *check_damper(const void *item)
{
    const struct veh_text_damper *d = item;

    return (d->axis == VEH_LINE) == (d->place.end.n > 0) ? NULL : reason("damper %s: axis line and an end go together", d->place.name);
}

static const char *check_friction(const void *item)
{
    const struct veh_text_friction *f = item;
    const char *name = f->place.name, *why;

    if ((why = check_three("friction", name, "stiffness", &f->stiffness, 1)) ||
        (why = check_three("friction", name, "rotation", &f->rotation, 1)))
        return why;
    return !f->spring && f->load == 0 ? reason("friction %s: needs a load or a spring", name) : NULL;
}

/* All that sits between bodies. */
enum { KINDS = 6 };
struct kind { const char *what; const struct yaml_list *list; size_t size; const char *(*check)(const void *); };

static void kinds(const struct veh_text_parts *p, struct kind kind[KINDS])
{
    const struct kind all[KINDS] = {{"coupling", &p->coupling, sizeof(struct veh_text_coupling), check_coupling},
                                    {"stop", &p->stop, sizeof(struct veh_text_stop), NULL},
                                    {"spring", &p->spring, sizeof(struct veh_text_spring), check_spring},
                                    {"damper", &p->damper, sizeof(struct veh_text_damper), check_damper},
                                    {"rod", &p->rod, sizeof(struct veh_text_rod), NULL},
                                    {"friction", &p->friction, sizeof(struct veh_text_friction), check_friction}};
    memcpy(kind, all, sizeof all);
}

const char *veh_text_check(const struct veh_text *in, int *line)
{
    struct kind kind[KINDS];
    const char *why;

    *line = 0;
    if (strlen(in->name) > 63)
        return reason("name: \"%s\" is longer than 63 letters", in->name);
    if (in->parts.wheelset.n < 1)
        return "wheelset: a vehicle needs one";
    if ((why = check_bodies(in, line)))
        return why;
    kinds(&in->parts, kind);
    for (int k = 0; k < KINDS; k++)
        for (int64_t i = 0; i < kind[k].list->n; i++) {
            const void *item = (const char *)kind[k].list->item + (size_t)i*kind[k].size;
            *line = kind[k].list->line[i];
            if ((why = check_place(in, kind[k].what, item)) || (kind[k].check && (why = kind[k].check(item))))
                return why;
        }
    return NULL;
}

/* A text that begins with this name, its side aside, and a colon. */
static int names(const char *text, const char *name)
{
    size_t n = strlen(name);

    if (strncmp(text, name, n))
        return 0;
    text += n;
    if (!strncmp(text, "-r", SIDE_LETTERS) || !strncmp(text, "-l", SIDE_LETTERS))
        text += SIDE_LETTERS;
    return *text == ':';
}

int veh_text_line(const struct veh_text *in, const char *why)
{
    struct kind kind[KINDS];
    const char *text = strchr(why, ' ');
    int line;

    if (!text++)
        return 0;
    for (int64_t i = 0; i < body_count(in); i++)
        if (names(text, body_name(in, i, &line)))
            return line;
    kinds(&in->parts, kind);
    for (int k = 0; k < KINDS; k++)
        for (int64_t i = 0; i < kind[k].list->n; i++) {
            const struct veh_text_place *p = (const void *)((const char *)kind[k].list->item + (size_t)i*kind[k].size);
            if (names(text, p->name))
                return kind[k].list->line[i];
        }
    return 0;
}
