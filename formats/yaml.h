/* Inputs written by people: a plain subset of YAML read against a schema table.
 *
 * The subset: maps, lists (block or flow), plain or quoted scalars, comments.  Anchors, aliases, tags, several documents, doubled keys
 * and keys without a value are refused.  One table per kind of input names every key with type, unit, range, default and help;
 * the same table prints --schema and --master.  Every refusal reads "file:line:column: error: ...". */
#ifndef VX_FORMATS_YAML_H
#define VX_FORMATS_YAML_H

#include <float.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum yaml_type {
    YAML_NUM,     /* double */
    YAML_INT,     /* int64_t */
    YAML_BOOL,    /* int: true or false */
    YAML_TEXT,    /* char *, allocated */
    YAML_CHOICE,  /* int: index into choice[] */
    YAML_NUMS,    /* struct yaml_nums: a list of numbers, or one */
    YAML_PAIRS,   /* struct yaml_nums: a list of [a, b] pairs, n counts numbers */
    YAML_TABLE,   /* struct yaml_table: one number, or {station: [...], value: [...]} or {number: [...], value: [...]} */
    YAML_MAP,     /* the struct of sub, in place */
    YAML_LIST     /* struct yaml_list of the struct of sub */
};

struct yaml_nums { int64_t n; double *x; };
struct yaml_list { int64_t n; void *item; int *line; };   /* line[n] of each item in its file, 0 of an override */

/* Over station (m) or sleeper number; straight between the knots, constant beyond them. */
struct yaml_table {
    int64_t n;                  /* 1 is a constant */
    int by_number;              /* knots are sleeper numbers, not stations */
    double *at, *value;         /* [n] */
};

#define YAML_POSITIVE DBL_MIN   /* as lo: greater than zero */
#define YAML_NO_LIMIT DBL_MAX

struct yaml_schema;

struct yaml_field {
    const char *key;
    enum yaml_type type;
    size_t at;                  /* offsetof in the struct */
    double lo, hi;              /* range of every number, both ends included */
    const char *unit;
    const char *value;          /* default as written in YAML; NULL is required; YAML_ABSENT leaves the struct's zero */
    const char *help;
    const struct yaml_schema *sub;
    const char *const *choice;  /* NULL-terminated */
};
#define YAML_ABSENT ""

struct yaml_schema {
    const char *name;           /* of the top: the one key at the root of the file */
    size_t size;                /* of the struct */
    const struct yaml_field *field; /* up to one with key NULL */
};

/* Reads path ("-" is standard input) into *object (schema->size bytes, zeroed here), after the overrides set[0..sets-1],
 * each "key.key.3.key=value" counted below the root key, list items from 1.  *hash covers the values read, not comments or layout. */
const char *yaml_read(const char *path, const struct yaml_schema *schema, char *const *set, int sets, void *object,
                      uint64_t *hash);
/* The same from a text that no file holds. */
const char *yaml_read_text(const char *text, const struct yaml_schema *schema, char *const *set, int sets, void *object,
                           uint64_t *hash);
/* Why a check between keys refused an object read so, "zone.2.sleepers: ...", as "file:line:column: error: zone.2.sleepers: ...", or after
 * the override that the key came from; without a place for what came from standard input or names no key. */
const char *yaml_blame(const char *path, const struct yaml_schema *schema, char *const *set, int sets, const char *why);

/* Not yaml_free: libyaml exports that name, and would call ours. */
void yaml_release(const struct yaml_schema *schema, void *object);

/* Every key, a line each: path, type, unit, range, default, help. */
void yaml_print_schema(const struct yaml_schema *schema, FILE *out);
/* A commented input file with every key and its default. */
void yaml_print_master(const struct yaml_schema *schema, FILE *out);

double yaml_table_at(const struct yaml_table *t, double station, double number);

#endif
