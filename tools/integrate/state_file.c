#include "tools/integrate/state_file.h"

#include <math.h>
#include <stdio.h>

const char *state_file_put(struct passage *p, const struct state_file_origin *from, const char *failed, struct vxf_out *o, double **rest)
{
    struct state s;
    struct state_part part[STATE_PARTS];
    const char *why = state_take(&s, p, rest);

    if (why)
        return why;
    snprintf(s.failed, sizeof s.failed, "%s", failed ? failed : "");
    s.vehicle = from->vehicle;
    s.contact[0] = from->contact[0];
    s.contact[1] = from->contact[1];
    s.text = from->text;
    s.track = from->track;
    state_put(&s, state_parts(p, part), part, o);
    return NULL;
}

int state_file_is_finite(struct passage *p)
{
    struct state_part part[STATE_PARTS];
    const int n = state_parts(p, part);

    for (int k = 0; k < n; k++)
        for (int64_t i = 0; i < part[k].n; i++)
            if (!isfinite(part[k].x[i]))
                return 0;
    return 1;
}

const char *state_file_resume(struct passage *p, const struct state_file_origin *from, const struct vxf *file, struct state *s,
                              struct state_difference *differs, int *n)
{
    const char *why;

    if ((why = state_read(s, file)) || (why = state_compare(s, from->track, differs, n)))
        return why;
    return s->vehicle != from->vehicle ? "is of another vehicle" : state_resume(s, p, differs, *n);
}
