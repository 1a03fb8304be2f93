/* Being a Unix program: options, messages, outputs that appear whole or not at all.
 *
 * The one folder that prints and exits; only tools/vx*.c include it.  Exit status: 0 done, 1 failed, 2 misuse. */
#ifndef VX_CLI_CLI_H
#define VX_CLI_CLI_H

#include <stdint.h>
#include <stdio.h>

#include "formats/reason.h"
#include "formats/vxf.h"

enum cli_type {
    CLI_FLAG,    /* int: 1 when given */
    CLI_NUM,     /* double within lo..hi */
    CLI_INT,     /* int64_t within lo..hi */
    CLI_TEXT,    /* const char * */
    CLI_CHOICE,  /* int: index into choice[] */
    CLI_LIST     /* struct cli_list: may be given again */
};

struct cli_list { int n; char **item; };

struct cli_option {
    const char *name;            /* long name; one character: a short option */
    enum cli_type type;
    void *value;                 /* holds the default before */
    double lo, hi;               /* CLI_NUM, CLI_INT */
    double factor;               /* multiplies a CLI_NUM into SI; 0 is 1 */
    const char *const *choice;   /* CLI_CHOICE, NULL-terminated */
    int letter;                  /* the name of one character is a long option all the same: --a */
};

struct cli_program {
    const char *name;
    const char *purpose;         /* one line */
    const char *usage;           /* the SYNOPSIS of its page, one form a line */
    const struct cli_option *option; /* up to one with name NULL; -h is added */
    int failure;                 /* exit status of cli_die; 0 is 1 */
};

/* Reads the options; returns the operands, *operands of them, between least and most; exits 2 on misuse, 0 after -h. */
char **cli_begin(const struct cli_program *p, int argc, char **argv, int least, int most, int *operands);

/* Misuse where an option was given that this form of the usage, from 0, has not; `what` it is that asks for the form, as "--modes". */
void cli_form(const struct cli_program *p, int form, const char *what);

/* The value of an option "key=number,key=number" into its items[n], within lo..hi, or misuse. */
struct cli_item { const char *key; double *value; double lo, hi; int needed; };
void cli_items(const char *option, const char *text, const struct cli_item *item, int n);

/* The value of an option "number,number" into value[most], each within lo..hi, or misuse; how many. */
int cli_numbers(const char *option, const char *text, double lo, double hi, double *value, int most);

/* Closes standard output, checked, and returns the exit status. */
int cli_end(void);

/* "vxtool: message" on stderr. */
_Noreturn void cli_die(const char *format, ...) VX_PRINTF(1, 2);     /* exit 1, or the program's failure; outputs begun are removed */
_Noreturn void cli_misuse(const char *format, ...) VX_PRINTF(1, 2);  /* exit 2 */
void cli_note(const char *format, ...) VX_PRINTF(1, 2);              /* goes on */

/* Dies with "name: why" unless why is NULL. */
void cli_check(const char *name, const char *why);

/* The command as typed, quoted where needed, without -o FILE: the CMD line of a header. */
const char *cli_command(void);

/* Opens a container of this kind (any where kind is NULL), or dies. */
void cli_open(struct vxf *f, const char *path, const char *kind);

/* An output: path NULL is standard output.  A regular file is written beside its place and moved there by
 * cli_close; a binary kind is never written to a terminal. */
struct cli_out {
    FILE *file;
    const char *path;
    char *temporary;             /* NULL where written directly */
    int keep;                    /* the temporary outlives a failure */
};
void cli_create(struct cli_out *out, const char *path, int binary);
/* The temporary is path.part and stays after a failure: for streams, readable while they grow. */
void cli_create_part(struct cli_out *out, const char *path);
void cli_close(struct cli_out *out);

/* Adds CMD= and writes the container to path, or standard output. */
void cli_write(struct vxf_out *o, const char *path);

#endif
