/* Runs as files: the page says what the tables say, what is written is read again, and numbers that point nowhere are refused. */
#include "formats/run.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tests/kernel/tap.h"

/* ---- the page ---- */

static char *page_text(void)
{
    static char text[65536];
    FILE *f = fopen("man/run.5", "r");
    size_t n = f ? fread(text, 1, sizeof text - 1, f) : 0;

    if (f)
        fclose(f);
    text[n] = 0;
    return text;
}

/* A row of the page: name, type, dims by their letters, unit, meaning. */
static void row_of(const struct run_channel_info *c, char *row, size_t size)
{
    static const char *const letter[] = {"", "w", "2", "3", "b", "6", "s", "n", "3", "f", "p"};
    char dims[32] = "";

    for (int d = 0; d < 4 && c->dim[d] != RUN_END; d++)
        snprintf(dims + strlen(dims), sizeof dims - strlen(dims), "[%s]", letter[c->dim[d]]);
    snprintf(row, size, "\n.It %s Ta %s Ta %s Ta %s Ta %s\n", c->name, vxf_type_name(c->type), *dims ? dims : "-", c->unit, c->meaning);
}

static void page(void)
{
    const char *text = page_text();
    char row[512];
    int missing = 0;

    for (int i = 0; i < RUN_CHANNELS + RUN_EXTREMES; i++) {
        row_of(i < RUN_CHANNELS ? &run_channels[i] : &run_extremes[i - RUN_CHANNELS], row, sizeof row);
        if (!strstr(text, row)) {
            printf("# not in man/run.5: %s", row + 1);
            missing++;
        }
    }
    ok(missing == 0, "man/run.5 has a row for each of %d series and extremes", RUN_CHANNELS + RUN_EXTREMES);
}

/* ---- files ---- */

enum { W = 2, B = 3, S = 4, N = 4, RECORDS = 5 };

static const double x[4] = {0, -2, -10, -12}, load[2 * W] = {1, 2, 3, 4}, inertia[3 * B] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
static int64_t wheelset[W] = {1, 2}, zone_of[2 * S] = {1, 0, 1, 0, 0, 0, 1, 1};
static const int64_t number[S] = {-1, 0, 1, 2};
static const char body_name[B][32] = {"carbody", "front", "rear"}, zone_name[1][32] = {"soft"};

static struct run make(void)
{
    return (struct run){.name = "a case", .route = "through", .speed = 22.5, .step = 1e-4, .friction = 0.3, .gravity = 9.81,
                        .rail_spacing = 1.5, .wheelsets = W, .bodies = B, .sleepers = S, .nodes = N, .zones = 1, .curves = 0,
                        .wheelset_x = x, .static_q = load, .radius = load, .wheelset = wheelset, .mass = inertia, .inertia = inertia,
                        .cg = inertia, .body_name = body_name, .sleeper_x = x, .sleeper_number = number, .node_x = x,
                        .zone_name = zone_name, .pad_zone = zone_of, .curve_x = x, .curvature = x};
}

/* Writes a run of RECORDS records, in two blocks, of time, station and Q, its k-th number k. */
static const char *store(const struct run *r, const char *path, int complete)
{
    int recorded[RUN_CHANNELS] = {[RUN_TIME] = 1, [RUN_STATION] = 1, [RUN_Q] = 1};
    static double value[64];
    const void *series[3] = {value, value, value}, *tail[RUN_EXTREMES];
    struct vxf_stream stream;
    struct vxf_out o;
    FILE *f = fopen(path, "wb");

    for (int i = 0; i < 64; i++)
        value[i] = i;
    for (int c = 0; c < RUN_EXTREMES; c++)
        tail[c] = value;
    vxf_out_begin(&o, "run");
    run_put(r, recorded, &o);
    const char *why = f ? vxf_stream_begin(&stream, &o, f) : "cannot write";
    if (!why)
        why = vxf_stream_block(&stream, 3, series);
    if (!why)
        why = vxf_stream_block(&stream, RECORDS - 3, series);
    if (!why && complete)
        why = vxf_stream_end(&stream, tail);
    if (f)
        fclose(f);
    vxf_out_free(&o);
    return why;
}

static void round_trip(const char *path, int complete)
{
    struct run r = make(), got;
    struct vxf f;
    const char *why = store(&r, path, complete);

    if (!why && !(why = vxf_open(&f, path))) {
        why = run_read(&got, &f);
        ok(!why, "%s run is read%s%s", complete ? "a complete" : "an incomplete", why ? ": " : "", why ? why : "");
        ok(got.complete == complete && got.records == RECORDS && got.wheelsets == W && got.bodies == B && got.sleepers == S && got.nodes == N &&
           got.zones == 1 && got.curves == 0, "counts");
        ok(got.speed == r.speed && got.step == r.step && got.rail_spacing == r.rail_spacing && strcmp(got.name, r.name) == 0, "keys");
        ok(memcmp(got.static_q, load, sizeof load) == 0 && memcmp(got.inertia, inertia, sizeof inertia) == 0 &&
           memcmp(got.pad_zone, zone_of, sizeof zone_of) == 0 && strcmp(got.body_name[2], "rear") == 0, "arrays");
        const double *Q = got.channel[RUN_Q];
        ok(Q && Q[2 * 2 * W + 3] == 11 && Q[3 * 2 * W] == 0, "series joined from blocks");
        ok(!got.channel[RUN_Y] && !got.channel[RUN_PAD], "what is not recorded is NULL");
        ok(complete ? got.extreme[RUN_MAX_PAD] && got.extreme[RUN_MAX_PAD][7] == 7 : !got.extreme[RUN_MAX_PAD], "extremes %s",
           complete ? "are there" : "are not");
        vxf_close(&f);
    } else {
        ok(0, "%s", why);
    }
}

static void refused(const char *path, const char *word)
{
    struct run r = make(), got;
    struct vxf f;
    const char *why = store(&r, path, 1);

    if (!why && !(why = vxf_open(&f, path))) {
        why = run_read(&got, &f);
        ok(why && strstr(why, word), "%s", why ? why : "is taken");
        vxf_close(&f);
    } else {
        ok(0, "%s", why);
    }
}

static void counts(void)
{
    struct run r = make();

    ok(run_count(&r, &run_channels[RUN_TIME]) == 1 && run_count(&r, &run_channels[RUN_Q]) == 2 * W &&
       run_count(&r, &run_channels[RUN_N]) == 6 * W && run_count(&r, &run_channels[RUN_BODY_Q]) == 6 * B &&
       run_count(&r, &run_channels[RUN_BALLAST_F]) == 3 * S && run_count(&r, &run_extremes[RUN_MAX_NODE_M]) == 2 * N,
       "numbers of a record, by channel");
}

int main(void)
{
    char path[] = "/tmp/veksel-run-XXXXXX";
    int fd = mkstemp(path);

    page();
    counts();
    if (fd < 0) {
        ok(0, "a scratch file");
        return done();
    }
    close(fd);
    round_trip(path, 1);
    round_trip(path, 0);
    wheelset[1] = B;
    refused(path, "wheelset.body: no body 3");
    wheelset[1] = -1;
    refused(path, "wheelset.body: no body -1");
    wheelset[1] = 2;
    zone_of[5] = 2;
    refused(path, "pad.zone: no zone 2");
    remove(path);
    return done();
}
