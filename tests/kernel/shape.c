/* Readers of MiniProf, Vampire, GENSYS and plain files: what they hold, what they refuse, files cut at every length. */
#include "tests/kernel/tap.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "formats/miniprof.h"
#include "formats/shape.h"

static char folder[] = "/tmp/vxshapeXXXXXX";
static char path[64];

static const char *file_write(const char *ending, const char *content, size_t length)
{
    snprintf(path, sizeof path, "%s/a%s", folder, ending);
    FILE *f = fopen(path, "w");
    fwrite(content, 1, length, f);
    fclose(f);
    return path;
}

static const char *read_text(struct shape *s, const char *ending, const char *content, struct shape_choice c)
{
    return shape_read(s, file_write(ending, content, strlen(content)), &c);
}

static const struct shape_choice rail = {.part = 'r'}, wheel = {.part = 'w'}, rail_mm = {.part = 'r', .unit = 1e-3};

#define KEYS "ProgramName=MiniProf\nStock=%Talent\nSide=%L\nXoffset=0.0000\nColumnDef=X,Y,A,C\nXYPoints=4\nSd=36.1\nSh=27.9\nqR=9.1\n"
#define ROWS "\n 1.0 10.0 0 0\n\"2.0 20.0 0 0\n 3.0 30.0 0 0 ! here\n 4.0,40.0,0,0   added by hand\n"
#define OLD "MINIPROF 101 148 1994 3 24\nStock.......:\n32.58 37.11 14.71  (Sd/Sh/qR)\n\n1.5 15.3 0.0\n1.6 15.6 0.0\n1.7 15.8 0.0\n"
#define MPT "[FileInfo]\nProgramName=MiniProf\n[Profile1Info]\nColumnDef=X,Y\n[Profile1Points]\n1 2\n3 4\n5 6\n" \
            "[Profile2Info]\nColumnDef=A,Y,X\n[Profile2Points]\n9 2 1\n9 4 3\n9 6 7\n"
#define WHE "WHEELPROFILE\na title\nTREADDATUM EUROPEAN\nFLANGEBACK 1360\n"
#define RAI "RAILPROFILE\na title\nGAUGEPOINT EUROPEAN\nGAUGE 1435\n"

static void test_miniprof(void)
{
    struct shape s;

    ok(!read_text(&s, ".whl", KEYS ROWS, wheel) && s.points.n == 3 && s.side == 'l', "MiniProf: points without those put out, side");
    near(s.points.y[2], 4e-3, 1e-18, "commas, and a remark behind the columns");
    near(s.flange_width, 36.1e-3, 1e-15, "Sd");
    shape_free(&s);
    ok(!read_text(&s, ".WHL", "\"a remark\n" KEYS " 1 2 3 4\n2 3 4 5\n3 4 5 6\n4 5 6 7\n", wheel) && s.points.n == 4,
       "an ending in capitals, a header without an empty line");
    shape_free(&s);
    ok(!read_text(&s, ".whl", OLD, wheel) && s.points.n == 3, "an old header");
    near(s.points.z[1], 15.6e-3, 1e-15, "its points begin behind the empty line");
    shape_free(&s);
    ok(!read_text(&s, ".mpt", MPT, (struct shape_choice){.part = 'r', .section = 2}) && s.points.n == 3, "a section of an .mpt");
    near(s.points.y[2], 7e-3, 1e-18, "columns by their own ColumnDef");
    shape_free(&s);
}

static void test_vampire(void)
{
    struct shape s;

    ok(!read_text(&s, ".whe", WHE "-750 0 750.5 0\n-760 -1 760 -1\n-770 -2 770 -2\n", (struct shape_choice){.part = 'w', .pick = SHAPE_RIGHT}),
       "Vampire: the right wheel");
    near(s.points.y[0], 0.5e-3, 1e-15, "y from the tread datum");
    near(s.distance, 1.36, 1e-15, "FLANGEBACK");
    shape_free(&s);
    read_text(&s, ".whe", WHE "-750 0 750.5 0\n-760 -1 760 -1\n-770 -2 770 -2\n", (struct shape_choice){.part = 'w', .pick = SHAPE_LEFT});
    near(s.points.y[0], 0, 1e-15, "the left one, turned");
    shape_free(&s);
    ok(!read_text(&s, ".rai", RAI "-717.5 -14 717.5 -14\n-730 0 730 0\n-760 -1 760 -1\n", rail), "both rails alike: either");
    near(s.points.z[0], 14e-3, 1e-15, "a rail's z turned down");
    near(s.datum, 14e-3, 1e-15, "GAUGEPOINT");
    shape_free(&s);
}

static void test_plain(void)
{
    struct shape s;

    ok(!read_text(&s, ".csv", "1.5,2\n2.5, 3\n3.5 ,4,0.5\n", rail_mm) && s.points.n == 3, "plain points between commas");
    near(s.points.weight[2], 0.5, 0, "a weight");
    shape_free(&s);
    ok(!read_text(&s, ".csv", "y (m),z (m)\n1,2\n3,4\n5,6\n", rail) && s.points.y[2] == 5, "a heading says the unit");
    shape_free(&s);
    ok(!read_text(&s, ".txt", "# a\n# y [mm], z [mm]\n1 2\n3 4\n5 6\n", rail), "also behind a comment sign");
    near(s.points.y[2], 5e-3, 1e-18, "mm");
    shape_free(&s);
    ok(!read_text(&s, ".rail", "# GENSYS\n1 2\n3 4\n5 6\n", rail) && s.kind->y_to_centre && s.kind->fixed, "GENSYS: y to the centre, mm");
    shape_free(&s);
}

