/* The walker: a tree against a schema table, into a struct.  A number is a number: what follows it, a decimal comma, a leading
 * zero, nan, an unknown, doubled or missing key are each refused with their place. */
#include "formats/yaml.h"
#include "formats/reason.h"
#include "formats/word.h"
#include "formats/yaml_tree.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#define LARGEST_INT 9007199254740992.0 /* 2^53: whole numbers are exact up to here */

struct walk {
    const char *path;
    XXH64_state_t *hash;
};

static const char *walk_map(struct walk *w, const struct yaml_schema *schema, const struct yaml_node *node, void *object);

/* ---- scalars ---- */

static void hash_text(struct walk *w, const char *text)
{
    XXH64_update(w->hash, text, strlen(text) + 1);
}

static void hash_number(struct walk *w, double value)
{
    XXH64_update(w->hash, &value, sizeof value);
}

static const char *scalar(struct walk *w, const struct yaml_field *f, const struct yaml_node *node)
{
    if (node->kind != YAML_SCALAR)
        return yaml_error(w->path, node, "%s: one value is wanted here, not a %s", f->key,
                          node->kind == YAML_MAPPING ? "map" : "list");
    if (node->plain && (!*node->text || strcmp(node->text, "null") == 0 || strcmp(node->text, "~") == 0))
        return yaml_error(w->path, node, "%s has no value", f->key);
    return NULL;
}

static const char *range(struct walk *w, const struct yaml_field *f, const struct yaml_node *node, double x)
{
    char lo[32] = "", hi[32] = "";
    const char *unit = strcmp(f->unit, "1") ? f->unit : "";     /* "at most 1", not "at most 1 1" */

    if (x >= f->lo && x <= f->hi)
        return NULL;
    if (f->lo == YAML_POSITIVE)
        snprintf(lo, sizeof lo, "greater than 0");
    else if (f->lo > -YAML_NO_LIMIT)
        snprintf(lo, sizeof lo, "at least %g", f->lo);
    if (f->hi < YAML_NO_LIMIT)
        snprintf(hi, sizeof hi, "%sat most %g", *lo ? " and " : "", f->hi);
    return yaml_error(w->path, node, "%s must be %s%s%s%s, not %s", f->key, lo, hi, *unit ? " " : "", unit, node->text);
}

static const char *number(struct walk *w, const struct yaml_field *f, const struct yaml_node *node, double *value)
{
    const char *why = scalar(w, f, node), *digits;
    char *end;

    if (why)
        return why;
    digits = node->text + (*node->text == '-' || *node->text == '+');
    errno = 0;
    *value = strtod(node->text, &end);
    if (!node->plain || *end || strspn(node->text, "0123456789+-.eE") != strlen(node->text) ||
        (digits[0] == '0' && digits[1] >= '0' && digits[1] <= '9'))
        return yaml_error(w->path, node, "%s: \"%s\" is not a plain number (unit %s)", f->key, node->text, f->unit);
    if (!isfinite(*value) || (errno == ERANGE && fabs(*value) > 1))
        return yaml_error(w->path, node, "%s: %s is out of range", f->key, node->text);
    if (f->type == YAML_INT && strspn(node->text, "0123456789+-") != strlen(node->text))
        return yaml_error(w->path, node, "%s: %s is not a whole number", f->key, node->text);
    if (f->type == YAML_INT && fabs(*value) > LARGEST_INT)
        return yaml_error(w->path, node, "%s: %s is out of range", f->key, node->text);
    hash_number(w, *value);
    return range(w, f, node, *value);
}

static const char *text(struct walk *w, const struct yaml_field *f, const struct yaml_node *node, char **to)
{
    const char *why = scalar(w, f, node);

    if (why)
        return why;
    hash_text(w, node->text);
    return (*to = strdup(node->text)) ? NULL : REASON_MEMORY;
}

