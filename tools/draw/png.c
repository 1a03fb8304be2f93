/* libpng with its settings fixed: filter and level decide the bytes. */
#include "tools/draw/png.h"

#include <png.h>
#include <setjmp.h>

#include "formats/reason.h"

static const double paper = 0.16;       /* m, width in print */
enum { LEVEL = 6 };                     /* of zlib */

static void fails(png_structp png, png_const_charp why)
{
    *(const char **)png_get_error_ptr(png) = reason("PNG: %s", why);
    png_longjmp(png, 1);
}

static void warns(png_structp png, png_const_charp why)
{
    (void)png;
    (void)why;
}

static void put_rows(png_structp png, png_infop info, int width, int height, const unsigned char *rgb, const char *history)
{
    png_uint_32 per_metre = (png_uint_32)(width / paper);
    char key[] = "Comment";
    png_text comment = {.compression = PNG_TEXT_COMPRESSION_NONE, .key = key, .text = (char *)history};

    png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_pHYs(png, info, per_metre, per_metre, PNG_RESOLUTION_METER);
    if (history)
        png_set_text(png, info, &comment, 1);
    png_set_compression_level(png, LEVEL);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_write_info(png, info);
    for (int y = 0; y < height; y++)
        png_write_row(png, rgb + 3 * (size_t)y * (size_t)width);
    png_write_end(png, NULL);
}

const char *png_put(FILE *out, int width, int height, const unsigned char *rgb, const char *history)
{
    const char *volatile why = NULL;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, (void *)&why, fails, warns);
    png_infop info = png ? png_create_info_struct(png) : NULL;

    if (!info)
        why = REASON_MEMORY;
    else if (!setjmp(png_jmpbuf(png))) {
        png_init_io(png, out);
        put_rows(png, info, width, height, rgb, history);
    }
    png_destroy_write_struct(&png, &info);
    return why;
}
