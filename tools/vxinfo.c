/* vxinfo: what a Veksel file holds, and how it was made.
 *
 * In: any container.  Out: text: kind, size, header lines, and one line an array with type, dims and unit.
 * Every hash has been checked when something is printed. */
#include "tools/cli/cli.h"

#include <string.h>

static const char usage[] = "vxinfo [--content | --history] [FILE ...]";

static int content, history;

static const struct cli_option options[] = {
    {.name = "content", .type = CLI_FLAG, .value = &content},
    {.name = "history", .type = CLI_FLAG, .value = &history},
    {0},
};

static const struct cli_program program = {
    .name = "vxinfo",
    .purpose = "Print what a Veksel file holds and how it was made.",
    .usage = usage,
    .option = options,
};

static void print_list(const char *what, const struct vxf_list *list)
{
    for (int i = 0; i < list->n; i++) {
        const struct vxf_array *a = &list->item[i];
        printf("%-8s %-24s %-5s", what, a->name, vxf_type_name(a->type));
        for (int k = 0; k < a->ndim; k++)
            printf("%s%lld", k ? " x " : " ", (long long)a->dim[k]);
        printf("%s  [%s]\n", a->ndim ? "" : " scalar", a->unit);
    }
}

/* Header lines as they stand, without those that print_list shows. */
static void print_keys(const struct vxf *f)
{
    for (const char *p = f->header, *end; *p; p = end + 1) {
        end = strchr(p, '\n');
        if (strncmp(p, "ARRAY= ", 7) && strncmp(p, "SERIES= ", 8) && strncmp(p, "TAIL= ", 6))
            printf("%.*s\n", (int)(end - p), p);
    }
}

static void print_history(const struct vxf *f)
{
    const char *line;
    int length;

    for (int k = 0; (line = vxf_line(f, "CMD", k, &length)); k++)
        printf("%.*s\n", length, line);
}

static void print_file(const struct vxf *f, const char *name)
{
    printf("%s: .%s, %zu bytes%s\n", name, f->kind, f->size, f->complete ? "" : ", NOT COMPLETE");
    print_keys(f);
    print_list("array", &f->array);
    print_list("series", &f->series);
    if (f->stream)
        printf("records  %lld in %d blocks\n", (long long)f->records, f->blocks);
    print_list("tail", &f->tail);
}

int main(int argc, char **argv)
{
    static char dash[] = "-", *standard_input[] = {dash};
    int n;
    char **path = cli_begin(&program, argc, argv, 0, 1 << 20, &n);

    if (content && history)
        cli_misuse("--content and --history exclude each other");
    if (n == 0) {
        path = standard_input;
        n = 1;
    }
    for (int i = 0; i < n; i++) {
        struct vxf f;
        cli_open(&f, path[i], NULL);
        if (content)
            printf("%016llx  %s\n", (unsigned long long)vxf_content(&f), path[i]);
        else if (history)
            print_history(&f);
        else
            print_file(&f, path[i]);
        vxf_close(&f);
    }
    return cli_end();
}
