#include "formats/shape.h"

#include <string.h>
#include <strings.h>

#include "formats/miniprof.h"
#include "formats/reason.h"
#include "formats/simpack.h"
#include "formats/vampire.h"

#define MM 1e-3

/* The last one, of plain points, ends every name. */
static const struct shape_kind kinds[] = {
    {".prr",   "Simpack",      'r', 1,  0, 0, 1, 0},
    {".prw",   "Simpack",      'w', 1,  0, 0, 1, 0},
    {".ban",   "MiniProf",     'r', MM, 1, 1, 0, 0},
    {".bnd",   "MiniProf",     'r', MM, 1, 1, 0, 0},
    {".whl",   "MiniProf",     'w', MM, 0, 1, 0, 1},
    {".mpt",   "MiniProf",     0,   MM, 1, 1, 0, 0},
    {".rail",  "GENSYS",       'r', MM, 1, 0, 1, 0},
    {".wheel", "GENSYS",       'w', MM, 1, 0, 1, 0},
    {".rai",   "Vampire",      'r', 1,  0, 0, 1, 0},
    {".whe",   "Vampire",      'w', 1,  0, 0, 1, 0},
    {"",       "plain points", 0,   0,  0, 0, 0, 0},
};

const struct shape_kind *shape_kind(const char *path)
{
    size_t n = strlen(path), m;
    const struct shape_kind *k = kinds;

    while ((m = strlen(k->ending)) > 0 && !(n > m && strcasecmp(path + n - m, k->ending) == 0))
        k++;
    return k;
}

static const char *simpack_shape(struct shape *s, const char *path, char *part)
{
    struct simpack file;
    const char *why = simpack_read(&file, path);

    if (!why) {
        s->points = file.points;
        *part = file.part;
    }
    return why;
}

static const char *miniprof_shape(struct shape *s, const char *path, int64_t section, char *part)
{
    struct miniprof file;
    const char *why = miniprof_read(&file, path, section);

    if (!why) {
        s->points = file.points;
        s->side = file.side;
        s->flange_height = file.height;
        s->flange_width = file.width;
        s->flange_slope = file.slope;
        *part = file.part ? file.part : *part;
    }
    return why;
}

static const char *vampire_shape(struct shape *s, const char *path, int pick, char *part)
{
    struct vampire file;
    const char *why = vampire_read(&file, path, pick);

    if (!why) {
        s->points = file.points;
        s->distance = file.distance;
        s->datum = file.datum;
        *part = file.part;
    }
    return why;
}

const char *shape_read(struct shape *s, const char *path, const struct shape_choice *c)
{
    const struct shape_kind *k = shape_kind(path);
    char part = c->part;
    const char *why;

    *s = (struct shape){.kind = k};
    if (c->section && strcmp(k->ending, ".mpt") != 0)
        return "section: only of a .mpt, which may hold several";
    if (c->pick && strcmp(k->name, "Vampire") != 0)
        return "file_side: only of a .rai or .whe, which hold both sides";
    if (strcmp(k->name, "Simpack") == 0)
        why = simpack_shape(s, path, &part);
    else if (strcmp(k->name, "MiniProf") == 0)
        why = miniprof_shape(s, path, c->section, &part);
    else if (strcmp(k->name, "Vampire") == 0)
        why = vampire_shape(s, path, c->pick, &part);
    else
        why = points_read(&s->points, path, k->unit > 0 ? k->unit : c->unit);
    if (!why && part != c->part)
        why = reason("holds a %s, not a %s", part == 'w' ? "wheel" : "rail", c->part == 'w' ? "wheel" : "rail");
    if (why)
        shape_free(s);
    return why;
}

void shape_free(struct shape *s)
{
    points_free(&s->points);
}
