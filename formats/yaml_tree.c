/* libyaml's events made into a tree.  Refused here: anchors, aliases, tags, a second document, doubled keys, keys that are
 * not plain words.  (libyaml passes doubled keys on, and reads {a: 1,2e8} as two entries, the second without a value.) */
#include "formats/yaml_tree.h"
#include "formats/reason.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <yaml.h>

struct reader {
    yaml_parser_t parser;
    yaml_event_t event;
    const char *path;
    const char *why;
};

const char *yaml_error(const char *path, const struct yaml_node *at, const char *format, ...)
{
    char message[400];
    va_list ap;

    va_start(ap, format);
    vsnprintf(message, sizeof message, format, ap);
    va_end(ap);
    if (at->set)
        return reason("--set %s: error: %s", at->set, message);
    return reason("%s:%d:%d: error: %s", path, at->line, at->column, message);
}

static struct yaml_node *new_node(enum yaml_kind kind, yaml_mark_t mark)
{
    struct yaml_node *node = calloc(1, sizeof *node);

    if (node) {
        node->kind = kind;
        node->line = (int)mark.line + 1;
        node->column = (int)mark.column + 1;
    }
    return node;
}

void yaml_tree_free(struct yaml_node *node)
{
    if (!node)
        return;
    for (int i = 0; i < node->n; i++) {
        if (node->key)
            free(node->key[i]);
        yaml_tree_free(node->child[i]);
    }
    free(node->key);
    free(node->child);
    free(node->text);
    free(node);
}

/* The next event into r->event; 0 with r->why set where there is none. */
static int next(struct reader *r)
{
    if (!yaml_parser_parse(&r->parser, &r->event)) {
        r->why = reason("%s:%zu:%zu: error: %s", r->path, r->parser.problem_mark.line + 1,
                        r->parser.problem_mark.column + 1, r->parser.problem ? r->parser.problem : "not readable");
        memset(&r->event, 0, sizeof r->event);
        return 0;
    }
    return 1;
}

static int fail(struct reader *r, yaml_mark_t mark, const char *message, const char *word)
{
    if (!r->why)
        r->why = reason("%s:%zu:%zu: error: %s%s", r->path, mark.line + 1, mark.column + 1, message, word);
    return 0;
}

/* Adds child (and, in a map, key) to node, which owns both from then on. */
static int add(struct yaml_node *node, char *key, struct yaml_node *child)
{
    struct yaml_node **children = realloc(node->child, (size_t)(node->n + 1) * sizeof *children);
    char **keys = node->key;

    if (children)
        node->child = children;
    if (node->kind == YAML_MAPPING && (keys = realloc(node->key, (size_t)(node->n + 1) * sizeof *keys)))
        node->key = keys;
    if (!children || !child || (node->kind == YAML_MAPPING && (!keys || !key))) {
        free(key);
        yaml_tree_free(child);
        return 0;
    }
    children[node->n] = child;
    if (node->kind == YAML_MAPPING)
        keys[node->n] = key;
    node->n++;
    return 1;
}

/* A NUL inside, which "a\0b" can say, becomes a space: the text would end there. */
static char *scalar_text(const yaml_event_t *event)
{
    size_t n = event->data.scalar.length;
    char *text = malloc(n + 1);

    if (!text)
        return NULL;
    memcpy(text, event->data.scalar.value, n);
    text[n] = 0;
    for (size_t i = 0; i < n; i++)
        if (!text[i])
            text[i] = ' ';
    return text;
}

static struct yaml_node *read_node(struct reader *r, int depth);

