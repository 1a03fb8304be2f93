/* A table none of whose places is on the track says one number for all of it, which is hardly meant: a wrong sign, or another track's.
 * What belongs to sleepers is told at them; rails vary between them too. */
#include "formats/trk_text_tables.h"

#include <math.h>
#include <string.h>

#include "formats/reason.h"

static const double ROUNDING = 1e-6;     /* m, and of a number */

static const char *check_table(const struct yaml_table *t, const char *path, const struct trk_text *in)
{
    const double spacing = in->sleeper.spacing, first = floor((in->from - in->first_sleeper) / spacing + 1.5);
    const double from = t->by_number ? first : in->from, to = t->by_number ? first + in->length / spacing - 1 : in->from + in->length;

    for (int64_t i = 0; i < t->n && t->by_number && t->n > 1 && strncmp(path, "rail.", 5); i++)
        if (floor(t->at[i]) < t->at[i])
            return reason("%s: %g is no number of a sleeper, which are whole", path, t->at[i]);
    if (t->n > 1 && (t->at[t->n - 1] < from - ROUNDING || t->at[0] > to + ROUNDING))
        return reason(t->by_number ? "%s: sleepers %g to %g are not on the track, whose sleepers are %.0f to %.0f"
                                   : "%s: stations %g to %g are not on the track, which lies from %g to %g", path, t->at[0], t->at[t->n - 1], from, to);
    return NULL;
}

/* Every table of an object of this schema, at the path of its keys. */
static const char *check_tables(const struct yaml_schema *s, const void *object, const char *path, const struct trk_text *in)
{
    const char *why = NULL, *base = object;
    char here[200];

    for (const struct yaml_field *f = s->field; f->key && !why; f++) {
        const int written = snprintf(here, sizeof here, "%s%s%s", path, *path ? "." : "", f->key);
        if (written < 0 || written >= (int)sizeof here)
            return "a path of keys is too long";
        if (f->type == YAML_TABLE)
            why = check_table((const struct yaml_table *)(const void *)(base + f->at), here, in);
        else if (f->type == YAML_MAP)
            why = check_tables(f->sub, base + f->at, here, in);
    }
    return why;
}

const char *trk_text_tables(const struct trk_text *in)
{
    const struct trk_text_check *c = in->check_rail.item;
    const char *why = in->model == TRK_TEXT_MOVING_MASS ? NULL : check_tables(&trk_text_schema, in, "", in);

    return why || in->check_rail.n == 0 || in->model == TRK_TEXT_MOVING_MASS ? why : check_table(&c->play, "check_rail.1.play", in);
}