static const char *boolean(struct walk *w, const struct yaml_field *f, const struct yaml_node *node, int *to)
{
    const char *why = scalar(w, f, node);

    if (why)
        return why;
    *to = strcmp(node->text, "true") == 0;
    hash_text(w, node->text);
    return *to || strcmp(node->text, "false") == 0
               ? NULL
               : yaml_error(w->path, node, "%s must be true or false, not \"%s\"", f->key, node->text);
}

static const char *choice(struct walk *w, const struct yaml_field *f, const struct yaml_node *node, int *to)
{
    const char *why = scalar(w, f, node);
    char all[200] = "";

    if (why)
        return why;
    hash_text(w, node->text);
    for (*to = 0; f->choice[*to]; ++*to) {
        if (strcmp(f->choice[*to], node->text) == 0)
            return NULL;
        snprintf(all + strlen(all), sizeof all - strlen(all), "%s%s", *to ? ", " : "", f->choice[*to]);
    }
    return yaml_error(w->path, node, "%s must be one of %s, not \"%s\"", f->key, all, node->text);
}

/* ---- lists and tables ---- */

static const char *numbers(struct walk *w, const struct yaml_field *f, const struct yaml_node *node, struct yaml_nums *to)
{
    const char *why = NULL;
    int one = node->kind == YAML_SCALAR;

    if (node->kind == YAML_MAPPING)
        return yaml_error(w->path, node, "%s: a list of numbers is wanted here, not a map", f->key);
    to->n = one ? 1 : node->n;
    to->x = calloc((size_t)to->n + 1, sizeof *to->x);
    if (!to->x)
        return REASON_MEMORY;
    hash_number(w, (double)to->n);
    for (int i = 0; i < to->n && !why; i++)
        why = number(w, f, one ? node : node->child[i], &to->x[i]);
    return why;
}

static const char *pairs(struct walk *w, const struct yaml_field *f, const struct yaml_node *node, struct yaml_nums *to)
{
    const char *why = NULL;

    if (node->kind != YAML_SEQUENCE)
        return yaml_error(w->path, node, "%s: a list of pairs [a, b] is wanted here", f->key);
    to->n = 2 * node->n;
    to->x = calloc((size_t)to->n + 1, sizeof *to->x);
    if (!to->x)
        return REASON_MEMORY;
    hash_number(w, (double)to->n);
    for (int i = 0; i < node->n && !why; i++) {
        const struct yaml_node *pair = node->child[i];
        if (pair->kind != YAML_SEQUENCE || pair->n != 2)
            return yaml_error(w->path, pair, "%s: a pair [a, b] is wanted here", f->key);
        if (!(why = number(w, f, pair->child[0], &to->x[2 * i])))
            why = number(w, f, pair->child[1], &to->x[2 * i + 1]);
    }
    return why;
}

static const char *table(struct walk *w, const struct yaml_field *f, const struct yaml_node *node, struct yaml_table *to)
{
    struct yaml_field axis = {.key = f->key, .type = YAML_NUM, .lo = -YAML_NO_LIMIT, .hi = YAML_NO_LIMIT};
    struct yaml_nums at = {0}, value = {0};
    const struct yaml_node *over, *values;
    const char *why;

    if (node->kind != YAML_MAPPING) {
        to->n = 1;
        to->at = calloc(1, sizeof *to->at);
        to->value = calloc(1, sizeof *to->value);
        return to->at && to->value ? number(w, f, node, to->value) : REASON_MEMORY;
    }
    to->by_number = yaml_tree_find(node, "number") != NULL;
    hash_number(w, to->by_number);
    axis.unit = to->by_number ? "sleeper number" : "m";
    over = yaml_tree_find(node, to->by_number ? "number" : "station");
    values = yaml_tree_find(node, "value");
    if (node->n != 2 || !over || !values)
        return yaml_error(w->path, node, "%s: one number, or {station: [...], value: [...]}, or {number: [...], "
                          "value: [...]} is wanted here", f->key);
    why = numbers(w, &axis, over, &at);
    if (!why)
        why = numbers(w, f, values, &value);
    to->n = at.n;
    to->at = at.x;
    to->value = value.x;
    if (!why && (at.n != value.n || at.n < 1))
        why = yaml_error(w->path, node, "%s: %lld places but %lld values", f->key, (long long)at.n, (long long)value.n);
    for (int64_t i = 1; !why && i < at.n; i++)
        if (!(at.x[i] > at.x[i - 1]))
            why = yaml_error(w->path, over->child[i], "%s: places must increase, %g after %g", f->key, at.x[i], at.x[i - 1]);
    return why;
}

