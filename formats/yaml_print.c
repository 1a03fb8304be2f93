/* A schema table as text: --schema, one line a key, and --master, an input to fill in. */
#include "formats/yaml.h"

#include <string.h>

static const char *type_names[] = {
    [YAML_NUM] = "number",   [YAML_INT] = "whole number", [YAML_BOOL] = "true or false", [YAML_TEXT] = "text",
    [YAML_CHOICE] = "word",  [YAML_NUMS] = "numbers",     [YAML_PAIRS] = "pairs",        [YAML_TABLE] = "number or table",
    [YAML_MAP] = "map",      [YAML_LIST] = "list",
};

static int has_unit(const struct yaml_field *f)
{
    return f->unit && *f->unit;
}

static void print_range(const struct yaml_field *f, FILE *out)
{
    if (f->type == YAML_CHOICE)
        for (int k = 0; f->choice[k]; k++)
            fprintf(out, "%s%s", k ? "|" : "", f->choice[k]);
    else if (f->lo == YAML_POSITIVE)
        fputs("> 0", out);
    else if (f->lo > -YAML_NO_LIMIT && f->lo < f->hi)
        fprintf(out, ">= %g", f->lo);
    if (f->type != YAML_CHOICE && f->hi < YAML_NO_LIMIT && f->lo < f->hi)
        fprintf(out, "%s<= %g", f->lo > -YAML_NO_LIMIT ? ", " : "", f->hi);
}

static void print_fields(const struct yaml_schema *schema, const char *above, FILE *out)
{
    for (const struct yaml_field *f = schema->field; f->key; f++) {
        char path[256];
        snprintf(path, sizeof path, "%s%s%s", above, *above ? "." : "", f->key);
        fprintf(out, "%s\t%s\t%s\t", path, type_names[f->type], has_unit(f) ? f->unit : "-");
        print_range(f, out);
        fprintf(out, "\t%s\t%s\n", !f->value ? "required" : *f->value ? f->value : "absent", f->help);
        if (f->type == YAML_LIST)
            snprintf(path + strlen(path), sizeof path - strlen(path), ".N");
        if (f->sub)
            print_fields(f->sub, path, out);
    }
}

void yaml_print_schema(const struct yaml_schema *schema, FILE *out)
{
    fputs("key\ttype\tunit\trange\tdefault\tmeaning\n", out);
    print_fields(schema, "", out);
}

/* Keys absent by default are commented out; the first item of a list begins with a dash. */
static void print_master(const struct yaml_schema *schema, int indent, int dash, int off, FILE *out)
{
    for (const struct yaml_field *f = schema->field; f->key; f++) {
        int hidden = off || (f->value && (!*f->value || strcmp(f->value, "[]") == 0));
        fprintf(out, "%*s%s%s%s:", indent - (dash ? 2 : 0), "", hidden ? "# " : "", dash ? "- " : "", f->key);
        if (f->type != YAML_MAP && f->type != YAML_LIST)
            fprintf(out, " %s", f->value && *f->value ? f->value : "");
        fprintf(out, "  # %s", f->help);
        if (has_unit(f))
            fprintf(out, " [%s]", f->unit);
        if (!f->value)
            fputs(" (required)", out);
        fputc('\n', out);
        if (f->sub)
            print_master(f->sub, indent + (f->type == YAML_LIST ? 4 : 2), f->type == YAML_LIST, hidden, out);
        dash = 0;
    }
}

void yaml_print_master(const struct yaml_schema *schema, FILE *out)
{
    fprintf(out, "%s:\n", schema->name);
    print_master(schema, 2, 0, 0, out);
}
