/* A check between keys knows their names and not their places: the text is read once more for these. */
#include "formats/yaml.h"

#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "formats/yaml_tree.h"

/* The child of a map by its key, of a list by its number from 1, by a word of this length; NULL where there is none. */
static const struct yaml_node *child_of(const struct yaml_node *node, const char *word, size_t length)
{
    const long item = node->kind == YAML_SEQUENCE ? strtol(word, NULL, 10) : 0;

    for (int i = 0; i < node->n; i++)
        if (node->kind == YAML_SEQUENCE ? item == i + 1 : strlen(node->key[i]) == length && strncmp(node->key[i], word, length) == 0)
            return node->child[i];
    return NULL;
}

/* The deepest node on the path of keys that a sentence begins with, up to its colon. */
static const struct yaml_node *deepest(const struct yaml_node *top, const char *sentence)
{
    const struct yaml_node *next;

    for (const char *word = sentence; (next = child_of(top, word, strcspn(word, ".:, "))); word++) {
        top = next;
        word += strcspn(word, ".:, ");
        if (*word != '.')
            break;
    }
    return top;
}

const char *yaml_blame(const char *path, const struct yaml_schema *schema, char *const *set, int sets, const char *why)
{
    char *sentence = strdup(why);
    struct yaml_node *root = NULL;

    if (!sentence)
        return REASON_MEMORY;
    if (strcmp(path, "-") == 0 || yaml_tree_read(path, NULL, &root) || root->n != 1 || strcmp(root->key[0], schema->name) != 0)
        why = reason("%s: error: %s", strcmp(path, "-") ? path : "standard input", sentence);
    else {
        const struct yaml_node *top = root->child[0], *at = top;
        int applied = 1;
        for (int i = 0; i < sets && applied; i++)
            applied = !yaml_tree_set(root->child[0], set[i]);
        if (applied)
            at = deepest(top, sentence);
        why = at == top ? reason("%s: error: %s", path, sentence) : yaml_error(path, at, "%s", sentence);
    }
    yaml_tree_free(root);
    free(sentence);
    return why;
}
