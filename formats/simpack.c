/* Blocks "NAME.begin ... NAME.end", lines "key = value", comments from '!' (CONTACT: also '%') on, points between point.begin and point.end. */
#include "formats/simpack.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "formats/lines.h"
#include "formats/reason.h"

struct keys {
    double version, type, smooth, dist_min, shift_y, shift_z, rotate;
    double bound_y_min, bound_y_max, bound_z_min, bound_z_max;    /* active where min < max */
    double mirror_y, mirror_z, inversion;
    double length_factor, angle_factor;                           /* user units per metre, per radian */
};

/* spline.type and the text keys say where the data came from, not where the points are. */
static const struct { const char *block, *key; size_t at; } key_table[] = {
    {"header", "version",        offsetof(struct keys, version)},
    {"header", "type",           offsetof(struct keys, type)},
    {"spline", "approx.smooth",  offsetof(struct keys, smooth)},
    {"spline", "point.dist.min", offsetof(struct keys, dist_min)},
    {"spline", "shift.y",        offsetof(struct keys, shift_y)},
    {"spline", "shift.z",        offsetof(struct keys, shift_z)},
    {"spline", "rotate",         offsetof(struct keys, rotate)},
    {"spline", "bound.y.min",    offsetof(struct keys, bound_y_min)},
    {"spline", "bound.y.max",    offsetof(struct keys, bound_y_max)},
    {"spline", "bound.z.min",    offsetof(struct keys, bound_z_min)},
    {"spline", "bound.z.max",    offsetof(struct keys, bound_z_max)},
    {"spline", "mirror.y",       offsetof(struct keys, mirror_y)},
    {"spline", "mirror.z",       offsetof(struct keys, mirror_z)},
    {"spline", "inversion",      offsetof(struct keys, inversion)},
    {"spline", "units.len.f",    offsetof(struct keys, length_factor)},
    {"spline", "units.ang.f",    offsetof(struct keys, angle_factor)},
};
static const char *const told_keys[] = {"file", "file.mtime", "comment", "type", "units.len", "units.ang", NULL};

struct scan {
    char block[2][16];       /* open blocks, outer first */
    int depth;
    struct keys keys;
    struct points points;
    int64_t room;
};

static const char *value_read(struct scan *c, const char *key, const char *value)
{
    const char *block = c->depth ? c->block[c->depth - 1] : "";

    for (size_t i = 0; i < sizeof key_table / sizeof *key_table; i++)
        if (strcmp(block, key_table[i].block) == 0 && strcmp(key, key_table[i].key) == 0) {
            const char *rest = points_number(value, (double *)((char *)&c->keys + key_table[i].at));
            return rest && !*rest ? NULL : reason("%s: '%s' is not a number", key, value);
        }
    for (int i = 0; told_keys[i]; i++)
        if (strcmp(key, told_keys[i]) == 0)
            return NULL;
    return reason("unknown key '%s'", key);
}

static const char *point_read(struct scan *c, const char *line)
{
    double row[3] = {0, 0, 1};
    int n = 0;

    for (; *line && n < 3; n++) {
        const char *rest = points_number(line, &row[n]);
        if (!rest)
            return reason("'%s' is not a number", line);
        line = rest + strspn(rest, " \t");
    }
    if (n < 2 || *line)
        return "a point is y z or y z weight";
    if (row[2] <= 0)
        return reason("weight must be positive, is %g", row[2]);
    return points_add(&c->points, &c->room, row[0], row[1], row[2]);
}

/* name.begin opens a block, name.end closes it. */
static const char *block_read(struct scan *c, const char *name, size_t length, int begins)
{
    if (begins) {
        if (c->depth == 2 || length >= sizeof c->block[0])
            return "block within a block";
        memcpy(c->block[c->depth], name, length);
        c->block[c->depth++][length] = '\0';
        return NULL;
    }
    if (c->depth == 0 || strncmp(c->block[c->depth - 1], name, length) != 0 || c->block[c->depth - 1][length])
        return reason("'%s' ends no open block", name);
    c->depth--;
    return NULL;
}

