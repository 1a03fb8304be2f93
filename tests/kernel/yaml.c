/* Inputs written by people: what is right is read, and every way of being wrong is refused with its place. */
#include "formats/yaml.h"

#include <stdlib.h>
#include <string.h>

#include "tests/kernel/tap.h"

struct pad { double stiffness, damping; };
struct zone { char *name; struct yaml_nums sleepers; struct pad railpad; };
struct track {
    char *name;
    double from, spacing;
    int64_t bays;
    int heavy, model;
    struct pad railpad;
    struct yaml_table bending;
    struct yaml_nums points;
    struct yaml_list zone;
};

static const char *const MODELS[] = {"lumped", "consistent", NULL};

#define AT(type, member) offsetof(struct type, member)
static const struct yaml_field PAD_FIELDS[] = {
    {"stiffness", YAML_NUM, AT(pad, stiffness), YAML_POSITIVE, 1e12, "N/m", NULL, "stiffness", NULL, NULL},
    {"damping", YAML_NUM, AT(pad, damping), 0, 1e9, "N s/m", "50e3", "damping", NULL, NULL},
    {0}};
static const struct yaml_schema PAD = {"railpad", sizeof(struct pad), PAD_FIELDS};
static const struct yaml_field ZONE_FIELDS[] = {
    {"name", YAML_TEXT, AT(zone, name), 0, 0, "", NULL, "name", NULL, NULL},
    {"sleepers", YAML_NUMS, AT(zone, sleepers), 1, 1000, "1", YAML_ABSENT, "numbers", NULL, NULL},
    {"railpad", YAML_MAP, AT(zone, railpad), 0, 0, "", NULL, "pad", &PAD, NULL},
    {0}};
static const struct yaml_schema ZONE = {"zone", sizeof(struct zone), ZONE_FIELDS};
static const struct yaml_field TRACK_FIELDS[] = {
    {"name", YAML_TEXT, AT(track, name), 0, 0, "", "track", "name", NULL, NULL},
    {"from", YAML_NUM, AT(track, from), -1e6, 1e6, "m", "0", "station", NULL, NULL},
    {"spacing", YAML_NUM, AT(track, spacing), 0.1, 10, "m", "0.6", "centre to centre", NULL, NULL},
    {"bays", YAML_INT, AT(track, bays), 1, YAML_NO_LIMIT, "1", "50", "number", NULL, NULL},
    {"heavy", YAML_BOOL, AT(track, heavy), 0, 0, "", "false", "a flag", NULL, NULL},
    {"model", YAML_CHOICE, AT(track, model), 0, 0, "", "lumped", "a word", NULL, MODELS},
    {"railpad", YAML_MAP, AT(track, railpad), 0, 0, "", NULL, "pad", &PAD, NULL},
    {"bending", YAML_TABLE, AT(track, bending), YAML_POSITIVE, 1e12, "N m2", "6.11e6", "stiffness of the rail", NULL, NULL},
    {"points", YAML_PAIRS, AT(track, points), -10, 10, "m", YAML_ABSENT, "pairs", NULL, NULL},
    {"zone", YAML_LIST, AT(track, zone), 0, 0, "", YAML_ABSENT, "zones", &ZONE, NULL},
    {0}};
static const struct yaml_schema TRACK = {"track", sizeof(struct track), TRACK_FIELDS};

static struct track t;
static uint64_t hash;

static const char *read_set(const char *text, char *set)
{
    return yaml_read_text(text, &TRACK, &set, set != NULL, &t, &hash);
}

/* The text is refused, and the reason is this one. */
static void refused(const char *text, const char *want)
{
    const char *why = read_set(text, NULL);

    if (!ok(why && strcmp(why, want) == 0, "refused: %s", want))
        printf("# got: %s\n", why ? why : "no failure");
    if (!why)
        yaml_release(&TRACK, &t);
}

/* The same of the value of railpad.stiffness, which stands in line 3 at column 16. */
static void refused_value(const char *value, const char *want)
{
    char text[200], reason[200];

    snprintf(text, sizeof text, "track:\n  railpad:\n    stiffness: %s\n", value);
    snprintf(reason, sizeof reason, "text:3:16: error: %s", want);
    refused(text, reason);
}

static void refused_set(const char *set, const char *want)
{
    char *copy = strdup(set), message[300];
    const char *why = read_set("track: {railpad: {stiffness: 1}, zone: [{name: a, railpad: {stiffness: 2}}]}", copy);

    snprintf(message, sizeof message, "--set %s: error: %s", set, want);
    if (!ok(why && strcmp(why, message) == 0, "refused: %s", message))
        printf("# got: %s\n", why ? why : "no failure");
    free(copy);
}