static void refused(const char *ending, const char *content, struct shape_choice c, const char *says)
{
    struct shape s;
    const char *why = read_text(&s, ending, content, c);
    ok(why && strstr(why, says), "%s refused: %s", ending, why ? why : "nothing");
}

static void test_refusals(void)
{
    refused(".ban", KEYS ROWS, rail, "holds a wheel, not a rail");
    refused(".whl", KEYS "\n1 2 0 0\n2 x 0 0\n", wheel, "line 12: 'x 0 0' is not a number");
    refused(".whl", KEYS "\n1 2 0 0\n2 3\n", wheel, "line 12: 2 numbers, ColumnDef names 4");
    refused(".whl", KEYS "\n1 2 0 0\n2 3 0 0\n3 4 0 0\n", wheel, "3 points, XYPoints says 4: cut short?");
    refused(".whl", KEYS "Xoffset=1.5\n" ROWS, wheel, "line 10: Xoffset=1.5: an offset is not read");
    refused(".whl", "ColumnDef=A,C\n", wheel, "line 1: ColumnDef=A,C names no X or no Y");
    refused(".whl", "not a profile\n", wheel, "line 1: 'not a profile' is neither");
    refused(".whl", "MINIPROF 101\n1 2\n", wheel, "empty line between header and points is missing");
    refused(".mpt", MPT, rail, "section: must be stated, the file holds 2");
    refused(".mpt", MPT, (struct shape_choice){.part = 'r', .section = 3}, "section 3: there are 2");
    refused(".mpt", "[FileInfo]\n[Other]\n", rail, "line 2: unknown section '[Other]'");
    refused(".ban", "1 2\n3 4\n5 6\n[Profile1Points]\n", rail, "line 4: '[Profile1Points]' in a file");
    refused(".ban", "1 2\n", (struct shape_choice){.part = 'r', .section = 1}, "section: only of a .mpt");
    refused(".whe", WHE "1 2 3\n", wheel, "line 5: 3 numbers, should be yl zl yr zr");
    refused(".whe", WHE "1 2 3 4 5\n", wheel, "line 5: more than four");
    refused(".whe", WHE "-1 2 3 4\n-1 2 3 4\n-1 2 3 4\n", wheel, "file_side: must be stated, left and right differ by");
    refused(".whe", "RAILPROFILE\n", wheel, "the file ends within its header");
    refused(".rai", "WHEELS\n", rail, "line 1: should be WHEELPROFILE or RAILPROFILE");
    refused(".rai", "RAILPROFILE\n\nGAUGEPOINT 14\nGAUGE 1435\n", rail, "line 3: unknown datum '14'");
    refused(".csv", "1,2\n3;4\n", rail_mm, "line 2: '3;4' is not a number");
    refused(".csv", "1,5 2,5\n", rail_mm, "line 1: commas between some");
    refused(".csv", "y (m),z (m)\n1,2\n", rail_mm, "line 1: the heading's unit is not the one stated");
    refused(".csv", "1,2\n", rail, "line 1: unit: must be stated");
    refused(".csv", "", rail_mm, "0 points");
}

/* Cut short anywhere, and with any byte another: read or refused, which the sanitizers watch. */
static void test_damage(void)
{
    static const struct { const char *ending, *text; struct shape_choice c; } files[] = {
        {".whl", KEYS ROWS, {.part = 'w'}}, {".whl", OLD, {.part = 'w'}}, {".mpt", MPT, {.part = 'r', .section = 2}},
        {".rai", RAI "-717.5 -14 717.5 -14\n-730 0 730 0\n-760 -1 760 -1\n", {.part = 'r'}},
        {".csv", "y (mm),z (mm)\n1.5,2\n2.5, 3\n3.5 ,4,0.5\n", {.part = 'r'}},
        {".prr", "header.begin\n version=1\n type=0\nheader.end\nspline.begin\n units.len.f=1000\n point.begin\n 1 2\n 3 4\n 5 6\n point.end\nspline.end\n",
         {.part = 'r'}}};
    static const char odd[] = {'\0', '\n', '=', '[', '\xff', '-', '"'};
    long tried = 0, silent = 0;

    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        size_t n = strlen(files[k].text);
        char *text = malloc(n + 1);
        for (size_t i = 0; i < n * (1 + sizeof odd); i++) {
            struct shape s;
            memcpy(text, files[k].text, n + 1);
            if (i >= n)
                text[i % n] = odd[i / n - 1];
            const char *why = shape_read(&s, file_write(files[k].ending, text, i < n ? i : n), &files[k].c);
            silent += why ? !*why : s.points.n < 3;
            tried++;
            shape_free(&s);
        }
        free(text);
    }
    ok(silent == 0, "%ld damaged files read or refused for a reason", tried);
}

int main(void)
{
    if (!mkdtemp(folder))
        return 1;
    test_miniprof();
    test_vampire();
    test_plain();
    test_refusals();
    test_damage();
    for (const char **e = (const char *[]){".whl", ".WHL", ".mpt", ".whe", ".rai", ".csv", ".txt", ".rail", ".ban", ".prr", NULL}; *e; e++) {
        snprintf(path, sizeof path, "%s/a%s", folder, *e);
        unlink(path);
    }
    rmdir(folder);
    return done();
}
