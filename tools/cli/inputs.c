#include "tools/cli/inputs.h"
#include "formats/beside.h"
#include "formats/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What the case names, and a batch has read already. */
struct source {
    const struct case_text *text;
    const char *path;                /* of the case */
    const struct inputs *kept;
};

/* File k of the inputs, of this kind; the option goes before the case.  Returns whether it is kept: then it is read as well. */
static int open_input(struct inputs *in, const struct source *from, int k, const char *option, const char *spelled, const char *named,
                      const char *kind)
{
    const struct inputs *kept = from->kept;

    if (!option && !named)
        cli_misuse("the case names no .%s file, and %s is not given", kind, spelled);
    if (!(in->name[k] = option ? strdup(option) : beside_path(named, from->path)))
        cli_die(REASON_MEMORY);
    if (kept && kept->name[k] && strcmp(kept->name[k], in->name[k]) == 0) {
        in->file[k] = kept->file[k];
        return 1;
    }
    cli_open(&in->file[k], in->name[k], kind);
    return 0;
}

static void check_side(const char *path, const struct ctab *t, char side)
{
    if (t->side != side)
        cli_die("%s: is of side %c, but %s wants side %c", path, t->side, side == 'l' ? "--contact-left" : "--contact-right", side);
}

/* A track has no name of its route; one without a curve is not that of a diverging route. */
static void check_track(const char *path, const struct case_text *c, const struct trk *t)
{
    int curved = 0;

    for (int64_t i = 0; i < t->curves; i++)
        curved |= fabs(t->curvature[i]) > 0;
    if (c->route == CASE_DIVERGING && !curved)
        cli_die("%s: the route is diverging, but this track has no curve", path);
}

static void read_irregularity(struct inputs *in, const char *path)
{
    char **file = &in->text.irregularity.file;

    cli_check(path, beside_place(file, path));
    if (*file)
        cli_check(*file, irregularity_read(&in->measured, *file));
}

static void read_creep(struct inputs *in, const struct source *from, const char *option)
{
    if (!option && !in->text.creep)
        return;
    in->files = INPUT_CREEP + 1;
    if (open_input(in, from, INPUT_CREEP, option, "--creep", in->text.creep, "creep"))
        in->creep = from->kept->creep;
    else
        cli_check(in->name[INPUT_CREEP], creep_read(&in->creep, &in->file[INPUT_CREEP]));
}

static void read_train(struct inputs *in, const struct source *from, const struct inputs_options *opt)
{
    const struct case_text *c = &in->text;

    if (!(c->speed > 0))
        cli_die("%s: speed_kmh: missing", from->path);
    if (open_input(in, from, INPUT_VEHICLE, opt->vehicle, "--vehicle", c->vehicle, "veh"))
        in->vehicle = from->kept->vehicle;
    else
        cli_check(in->name[INPUT_VEHICLE], veh_read(&in->vehicle, &in->file[INPUT_VEHICLE]));
    for (int side = 0; side < 2; side++) {
        const int k = side ? INPUT_RIGHT : INPUT_LEFT;
        if (open_input(in, from, k, side ? opt->right : opt->left, side ? "--contact-right" : "--contact-left",
                       side ? c->contact_right : c->contact_left, "ctab"))
            in->table[side] = from->kept->table[side];
        else
            cli_check(in->name[k], ctab_read(&in->table[side], &in->file[k]));
        check_side(in->name[k], &in->table[side], side ? 'r' : 'l');
    }
    read_irregularity(in, from->path);
    read_creep(in, from, opt->creep);
}

/* A prescribed force stands for vehicle and contact. */
void inputs_read(struct inputs *in, const char *path, const struct inputs_options *opt, const struct inputs *kept)
{
    const struct case_text *c = &in->text;
    const struct source from = {c, path, kept};
    const char *why;

    if ((why = yaml_read(path, &case_text_schema, opt->set.item, opt->set.n, &in->text, &in->hash)))
        cli_die("%s", why); /* begins with its place */
    if ((why = case_text_check(c)))
        cli_die("%s", yaml_blame(path, &case_text_schema, opt->set.item, opt->set.n, why));
    if (strlen(c->name) >= sizeof ((struct run *)NULL)->name)
        cli_die("%s: name: longer than %zu letters", path, sizeof ((struct run *)NULL)->name - 1);
    in->files = c->force.amplitude > 0 ? INPUT_TRACK + 1 : INPUT_RIGHT + 1;
    if (!inputs_have_train(in) && (c->vehicle || c->contact_left || c->contact_right || opt->vehicle || opt->left || opt->right || opt->creep))
        cli_die("%s: force: a prescribed force stands instead of vehicle and contact tables", path);
    if (open_input(in, &from, INPUT_TRACK, opt->track, "--track", c->track, "trk"))
        in->track = kept->track;
    else
        cli_check(in->name[INPUT_TRACK], trk_read(&in->track, &in->file[INPUT_TRACK]));
    check_track(in->name[INPUT_TRACK], c, &in->track);
    if (inputs_have_train(in))
        read_train(in, &from, opt);
}

int inputs_have_train(const struct inputs *in)
{
    return in->files > INPUT_VEHICLE;
}

int inputs_have_creep(const struct inputs *in)
{
    return in->files > INPUT_CREEP;
}

void inputs_put(const struct inputs *in, struct vxf_out *o)
{
    for (int i = 0; i < in->files; i++)
        vxf_put_input(o, &in->file[i]);
    vxf_put_key(o, "INPUT", "case %016llx", (unsigned long long)in->hash);
    if (in->text.irregularity.file)
        vxf_put_key(o, "INPUT", "irregularity %016llx", (unsigned long long)in->measured.hash);
}

void inputs_release(struct inputs *in)
{
    for (int i = 0; i < in->files; i++) {
        vxf_close(&in->file[i]);
        free(in->name[i]);
    }
    irregularity_free(&in->measured);
    yaml_release(&case_text_schema, &in->text);
}
