/* The rows at the corners of a cell are joined along their links, corner after corner; a branch holds one row of a corner at most.
 *
 * Most cells have as many rows at each corner, and each goes on with its like; few ways to join there are at all, some thousand in the table
 * of a turnout, so cells name theirs in a list of them. */
#include "tools/contact/branch.h"

#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "formats/room.h"

enum { CORNERS = CTAB_CORNERS, MOST = CORNERS * CTAB_MOST, NO_BRANCH = 255, BUCKETS = 1 << 14 };

/* Corners of a cell. */
struct corners {
    int count[CORNERS];             /* rows; 0 beyond the table */
    const uint8_t *link[CORNERS];   /* [count][CTAB_LINKS] */
};

/* Branches of a cell, [n] and zeros after, and the branch of each row of its corners. */
struct joined {
    uint8_t branch[MOST + 1][CORNERS];
    int n;
    uint8_t of[CORNERS][CTAB_MOST];
};

/* All branches so far, those of a cell up to a row of zeros. */
struct lists {
    uint8_t (*branch)[CORNERS];     /* [room] */
    int32_t *next;                  /* [room] of a list's first branch: the list before it in the same bucket, -1 none */
    int32_t bucket[BUCKETS];
    int64_t n, room;
};

static void cell_corners(const struct ctab *t, const int64_t at[3], struct corners *c)
{
    for (int k = 0; k < CORNERS; k++) {
        int64_t is = at[0] + (k >> 2), iy = at[1] + (k >> 1 & 1), iu = at[2] + (k & 1);
        int in = is < t->stations && iy < t->yaws && iu < t->us;
        const int32_t *first = t->first + (in ? (is * t->yaws + iy) * t->us + iu : 0);
        c->count[k] = in ? first[1] - first[0] : 0;
        c->link[k] = t->link + (int64_t)first[0] * CTAB_LINKS;
    }
}

static void join_row(struct joined *o, int k, int i, int branch)
{
    o->of[k][i] = (uint8_t)branch;
    o->branch[branch][k] = (uint8_t)(i + 1);
}

/* Two branches that a row belongs to both become one, the rows of `from` those of `to`. */
static void join_branches(struct joined *o, int to, int from)
{
    for (int k = 0; k < CORNERS; k++)
        if (o->branch[from][k])
            join_row(o, k, o->branch[from][k] - 1, to);
    memset(o->branch[from], 0, CORNERS);
}

/* Do two branches hold rows of one corner? */
static int meet(const uint8_t a[CORNERS], const uint8_t b[CORNERS])
{
    for (int k = 0; k < CORNERS; k++)
        if (a[k] && b[k])
            return 1;
    return 0;
}

/* Row i of corner k goes on with a branch that holds the corner before it. */
static void join_linked(struct joined *o, int k, int i, int branch)
{
    int own = o->of[k][i];

    if (own == NO_BRANCH && !o->branch[branch][k])
        join_row(o, k, i, branch);
    else if (own != NO_BRANCH && own != branch && !meet(o->branch[own], o->branch[branch]))
        join_branches(o, own, branch);
}

/* Rows of corner k: each goes on with the branch whose row at a corner before links to it, or begins one. */
static void join_corner(const struct corners *c, int k, struct joined *o)
{
    memset(o->of[k], NO_BRANCH, CTAB_MOST);
    for (int axis = 0; axis < CTAB_LINKS; axis++) {
        int before = k ^ 1 << axis;
        if (before > k)
            continue;
        for (int j = 0; j < c->count[before]; j++) {
            int i = c->link[before][j * CTAB_LINKS + axis] - 1;
            if (i >= 0 && i < c->count[k])
                join_linked(o, k, i, o->of[before][j]);
        }
    }
    for (int i = 0; i < c->count[k]; i++)
        if (o->of[k][i] == NO_BRANCH) {
            memset(o->branch[o->n], 0, CORNERS);
            join_row(o, k, i, o->n++);
        }
}

static void join(const struct corners *c, struct joined *o)
{
    static const uint8_t none[CORNERS];
    int n = 0;

    o->n = 0;
    for (int k = 0; k < CORNERS; k++)
        join_corner(c, k, o);
    for (int i = 0; i < o->n; i++)
        if (memcmp(o->branch[i], none, CORNERS))
            memmove(o->branch[n++], o->branch[i], CORNERS);
    memset(o->branch[n], 0, CORNERS);
    o->n = n;
}

static const char *lists_room(struct lists *l, int64_t more)
{
    int64_t room = 2 * (l->room + more);

    if (l->n + more <= l->room)
        return NULL;
    uint8_t (*branch)[CORNERS] = realloc(l->branch, (size_t)room * sizeof *branch);
    if (branch)
        l->branch = branch;
    int32_t *next = realloc(l->next, (size_t)room * sizeof *next);
    if (next)
        l->next = next;
    if (!branch || !next || room > INT32_MAX)
        return REASON_MEMORY;
    l->room = room;
    return NULL;
}

/* Multiplies each row in, after Fowler, Noll and Vo; the upper bits are the mixed ones. */
static int32_t *bucket_find(struct lists *l, const struct joined *o)
{
    uint64_t hash = 0xcbf29ce484222325, row;

    for (int i = 0; i < o->n; i++) {
        memcpy(&row, o->branch[i], sizeof row);
        hash = (hash ^ row) * 0x9e3779b97f4a7c15;
    }
    return &l->bucket[hash >> 40 & (BUCKETS - 1)];
}

/* The list of a cell's branches, added where there is none like it. */
static const char *lists_find(struct lists *l, const struct joined *o, int32_t *list)
{
    const size_t bytes = (size_t)(o->n + 1) * CORNERS;
    int32_t *bucket = bucket_find(l, o);
    const char *why;

    for (*list = *bucket; *list >= 0; *list = l->next[*list])
        if (l->n - *list > o->n && !memcmp(l->branch[*list], o->branch, bytes))
            return NULL;
    if ((why = lists_room(l, o->n + 1)))
        return why;
    *list = (int32_t)l->n;
    memcpy(l->branch[l->n], o->branch, bytes);
    l->next[l->n] = *bucket;
    *bucket = *list;
    l->n += o->n + 1;
    return NULL;
}

const char *branch_cells(struct ctab *t)
{
    struct lists *l = calloc(1, sizeof *l);
    int32_t *cell = room_take(&t->store, t->stations * t->yaws * t->us, sizeof *cell), *at = cell;
    const char *why = l && cell ? NULL : REASON_MEMORY;

    for (int i = 0; i < BUCKETS && !why; i++)
        l->bucket[i] = -1;
    for (int64_t is = 0; is < t->stations; is++)
        for (int64_t iy = 0; iy < t->yaws; iy++)
            for (int64_t iu = 0; iu < t->us && !why; iu++) {
                struct corners c;
                struct joined o;
                cell_corners(t, (const int64_t[]){is, iy, iu}, &c);
                join(&c, &o);
                why = lists_find(l, &o, at++);
            }
    uint8_t *branch = why ? NULL : room_take(&t->store, l->n, CORNERS);
    if (branch) {
        memcpy(branch, l->branch, (size_t)l->n * CORNERS);
        t->cell = cell;
        t->branch = branch;
        t->branches = l->n;
    }
    if (l) {
        free(l->branch);
        free(l->next);
    }
    free(l);
    return branch ? NULL : REASON_MEMORY;
}