static void accepted(void)
{
    const char *text =
        "# a comment\n"
        "track:\n"
        "  name: \"one: two\"   # quoted\n"
        "  from: -15.5\n"
        "  bays: 12\n"
        "  heavy: true\n"
        "  model: consistent\n"
        "  railpad: {stiffness: 300e6}\n"
        "  bending: {station: [0, 1.5, 3], value: [1e6, 2e6, 2e6]}\n"
        "  points: [[1, 2], [3, 4]]\n"
        "  zone:\n"
        "    - {name: first, sleepers: [1, 2, 3], railpad: {stiffness: 1e6, damping: 0}}\n"
        "    - name: second\n"
        "      railpad:\n"
        "        stiffness: .5E+3\n";

    ok(!read_set(text, NULL), "a right input is read");
    ok(strcmp(t.name, "one: two") == 0 && t.from == -15.5 && t.spacing == 0.6 && t.bays == 12 && t.heavy && t.model == 1,
       "scalars, one by default");
    ok(t.railpad.stiffness == 300e6 && t.railpad.damping == 50e3, "a map, one value by default");
    ok(t.bending.n == 3 && !t.bending.by_number && yaml_table_at(&t.bending, 0.75, 0) == 1.5e6, "a table over station, straight between");
    ok(yaml_table_at(&t.bending, -1, 0) == 1e6 && yaml_table_at(&t.bending, 9, 0) == 2e6, "constant beyond its ends");
    ok(t.points.n == 4 && t.points.x[3] == 4, "pairs");
    ok(t.zone.n == 2, "a list of two zones");
    const struct zone *z = t.zone.item;
    ok(z[0].sleepers.n == 3 && z[0].railpad.damping == 0 && z[1].sleepers.n == 0 && z[1].railpad.stiffness == 500, "with their keys");
    yaml_release(&TRACK, &t);
    ok(!read_set("track: {railpad: {stiffness: 1}, bending: 3}", NULL) && t.bending.n == 1 && yaml_table_at(&t.bending, 7, 7) == 3,
       "a table may be one number");
    yaml_release(&TRACK, &t);
}

static void numbers(void)
{
    refused_value("80 km/h", "stiffness: \"80 km/h\" is not a plain number (unit N/m)");
    refused_value("1,2e8", "stiffness: \"1,2e8\" is not a plain number (unit N/m)");
    refused_value("nan", "stiffness: \"nan\" is not a plain number (unit N/m)");
    refused_value(".nan", "stiffness: \".nan\" is not a plain number (unit N/m)");
    refused_value("inf", "stiffness: \"inf\" is not a plain number (unit N/m)");
    refused_value("0x10", "stiffness: \"0x10\" is not a plain number (unit N/m)");
    refused_value("1_000", "stiffness: \"1_000\" is not a plain number (unit N/m)");
    refused_value("1e999", "stiffness: 1e999 is out of range");
    refused_value("0200", "stiffness: \"0200\" is not a plain number (unit N/m)");
    refused_value("-.", "stiffness: \"-.\" is not a plain number (unit N/m)");
    refused_value("1e", "stiffness: \"1e\" is not a plain number (unit N/m)");
    refused_value("1.2.3", "stiffness: \"1.2.3\" is not a plain number (unit N/m)");
    refused_value("\"12\"", "stiffness: \"12\" is not a plain number (unit N/m)");
    refused_value("true", "stiffness: \"true\" is not a plain number (unit N/m)");
    refused_value("0", "stiffness must be greater than 0 and at most 1e+12 N/m, not 0");
    refused_value("-3", "stiffness must be greater than 0 and at most 1e+12 N/m, not -3");
    refused_value("2e12", "stiffness must be greater than 0 and at most 1e+12 N/m, not 2e12");
    refused_value("~", "stiffness has no value");
    refused_value("null", "stiffness has no value");
    refused_value("[1]", "stiffness: one value is wanted here, not a list");
    refused_value("{a: 1}", "stiffness: one value is wanted here, not a map");
    refused("track:\n  railpad:\n    stiffness:\n", "text:3:15: error: stiffness has no value");
    refused("track: {bays: 1.5, railpad: {stiffness: 1}}", "text:1:15: error: bays: 1.5 is not a whole number");
    refused("track: {bays: 1e3, railpad: {stiffness: 1}}", "text:1:15: error: bays: 1e3 is not a whole number");
    refused("track: {bays: 0200, railpad: {stiffness: 1}}", "text:1:15: error: bays: \"0200\" is not a plain number (unit 1)");
    refused("track: {bays: 99999999999999999999, railpad: {stiffness: 1}}", "text:1:15: error: bays: 99999999999999999999 is out of range");
    refused("track: {heavy: yes, railpad: {stiffness: 1}}", "text:1:16: error: heavy must be true or false, not \"yes\"");
    refused("track: {model: lump, railpad: {stiffness: 1}}", "text:1:16: error: model must be one of lumped, consistent, not \"lump\"");
}

