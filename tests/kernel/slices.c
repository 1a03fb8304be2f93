/* Lists of sections: what a .slcs says, and what is refused. */
#include "tests/kernel/tap.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "formats/slices.h"

static char path[] = "/tmp/slices-XXXXXX";

static const char *text_read(struct slices *s, const char *text)
{
    FILE *file = fopen(path, "w");

    if (!file || fputs(text, file) < 0 || fclose(file) != 0)
        return "cannot write";
    return slices_read(s, path);
}

static void test_list(void)
{
    struct slices s;
    const char *why = text_read(&s, "% an artificial rail\n\n 0.5 1000. U_OFFSET [usr], U_SCALE [mm/usr], usr = m\n 2 NSLC\n"
                                "3 1 0 ! NFEAT NKINK NACCEL\n1 U_INTPOL\n -1.0 'a/b 1.prr' ! first\n  0.25 'c%.txt'\n 2 P_KINK\n"
                                "-1.0 -1 0. 12.5\n 0.25 0 30\n 999.\n");

    ok(!why && s.n == 2 && s.features == 3, "a list of two slices%s%s", why ? ": " : "", why ? why : "");
    if (why)
        return;
    near(s.station[0], -0.5, 1e-15, "station: scale times (offset + u)");
    near(s.station[1], 0.75, 1e-15, "the next");
    ok(strcmp(s.file[0], "/tmp/a/b 1.prr") == 0 && strcmp(s.file[1], "/tmp/c%.txt") == 0,
       "names count from the folder of the list, and keep blanks and comment marks");
    ok(s.feature[0] < 0 && s.feature[1] == 0, "a feature that is not there is negative");
    near(s.feature[5], 0.999, 1e-15, "features go on over lines, in mm");
    slices_free(&s);
}

static void refused(const char *text, const char *part)
{
    struct slices s;
    const char *why = text_read(&s, text);

    ok(why && strstr(why, part), "refused: %s", why ? why : "not");
    if (!why)
        slices_free(&s);
}

static void test_index(void)
{
    struct slices s;
    FILE *file = fopen(path, "w");
    const char *why;

    ok(file && fputs(" 01   -0.5\n\n 2 1.25 # last\n", file) >= 0 && fclose(file) == 0, "an index");
    why = slices_index(&s, path, "Rail_*.txt");
    ok(!why && s.n == 2 && strcmp(s.file[0], "/tmp/Rail_01.txt") == 0 && s.station[1] == 1.25, "an index and a pattern name files");
    slices_free(&s);
    why = slices_index(&s, path, "Rail.txt");
    ok(why && strstr(why, "no *"), "refused: %s", why ? why : "not");
}

int main(void)
{
    int file = mkstemp(path);

    ok(file >= 0 && close(file) == 0, "a file to write");
    test_list();
    refused("0 1\n2\n0 0 0\n1\n0 'a'\n0 'b'\n", "must increase");
    refused("0 1\n2\n0 0 0\n1\n0 'a'\n", "too early");
    refused("0 1\n1\n0 0 0\n1\n0 a\n", "quotes");
    refused("0 1\n1\n0 0 0\n3\n0 'a'\n", "U_INTPOL 1 or 2");
    refused("0 1\n1\n3 0 0\n1\n0 'a'\n0 0 20 10\n", "behind the one before");
    refused("0 1\n1\n3 0 0\n1\n0 'a'\n5 0 20 30\n", "elsewhere");
    refused("0 1\n1.5\n", "NSLC");
    refused("0 1\nx\n", "should be NSLC");
    test_index();
    unlink(path);
    const char *why = slices_read(&(struct slices){0}, "wheel.slcw");
    ok(why && strstr(why, "out of round"), "refused: %s", why ? why : "not");
    return done();
}
