/* A chart's numbers before it is drawn, and that what is drawn is there, the same each time. */
#include "tools/draw/chart.h"

#include <stdlib.h>
#include <string.h>

#include "tests/kernel/tap.h"
#include "tools/draw/curves.h"
#include "tools/draw/layout.h"
#include "tools/draw/png.h"
#include "tools/draw/receptance.h"

enum { N = 501, W = 640, H = 360 };
static double x[N], force[N], other[N];

static void fill_chart(struct chart *c)
{
    chart_begin(c);
    c->title = "Wheel force";
    c->x.label = "station (m)";
    struct chart_panel *p = chart_add_panel(c, "Q (kN)", 1e-3);
    chart_add_series(c, p, "left", N, x, force);
    chart_add_note(c, p, x[250], force[250], "middle");
    p = chart_add_panel(c, "Y (kN)", 1e-3);
    chart_add_series(c, p, "left", N, x, other);
    chart_add_series(c, p, "right", N, x, force)->dash = CANVAS_DASHED;
    chart_add_line(c, 5, "crossing");
}

static void layout(void)
{
    struct chart c;
    struct text t;
    struct layout l;
    double px[2];

    fill_chart(&c);
    ok(text_open(&t) == NULL, "a font is found");
    layout_make(&l, &c, &t, W, H);
    near(l.x.lo, 0, 1e-12, "x begins with the data");
    near(l.x.hi, 10, 1e-12, "x ends with the data");
    ok(l.y[0].lo <= 90 && l.y[0].hi >= 110, "Q from %g to %g kN holds 90 .. 110", l.y[0].lo, l.y[0].hi);
    ok(l.box[1].y > l.box[0].y + l.box[0].h, "the second panel lies below the first");
    ok(l.box[0].x == l.box[1].x && l.box[0].w == l.box[1].w, "both share x");
    ok(l.box[1].y + l.box[1].h < H && l.box[0].x + l.box[0].w < W, "inside the picture");
    ok(l.entries == 2, "a line named in both panels is named once");
    for (int k = 0; k < l.entries; k++)
        ok(l.entry[k].y < l.box[k].y && (k == 0 || l.entry[k].y > l.box[k - 1].y + l.box[k - 1].h),
           "entry %d of the legend lies above its panel, outside the boxes", k);
    layout_place(&l, &c, 0, 10, l.y[0].hi * 1e3, px);
    near(px[0], l.box[0].x + l.box[0].w, 1e-9, "the last x is at the right edge");
    near(px[1], l.box[0].y, 1e-9, "the top of y at the upper edge");
    c.panel[0].y.down = 1;
    layout_make(&l, &c, &t, W, H);
    layout_place(&l, &c, 0, 10, l.y[0].hi * 1e3, px);
    near(px[1], l.box[0].y + l.box[0].h, 1e-9, "of z, which grows downwards, at the lower edge");
    text_free(&t);
    chart_free(&c);
}

static void equal(void)
{
    struct chart c;
    struct text t;
    struct layout l;
    double a[2], b[2], d[2];

    text_open(&t);
    chart_begin(&c);
    c.equal = 1;
    c.x.factor = 1e3;
    chart_add_series(&c, chart_add_panel(&c, "z (mm)", 1e3), NULL, N, x, other);
    layout_make(&l, &c, &t, W, H);
    layout_place(&l, &c, 0, 0, 0, a);
    layout_place(&l, &c, 0, 1, 0, b);
    layout_place(&l, &c, 0, 0, 1, d);
    near((b[0] - a[0]) / (a[1] - d[1]), 1, 1e-9, "a metre is as long along y as along x");
    text_free(&t);
    chart_free(&c);
}

static void pieces(void)
{
    static double broken[N], xy[2 * N];
    struct chart c;
    struct text t;
    struct layout l;
    int64_t from = 0;
    int lengths[3];

    memcpy(broken, force, sizeof broken);
    broken[100] = NAN;
    chart_begin(&c);
    const struct chart_series *s = chart_add_series(&c, chart_add_panel(&c, NULL, 1), NULL, N, x, broken);
    text_open(&t);
    layout_make(&l, &c, &t, 4 * W, 4 * H);
    for (int k = 0; k < 3; k++)
        lengths[k] = curves_piece(&l, &c, 0, s, &from, xy);
    ok(lengths[0] == 100 && lengths[1] == 400 && lengths[2] == 0, "a NaN lifts the pen: 100 and 400 points, not %d and %d",
       lengths[0], lengths[1]);
    layout_make(&l, &c, &t, CANVAS_LEAST, CANVAS_LEAST);
    from = 0;
    lengths[0] = curves_piece(&l, &c, 0, s, &from, xy);
    ok(lengths[0] > 1 && lengths[0] <= 100, "on a small picture points that coincide are left out: %d of 100", lengths[0]);
    text_free(&t);
    chart_free(&c);
}

