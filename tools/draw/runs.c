#include "tools/draw/runs.h"

#include <math.h>

#define KMH 3.6 /* km/h in a m/s */

static const char *const side_name[] = {"left", "right"};
static const char *const place_name[] = {"left", "middle", "right"};
static const enum canvas_dash side_dash[] = {CANVAS_SOLID, CANVAS_DASHED};
static const enum canvas_dash place_dash[] = {CANVAS_SOLID, CANVAS_DASHED, CANVAS_DOTTED};

/* Element `index` of each record of a channel, NULL with a reason in c->why where it is not in the run. */
static double *channel(struct chart *c, const struct run *r, enum run_channel ch, int64_t index)
{
    int64_t count = run_count(r, &run_channels[ch]);
    double *x = r->channel[ch] ? chart_numbers(c, r->records) : NULL;

    if (!r->channel[ch])
        c->why = reason("the run holds no %s: record the group %s", run_channels[ch].name,
                        run_group_name[run_channels[ch].group]);
    if (!x)
        return NULL;
    for (int64_t i = 0; i < r->records; i++)
        x[i] = run_channels[ch].type == VXF_F64 ? ((const double *)r->channel[ch])[i * count + index]
                                                : (double)((const float *)r->channel[ch])[i * count + index];
    return x;
}

static double *stations(struct chart *c, const struct run *r, double behind)
{
    double *x = channel(c, r, RUN_STATION, 0);

    for (int64_t i = 0; x && i < r->records; i++)
        x[i] += behind;
    return x;
}

/* What the chart shows, and of which run where it is one alone. */
static void set_title(struct chart *c, const struct run *r, const char *label, const char *what)
{
    if (c->panels == 0)
        c->title = label ? what : chart_words(c, "%s, %s at %.4g km/h%s", what, r->name, r->speed * KMH,
                                              r->complete ? "" : " (not complete)");
}

/* One force of a wheelset, a panel for each side. */
static const char *wheel_force(struct chart *c, const struct run *r, const char *label, int64_t wheelset, enum run_channel ch,
                               const char *name)
{
    if (wheelset > r->wheelsets)
        return reason("wheelset %lld: the train has %lld", (long long)wheelset, (long long)r->wheelsets);
    if (c->panels == 0) {
        c->alike = 1;
        c->x.label = chart_words(c, "station of wheelset %lld (m)", (long long)wheelset);
        for (int side = 0; side < 2; side++)
            chart_add_panel(c, chart_words(c, "%s, %s (kN)", name, side_name[side]), 1e-3);
    }
    double *x = stations(c, r, r->wheelset_x[wheelset - 1]);
    for (int side = 0; x && side < 2; side++) {
        double *force = channel(c, r, ch, 2 * (wheelset - 1) + side);
        if (force)
            chart_add_series(c, &c->panel[side], label, r->records, x, force);
    }
    return c->why;
}

const char *runs_vertical(struct chart *c, const struct run *r, const char *label, const struct runs_choice *choice)
{
    set_title(c, r, label, "Vertical wheel force");
    return wheel_force(c, r, label, choice->wheelset, RUN_Q, "Q");
}

const char *runs_lateral(struct chart *c, const struct run *r, const char *label, const struct runs_choice *choice)
{
    set_title(c, r, label, "Lateral wheel force");
    return wheel_force(c, r, label, choice->wheelset, RUN_Y, "Y");
}

/* A line of a panel: element `index` of a channel, NaN where `load`, of as many records, is 0.  Runs may lie on one another: dashes. */
static void add_motion(struct chart *c, const struct run *r, const char *label, struct chart_panel *panel, const double *x, const double *load,
                       enum run_channel ch, int64_t index)
{
    enum canvas_dash dash = place_dash[panel->colours % 3];
    double *y = channel(c, r, ch, index);

    for (int64_t i = 0; y && load && i < r->records; i++)
        y[i] = load[i] > 0 ? y[i] : NAN;
    if (y)
        chart_add_series(c, panel, label, r->records, x, y)->dash = dash;
}

const char *runs_wheelset(struct chart *c, const struct run *r, const char *label, const struct runs_choice *choice)
{
    int64_t w = choice->wheelset - 1;

    if (w >= r->wheelsets)
        return reason("wheelset %lld: the train has %lld", (long long)w + 1, (long long)r->wheelsets);
    set_title(c, r, label, "Wheelset");
    if (c->panels == 0) {
        c->x.label = chart_words(c, "station of wheelset %lld (m)", (long long)w + 1);
        chart_add_panel(c, "yaw (mrad)", 1e3);
        chart_add_panel(c, "lateral (mm)", 1e3);
        for (int side = 0; side < 2; side++)
            chart_add_panel(c, chart_words(c, "on %s wheel (mm)", side_name[side]), 1e3);
        for (int side = 0; side < 2; side++)
            chart_add_panel(c, chart_words(c, "on %s rail (mm)", side_name[side]), 1e3);
    }
    double *x = stations(c, r, r->wheelset_x[w]);
    if (!x)
        return c->why;
    add_motion(c, r, label, &c->panel[0], x, NULL, RUN_BODY_Q, 6 * r->wheelset[w] + 5);
    add_motion(c, r, label, &c->panel[1], x, NULL, RUN_BODY_Q, 6 * r->wheelset[w] + 1);
    for (int side = 0; side < 2; side++) {
        int64_t first = 3 * (2 * w + side);
        const double *load = channel(c, r, RUN_N, first);
        add_motion(c, r, label, &c->panel[2 + side], x, load, RUN_CONTACT_WHEEL_Y, first);
        add_motion(c, r, label, &c->panel[4 + side], x, load, RUN_CONTACT_Y, first);
    }
    return c->why;
}

