/* vxcmp: whether two Veksel files hold the same, to the bit or within tolerances.
 *
 * In: two containers of one kind.  Out: text, a line for each key or array that differs, with the largest difference and its
 * place.  History (SOFTWARE, CMD, INPUT) is not compared.  Exit status: 0 same, 1 different, 2 trouble. */
#include "tools/cli/cli.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/vxf_compare.h"

static const char usage[] = "vxcmp [--rel X] [--max X] [--rms X] [--only NAME]... [--ignore NAME]... A B";

static struct {
    struct vxf_tolerance tolerance;
    struct cli_list only, ignore;
} opt;

static const struct cli_option options[] = {
    {.name = "rel", .type = CLI_NUM, .value = &opt.tolerance.relative, .lo = 0, .hi = DBL_MAX},
    {.name = "max", .type = CLI_NUM, .value = &opt.tolerance.absolute, .lo = 0, .hi = DBL_MAX},
    {.name = "rms", .type = CLI_NUM, .value = &opt.tolerance.rms, .lo = 0, .hi = DBL_MAX},
    {.name = "only", .type = CLI_LIST, .value = &opt.only},
    {.name = "ignore", .type = CLI_LIST, .value = &opt.ignore},
    {0},
};

static const struct cli_program program = {
    .name = "vxcmp",
    .purpose = "Compare two Veksel files, to the bit or within tolerances.",
    .usage = usage,
    .option = options,
    .failure = 2,
};

static int listed(const struct cli_list *list, const char *name, size_t length)
{
    for (int i = 0; i < list->n; i++)
        if (strlen(list->item[i]) == length && strncmp(list->item[i], name, length) == 0)
            return 1;
    return 0;
}

static int wanted(const char *name, size_t length)
{
    return (opt.only.n == 0 || listed(&opt.only, name, length)) && !listed(&opt.ignore, name, length);
}

/* ---- keys ---- */

/* A key's value as a number; NaN where it is none. */
static double value_of(const char *text)
{
    char *end;
    double x = strtod(text, &end);

    return end == text || *end != '\n' ? NAN : x;
}

static int same_value(const char *a, const char *b)
{
    size_t n = strcspn(a, "\n"), m = strcspn(b, "\n");
    double x = value_of(a), y = value_of(b);
    struct vxf_array p = {.type = VXF_F64, .data = &x}, q = {.type = VXF_F64, .data = &y};
    struct vxf_difference d;

    if (n == m && strncmp(a, b, n) == 0)
        return 1;
    return !isnan(x) && !isnan(y) && !vxf_compare(&p, &q, &opt.tolerance, &d);
}

static int is_key(const char *line)
{
    return !vxf_is_history(line) && strncmp(line, "ARRAY= ", 7) && strncmp(line, "SERIES= ", 8) &&
           strncmp(line, "TAIL= ", 6) && wanted(line, strcspn(line, "="));
}

static const char *next_key(const char *line)
{
    while (*line && !is_key(line))
        line = strchr(line, '\n') + 1;
    return line;
}

/* The files of one kind have the same keys in the same order. */
static int compare_keys(const struct vxf *a, const struct vxf *b)
{
    const char *p = next_key(a->header), *q = next_key(b->header);
    int differ = 0;

    while (*p && *q) {
        size_t n = strcspn(p, "="), m = strcspn(q, "=");
        if (n != m || strncmp(p, q, n) != 0)
            break;
        if (!same_value(p + n + 2, q + n + 2)) {
            differ = 1;
            printf("key %.*s: %.*s and %.*s\n", (int)n, p, (int)strcspn(p + n + 2, "\n"), p + n + 2,
                   (int)strcspn(q + n + 2, "\n"), q + n + 2);
        }
        p = next_key(strchr(p, '\n') + 1);
        q = next_key(strchr(q, '\n') + 1);
    }
    if (*p || *q)
        printf("keys differ from %.*s on\n", (int)strcspn(*p ? p : q, "="), *p ? p : q);
    return differ || *p || *q;
}

