#include "formats/miniprof.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "formats/lines.h"
#include "formats/reason.h"

#define MM 1e-3

enum { COLUMNS = 16 };
enum state { START, HEADER, OLD_HEADER, DATA };

struct scan {
    enum state state;
    int64_t wanted, sections, section;  /* of a .mpt; section is 0 in its [FileInfo], and in other files */
    int several;                        /* a .mpt */
    int x, y, columns;                  /* where they are in a line, from 0; how many ColumnDef names */
    double told;                        /* XYPoints, 0 where not said */
    int64_t hidden;                     /* points put out by a comment sign */
    int64_t room;
    struct miniprof *m;
};

static int wanted(const struct scan *c)
{
    return !c->several || c->section == c->wanted;
}

/* "X,Y,A,C": x and y are where it has them; '*' stands for any more. */
static const char *columns_read(struct scan *c, const char *value)
{
    c->x = c->y = -1;
    c->columns = 0;
    for (const char *p = value; *p; p++) {
        if (*p == ',' || isspace((unsigned char)*p))
            continue;
        if (c->columns == COLUMNS)
            return "ColumnDef names too many columns";
        if (*p == 'X' || *p == 'x')
            c->x = c->columns;
        if (*p == 'Y' || *p == 'y')
            c->y = c->columns;
        c->columns += *p != '*';
    }
    return c->x < 0 || c->y < 0 ? reason("ColumnDef=%s names no X or no Y", value) : NULL;
}

static const char *flange_read(struct miniprof *m, double *x, const char *key, const char *value)
{
    const char *rest = points_number(value, x);

    m->part = 'w';
    *x *= MM;
    return !*value || (rest && !*rest) ? NULL : reason("%s=%s is not a number", key, value);
}

/* Whether the points already hold the offset is not written anywhere, so only 0 is read. */
static const char *offset_read(const char *key, const char *value)
{
    double x = 0;

    if (*value && !points_number(value, &x))
        return reason("%s=%s is not a number", key, value);
    return x == 0 ? NULL : reason("%s=%s: an offset is not read; put it into the points, or set it to 0 and give shift_y", key, value);
}

static const char *key_read(struct scan *c, const char *key, const char *value)
{
    struct miniprof *m = c->m;
    double number;

    if (!wanted(c))
        return NULL;
    if (strcasecmp(key, "ColumnDef") == 0)
        return *value ? columns_read(c, value) : NULL;
    if (strcasecmp(key, "XYPoints") == 0 && points_number(value, &number))
        c->told = number;
    if (strcasecmp(key, "Side") == 0) {
        char letter = (char)toupper((unsigned char)value[*value == '%']);
        m->side = letter == 'L' ? 'l' : letter == 'R' ? 'r' : 0;
    }
    if (strcasecmp(key, "Sh") == 0)
        return flange_read(m, &m->height, key, value);
    if (strcasecmp(key, "Sd") == 0)
        return flange_read(m, &m->width, key, value);
    if (strcasecmp(key, "qR") == 0)
        return flange_read(m, &m->slope, key, value);
    return strcasecmp(key, "Xoffset") == 0 ? offset_read(key, value) : NULL;
}

/* What follows the columns is a remark if it begins with a letter. */
static const char *point_read(struct scan *c, const char *line)
{
    double v[COLUMNS] = {0};
    int n = 0, least = c->x > c->y ? c->x + 1 : c->y + 1, remark = 0;

    for (const char *rest; *line && n < COLUMNS && !remark; n++, line = rest + strspn(rest, " \t,")) {
        remark = n >= c->columns && n >= least && isalpha((unsigned char)*line);
        if (remark)
            break;
        if (!(rest = points_number(line, &v[n])) || !strchr(" \t,", *rest))
            return reason("'%.20s' is not a number", line);
    }
    if (n < least || (n < c->columns && c->columns > 2))
        return reason("%d numbers, ColumnDef names %d", n, c->columns);
    return points_add(&c->m->points, &c->room, v[c->x] * MM, v[c->y] * MM, 1);
}

