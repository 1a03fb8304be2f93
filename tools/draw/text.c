/* FreeType without hinting, so that widths scale and rotated strings look like the others. */
#include "tools/draw/text.h"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "formats/reason.h"

static const char family[] = "DejaVu Sans";
static const double capital = 0.729;    /* of the em: height of a capital and of a digit of DejaVu Sans */

/* Path of the installed font nearest to the family, into path[size]. */
static const char *font_path(enum text_weight weight, char *path, size_t size)
{
    FcPattern *want = FcPatternCreate(), *got = NULL;
    FcResult result;
    FcChar8 *file;
    const char *why = "no font found (DejaVu Sans is in the package fonts-dejavu-core)";

    if (!want)
        return REASON_MEMORY;
    FcPatternAddString(want, FC_FAMILY, (const FcChar8 *)family);
    FcPatternAddInteger(want, FC_WEIGHT, weight == TEXT_BOLD ? FC_WEIGHT_BOLD : FC_WEIGHT_BOOK);
    FcConfigSubstitute(NULL, want, FcMatchPattern);
    FcDefaultSubstitute(want);
    got = FcFontMatch(NULL, want, &result);
    if (got && FcPatternGetString(got, FC_FILE, 0, &file) == FcResultMatch &&
        snprintf(path, size, "%s", (const char *)file) < (int)size)
        why = NULL;
    if (got)
        FcPatternDestroy(got);
    FcPatternDestroy(want);
    return why;
}

const char *text_open(struct text *t)
{
    char path[1024];
    const char *why;

    *t = (struct text){0};
    if (!FcInit())
        return "fontconfig does not start";
    FT_Library library;
    if (FT_Init_FreeType(&library) != 0)
        return "FreeType does not start";
    t->library = library;
    for (enum text_weight w = 0; w < TEXT_WEIGHTS; w++) {
        FT_Face face = NULL;
        why = font_path(w, path, sizeof path);
        if (!why && FT_New_Face(library, path, 0, &face) != 0)
            why = reason("%s: not a font FreeType reads", path);
        if (why) {
            text_free(t);
            return why;
        }
        t->face[w] = face;
    }
    return NULL;
}

void text_free(struct text *t)
{
    if (t->library)
        FT_Done_FreeType(t->library);
    free(t->word);
    *t = (struct text){0};
}

/* The next character of a UTF-8 string; a stray byte stands for itself. */
static unsigned long character(const char **s)
{
    const unsigned char *p = (const unsigned char *)*s;
    int more = p[0] >= 0xf0 ? 3 : p[0] >= 0xe0 ? 2 : p[0] >= 0xc0 ? 1 : 0;
    unsigned long code = more ? p[0] & (0x3fu >> more) : p[0];

    for (int k = 1; k <= more; k++) {
        if ((p[k] & 0xc0) != 0x80) {
            *s += 1;
            return p[0];
        }
        code = code << 6 | (p[k] & 0x3f);
    }
    *s += 1 + more;
    return code;
}

/* Distance in px to add before `glyph` when it follows `last`. */
static double kerning(FT_Face face, FT_UInt last, FT_UInt glyph)
{
    FT_Vector delta = {0, 0};

    if (last && FT_HAS_KERNING(face))
        FT_Get_Kerning(face, last, glyph, FT_KERNING_UNFITTED, &delta);
    return (double)delta.x / 64;
}

double text_width(const struct text *t, const char *string, double size, enum text_weight weight)
{
    FT_Face face = t->face[weight];
    FT_UInt last = 0;
    double width = 0;

    FT_Set_Char_Size(face, 0, (FT_F26Dot6)lround(64 * size), 72, 72);
    FT_Set_Transform(face, NULL, NULL);
    while (*string) {
        FT_UInt glyph = FT_Get_Char_Index(face, character(&string));
        if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING) != 0)
            continue;
        width += kerning(face, last, glyph) + (double)face->glyph->linearHoriAdvance / 65536;
        last = glyph;
    }
    return width;
}

double text_height(double size)
{
    return capital * size;
}

void text_add(struct text *t, double x, double y, const struct text_style *style, const char *string)
{
    if (t->n == t->room) {
        int room = t->room ? 2 * t->room : 64;
        struct text_word *more = realloc(t->word, (size_t)room * sizeof *more);
        if (!more) {
            t->why = REASON_MEMORY;
            return;
        }
        t->word = more;
        t->room = room;
    }
    struct text_word *w = &t->word[t->n++];
    *w = (struct text_word){.x = x, .y = y, .style = *style};
    snprintf(w->string, sizeof w->string, "%s", string);
}

/* Blends a glyph, grey [rows][pitch], into the picture with its upper left corner at (left, top). */
static void blend(struct canvas *c, const FT_Bitmap *grey, int left, int top, unsigned colour)
{
    const int ink[3] = {(int)(colour >> 16 & 255), (int)(colour >> 8 & 255), (int)(colour & 255)};

    for (int j = 0; j < (int)grey->rows; j++)
        for (int i = 0; i < (int)grey->width; i++) {
            int x = left + i, y = top + j, cover = grey->buffer[j * grey->pitch + i];
            if (x < 0 || y < 0 || x >= c->width || y >= c->height)
                continue;
            unsigned char *to = c->rgb + 3 * ((size_t)y * (size_t)c->width + (size_t)x);
            for (int k = 0; k < 3; k++)
                to[k] = (unsigned char)((to[k] * (255 - cover) + ink[k] * cover + 127) / 255);
        }
}

static void paint_word(const struct text *t, struct canvas *c, const struct text_word *w)
{
    const struct text_style *s = &w->style;
    FT_Face face = t->face[s->weight];
    double along = -s->across * text_width(t, w->string, s->size, s->weight), up = s->up * text_height(s->size);
    FT_Matrix quarter = {0, -0x10000, 0x10000, 0};
    FT_UInt last = 0;

    for (const char *p = w->string; *p;) {
        FT_UInt glyph = FT_Get_Char_Index(face, character(&p));
        along += kerning(face, last, glyph);
        last = glyph;
        /* FreeType's y is up: the base line runs to the right, or upwards where the string is turned. */
        double x = s->upright ? w->x + up : w->x + along, y = s->upright ? w->y - along : w->y + up;
        FT_Vector part = {(FT_Pos)lround(64 * (x - floor(x))), (FT_Pos)lround(64 * (ceil(y) - y))};
        FT_Set_Transform(face, s->upright ? &quarter : NULL, &part);
        if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_RENDER) != 0)
            continue;
        blend(c, &face->glyph->bitmap, (int)floor(x) + face->glyph->bitmap_left, (int)ceil(y) - face->glyph->bitmap_top,
              s->colour);
        along += (double)face->glyph->linearHoriAdvance / 65536;
    }
}

const char *text_paint(const struct text *t, struct canvas *c)
{
    for (int i = 0; i < t->n; i++)
        paint_word(t, c, &t->word[i]);
    return t->why;
}