static const char *items(struct walk *w, const struct yaml_field *f, const struct yaml_node *node, struct yaml_list *to)
{
    const char *why = NULL;

    if (node->kind != YAML_SEQUENCE)
        return yaml_error(w->path, node, "%s: a list is wanted here", f->key);
    to->item = calloc((size_t)node->n + 1, f->sub->size);
    to->line = calloc((size_t)node->n + 1, sizeof *to->line);
    if (!to->item || !to->line)
        return REASON_MEMORY;
    to->n = node->n;
    for (int i = 0; i < node->n; i++)
        to->line[i] = node->child[i]->set ? 0 : node->child[i]->line;
    hash_number(w, (double)to->n);
    for (int i = 0; i < node->n && !why; i++)
        why = walk_map(w, f->sub, node->child[i], (char *)to->item + (size_t)i * f->sub->size);
    return why;
}

/* ---- maps ---- */

static const char *value(struct walk *w, const struct yaml_field *f, const struct yaml_node *node, void *to)
{
    const char *why;
    double x;

    switch (f->type) {
    case YAML_NUM:
        return number(w, f, node, to);
    case YAML_INT:
        why = number(w, f, node, &x);
        *(int64_t *)to = why ? 0 : (int64_t)x;
        return why;
    case YAML_BOOL:
        return boolean(w, f, node, to);
    case YAML_TEXT:
        return text(w, f, node, to);
    case YAML_CHOICE:
        return choice(w, f, node, to);
    case YAML_NUMS:
        return numbers(w, f, node, to);
    case YAML_PAIRS:
        return pairs(w, f, node, to);
    case YAML_TABLE:
        return table(w, f, node, to);
    case YAML_MAP:
        return walk_map(w, f->sub, node, to);
    case YAML_LIST:
        return items(w, f, node, to);
    }
    return "BUG: a schema names an unknown type";
}

/* The default is YAML itself, so that it reads the same in --master and here. */
static const char *default_value(struct walk *w, const struct yaml_field *f, void *to)
{
    struct yaml_node *node;
    const char *why;

    if (strcmp(f->value, YAML_ABSENT) == 0)
        return NULL;
    if ((why = yaml_tree_read("default", f->value, &node)))
        return why;
    why = value(w, f, node, to);
    yaml_tree_free(node);
    return why;
}

/* The place is that of the key.  A key that is a number is what follows a decimal comma in {a: 1,2e8}. */
static const char *unknown(struct walk *w, const struct yaml_schema *schema, const struct yaml_node *child, const char *key)
{
    const struct yaml_node at = {.set = child->set, .line = child->key_line, .column = child->key_column};
    const char *nearest = NULL;
    int least = (int)strlen(key) / 2 + 1;

    if (least > 4)
        least = 4;
    for (const struct yaml_field *f = schema->field; f->key; f++)
        if (word_distance(key, f->key) < least) {
            least = word_distance(key, f->key);
            nearest = f->key;
        }
    if (nearest)
        return yaml_error(w->path, &at, "unknown key %s in %s, did you mean %s?", key, schema->name, nearest);
    return yaml_error(w->path, &at, "unknown key %s in %s%s", key, schema->name,
                      *key >= '0' && *key <= '9' ? " (numbers have a decimal point, not a comma)" : "");
}