/* Cuts the comment, which a quote hides, and the blanks at both ends. */
static char *line_trim(char *line)
{
    int quoted = 0;
    line += strspn(line, " \t\r\n");
    for (char *p = line; *p; p++) {
        quoted ^= *p == '\'';
        if ((*p == '!' || *p == '%') && !quoted)
            *p = '\0';
    }
    size_t n = strlen(line);
    while (n && strchr(" \t\r\n", line[n - 1]))
        line[--n] = '\0';
    return line;
}

static const char *line_read(struct scan *c, char *line)
{
    size_t n = strlen(line);
    char *equals = strchr(line, '=');

    if (n == 0)
        return NULL;
    if (!equals && n > 6 && strcmp(line + n - 6, ".begin") == 0)
        return block_read(c, line, n - 6, 1);
    if (!equals && n > 4 && strcmp(line + n - 4, ".end") == 0)
        return block_read(c, line, n - 4, 0);
    if (c->depth && strcmp(c->block[c->depth - 1], "point") == 0)
        return point_read(c, line);
    if (!equals)
        return reason("'%s' is neither a block nor key = value", line);
    char *value = equals + 1 + strspn(equals + 1, " \t");
    *equals = '\0';
    return value_read(c, line_trim(line), value);
}

static const char *keys_check(const struct keys *k, const struct scan *c)
{
    if (c->depth)
        return reason("block '%s' is not closed", c->block[c->depth - 1]);
    if (k->type != 0 && k->type != 1)
        return reason("type must be 0 (rail) or 1 (wheel), is %g", k->type);
    if (k->length_factor <= 0 || k->angle_factor <= 0)
        return "units.len.f and units.ang.f must be there and positive";
    return NULL;
}

static int point_kept(const struct keys *k, double y, double z)
{
    return !(k->bound_y_min < k->bound_y_max && (y < k->bound_y_min || y > k->bound_y_max)) &&
           !(k->bound_z_min < k->bound_z_max && (z < k->bound_z_min || z > k->bound_z_max));
}

/* Steps 1 to 7 of the file's own comments. */
static void points_transform(struct points *p, const struct keys *k)
{
    double c = cos(k->rotate / k->angle_factor), s = sin(k->rotate / k->angle_factor);
    double last_y = 0, last_z = 0;
    int64_t m = 0;

    for (int64_t i = 0; i < p->n; i++) {
        double y0 = p->y[i], z0 = p->z[i];
        if (i > 0 && hypot(y0 - last_y, z0 - last_z) < k->dist_min)
            continue;
        last_y = y0;
        last_z = z0;
        y0 += k->shift_y;
        z0 += k->shift_z;
        double y = y0 * c - z0 * s, z = y0 * s + z0 * c;
        if (!point_kept(k, y, z))
            continue;
        p->y[m] = (k->mirror_y != 0 ? -y : y) / k->length_factor;
        p->z[m] = (k->mirror_z != 0 ? -z : z) / k->length_factor;
        p->weight[m++] = p->weight[i];
    }
    p->n = m;
    for (int64_t i = 0, j = m - 1; k->inversion != 0 && i < j; i++, j--) {
        double y = p->y[i], z = p->z[i], w = p->weight[i];
        p->y[i] = p->y[j], p->z[i] = p->z[j], p->weight[i] = p->weight[j];
        p->y[j] = y, p->z[j] = z, p->weight[j] = w;
    }
}

static const char *scan_line(void *scan, long number, char *text)
{
    (void)number;
    return line_read(scan, line_trim(text));
}

const char *simpack_read(struct simpack *s, const char *path)
{
    struct scan c = {.keys = {.type = -1, .angle_factor = 1}};
    *s = (struct simpack){0};
    const char *why = lines_read(path, scan_line, &c);
    if (!why)
        why = keys_check(&c.keys, &c);
    if (!why)
        points_transform(&c.points, &c.keys);
    if (!why && c.points.n < 3)
        why = reason("%lld points, a profile needs at least 3", (long long)c.points.n);
    if (why) {
        points_free(&c.points);
        return why;
    }
    s->part = c.keys.type == 1 ? 'w' : 'r';
    s->smooth = c.keys.smooth;
    s->points = c.points;
    return NULL;
}

void simpack_free(struct simpack *s)
{
    points_free(&s->points);
}