static int read_entry(struct reader *r, struct yaml_node *map, int depth)
{
    yaml_mark_t mark = r->event.start_mark;
    struct yaml_node *child;
    char *key;

    if (r->event.type != YAML_SCALAR_EVENT) {
        yaml_event_delete(&r->event);
        return fail(r, mark, "a key must be a word", "");
    }
    key = scalar_text(&r->event);
    yaml_event_delete(&r->event);
    if (!key || yaml_tree_find(map, key)) {
        fail(r, mark, key ? "this key stands twice: " : REASON_MEMORY, key ? key : "");
        free(key);
        return 0;
    }
    child = next(r) ? read_node(r, depth + 1) : NULL;
    if (!child) {
        free(key);
        return 0;
    }
    child->key_line = (int)mark.line + 1;
    child->key_column = (int)mark.column + 1;
    return add(map, key, child) || fail(r, mark, REASON_MEMORY, "");
}

static struct yaml_node *read_children(struct reader *r, enum yaml_kind kind, int depth)
{
    yaml_event_type_t end = kind == YAML_MAPPING ? YAML_MAPPING_END_EVENT : YAML_SEQUENCE_END_EVENT;
    struct yaml_node *node = new_node(kind, r->event.start_mark);
    int going = node != NULL;

    yaml_event_delete(&r->event);
    while (going && (going = next(r)) && r->event.type != end) {
        if (kind == YAML_MAPPING)
            going = read_entry(r, node, depth);
        else {
            struct yaml_node *child = read_node(r, depth + 1);
            going = child && (add(node, NULL, child) || fail(r, r->event.start_mark, REASON_MEMORY, ""));
        }
    }
    if (!going) {
        yaml_tree_free(node);
        return NULL;
    }
    yaml_event_delete(&r->event);
    return node;
}

static struct yaml_node *read_scalar(struct reader *r)
{
    struct yaml_node *node = new_node(YAML_SCALAR, r->event.start_mark);

    if (node) {
        node->text = scalar_text(&r->event);
        node->plain = r->event.data.scalar.style == YAML_PLAIN_SCALAR_STYLE;
    }
    yaml_event_delete(&r->event);
    if (node && !node->text) {
        yaml_tree_free(node);
        return NULL;
    }
    return node;
}

/* The node that r->event begins; the event is consumed. */
static struct yaml_node *read_node(struct reader *r, int depth)
{
    yaml_mark_t mark = r->event.start_mark;
    const char *what = NULL;

    if (depth > 32)
        what = "nested too deep";
    else if (r->event.type == YAML_ALIAS_EVENT)
        what = "aliases are not part of this input format";
    else if (r->event.type == YAML_SCALAR_EVENT && (r->event.data.scalar.anchor || r->event.data.scalar.tag))
        what = "anchors and tags are not part of this input format";
    else if (r->event.type == YAML_MAPPING_START_EVENT &&
             (r->event.data.mapping_start.anchor || r->event.data.mapping_start.tag))
        what = "anchors and tags are not part of this input format";
    else if (r->event.type == YAML_SEQUENCE_START_EVENT &&
             (r->event.data.sequence_start.anchor || r->event.data.sequence_start.tag))
        what = "anchors and tags are not part of this input format";
    if (what) {
        yaml_event_delete(&r->event);
        fail(r, mark, what, "");
        return NULL;
    }
    if (r->event.type == YAML_MAPPING_START_EVENT)
        return read_children(r, YAML_MAPPING, depth);
    if (r->event.type == YAML_SEQUENCE_START_EVENT)
        return read_children(r, YAML_SEQUENCE, depth);
    return read_scalar(r);
}

/* Stream start, one document, stream end. */
static struct yaml_node *read_document(struct reader *r)
{
    struct yaml_node *root = NULL;

    while (!r->why && next(r)) {
        yaml_event_type_t type = r->event.type;
        if (type == YAML_STREAM_END_EVENT) {
            yaml_event_delete(&r->event);
            break;
        }
        if (type == YAML_STREAM_START_EVENT || type == YAML_DOCUMENT_START_EVENT || type == YAML_DOCUMENT_END_EVENT)
            yaml_event_delete(&r->event);
        else if (root) {
            fail(r, r->event.start_mark, "a second document", "");
            yaml_event_delete(&r->event);
        } else if (!(root = read_node(r, 0)) && !r->why)
            r->why = REASON_MEMORY;
    }
    if (!root && !r->why)
        r->why = reason("%s: empty input", r->path);
    if (r->why) {
        yaml_tree_free(root);
        return NULL;
    }
    return root;
}