static const struct yaml_field *field_of(const struct yaml_schema *schema, const char *key)
{
    for (const struct yaml_field *f = schema->field; f->key; f++)
        if (strcmp(f->key, key) == 0)
            return f;
    return NULL;
}

static const char *walk_map(struct walk *w, const struct yaml_schema *schema, const struct yaml_node *node, void *object)
{
    const char *why = NULL;

    if (node->kind != YAML_MAPPING)
        return yaml_error(w->path, node, "%s: keys with values are wanted here", schema->name);
    for (int i = 0; i < node->n; i++)
        if (!field_of(schema, node->key[i]))
            return unknown(w, schema, node->child[i], node->key[i]);
    for (const struct yaml_field *f = schema->field; f->key && !why; f++) {
        const struct yaml_node *child = yaml_tree_find(node, f->key);
        hash_text(w, f->key);
        if (child)
            why = value(w, f, child, (char *)object + f->at);
        else if (f->value)
            why = default_value(w, f, (char *)object + f->at);
        else
            why = yaml_error(w->path, node, "key %s is missing in %s", f->key, schema->name);
    }
    return why;
}

static const char *walk_root(struct walk *w, const struct yaml_schema *schema, struct yaml_node *root, char *const *set,
                             int sets, void *object)
{
    struct yaml_node *top;
    const char *why = NULL;

    if (root->kind != YAML_MAPPING || root->n != 1 || strcmp(root->key[0], schema->name) != 0)
        return yaml_error(w->path, root, "the file must begin with the one key %s:", schema->name);
    top = root->child[0];
    for (int i = 0; i < sets && !why; i++)
        why = yaml_tree_set(top, set[i]);
    return why ? why : walk_map(w, schema, top, object);
}

static const char *read_from(const char *path, const char *text_, const struct yaml_schema *schema, char *const *set, int sets,
                             void *object, uint64_t *hash)
{
    struct walk w = {.path = strcmp(path, "-") ? path : "standard input", .hash = XXH64_createState()};
    struct yaml_node *root = NULL;
    const char *why = w.hash ? yaml_tree_read(path, text_, &root) : REASON_MEMORY;

    memset(object, 0, schema->size);
    if (!why) {
        XXH64_reset(w.hash, 0);
        why = walk_root(&w, schema, root, set, sets, object);
        if (hash)
            *hash = XXH64_digest(w.hash);
    }
    yaml_tree_free(root);
    XXH64_freeState(w.hash);
    if (why)
        yaml_release(schema, object);
    return why;
}

const char *yaml_read(const char *path, const struct yaml_schema *schema, char *const *set, int sets, void *object,
                      uint64_t *hash)
{
    return read_from(path, NULL, schema, set, sets, object, hash);
}

const char *yaml_read_text(const char *text_, const struct yaml_schema *schema, char *const *set, int sets, void *object,
                           uint64_t *hash)
{
    return read_from("text", text_, schema, set, sets, object, hash);
}

void yaml_release(const struct yaml_schema *schema, void *object)
{
    for (const struct yaml_field *f = schema->field; f->key; f++) {
        void *at = (char *)object + f->at;
        struct yaml_list *list = at;
        if (f->type == YAML_TEXT)
            free(*(char **)at);
        else if (f->type == YAML_NUMS || f->type == YAML_PAIRS)
            free(((struct yaml_nums *)at)->x);
        else if (f->type == YAML_TABLE) {
            free(((struct yaml_table *)at)->at);
            free(((struct yaml_table *)at)->value);
        } else if (f->type == YAML_MAP)
            yaml_release(f->sub, at);
        else if (f->type == YAML_LIST) {
            for (int64_t i = 0; i < list->n; i++)
                yaml_release(f->sub, (char *)list->item + (size_t)i * f->sub->size);
            free(list->item);
            free(list->line);
        }
    }
    memset(object, 0, schema->size);
}
