#include "formats/sections_text.h"

#include <stddef.h>

#include "formats/beside.h"
#include "formats/reason.h"

#define ANY (-YAML_NO_LIMIT), YAML_NO_LIMIT
#define FROM_KEYS(s, from) \
    {"file", YAML_TEXT, offsetof(s, from.file), ANY, "", YAML_ABSENT, "a CONTACT .slcs", NULL, NULL}, \
    {"index", YAML_TEXT, offsetof(s, from.index), ANY, "", YAML_ABSENT, "a file of numbers and stations, two columns", NULL, NULL}, \
    {"files", YAML_TEXT, offsetof(s, from.files), ANY, "", YAML_ABSENT, "the sections beside that index, * for the number", NULL, NULL}, \
    {"list", YAML_LIST, offsetof(s, from.list), ANY, "", YAML_ABSENT, "the sections one by one", &entry_schema, NULL}

static const struct yaml_schema entry_schema = {"list", sizeof(struct sections_entry), (const struct yaml_field[]){
    {"station", YAML_NUM, offsetof(struct sections_entry, station), ANY, "m", NULL, "where the section stands", NULL, NULL},
    {"file", YAML_TEXT, offsetof(struct sections_entry, file), ANY, "", NULL, "its points", NULL, NULL},
    {0}}};

static const struct yaml_schema name_schema = {"names", sizeof(struct sections_name), (const struct yaml_field[]){
    {"name", YAML_TEXT, offsetof(struct sections_name, name), ANY, "", NULL, "of a body", NULL, NULL},
    {0}}};

static const struct yaml_schema extra_schema = {"extra", sizeof(struct sections_extra), (const struct yaml_field[]){
    {"name", YAML_TEXT, offsetof(struct sections_extra, name), ANY, "", NULL, "of the body", NULL, NULL},
    FROM_KEYS(struct sections_extra, from),
    {0}}};

const struct yaml_schema sections_text_schema = {"sections", sizeof(struct sections_text), (const struct yaml_field[]){
    FROM_KEYS(struct sections_text, from),
    {"reference", YAML_INT, offsetof(struct sections_text, reference), 1, 1e6, "1", "1",
     "section whose top is z = 0 and whose gauge face stands at half a gauge", NULL, NULL},
    {"position", YAML_NUM, offsetof(struct sections_text, position), 0, 3, "m", "0",
     "of the sections' y = 0 from the centre line; 0: from gauge and reference", NULL, NULL},
    {"at", YAML_NUM, offsetof(struct sections_text, at), ANY, "m", "0", "station of the lists' 0", NULL, NULL},
    {"cut_depth", YAML_NUM, offsetof(struct sections_text, cut_depth), YAML_POSITIVE, 0.2, "m", "0.035",
     "below the reference's top; deeper surface parts one body from the next", NULL, NULL},
    {"every", YAML_NUM, offsetof(struct sections_text, every), 0, YAML_NO_LIMIT, "m", "0",
     "most between two sections made where they differ; 0: what moves a body by 0.5 mm", NULL, NULL},
    {"names", YAML_LIST, offsetof(struct sections_text, names), ANY, "", YAML_ABSENT, "of the bodies in the order in which they begin",
     &name_schema, NULL},
    {"extra", YAML_LIST, offsetof(struct sections_text, extra), ANY, "", YAML_ABSENT, "bodies that stand in lists of their own",
     &extra_schema, NULL},
    {0}}};

static const char *list_check(const struct sections_list *l)
{
    if ((l->file != NULL) + (l->index != NULL) + (l->list.n > 0) != 1)
        return "one of file, index and list must name the sections";
    if ((l->index != NULL) != (l->files != NULL))
        return "index and files belong together";
    return NULL;
}

const char *sections_text_check(const struct sections_text *t)
{
    const struct sections_extra *extra = t->extra.item;
    const char *why = list_check(&t->from);

    if (why)
        return reason("sections: %s", why);
    for (int64_t i = 0; i < t->extra.n; i++)
        if ((why = list_check(&extra[i].from)))
            return reason("sections: extra %s: %s", extra[i].name, why);
    return NULL;
}

static const char *list_place(struct sections_list *l, const char *input)
{
    struct sections_entry *entry = l->list.item;
    const char *why = beside_place(&l->file, input);

    if (!why)
        why = beside_place(&l->index, input);
    for (int64_t i = 0; !why && i < l->list.n; i++)
        why = beside_place(&entry[i].file, input);
    return why;
}

const char *sections_text_place(struct sections_text *t, const char *input)
{
    struct sections_extra *extra = t->extra.item;
    const char *why = list_place(&t->from, input);

    for (int64_t i = 0; !why && i < t->extra.n; i++)
        why = list_place(&extra[i].from, input);
    return why;
}

const char *sections_text_slices(const struct sections_list *l, struct slices *s)
{
    const struct sections_entry *entry = l->list.item;
    const char *why = NULL;

    *s = (struct slices){0};
    if (l->list.n == 0) {
        why = l->file ? slices_read(s, l->file) : slices_index(s, l->index, l->files);
        return why ? reason("%s: %s", l->file ? l->file : l->index, why) : NULL;
    }
    for (int64_t i = 0; !why && i < l->list.n; i++)
        why = slices_add(s, entry[i].station, entry[i].file);
    if (why)
        slices_free(s);
    return why;
}
