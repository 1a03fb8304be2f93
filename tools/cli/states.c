#include "tools/cli/states.h"
#include "tools/integrate/state.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The .state beside the .run. */
static char *path_beside(const char *out)
{
    const size_t n = strlen(out), end = n > 4 && strcmp(out + n - 4, ".run") == 0 ? n - 4 : n;
    char *path = calloc(end + sizeof ".state", 1);

    if (!path)
        cli_die(REASON_MEMORY);
    snprintf(path, end + sizeof ".state", "%.*s.state", (int)end, out);
    return path;
}

void states_save(struct passage *p, const struct inputs *in, const char *out, const char *failed)
{
    struct state s;
    struct state_part part[STATE_PARTS];
    struct vxf_out o;
    char *path = path_beside(out);
    double *rest = NULL;

    cli_check(path, state_take(&s, p, &rest));
    snprintf(s.failed, sizeof s.failed, "%s", failed ? failed : "");
    s.vehicle = vxf_content(&in->file[1]);
    s.contact[0] = vxf_content(&in->file[2]);
    s.contact[1] = vxf_content(&in->file[3]);
    s.text = in->hash;
    s.track = &in->file[0];
    vxf_out_begin(&o, "state");
    inputs_put(in, &o);
    state_put(&s, state_parts(p, part), part, &o);
    cli_write(&o, path);
    vxf_out_free(&o);
    free(rest);
    free(path);
}

void states_leave(struct passage *p, const struct inputs *in, const char *out, const char *failed)
{
    struct state_part part[STATE_PARTS];
    const int n = state_parts(p, part);

    for (int k = 0; k < n; k++)
        for (int64_t i = 0; i < part[k].n; i++)
            if (!isfinite(part[k].x[i]))
                return;
    if (out && in->files > 1)
        states_save(p, in, out, failed);
}

void states_resume(struct passage *p, const struct inputs *in, const char *path, const struct vxf *file)
{
    struct state s;
    struct state_difference differs[STATE_DIFFERENCES];
    int n;

    cli_check(path, state_read(&s, file));
    cli_check(path, state_compare(&s, &in->file[0], differs, &n));
    if (s.vehicle != vxf_content(&in->file[1]))
        cli_die("%s: is of another vehicle", path);
    cli_check(path, state_resume(&s, p, differs, n));
    for (int k = 0; k < n; k++)
        cli_note("%s of the track differs from %.2f to %.2f m, beyond the state's reach from %.2f to %.2f m", differs[k].name,
                 differs[k].from, differs[k].to, s.reach[0], s.reach[1]);
    for (int side = 0; side < 2; side++)
        if (s.contact[side] != vxf_content(&in->file[2 + side]))
            cli_note("the %s contact table is not that of the state", side ? "right" : "left");
    if (s.text != in->hash)
        cli_note("the case is not that of the state");
}
