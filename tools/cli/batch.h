/* Many commands of one program in one process: a file with the words of one a line.
 *
 * Each line is run in a child, which finds in memory what the parent has read.  So no line can harm another, and what one leaves is the same
 * whether they run one after another or several at once. */
#ifndef VX_CLI_BATCH_H
#define VX_CLI_BATCH_H

#include <stdint.h>

struct batch_line {
    long number;                 /* in the file */
    int n;
    char **word;                 /* [n] */
    const char *out;             /* the word after -o */
    char *text;                  /* holds the words */
};

struct batch {
    const char *path;
    int n;
    struct batch_line *line;
};

/* Lines of words apart by blanks; # begins a comment.  Dies where a line has no output of its own. */
void batch_read(struct batch *b, const char *path);

/* Runs every line, `jobs` at once.  In the child of a line returns it; in the parent, when all have ended, NULL, and *failed lines that
 * failed, each of which is told. */
const struct batch_line *batch_run(const struct batch *b, int64_t jobs, int *failed);

/* The command of a line: argv[argc], parsed, with its operands from argv[operand] on, and the words of the line before these; without the options
 * `left_out`, NULL-terminated, and their values.  *n is how many words. */
char **batch_command(const struct batch_line *line, int argc, char **argv, int operand, const char *const *left_out, int *n);

void batch_free(struct batch *b);

#endif
