/* A .slcs is read as CONTACT's list-directed input is: values first on a line, what follows them is comment, as is all from '%', '!' or '"'
 * on; empty lines do not count.  Stations are U_SCALE (U_OFFSET + u) and features S_F, both mm. */
#include "formats/slices.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/beside.h"
#include "formats/points.h"
#include "formats/reason.h"

#define MILLIMETRE 1e-3
#define STATION_SAME 1e-6    /* m, between the two lists of stations */
#define MOST 100000          /* slices, features */

struct scan {
    FILE *file;
    char *line;
    size_t size;
    long number;
    const char *at;          /* rest of the line */
};

/* To the next line that says something. */
static const char *line_next(struct scan *c)
{
    while (getline(&c->line, &c->size, c->file) >= 0) {
        int quoted = 0;
        c->number++;
        for (char *p = c->line; *p; p++) {
            quoted ^= *p == '\'';
            if (!quoted && strchr("%!\"\r\n", *p))
                *p = '\0';
        }
        c->at = c->line + strspn(c->line, " \t");
        if (*c->at)
            return NULL;
    }
    return ferror(c->file) ? reason("%s", strerror(errno)) : reason("ends after line %ld, too early", c->number);
}

/* n numbers from a new line on, on as many lines as it takes. */
static const char *numbers_next(struct scan *c, const char *what, int64_t n, double *x)
{
    const char *why = line_next(c);

    for (int64_t i = 0; !why && i < n; i++) {
        c->at += strspn(c->at, " \t,");
        if (!*c->at && (why = line_next(c)))
            break;
        const char *rest = points_number(c->at, &x[i]);
        if (!rest || (*rest && !strchr(" \t,", *rest)))
            return reason("line %ld: '%s' should be %s", c->number, c->at, what);
        c->at = rest;
    }
    return why;
}

static const char *counts_next(struct scan *c, const char *what, int64_t n, int64_t *count)
{
    double x[3];
    const char *why = numbers_next(c, what, n, x);

    for (int64_t i = 0; !why && i < n; i++) {
        if (x[i] != floor(x[i]) || x[i] < 0 || x[i] > MOST)
            return reason("line %ld: %s: %g", c->number, what, x[i]);
        count[i] = (int64_t)x[i];
    }
    return why;
}

/* u 'file' */
static const char *slice_next(struct scan *c, struct slices *s, const char *path, const double scale[2])
{
    double u;
    const char *why = numbers_next(c, "u 'file'", 1, &u);
    if (why)
        return why;
    const char *open = c->at + strspn(c->at, " \t,"), *close = *open == '\'' ? strchr(open + 1, '\'') : NULL;
    if (!close || close == open + 1)
        return reason("line %ld: no file name in quotes ''", c->number);
    char *name = strndup(open + 1, (size_t)(close - open - 1)), *file = name ? beside_path(name, path) : NULL;
    why = file ? slices_add(s, scale[1] * (scale[0] + u) * MILLIMETRE, file) : REASON_MEMORY;
    free(name);
    free(file);
    return why ? reason("line %ld: %s", c->number, why) : NULL;
}

/* u S_1 ... S_features, once more for every slice. */
static const char *features_next(struct scan *c, struct slices *s, int64_t i, const double scale[2])
{
    double *row = calloc((size_t)s->features + 1, sizeof *row), last = -1;
    const char *why = row ? numbers_next(c, "u and its features", s->features + 1, row) : REASON_MEMORY;

    if (!why && fabs(scale[1] * (scale[0] + row[0]) * MILLIMETRE - s->station[i]) > STATION_SAME)
        why = reason("line %ld: features at %g, but the slice stands elsewhere", c->number, row[0]);
    for (int64_t k = 0; !why && k < s->features; k++) {
        double feature = row[k + 1] * MILLIMETRE;
        if (feature >= 0 && feature <= last)
            why = reason("line %ld: feature %lld does not lie behind the one before", c->number, (long long)k + 1);
        last = feature >= 0 ? feature : last;
        s->feature[i * s->features + k] = feature;
    }
    free(row);
    return why;
}

/* Part numbers of kinks or accelerations. */
static const char *parts_next(struct scan *c, int64_t n)
{
    double *part = calloc((size_t)n + 1, sizeof *part);
    const char *why = !part ? REASON_MEMORY : n ? numbers_next(c, "part numbers", n, part) : NULL;

    free(part);
    return why;
}