/* ---- arrays ---- */

/* Element number at (0-based, storage order) as [i,j,..] from 1. */
static void print_place(const struct vxf_array *a, int64_t at)
{
    int64_t index[VXF_DIMS];

    for (int k = a->ndim - 1; k >= 0; k--) {
        index[k] = at % a->dim[k] + 1;
        at /= a->dim[k];
    }
    for (int k = 0; k < a->ndim; k++)
        printf("%s%lld", k ? "," : " at [", (long long)index[k]);
    if (a->ndim)
        putchar(']');
}

static void print_element(const struct vxf_array *a, const double x[2])
{
    printf(a->type == VXF_F32 ? "%.9g" : "%.17g", x[0]);
    if (a->type == VXF_C128)
        printf("%+.17gi", x[1]);
}

static int compare_arrays(const struct vxf_array *a, const struct vxf_array *b)
{
    const char *why = vxf_compare_shape(a, b);
    struct vxf_difference d;

    if (why) {
        printf("%s %s\n", a->name, why);
        return 1;
    }
    if (!vxf_compare(a, b, &opt.tolerance, &d))
        return 0;
    printf("%s: largest difference %.4g %s", a->name, d.largest, a->unit);
    print_place(a, d.at);
    fputs(", ", stdout);
    print_element(a, d.a);
    fputs(" and ", stdout);
    print_element(a, d.b);
    printf("; rms %.4g; %lld of %lld differ\n", d.rms, (long long)d.off, (long long)vxf_count(a));
    return 1;
}

static int compare_lists(const struct vxf_list *a, const struct vxf_list *b)
{
    int differ = 0;

    for (int i = 0; i < a->n; i++) {
        const struct vxf_array *p = &a->item[i], *q = vxf_find(b, p->name);
        if (!wanted(p->name, strlen(p->name)))
            continue;
        if (!q)
            printf("%s stands in the first file alone\n", p->name);
        if (!q || compare_arrays(p, q))
            differ = 1;
    }
    for (int i = 0; i < b->n; i++)
        if (!vxf_find(a, b->item[i].name) && wanted(b->item[i].name, strlen(b->item[i].name))) {
            printf("%s stands in the second file alone\n", b->item[i].name);
            differ = 1;
        }
    return differ;
}

/* A name of --only that is in neither file would compare nothing and say "same". */
static void check_only(const struct vxf *f, const struct vxf_list *a, const struct vxf_list *b)
{
    for (int i = 0; i < opt.only.n; i++) {
        int length;
        if (!vxf_find(a, opt.only.item[i]) && !vxf_find(b, opt.only.item[i]) && !vxf_line(f, opt.only.item[i], 0, &length))
            cli_die("--only %s: neither file has it", opt.only.item[i]);
    }
}

int main(int argc, char **argv)
{
    struct vxf_list list[2];
    struct vxf f[2];
    int n, differ;
    char **path = cli_begin(&program, argc, argv, 2, 2, &n);

    if (strcmp(path[0], "-") == 0 && strcmp(path[1], "-") == 0)
        cli_misuse("standard input can be one of the files, not both");
    for (int i = 0; i < 2; i++) {
        cli_open(&f[i], path[i], i ? f[0].kind : NULL);
        cli_check(path[i], vxf_select(&f[i], 0, NULL, &list[i]));
    }
    check_only(&f[0], &list[0], &list[1]);
    differ = compare_keys(&f[0], &f[1]);
    differ |= compare_lists(&list[0], &list[1]);
    if (f[0].complete != f[1].complete) {
        printf("the %s file is not complete\n", f[0].complete ? "second" : "first");
        differ = 1;
    }
    for (int i = 0; i < 2; i++) {
        free(list[i].item);
        vxf_close(&f[i]);
    }
    free(opt.only.item);
    free(opt.ignore.item);
    cli_end();
    return differ;
}
