#include "tools/cli/inputs.h"
#include "formats/beside.h"
#include "formats/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The option goes before the case.  Returns the name, for messages. */
static char *open_input(struct vxf *f, const char *option, const char *spelled, const char *case_path, const char *named,
                        const char *kind)
{
    char *path;

    if (!option && !named)
        cli_misuse("the case names no .%s file, and %s is not given", kind, spelled);
    if (!(path = option ? strdup(option) : beside_path(named, case_path)))
        cli_die(REASON_MEMORY);
    cli_open(f, path, kind);
    return path;
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

static void read_creep(struct inputs *in, const char *path, const char *option)
{
    if (!option && !in->text.creep)
        return;
    char *name = open_input(&in->file[in->files++], option, "--creep", path, in->text.creep, "creep");
    cli_check(name, creep_read(&in->creep, &in->file[4]));
    free(name);
}

static void read_train(struct inputs *in, const char *path, const struct inputs_options *opt)
{
    const struct case_text *c = &in->text;
    char *name[4];

    if (!(c->speed > 0))
        cli_die("%s: speed_kmh: missing", path);
    name[1] = open_input(&in->file[1], opt->vehicle, "--vehicle", path, c->vehicle, "veh");
    name[2] = open_input(&in->file[2], opt->left, "--contact-left", path, c->contact_left, "ctab");
    name[3] = open_input(&in->file[3], opt->right, "--contact-right", path, c->contact_right, "ctab");
    cli_check(name[1], veh_read(&in->vehicle, &in->file[1]));
    cli_check(name[2], ctab_read(&in->table[0], &in->file[2]));
    cli_check(name[3], ctab_read(&in->table[1], &in->file[3]));
    check_side(name[2], &in->table[0], 'l');
    check_side(name[3], &in->table[1], 'r');
    read_irregularity(in, path);
    read_creep(in, path, opt->creep);
    for (int i = 1; i < 4; i++)
        free(name[i]);
}

/* A prescribed force stands for vehicle and contact. */
void inputs_read(struct inputs *in, const char *path, const struct inputs_options *opt)
{
    const struct case_text *c = &in->text;
    const char *why;
    char *name;

    if ((why = yaml_read(path, &case_text_schema, opt->set.item, opt->set.n, &in->text, &in->hash)))
        cli_die("%s", why); /* begins with its place */
    if (strlen(c->name) >= sizeof ((struct run *)NULL)->name)
        cli_die("%s: name: longer than %zu letters", path, sizeof ((struct run *)NULL)->name - 1);
    in->files = c->force.amplitude > 0 ? 1 : 4;
    if (in->files == 1 && (c->vehicle || c->contact_left || c->contact_right || opt->vehicle || opt->left || opt->right || opt->creep))
        cli_die("%s: force: a prescribed force stands instead of vehicle and contact tables", path);
    name = open_input(&in->file[0], opt->track, "--track", path, c->track, "trk");
    cli_check(name, trk_read(&in->track, &in->file[0]));
    check_track(name, c, &in->track);
    free(name);
    if (in->files > 1)
        read_train(in, path, opt);
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
    for (int i = 0; i < in->files; i++)
        vxf_close(&in->file[i]);
    irregularity_free(&in->measured);
    yaml_release(&case_text_schema, &in->text);
}