static const char *list_scan(struct scan *c, struct slices *s, const char *path)
{
    double scale[2];
    int64_t slices, count[3], method;
    const char *why;

    if ((why = numbers_next(c, "U_OFFSET U_SCALE", 2, scale)) || (why = counts_next(c, "NSLC", 1, &slices)) ||
        (why = counts_next(c, "NFEAT NKINK NACCEL", 3, count)) || (why = counts_next(c, "U_INTPOL", 1, &method)))
        return why;
    if (scale[1] <= 0 || slices < 1 || (method != 1 && method != 2))
        return reason("line %ld: U_SCALE must be positive, NSLC 1 or more, U_INTPOL 1 or 2", c->number);
    for (int64_t i = 0; i < slices; i++)
        if ((why = slice_next(c, s, path, scale)))
            return why;
    if (count[0] <= 1)
        return NULL;
    if ((why = parts_next(c, count[1])) || (why = parts_next(c, count[2])))
        return why;
    s->features = count[0];
    if (!(s->feature = calloc((size_t)(s->n * s->features), sizeof *s->feature)))
        return REASON_MEMORY;
    for (int64_t i = 0; i < s->n; i++)
        if ((why = features_next(c, s, i, scale)))
            return why;
    return NULL;
}

const char *slices_add(struct slices *s, double station, const char *file)
{
    if (s->n && station <= s->station[s->n - 1])
        return reason("stations must increase, %g m does not", station);
    double *stations = realloc(s->station, (size_t)(s->n + 1) * sizeof *stations);
    if (stations)
        s->station = stations;
    char **files = realloc(s->file, (size_t)(s->n + 1) * sizeof *files);
    if (files)
        s->file = files;
    char *copy = strdup(file);
    if (!stations || !files || !copy) {
        free(copy);
        return REASON_MEMORY;
    }
    s->station[s->n] = station;
    s->file[s->n++] = copy;
    return NULL;
}

const char *slices_read(struct slices *s, const char *path)
{
    struct scan c = {0};
    size_t n = strlen(path);

    *s = (struct slices){0};
    if (n > 5 && strcmp(path + n - 5, ".slcw") == 0)
        return "slices round a wheel (.slcw): wheels out of round are not read, a wheel has one section";
    if (!(c.file = fopen(path, "r")))
        return reason("%s", strerror(errno));
    const char *why = list_scan(&c, s, path);
    free(c.line);
    fclose(c.file);
    if (why)
        slices_free(s);
    return why;
}

/* number and station of one line, and its file. */
static const char *index_add(struct slices *s, const struct scan *c, const char *path, const char *files)
{
    double number, station;
    const char *first = c->at, *rest = points_number(first, &number), *star = strchr(files, '*');
    size_t n = rest ? (size_t)(rest - first) : 0, before = (size_t)(star - files);

    if (!rest || !points_number(rest, &station))
        return reason("line %ld: '%s' should be number and station", c->number, first);
    char *name = calloc(strlen(files) + n + 1, 1);
    if (!name)
        return REASON_MEMORY;
    memcpy(name, files, before);
    memcpy(name + before, first, n);
    memcpy(name + before + n, star + 1, strlen(star + 1));
    char *file = beside_path(name, path);
    const char *why = file ? slices_add(s, station, file) : REASON_MEMORY;
    free(name);
    free(file);
    return why ? reason("line %ld: %s", c->number, why) : NULL;
}

const char *slices_index(struct slices *s, const char *path, const char *files)
{
    struct scan c = {0};
    const char *why = NULL;

    *s = (struct slices){0};
    if (!strchr(files, '*'))
        return reason("files: '%s' has no * for the number", files);
    if (!(c.file = fopen(path, "r")))
        return reason("%s", strerror(errno));
    while (!why && getline(&c.line, &c.size, c.file) >= 0) {
        c.number++;
        c.line[strcspn(c.line, "#\r\n")] = '\0';
        c.at = c.line + strspn(c.line, " \t");
        if (*c.at)
            why = index_add(s, &c, path, files);
    }
    if (!why && ferror(c.file))
        why = reason("%s", strerror(errno));
    free(c.line);
    fclose(c.file);
    if (!why && s->n == 0)
        why = "names no sections";
    if (why)
        slices_free(s);
    return why;
}

void slices_free(struct slices *s)
{
    for (int64_t i = 0; i < s->n; i++)
        free(s->file[i]);
    free(s->station);
    free(s->file);
    free(s->feature);
    *s = (struct slices){0};
}