static void keys(void)
{
    refused("track:\n  spacingg: 1\n", "text:2:3: error: unknown key spacingg in track, did you mean spacing?");
    refused("track:\n  ralpad:\n    stiffness: 1\n", "text:2:3: error: unknown key ralpad in track, did you mean railpad?");
    refused("track:\n  zebra: 1\n", "text:2:3: error: unknown key zebra in track");
    refused("track:\n  q: 1\n", "text:2:3: error: unknown key q in track");
    refused("track:\n  railpad: {stiffness: 1,2e8}\n", "text:2:26: error: unknown key 2e8 in railpad (numbers have a decimal point, not a comma)");
    refused("track:\n  railpad: {stiffness: 1, stiffness: 2}\n", "text:2:27: error: this key stands twice: stiffness");
    refused("track:\n  from: 1\n  railpad: {stiffness: 1}\n  from: 2\n", "text:4:3: error: this key stands twice: from");
    refused("track:\n  from: 1\n", "text:2:3: error: key railpad is missing in track");
    refused("track:\n  railpad:\n    damping: 1\n", "text:3:5: error: key stiffness is missing in railpad");
    refused("track:\n  railpad: {stiffness: 1}\n  zone:\n    - {name: a}\n", "text:4:7: error: key railpad is missing in zone");
    refused("tracks:\n  railpad: {stiffness: 1}\n", "text:1:1: error: the file must begin with the one key track:");
    refused("track: {railpad: {stiffness: 1}}\nother: 2\n", "text:1:1: error: the file must begin with the one key track:");
    refused("- 1\n", "text:1:1: error: the file must begin with the one key track:");
    refused("track: 3\n", "text:1:8: error: track: keys with values are wanted here");
    refused("", "text: empty input");
    refused("# nothing\n", "text: empty input");
}

static void shapes(void)
{
    refused("track: {railpad: {stiffness: 1}, points: [[1, 2], [3]]}", "text:1:51: error: points: a pair [a, b] is wanted here");
    refused("track: {railpad: {stiffness: 1}, points: [[1, 2], [3, 11]]}", "text:1:55: error: points must be at least -10 and at most 10 m, not 11");
    refused("track: {railpad: {stiffness: 1}, points: 4}", "text:1:42: error: points: a list of pairs [a, b] is wanted here");
    refused("track: {railpad: {stiffness: 1}, zone: 4}", "text:1:40: error: zone: a list is wanted here");
    refused("track: {railpad: {stiffness: 1}, bending: {station: [0, 1], value: [1]}}",
            "text:1:43: error: bending: 2 places but 1 values");
    refused("track: {railpad: {stiffness: 1}, bending: {station: [1, 1], value: [1, 2]}}",
            "text:1:57: error: bending: places must increase, 1 after 1");
    refused("track: {railpad: {stiffness: 1}, bending: {station: [], value: []}}", "text:1:43: error: bending: 0 places but 0 values");
    refused("track: {railpad: {stiffness: 1}, bending: {station: [0], value: [0]}}",
            "text:1:66: error: bending must be greater than 0 and at most 1e+12 N m2, not 0");
    refused("track: {railpad: {stiffness: 1}, bending: {at: [0], value: [1]}}",
            "text:1:43: error: bending: one number, or {station: [...], value: [...]}, or {number: [...], value: [...]} is wanted here");
}

static void beyond_the_subset(void)
{
    char deep[200] = "track: ";

    refused("track: &a {railpad: {stiffness: 1}}", "text:1:8: error: anchors and tags are not part of this input format");
    refused("track: {railpad: {stiffness: *a}}", "text:1:30: error: aliases are not part of this input format");
    refused("track: {railpad: {stiffness: !!float 1}}", "text:1:30: error: anchors and tags are not part of this input format");
    refused("track: {railpad: {stiffness: 1}}\n---\ntrack: 1\n", "text:3:1: error: a second document");
    refused("track: {[a]: 1}", "text:1:9: error: a key must be a word");
    memset(deep + strlen(deep), '[', 60);
    refused(deep, "text:1:40: error: nested too deep");
    ok(read_set("track:\n\trailpad: 1\n", NULL) != NULL, "a tab as indent is refused");
    ok(read_set("track: {railpad: {stiffness: 1}", NULL) != NULL, "a brace left open is refused");
    ok(read_set("track: {railpad: {stiffness: 1}, name: \"a\xff\"}", NULL) != NULL, "bytes that are not UTF-8 are refused");
}

