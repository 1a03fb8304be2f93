/* Between the parts of cli. */
#ifndef VX_CLI_CLI_PRIVATE_H
#define VX_CLI_CLI_PRIVATE_H

#include "tools/cli/cli.h"

extern const char *cli_name;              /* of the program, for messages */
extern int cli_failure;                   /* exit status of cli_die */
void cli_remember(int argc, char **argv); /* keeps the command line for cli_command */
void cli_forget(void);
void cli_remove_outputs(void);            /* outputs begun and not closed */

/* cli_create of a regular file and cli_close for one the program can do without: they return the reason.  Writing that failed with
 * `why` ends with it, and nothing stays. */
const char *cli_begin_file(struct cli_out *out, const char *path);
const char *cli_end_file(struct cli_out *out, const char *why);

#endif
