/* States of a run: saved beside it, left by one that fails, gone on from. */
#ifndef VX_CLI_STATES_H
#define VX_CLI_STATES_H

#include "tools/cli/inputs.h"
#include "tools/integrate/passage.h"

/* Into the .state beside `out`, a .run; `failed` is NULL or why the run ends there. */
void states_save(struct passage *p, const struct inputs *in, const char *out, const char *failed);

/* What a run that fails leaves for a post-mortem, where its numbers are still finite and `out` is not NULL. */
void states_leave(struct passage *p, const struct inputs *in, const char *out, const char *failed);

/* p goes on from the state in `file`, which messages call `path`.  What differs is told; what must not, refused. */
void states_resume(struct passage *p, const struct inputs *in, const char *path, const struct vxf *file);

#endif
