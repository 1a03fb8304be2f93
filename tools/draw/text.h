/* Words on a picture: DejaVu Sans by FreeType, collected while the canvas is drawn and painted onto its pixels after canvas_end. */
#ifndef VX_DRAW_TEXT_H
#define VX_DRAW_TEXT_H

#include "tools/draw/canvas.h"

enum { TEXT_MOST = 160 };     /* bytes of one string */

enum text_weight { TEXT_BOOK, TEXT_BOLD, TEXT_WEIGHTS };

/* How a string is set.  The point (x, y) lies at the fraction `across` of its width (0 left, 1 right end) and at the
 * fraction `up` of the height of its capitals (0 base line, 1 their top); upright strings read upwards. */
struct text_style {
    double size;              /* px, of the em */
    enum text_weight weight;
    unsigned colour;          /* 0xRRGGBB */
    double across, up;
    int upright;
};

struct text_word {
    char string[TEXT_MOST];   /* UTF-8 */
    double x, y;              /* px */
    struct text_style style;
};

struct text {
    void *library;
    void *face[TEXT_WEIGHTS];
    int n, room;
    struct text_word *word;   /* [n] */
    const char *why;          /* first failure of text_add, told by text_paint */
};

/* Finds and loads the fonts; text_free accepts a zeroed or failed one. */
const char *text_open(struct text *t);
void text_free(struct text *t);

double text_width(const struct text *t, const char *string, double size, enum text_weight weight);   /* px */
double text_height(double size);                                                                     /* px, of a capital */

void text_add(struct text *t, double x, double y, const struct text_style *style, const char *string);
const char *text_paint(const struct text *t, struct canvas *c);

#endif
