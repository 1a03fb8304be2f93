/* Between the parts of cli. */
#ifndef VX_CLI_CLI_PRIVATE_H
#define VX_CLI_CLI_PRIVATE_H

#include "tools/cli/cli.h"

extern const char *cli_name;              /* of the program, for messages */
extern int cli_failure;                   /* exit status of cli_die */
void cli_remember(int argc, char **argv); /* keeps the command line for cli_command */
void cli_forget(void);
void cli_remove_outputs(void);            /* outputs begun and not closed */

#endif