static void overrides(void)
{
    char pad[] = "railpad.stiffness=150e6", item[] = "zone.1.railpad.stiffness=16e6", new_key[] = "spacing=0.5";
    char table[] = "bending={number: [1, 2], value: [3, 4]}";
    const char *text = "track: {railpad: {stiffness: 1}, zone: [{name: a, railpad: {stiffness: 2}}]}";

    ok(!read_set(text, pad) && t.railpad.stiffness == 150e6, "a value is overridden");
    yaml_release(&TRACK, &t);
    ok(!read_set(text, item) && ((struct zone *)t.zone.item)[0].railpad.stiffness == 16e6, "in a list too, items from 1");
    yaml_release(&TRACK, &t);
    ok(!read_set(text, new_key) && t.spacing == 0.5, "a value the file leaves to its default");
    yaml_release(&TRACK, &t);
    ok(!read_set(text, table) && t.bending.by_number && yaml_table_at(&t.bending, 0, 1.5) == 3.5, "a table for a number");
    yaml_release(&TRACK, &t);
    refused_set("railpad.stiffness=80 km/h", "stiffness: \"80 km/h\" is not a plain number (unit N/m)");
    refused_set("railpad.stifness=1", "unknown key stifness in railpad, did you mean stiffness?");
    refused_set("zone.2.railpad.stiffness=1", "2 is not an item of a list of 1");
    refused_set("zone.0.railpad.stiffness=1", "0 is not an item of a list of 1");
    refused_set("zone.x.railpad.stiffness=1", "x is not an item of a list of 1");
    refused_set("spacing.x=1", "spacing: one value is wanted here, not a map");
    refused_set("railpad.stiffness", "should be KEY=VALUE");
    refused_set("railpad.stiffness=", "should be KEY=VALUE");
    refused_set("=1", "should be KEY=VALUE");
    refused_set("railpad..stiffness=1", "a key is empty");
    refused_set("railpad.stiffness={", "the value cannot be read");
}

static uint64_t hash_of(const char *text, char *set)
{
    if (read_set(text, set))
        return 0;
    yaml_release(&TRACK, &t);
    return hash;
}

static void hashes(void)
{
    char same[] = "railpad.stiffness=1", other[] = "railpad.stiffness=2";
    const char *text = "track: {railpad: {stiffness: 1}}";
    uint64_t plain = hash_of(text, NULL);

    ok(plain && plain == hash_of("# comment\ntrack:\n  railpad:\n    stiffness: 1.0\n", NULL), "layout and comments do not enter the hash");
    ok(plain == hash_of("track: {railpad: {damping: 50e3, stiffness: 1}}", NULL), "nor does a default written out");
    ok(plain == hash_of(text, same) && plain != hash_of(text, other), "an override enters by its value");
    ok(hash_of("track: {railpad: {stiffness: 1}, bending: {station: [1], value: [2]}}", NULL) !=
       hash_of("track: {railpad: {stiffness: 1}, bending: {number: [1], value: [2]}}", NULL), "a table over numbers is not one over stations");
}

/* The master file with its required keys filled in is a right input. */
static void master(void)
{
    char *text = NULL, filled[4096], *at;
    size_t n;
    FILE *out = open_memstream(&text, &n);

    yaml_print_master(&TRACK, out);
    fclose(out);
    at = strstr(text, "    stiffness:");
    ok(at && n < sizeof filled - 8, "the master file has the key that is required");
    snprintf(filled, sizeof filled, "%.*s    stiffness: 7%s", (int)(at - text), text, at + strlen("    stiffness:"));
    const char *why = read_set(filled, NULL);
    if (ok(!why && t.railpad.stiffness == 7 && t.spacing == 0.6, "filled in, it is read"))
        yaml_release(&TRACK, &t);
    else
        printf("# %s\n", why ? why : "another value");
    free(text);
}

int main(void)
{
    accepted();
    numbers();
    keys();
    shapes();
    beyond_the_subset();
    overrides();
    hashes();
    master();
    return done();
}
