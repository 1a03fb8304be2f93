/* The sections of the cast crossing 56E1-R245-1:9.25 (S&C benchmark, in CONTACT's .slcs): path of a rigid S1002 over them, section by
 * section, against one computed independently; between the sections it is smooth, and falls as the surface does.
 *
 * Right side; u > 0 moves the wheel to the field side.  The published path has the sections' y = 0 at 753.0 mm; gauge 1435 mm and the plain
 * section's face, 35.00 mm from its y = 0, would have it at 752.5 mm. */
#include "tests/kernel/tap.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "formats/sections.h"
#include "tools/contact/search.h"
#include "tools/profile/gauge.h"
#include "tools/profile/measured_input.h"
#include "tools/profile/zones.h"

#define FOLDER "../shared/data/"
#define GRID 1e-4            /* m */
#define JUMP 5e-4            /* m: a contact that moved more in a millimetre has jumped */

enum { DISPLACEMENTS = 9, COLUMNS = 11, RAIL = 0, NOSE = 1 };

static const double displacement[DISPLACEMENTS] = {-4e-3, -3e-3, -2e-3, -1e-3, 0, 1e-3, 2e-3, 3e-3, 4e-3};

struct path { struct search_contact first; double fall; int touches; };

static const char *rail_make(struct prof *p, struct set *set)
{
    static char position[] = "sections.position=0.753", every[] = "sections.every=0.001", spacing[] = "spacing=0.0003";
    char *const keys[] = {position, every, spacing};
    struct prof_text t;
    struct sections list;
    struct section s;
    uint64_t hash = 0;
    const char *why = prof_text_file(&t, FOLDER "contact_profiles/uk_crossing.slcs", PROF_SECTIONS, PROF_UNSTATED, keys, 3, &hash);

    if (why || (why = sections_read(&list, &t, &t.sections.from, &hash)) || (why = measured_input(&t, &list, &s, set)))
        return why;
    ok(list.slices.n == 148 && set->bodies == 2, "148 sections, two bodies");
    ok(s.residual.worst < 1e-4 && s.residual.rms < 3e-6, "smoothed over 3 mm the points depart %.0f um at most, %.1f um mean square",
       1e6 * s.residual.worst, 1e6 * s.residual.rms);
    *p = (struct prof){.part = 'r', .position = gauge_rail_position(s.gauge_face, t.gauge)};
    near(p->position, 0.753, 1e-12, "position as stated");
    sections_free(&list);
    prof_text_free(&t);
    return set_prof(set, 'r', p);
}

static void wheel_make(struct prof *p)
{
    static const char *const name[] = {"wheel"};
    struct prof_text t;
    struct points points;
    struct section s;
    struct set set = {.bodies = 1, .body = name};

    *p = (struct prof){.part = 'w', .side = 'r', .radius = 0.46, .position = gauge_wheel_position(1.360, 0.070)};
    ok(!prof_text_read(&t, "data/profiles/S1002.yaml", NULL, 0, NULL) &&
           !zones_points(t.zones.n, t.zones.item, t.symmetric, 1e-4, &points) &&
           !section_make(&s, &points, &(struct section_options){1, 0, 0.014, 0.003, 1e-4}) && !set_section(&set, 0) &&
           !set_body(&set, 0, &s.outline) && !set_prof(&set, 'r', p), "S1002");
    points_free(&points);
    set_free(&set);
    prof_text_free(&t);
}

/* fall of a body at y in a section. */
static double fall_at(const struct prof *p, int64_t section, int body, double y)
{
    for (int64_t k = 0; k < p->polys; k++)
        for (int64_t j = p->poly_first[k] + 1; p->poly_section[k] == section && p->poly_body[k] == body && j < p->poly_first[k + 1]; j++)
            if (p->y[j - 1] <= y && y <= p->y[j])
                return p->fall[j - 1] + (p->fall[j] - p->fall[j - 1]) * (y - p->y[j - 1]) / (p->y[j] - p->y[j - 1]);
    return NAN;
}

/* Section by section, path[sections][DISPLACEMENTS]. */
static void path_search(const struct prof *wheel, const struct prof *rail, struct path *path)
{
    struct search_contact c[SEARCH_MOST];
    struct search s;
    double yaw = 0;

    ok(!search_begin(&s, wheel, rail, &yaw, 1, SEARCH_PLANE, GRID), "the search");
    for (int64_t i = 0; i < rail->sections; i++) {
        search_section(&s, rail, i);
        for (int k = 0; k < DISPLACEMENTS; k++, path++) {
            path->touches = search_contacts(&s, 0, lrint(displacement[k] / GRID), c) > 0;
            path->first = c[0];
            path->fall = path->touches ? fall_at(rail, i, c[0].body, c[0].at.y) : NAN;
        }
    }
    search_free(&s);
}