static int64_t find_sleeper(const struct run *r, int64_t number)
{
    for (int64_t k = 0; k < r->sleepers; k++)
        if (r->sleeper_number[k] == number)
            return k;
    return -1;
}

/* The numbers of the sleepers to show of a run, and how many. */
static int sleepers_shown(const struct run *r, const struct runs_choice *choice, int64_t number[CHART_PANELS])
{
    int n = 0;

    for (int k = 0; k < choice->sleepers; k++)
        if (choice->asked || find_sleeper(r, choice->sleeper[k]) >= 0)
            number[n++] = choice->sleeper[k];
    if (n == 0 && r->sleepers > 0)
        number[n++] = r->sleeper_number[r->sleepers / 2];
    return n;
}

/* The line of one part out of `parts`: with several runs in a chart colours tell them apart, and dashes the parts. */
static void add_part(struct chart *c, struct chart_panel *panel, const char *label, const char *part, enum canvas_dash dash,
                     int parts, int64_t n, const double *x, const double *y)
{
    unsigned colour = chart_colour(label ? panel->colours / parts : panel->colours);
    const char *name = label ? chart_words(c, "%s, %s", label, part) : part;
    struct chart_series *s = chart_add_series(c, panel, name, n, x, y);

    s->colour = colour;
    s->dash = dash;
}

/* A force at the sleepers chosen, a panel for each, `parts` lines [part][sleeper] in each. */
static const char *at_sleepers(struct chart *c, const struct run *r, const char *label, const struct runs_choice *choice,
                               enum run_channel ch, const char *const *part, const enum canvas_dash *dash, int parts)
{
    int64_t number[CHART_PANELS];
    const int shown = sleepers_shown(r, choice, number);

    if (c->panels == 0) {
        c->alike = 1;
        c->x.label = "station of the front wheelset (m)";
        for (int k = 0; k < shown; k++)
            chart_add_panel(c, chart_words(c, "sleeper %lld (kN)", (long long)number[k]), 1e-3);
    }
    if (c->panels != shown)
        return "the runs do not have the same sleepers: --sleeper names some";
    double *x = stations(c, r, 0);
    for (int k = 0; x && k < shown; k++) {
        int64_t sleeper = find_sleeper(r, number[k]);
        if (sleeper < 0)
            return reason("no sleeper has number %lld: they are %lld to %lld", (long long)number[k], (long long)r->sleeper_number[0],
                          (long long)r->sleeper_number[r->sleepers - 1]);
        for (int p = 0; p < parts; p++) {
            double *force = channel(c, r, ch, p * r->sleepers + sleeper);
            if (force)
                add_part(c, &c->panel[k], label, part[p], dash[p], parts, r->records, x, force);
        }
    }
    return c->why;
}

const char *runs_pads(struct chart *c, const struct run *r, const char *label, const struct runs_choice *choice)
{
    set_title(c, r, label, "Force of the railpads on sleepers");
    return at_sleepers(c, r, label, choice, RUN_PAD, side_name, side_dash, 2);
}

const char *runs_ballast(struct chart *c, const struct run *r, const char *label, const struct runs_choice *choice)
{
    set_title(c, r, label, "Force on the ballast under sleepers");
    return at_sleepers(c, r, label, choice, RUN_BALLAST_F, place_name, place_dash, 3);
}

/* A largest force over sleeper number, a line for each part. */
static const char *along(struct chart *c, const struct run *r, const char *label, enum run_extreme what, const char *name,
                         const char *const *part, const enum canvas_dash *dash, int parts)
{
    double *number = chart_numbers(c, r->sleepers);

    if (!r->extreme[what])
        return reason("the run holds no %s: it is not complete", run_extremes[what].name);
    if (c->panels == 0) {
        c->x.label = "sleeper number";
        c->x.whole = 1;
        chart_add_panel(c, name, 1e-3);
    }
    for (int64_t k = 0; number && k < r->sleepers; k++)
        number[k] = (double)r->sleeper_number[k];
    for (int p = 0; number && p < parts; p++)
        add_part(c, &c->panel[0], label, part[p], dash[p], parts, r->sleepers, number, r->extreme[what] + p * r->sleepers);
    return c->why;
}

const char *runs_max_pads(struct chart *c, const struct run *r, const char *label, const struct runs_choice *choice)
{
    (void)choice;
    set_title(c, r, label, "Largest force of each railpad");
    return along(c, r, label, RUN_MAX_PAD, "force on the sleeper (kN)", side_name, side_dash, 2);
}

const char *runs_max_ballast(struct chart *c, const struct run *r, const char *label, const struct runs_choice *choice)
{
    (void)choice;
    set_title(c, r, label, "Largest force on the ballast");
    return along(c, r, label, RUN_MAX_BALLAST, "force on the ballast (kN)", place_name, place_dash, 3);
}