static unsigned char *draw(struct canvas *canvas)
{
    struct chart c;

    fill_chart(&c);
    const char *why = canvas_new(canvas, W, H);
    why = why ? why : chart_draw(&c, canvas);
    ok(why == NULL, "drawn%s%s", why ? ": " : "", why ? why : "");
    chart_free(&c);
    return canvas->rgb;
}

static long count(const unsigned char *rgb, unsigned colour)
{
    long n = 0;

    for (long i = 0; i < (long)W * H; i++)
        n += rgb[3 * i] == colour >> 16 && rgb[3 * i + 1] == (colour >> 8 & 255) && rgb[3 * i + 2] == (colour & 255);
    return n;
}

static void picture(void)
{
    struct canvas a, b;

    draw(&a);
    draw(&b);
    ok(count(a.rgb, 0xffffff) > W * H / 2, "mostly white");
    ok(count(a.rgb, CHART_BLUE) > 200, "the first line is there: %ld pixels of pure blue", count(a.rgb, CHART_BLUE));
    ok(count(a.rgb, CHART_RED) > 100, "the second too: %ld of red", count(a.rgb, CHART_RED));
    ok(count(a.rgb, 0) > 50, "and words: %ld of black", count(a.rgb, 0));
    ok(memcmp(a.rgb, b.rgb, (size_t)W * H * 3) == 0, "the same picture twice");
    FILE *file[2] = {tmpfile(), tmpfile()};
    char bytes[2][200000];
    size_t size[2] = {0};
    for (int k = 0; k < 2 && file[k]; k++) {
        ok(png_put(file[k], W, H, k ? b.rgb : a.rgb, "vxplot test") == NULL, "written as PNG");
        rewind(file[k]);
        size[k] = fread(bytes[k], 1, sizeof bytes[k], file[k]);
        fclose(file[k]);
    }
    ok(size[0] > 1000 && size[0] == size[1] && memcmp(bytes[0], bytes[1], size[0]) == 0, "the same bytes twice, %zu", size[0]);
    canvas_free(&a);
    canvas_free(&b);
}

/* |1/(1 - r^2 + 2 i d r)| at resonances 100 and 300 Hz. */
static void peaks(void)
{
    static double a[1000];
    int64_t peak[4];

    for (int i = 0; i < 1000; i++) {
        double r = i / 100.0, s = i / 300.0;
        a[i] = 1 / hypot(1 - r * r, 0.1 * r) + 1 / hypot(1 - s * s, 0.1 * s);
    }
    ok(receptance_peaks(1000, a, 1.05, 4, peak) == 2, "two peaks");
    ok(labs((long)peak[0] - 100) <= 1 && labs((long)peak[1] - 300) <= 1, "at 100 and 300 Hz: %ld, %ld", (long)peak[0], (long)peak[1]);
}

static void refusals(void)
{
    struct chart c;
    struct canvas canvas;

    ok(canvas_new(&canvas, 10, 10) != NULL, "a picture of 10 x 10 pixels is refused");
    ok(canvas_new(&canvas, 100000, 100) != NULL, "a picture of 100000 pixels too");
    canvas_new(&canvas, W, H);
    chart_begin(&c);
    ok(chart_draw(&c, &canvas) != NULL, "a chart without a panel is refused");
    for (int k = 0; k <= CHART_PANELS; k++)
        chart_add_panel(&c, "", 1);
    ok(chart_draw(&c, &canvas) != NULL, "a panel too many is told when drawn");
    chart_free(&c);
    canvas_free(&canvas);
}

int main(void)
{
    for (int i = 0; i < N; i++) {
        x[i] = 10.0 * i / (N - 1);
        force[i] = 100e3 + 10e3 * sin(2 * M_PI * x[i] / 5);
        other[i] = 2e3 * cos(x[i]);
    }
    layout();
    equal();
    pieces();
    picture();
    peaks();
    refusals();
    return done();
}