/* Height over that of the plain section at u = 0, as published (mm), at every section given. */
static void test_published(const struct prof *rail, const struct path *path)
{
    FILE *file = fopen(FOLDER "uk_crossing_path.csv", "r");
    char line[512];
    double column[COLUMNS], zero = 0, worst = 0, at = 0;
    int64_t i = 0, rows = 0;

    if (!ok(file && fgets(line, sizeof line, file), "the published path"))
        return;
    for (; fgets(line, sizeof line, file); rows++) {
        const char *p = line;
        for (int k = 0; k < COLUMNS; k++, p += strcspn(p, ",\n") + 1)
            column[k] = strtod(p, NULL);
        while (i < rail->sections - 1 && fabs(rail->station[i] - column[0]) > 1e-6)
            i++;
        const struct path *here = path + i * DISPLACEMENTS;
        if (rows == 0)
            zero = 1e3 * here[4].first.at.gap - column[5];
        for (int k = 0; k < 5; k++) {
            double off = 1e3 * here[2 * k].first.at.gap - zero - column[1 + 2 * k];
            if (!(fabs(off) <= fabs(worst))) {
                worst = off;
                at = column[0];
            }
        }
    }
    fclose(file);
    ok(rows == 148 && fabs(worst) < 0.02, "%d sections, five displacements: at most %.4f mm off, at %.3f m", (int)rows, worst, at);
}

/* Increments of the path over a millimetre against the mean of their neighbours', fall at the contact against the path's own slope. */
static void test_between(const struct prof *rail, const struct path *path, int k)
{
    const double *x = rail->station;
    double worst = 0, at = 0, fall = 0;

    for (int64_t i = 1; i < rail->sections - 1; i++) {
        const struct path *a = path + (i - 1) * DISPLACEMENTS + k, *b = a + DISPLACEMENTS, *c = b + DISPLACEMENTS;
        if (x[i + 1] - x[i - 1] > 2.1e-3)
            continue;
        double before = (b->first.at.gap - a->first.at.gap) / (x[i] - x[i - 1]);
        double after = (c->first.at.gap - b->first.at.gap) / (x[i + 1] - x[i]);
        if (!(fabs(after - before) * 1e-3 / 2 <= worst)) {
            worst = fabs(after - before) * 1e-3 / 2;
            at = x[i];
        }
        if (a->first.body == c->first.body && fabs(c->first.at.y - a->first.at.y) < JUMP)
            fall = fmax(fall, fabs(b->fall - (before + after) / 2));
    }
    ok(worst < 3e-5, "u = %g mm: increments differ by %.1f um at most from their neighbours' mean, at %.3f m", 1e3 * displacement[k],
       1e6 * worst, at);
    ok(fall < 1e-3, "fall at the contact is the slope of the path within %.2f mm/m", 1e3 * fall);
}

static void test_transfer(const struct prof *rail, const struct path *path, int k)
{
    int64_t i = 0;

    while (i < rail->sections - 1 && path[i * DISPLACEMENTS + k].first.body == RAIL)
        i++;
    const struct path *wing = path + (i - 2) * DISPLACEMENTS + k, *nose = path + (i + 2) * DISPLACEMENTS + k;
    ok(path[i * DISPLACEMENTS + k].first.body == NOSE && rail->station[i] > 0.23 && rail->station[i] < 0.31,
       "u = %g mm: onto the nose at %.3f m", 1e3 * displacement[k], rail->station[i]);
    ok(wing->fall > 6.5e-3 && wing->fall < 8e-3, "the wing falls by %.1f mm/m there", 1e3 * wing->fall);
    ok(nose->fall < -9.5e-3 && nose->fall > -12.5e-3, "the nose rises by %.1f mm/m", -1e3 * nose->fall);
}

int main(void)
{
    struct prof rail, wheel;
    struct set set;

    if (access(FOLDER "contact_profiles/uk_crossing.slcs", R_OK) != 0) {
        puts("1..0 # SKIP " FOLDER "contact_profiles is absent");
        return 0;
    }
    const char *why = rail_make(&rail, &set);
    if (!ok(!why, "the crossing%s%s", why ? ": " : "", why ? why : ""))
        return done();
    wheel_make(&wheel);
    struct path *path = calloc((size_t)rail.sections * DISPLACEMENTS, sizeof *path);
    if (!ok(path != NULL, "memory"))
        return done();
    path_search(&wheel, &rail, path);
    test_published(&rail, path);
    for (int k = 0; k < DISPLACEMENTS; k++)
        test_between(&rail, path, k);
    for (int k = 0; k < DISPLACEMENTS; k += 2)
        test_transfer(&rail, path, k);
    free(path);
    prof_free(&rail);
    prof_free(&wheel);
    set_free(&set);
    return done();
}
