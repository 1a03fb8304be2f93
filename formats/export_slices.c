#include "formats/export_slices.h"

#include <errno.h>
#include <inttypes.h>
#include <string.h>
#include <sys/stat.h>

#include "formats/export_simpack.h"
#include "formats/reason.h"

enum { PATH = 1024 };

static const char *slice_write(const struct prof *p, int64_t poly, const char *path)
{
    FILE *out = fopen(path, "w");
    if (!out)
        return reason("%s: %s", path, strerror(errno));
    export_simpack(p, poly, out);
    int bad = ferror(out);
    return fclose(out) || bad ? reason("%s: %s", path, strerror(errno)) : NULL;
}

/* Index of the body; -1 where there is none, or several and none is named. */
static int64_t body_find(const struct prof *p, const char *body)
{
    if (!body)
        return p->bodies == 1 ? 0 : -1;
    for (int64_t i = 0; i < p->bodies; i++)
        if (strcmp(p->body[i], body) == 0)
            return i;
    return -1;
}

static const char *slices_count(const struct prof *p, int64_t body, int64_t *n)
{
    int64_t last = -1;

    *n = 0;
    for (int64_t i = 0; i < p->polys; i++) {
        if (p->poly_body[i] != body)
            continue;
        if (*n && p->poly_section[i] != last + 1)
            return reason("the body \"%s\" ends at %g m and begins again at %g m: no single run of slices", p->body[body], p->station[last],
                          p->station[p->poly_section[i]]);
        last = p->poly_section[i];
        ++*n;
    }
    return *n < 2 ? "a run of slices has at least two sections" : NULL;
}

/* The folder of the slices; *name is its last part. */
static const char *folder_make(const char *slcs, char *folder, const char **name)
{
    size_t n = strlen(slcs);

    if (n < 6 || strcmp(slcs + n - 5, ".slcs") != 0 || slcs[n - 6] == '/')
        return reason("%s: slices want an output that ends in .slcs", slcs);
    if (n + 32 > PATH || strchr(slcs, '\''))
        return reason("%s: too long, or with a quote", slcs);
    memcpy(folder, slcs, n - 5);
    folder[n - 5] = '\0';
    *name = strrchr(folder, '/') ? strrchr(folder, '/') + 1 : folder;
    return mkdir(folder, 0777) && errno != EEXIST ? reason("%s: %s", folder, strerror(errno)) : NULL;
}

const char *export_slices(const struct prof *p, const char *body, const char *slcs, FILE *out)
{
    int64_t b = body_find(p, body), n, number = 0;
    char folder[PATH], path[2 * PATH];
    const char *why, *name = "";

    if (p->part != 'r')
        return "slices along the track are those of a rail";
    if (b < 0)
        return body ? reason("there is no body \"%s\"", body) : reason("it holds %lld bodies: say which", (long long)p->bodies);
    if ((why = slices_count(p, b, &n)) || (why = folder_make(slcs, folder, &name)))
        return why;
    fprintf(out, "%% %s, %s; as on a right side: y to the right, z down\n\n", p->name, p->body[b]);
    fprintf(out, "  0.000  1000.0     U_OFFSET [m], U_SCALE [mm/m]\n  %" PRId64 "               NSLC\n", n);
    fprintf(out, "  0  0  0           NFEAT, NKINK, NACCEL\n  1                 U_INTPOL\n\n");
    for (int64_t i = 0; i < p->polys; i++) {
        if (p->poly_body[i] != b)
            continue;
        snprintf(path, sizeof path, "%s/slice_%" PRId64 ".prr", folder, ++number);
        if ((why = slice_write(p, i, path)))
            return why;
        fprintf(out, "  %.9f  '%s/slice_%" PRId64 ".prr'\n", p->station[p->poly_section[i]], name, number);
    }
    return NULL;
}
