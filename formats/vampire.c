/* Four header lines, then four columns. */
#include "formats/vampire.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/lines.h"
#include "formats/reason.h"

#define MM 1e-3
#define INCH 25.4
#define ALIKE 1e-6           /* m, between the two sides */

enum { HEADER = 4 };         /* lines */

struct scan {
    long lines;
    char part;
    double datum;            /* mm, from the flange back to the tread datum, or from the top down to the gauge point */
    double distance;         /* mm, between the flange backs, or the gauge */
    struct points side[2];   /* m, left as in the file, right */
    int64_t room[2];
};

/* The rest of a line that begins with this word, else NULL. */
static const char *after(const char *line, const char *word)
{
    size_t n = strlen(word);
    if (strncmp(line, word, n) != 0 || !strchr(" \t", line[n]))
        return NULL;
    return line + n + strspn(line + n, " \t");
}

static const char *number_read(const char *text, const char *key, double *x)
{
    const char *rest = points_number(text, x);
    return rest && !rest[strspn(rest, " \t")] ? NULL : reason("%s: '%.20s' is not a number", key, text);
}

static const char *datum_read(struct scan *c, const char *line)
{
    static const struct { char part; const char *name; double length; } datums[] = {
        {'w', "EUROPEAN", 70}, {'w', "US1", (2 + 27.0 / 32) * INCH}, {'w', "US2", (3 + 1.0 / 16) * INCH},
        {'r', "EUROPEAN", 14}, {'r', "US", 5.0 / 8 * INCH}};
    const char *value = after(line, c->part == 'w' ? "TREADDATUM" : "GAUGEPOINT"), *custom;

    if (!value)
        return reason("should be %s", c->part == 'w' ? "TREADDATUM" : "GAUGEPOINT");
    if ((custom = after(value, "CUSTOM")))
        return number_read(custom, "CUSTOM", &c->datum);
    for (size_t i = 0; i < sizeof datums / sizeof *datums; i++)
        if (c->part == datums[i].part && strcmp(value, datums[i].name) == 0)
            c->datum = datums[i].length;
    return c->datum > 0 ? NULL : reason("unknown datum '%.20s'", value);
}

static const char *header_read(struct scan *c, long number, const char *line)
{
    if (number == 1) {
        c->part = strcmp(line, "WHEELPROFILE") == 0 ? 'w' : strcmp(line, "RAILPROFILE") == 0 ? 'r' : 0;
        return c->part ? NULL : "should be WHEELPROFILE or RAILPROFILE";
    }
    if (number == 3)
        return datum_read(c, line);
    if (number == 4) {
        const char *key = c->part == 'w' ? "FLANGEBACK" : "GAUGE", *value = after(line, key);
        return value ? number_read(value, key, &c->distance) : reason("should be %s", key);
    }
    return NULL;
}

static const char *row_read(struct scan *c, const char *line)
{
    double v[4], up = c->part == 'r' ? -MM : MM;
    const char *why;

    for (int n = 0; n < 4; n++) {
        const char *rest = points_number(line, &v[n]);
        if (!rest || !strchr(" \t,", *rest))
            return *line ? reason("'%.20s' is not a number", line) : reason("%d numbers, should be yl zl yr zr", n);
        line = rest + strspn(rest, " \t,");
    }
    if (*line)
        return "more than four numbers";
    if ((why = points_add(&c->side[0], &c->room[0], v[0] * MM, v[1] * up, 1)))
        return why;
    return points_add(&c->side[1], &c->room[1], v[2] * MM, v[3] * up, 1);
}

/* Cuts the comment of a row and the blanks at both ends. */
static const char *scan_line(void *scan, long number, char *line)
{
    struct scan *c = scan;

    c->lines = number;
    line += strspn(line, " \t");
    line[strcspn(line, number > HEADER ? "\"!%\r\n" : "\r\n")] = '\0';
    size_t n = strlen(line);
    while (n && strchr(" \t", line[n - 1]))
        line[--n] = '\0';
    if (number <= HEADER)
        return header_read(c, number, line);
    return n ? row_read(c, line) : NULL;
}

/* The left side becomes a right one. */
static const char *sides_turn(struct scan *c, int side)
{
    double apart = 0;

    for (int64_t i = 0; i < c->side[0].n; i++) {
        c->side[0].y[i] = -c->side[0].y[i];
        apart = fmax(apart, hypot(c->side[0].y[i] - c->side[1].y[i], c->side[0].z[i] - c->side[1].z[i]));
    }
    return side || apart <= ALIKE ? NULL
                                  : reason("file_side: must be stated, left and right differ by %.2f mm", 1e3 * apart);
}

const char *vampire_read(struct vampire *v, const char *path, int side)
{
    struct scan c = {0};
    *v = (struct vampire){0};
    const char *why = lines_read(path, scan_line, &c);
    if (!why && c.lines <= HEADER)
        why = "the file ends within its header";
    if (!why && c.side[1].n < 3)
        why = reason("%lld points, a profile needs at least 3", (long long)c.side[1].n);
    if (!why)
        why = sides_turn(&c, side);
    points_free(&c.side[side != 2 ? 0 : 1]);
    v->part = c.part;
    v->distance = c.distance * MM;
    v->datum = c.datum * MM;
    v->points = c.side[side != 2];
    for (int64_t i = 0; c.part == 'w' && i < v->points.n; i++)
        v->points.y[i] -= (c.distance / 2 + c.datum) * MM;
    if (why)
        vampire_free(v);
    return why;
}

void vampire_free(struct vampire *v)
{
    points_free(&v->points);
}