/* [FileInfo], [Profile1Info], [Profile1Points], ... */
static const char *bracket_read(struct scan *c, const char *line)
{
    char *end;
    long number;

    if (!c->several && c->state != START)
        return reason("'%.30s' in a file that does not begin with a section", line);
    c->several = 1;
    c->state = HEADER;
    if (strcasecmp(line, "[FileInfo]") == 0)
        return NULL;
    number = strncasecmp(line, "[Profile", 8) == 0 && isdigit((unsigned char)line[8]) ? strtol(line + 8, &end, 10) : 0;
    if (number < 1 || (strcasecmp(end, "Info]") != 0 && strcasecmp(end, "Points]") != 0))
        return reason("unknown section '%.30s'", line);
    c->section = number;
    c->sections = number > c->sections ? number : c->sections;
    c->state = strcasecmp(end, "Points]") == 0 ? DATA : HEADER;
    return NULL;
}

static const char *data_line(struct scan *c, char *line)
{
    size_t shown = strcspn(line, "\"!%");
    int hides = line[shown] != '\0' && shown == 0;

    line[shown] = '\0';
    c->hidden += hides && wanted(c);
    return !*line || !wanted(c) ? NULL : point_read(c, line);
}

/* Blanks at its ends are cut off already. */
static const char *line_read(struct scan *c, char *line)
{
    char *equals = strchr(line, '=');

    if (*line == '[')
        return bracket_read(c, line);
    if (c->state == START && *line) {
        int wheel = strncmp(line, "#MINIWHEELPROF", 14) == 0;
        c->state = wheel || strncmp(line, "MINIPROF", 8) == 0 ? OLD_HEADER : HEADER;
        c->m->part = wheel ? 'w' : 0;
        if (c->state == OLD_HEADER)
            return NULL;
    }
    if (c->state == DATA)
        return data_line(c, line);
    if (!*line) {
        c->state = c->state == START || c->several ? c->state : DATA;
        return NULL;
    }
    if (c->state == OLD_HEADER || *line == '"')
        return NULL;
    if (equals && !strchr("+-.0123456789", *line)) {
        *equals = '\0';
        return key_read(c, line, equals + 1);
    }
    if (c->several || !strchr("+-.0123456789", *line))
        return reason("'%.30s' is neither Key=Value nor a point", line);
    c->state = DATA;
    return data_line(c, line);
}

static char *line_trim(char *line)
{
    line += strspn(line, " \t");
    size_t n = strlen(line);
    while (n && strchr(" \t\r\n", line[n - 1]))
        line[--n] = '\0';
    return line;
}

static const char *scan_line(void *scan, long number, char *text)
{
    (void)number;
    return line_read(scan, line_trim(text));
}

static const char *scan_check(const struct scan *c)
{
    int64_t n = c->m->points.n;

    if (c->several && c->wanted > c->sections)
        return reason("section %lld: there are %lld", (long long)c->wanted, (long long)c->sections);
    if (c->state == OLD_HEADER)
        return "the empty line between header and points is missing";
    if (n < 3)
        return reason("%lld points, a profile needs at least 3", (long long)n);
    if ((double)(n + c->hidden) < c->told)
        return reason("%lld points, XYPoints says %.0f: cut short?", (long long)n, c->told);
    return NULL;
}

const char *miniprof_read(struct miniprof *m, const char *path, int64_t section)
{
    struct scan c = {.x = 0, .y = 1, .columns = 2, .wanted = section ? section : 1, .m = m};
    *m = (struct miniprof){0};
    const char *why = lines_read(path, scan_line, &c);
    if (!why && c.several && section == 0 && c.sections > 1)
        why = reason("section: must be stated, the file holds %lld", (long long)c.sections);
    if (!why)
        why = scan_check(&c);
    if (why)
        miniprof_free(m);
    return why;
}

void miniprof_free(struct miniprof *m)
{
    points_free(&m->points);
}