const char *yaml_tree_read(const char *path, const char *text, struct yaml_node **root)
{
    struct reader r = {.path = text || strcmp(path, "-") ? path : "standard input"};
    FILE *file = NULL;

    *root = NULL;
    if (!text && !(file = strcmp(path, "-") == 0 ? stdin : fopen(path, "rb")))
        return reason("%s: %s", path, strerror(errno));
    if (!yaml_parser_initialize(&r.parser)) {
        if (file && file != stdin)
            fclose(file);
        return REASON_MEMORY;
    }
    if (text)
        yaml_parser_set_input_string(&r.parser, (const unsigned char *)text, strlen(text));
    else
        yaml_parser_set_input_file(&r.parser, file);
    *root = read_document(&r);
    if (file && ferror(file))          /* libyaml says no more than "input error": of a folder, say */
        r.why = reason("%s: %s", r.path, strerror(errno));
    yaml_parser_delete(&r.parser);
    if (file && file != stdin)
        fclose(file);
    return r.why;
}

struct yaml_node *yaml_tree_find(const struct yaml_node *map, const char *key)
{
    for (int i = 0; i < map->n; i++)
        if (map->key && strcmp(map->key[i], key) == 0)
            return map->child[i];
    return NULL;
}

/* ---- overrides ---- */

static void mark_set(struct yaml_node *node, const char *set)
{
    node->set = set;
    for (int i = 0; i < node->n; i++)
        mark_set(node->child[i], set);
}

/* Where child `word` of node hangs; a map gets an empty one where it has none. */
static const char *step(struct yaml_node *node, const char *word, const char *set, struct yaml_node ***place)
{
    char *end;
    long item;

    if (node->kind == YAML_SEQUENCE) {
        item = strtol(word, &end, 10);
        if (end == word || *end || item < 1 || item > node->n)
            return reason("--set %s: error: %s is not an item of a list of %d", set, word, node->n);
        *place = &node->child[item - 1];
        return NULL;
    }
    if (node->kind != YAML_MAPPING)
        return reason("--set %s: error: %s stands below a value, not below a map", set, word);
    for (int i = 0; i < node->n; i++)
        if (strcmp(node->key[i], word) == 0) {
            *place = &node->child[i];
            return NULL;
        }
    struct yaml_node *made = new_node(YAML_MAPPING, (yaml_mark_t){0});
    if (made)
        made->set = set;
    if (!add(node, strdup(word), made))
        return REASON_MEMORY;
    *place = &node->child[node->n - 1];
    return NULL;
}

const char *yaml_tree_set(struct yaml_node *root, const char *set)
{
    const char *value = strchr(set, '='), *why = NULL;
    struct yaml_node **place = NULL, *node;
    char *path, *rest, *word;

    if (!value || value == set || !value[1])
        return reason("--set %s: error: should be KEY=VALUE", set);
    if ((why = yaml_tree_read("value", value + 1, &node)))
        return reason("--set %s: error: the value cannot be read", set);
    mark_set(node, set);
    path = strndup(set, (size_t)(value - set));
    if (!path)
        why = REASON_MEMORY;
    for (word = path; word && !why; word = rest) {
        if ((rest = strchr(word, '.')))
            *rest++ = 0;
        why = *word ? step(place ? *place : root, word, set, &place) : reason("--set %s: error: a key is empty", set);
    }
    free(path);
    if (why) {
        yaml_tree_free(node);
        return why;
    }
    yaml_tree_free(*place);
    *place = node;
    return NULL;
}
