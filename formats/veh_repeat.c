/* Items are copied by their schema: texts and numbers anew, since every item owns its own; then names get the number of the place and
 * x its position. */
#include "formats/veh_repeat.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

/* The lists of veh_text_parts, in its order. */
enum kind { BODY, WHEELSET, COUPLING, STOP, SPRING, DAMPER, ROD, FRICTION, KINDS };

static const char *const KEY[KINDS] = {"body", "wheelset", "coupling", "stop", "spring", "damper", "rod", "friction"};

static struct yaml_list *list_of(struct veh_text_parts *p, int kind)
{
    struct yaml_list *const list[KINDS] = {&p->body, &p->wheelset, &p->coupling, &p->stop, &p->spring, &p->damper, &p->rod, &p->friction};
    return list[kind];
}

static const struct yaml_schema *schema_of(int kind)
{
    const struct yaml_field *f = veh_text_schema.field;
    while (strcmp(f->key, KEY[kind]))
        f++;
    return f->sub;
}

static int copy_numbers(struct yaml_nums *x)
{
    const double *from = x->x;

    if (!from)
        return 1;
    x->x = calloc((size_t)x->n + 1, sizeof *x->x);
    if (x->x)
        memcpy(x->x, from, (size_t)x->n*sizeof *x->x);
    return x->x != NULL;
}

/* What *to owns, after it was copied byte by byte, is made its own; all of it or NULL, so that it can be released. */
static int own_item(const struct yaml_schema *s, void *to)
{
    int good = 1;

    for (const struct yaml_field *f = s->field; f->key; f++) {
        void *at = (char *)to + f->at;
        if (f->type == YAML_TEXT && *(char **)at)
            good &= (*(char **)at = strdup(*(char **)at)) != NULL;
        else if (f->type == YAML_NUMS || f->type == YAML_PAIRS)
            good &= copy_numbers(at);
    }
    return good;
}

/* Copies of all of `from` to the end of `to`. */
static const char *append(const struct yaml_schema *s, const struct yaml_list *from, struct yaml_list *to)
{
    size_t n = (size_t)(to->n + from->n);
    void *item = realloc(to->item, (n + 1)*s->size);
    if (item)
        to->item = item;
    int *line = realloc(to->line, (n + 1)*sizeof *line);
    if (line)
        to->line = line;
    if (!item || !line)
        return REASON_MEMORY;
    for (int64_t i = 0; i < from->n; i++, to->n++) {
        char *copy = (char *)to->item + (size_t)to->n*s->size;
        memcpy(copy, (const char *)from->item + (size_t)i*s->size, s->size);
        to->line[to->n] = from->line[i];
        if (!own_item(s, copy)) {
            to->n++;
            return REASON_MEMORY;
        }
    }
    return NULL;
}

/* Every item of these kinds begins with its name. */
static int names_one(struct veh_text_parts *p, int first, int last, const char *name)
{
    for (int kind = first; kind <= last; kind++) {
        const struct yaml_list *list = list_of(p, kind);
        for (int64_t i = 0; i < list->n; i++)
            if (!strcmp(*(char *const *)((const char *)list->item + (size_t)i*schema_of(kind)->size), name))
                return 1;
    }
    return 0;
}

static const char *number_name(char **name, int number)
{
    size_t room = strlen(*name) + 12;
    char *longer = realloc(*name, room);

    if (!longer)
        return REASON_MEMORY;
    *name = longer;
    snprintf(longer + strlen(longer), room - strlen(longer), "%d", number);
    return NULL;
}

static const char *number_own(struct veh_text_parts *own, int first, int last, char **name, int number)
{
    return *name && names_one(own, first, last, *name) ? number_name(name, number) : NULL;
}

/* One copy, at x, as the number-th of the bogies. */
static const char *place_item(struct veh_text_parts *own, int kind, void *item, double x, int number)
{
    struct veh_text_place *p = item;
    const char *why = number_name(item, number);

    if (kind == BODY)
        ((struct veh_text_body *)item)->x += x;
    if (kind == WHEELSET)
        ((struct veh_text_wheelset *)item)->x += x;
    if (kind == BODY || kind == WHEELSET || why)
        return why;
    if (p->at.n > 0)
        p->at.x[0] += x;
    if (p->end.n > 0)
        p->end.x[0] += x;
    if ((why = number_own(own, BODY, WHEELSET, &p->from, number)) || (why = number_own(own, BODY, WHEELSET, &p->to, number)))
        return why;
    return kind == FRICTION ? number_own(own, COUPLING, SPRING, &((struct veh_text_friction *)item)->spring, number) : NULL;
}

static const char *place_bogie(struct veh_text *in, struct veh_text_bogie *bogie, double x, int number)
{
    for (int kind = 0; kind < KINDS; kind++) {
        const struct yaml_schema *s = schema_of(kind);
        struct yaml_list *to = list_of(&in->parts, kind);
        int64_t first = to->n;
        const char *why = append(s, list_of(&bogie->parts, kind), to);
        for (int64_t i = first; i < to->n && !why; i++)
            why = place_item(&bogie->parts, kind, (char *)to->item + (size_t)i*s->size, x, number);
        if (why)
            return why;
    }
    return NULL;
}

const char *veh_repeat(struct veh_text *in)
{
    struct veh_text_bogie *bogie = in->bogie.item;
    int number = 0;

    for (int64_t i = 0; i < in->bogie.n; i++)
        for (int64_t k = 0; k < bogie[i].at.n; k++) {
            const char *why = place_bogie(in, &bogie[i], bogie[i].at.x[k], ++number);
            if (why)
                return why;
        }
    return NULL;
}
