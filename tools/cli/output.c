/* Outputs that appear whole or not at all.
 *
 * A regular file is written as a temporary in its own folder, flushed to disk and renamed into place, so what existed stays until
 * the new one is complete.  What is not a regular file (/dev/null, a named pipe) is written directly. */
#include "tools/cli/cli.h"
#include "tools/cli/cli_private.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { OUTPUTS = 4 };
static struct cli_out *open_outputs[OUTPUTS];

void cli_remove_outputs(void)
{
    for (int i = 0; i < OUTPUTS; i++)
        if (open_outputs[i] && open_outputs[i]->temporary && !open_outputs[i]->keep)
            unlink(open_outputs[i]->temporary);
}

/* Interrupted or terminated: no temporary stays.  unlink and raise may be called in a handler; SA_RESETHAND lets raise end the program. */
static void interrupted(int signal)
{
    cli_remove_outputs();
    raise(signal);
}

static void catch_signals(void)
{
    static const int signals[] = {SIGHUP, SIGINT, SIGPIPE, SIGTERM};
    struct sigaction action = {.sa_handler = interrupted, .sa_flags = SA_RESETHAND};

    for (size_t k = 0; k < sizeof signals / sizeof *signals; k++) {
        struct sigaction before;
        if (sigaction(signals[k], NULL, &before) == 0 && before.sa_handler == SIG_DFL)
            sigaction(signals[k], &action, NULL);
    }
}

static void enrol(struct cli_out *out)
{
    catch_signals();
    for (int i = 0; i < OUTPUTS; i++)
        if (!open_outputs[i]) {
            open_outputs[i] = out;
            return;
        }
    cli_die("BUG: more than %d outputs", OUTPUTS);
}

static int is_special(const char *path)
{
    struct stat st;

    return stat(path, &st) == 0 && !S_ISREG(st.st_mode);
}

/* Standard output, or a file that is not regular.  A binary kind would only spoil a terminal. */
static int create_directly(struct cli_out *out, const char *path, int binary)
{
    if (path && !is_special(path))
        return 0;
    out->file = path ? fopen(path, "wb") : stdout;
    if (!out->file)
        cli_die("%s: %s", path, strerror(errno));
    if (binary && isatty(fileno(out->file)))
        cli_misuse("standard output is a terminal: name a file with -o, or use a pipe");
    return 1;
}

/* The same folder, or the rename would cross file systems; mkstemp gives mode 0600, the user's mask decides here. */
static FILE *open_beside(char *name)
{
    mode_t mask = umask(0);
    int fd = mkstemp(name);

    umask(mask);
    if (fd < 0)
        return NULL;
    fchmod(fd, 0666 & ~mask);
    return fdopen(fd, "wb");
}

const char *cli_begin_file(struct cli_out *out, const char *path)
{
    size_t n = strlen(path) + 8;

    *out = (struct cli_out){.path = path, .temporary = malloc(n)};
    if (!out->temporary)
        return REASON_MEMORY;
    snprintf(out->temporary, n, "%s.XXXXXX", path);
    out->file = open_beside(out->temporary);
    if (!out->file) {
        const char *why = strerror(errno);
        free(out->temporary);
        out->temporary = NULL;
        return why;
    }
    enrol(out);
    return NULL;
}

void cli_create(struct cli_out *out, const char *path, int binary)
{
    *out = (struct cli_out){.path = path};
    if (!create_directly(out, path, binary))
        cli_check(path, cli_begin_file(out, path));
}

void cli_create_part(struct cli_out *out, const char *path)
{
    size_t n = path ? strlen(path) + 6 : 0;

    *out = (struct cli_out){.path = path, .keep = 1};
    if (create_directly(out, path, 1))
        return;
    if (!(out->temporary = malloc(n)))
        cli_die(REASON_MEMORY);
    snprintf(out->temporary, n, "%s.part", path);
    out->file = fopen(out->temporary, "wb");
    if (!out->file)
        cli_die("%s: %s", out->temporary, strerror(errno));
    enrol(out);
}

/* A write that failed before leaves no trace but ferror. */
static const char *write_error(void)
{
    return errno ? strerror(errno) : "write error";
}

static void drop(struct cli_out *out)
{
    for (int i = 0; i < OUTPUTS; i++)
        if (open_outputs[i] == out)
            open_outputs[i] = NULL;
    free(out->temporary);
    out->temporary = NULL;
}

const char *cli_end_file(struct cli_out *out, const char *why)
{
    if (!why && (ferror(out->file) || fflush(out->file) != 0 || (out->temporary && fsync(fileno(out->file)) != 0)))
        why = write_error();
    if (fclose(out->file) != 0 && !why)
        why = write_error();
    if (!why && out->temporary && rename(out->temporary, out->path) != 0)
        why = strerror(errno);
    if (why && out->temporary && !out->keep)
        unlink(out->temporary);
    drop(out);
    return why;
}

void cli_close(struct cli_out *out)
{
    if (out->file != stdout)
        cli_check(out->path, cli_end_file(out, NULL));
    else if (ferror(stdout) || fflush(stdout) != 0)
        cli_die("standard output: %s", write_error());
}

void cli_write(struct vxf_out *o, const char *path)
{
    struct cli_out out;

    vxf_put_key(o, "CMD", "%s", cli_command());
    cli_create(&out, path, 1);
    cli_check(path ? path : "standard output", vxf_write(o, out.file));
    cli_close(&out);
}
