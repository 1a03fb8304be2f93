/* A YAML text as a tree of maps, lists and scalars, each with its place: between the parts of yaml. */
#ifndef VX_FORMATS_YAML_TREE_H
#define VX_FORMATS_YAML_TREE_H

#include "formats/reason.h"

enum yaml_kind { YAML_SCALAR, YAML_MAPPING, YAML_SEQUENCE };

struct yaml_node {
    enum yaml_kind kind;
    int line, column;            /* from 1 */
    int key_line, key_column;    /* of its key, in a map */
    const char *set;             /* the override it came from, else NULL */
    char *text;                  /* of a scalar */
    int plain;                   /* scalar without quotes */
    int n;
    char **key;                  /* [n] of a map */
    struct yaml_node **child;    /* [n] */
};

/* Reads a file ("-" is standard input) or, where text is given, that text. */
const char *yaml_tree_read(const char *path, const char *text, struct yaml_node **root);
void yaml_tree_free(struct yaml_node *node);

/* Puts "key.key.3.key=value" into the tree below root; maps on the way are made, list items counted from 1. */
const char *yaml_tree_set(struct yaml_node *root, const char *set);

struct yaml_node *yaml_tree_find(const struct yaml_node *map, const char *key);

/* "path:line:column: error: message", or "--set ...: error: message". */
const char *yaml_error(const char *path, const struct yaml_node *at, const char *format, ...) VX_PRINTF(3, 4);

#endif
