#include "formats/export_simpack.h"

#include "formats/export_points.h"

/* A comment is quoted: its quotes become blanks. */
static void comment_put(const struct prof *p, int64_t poly, FILE *out)
{
    fprintf(out, "  comment        = '");
    for (const char *c = p->name; *c; c++)
        putc(*c == '\'' || (unsigned char)*c < ' ' ? ' ' : *c, out);
    fprintf(out, ", %s, station %.9g m'\n", p->body[p->poly_body[poly]], p->station[p->poly_section[poly]]);
}

void export_simpack(const struct prof *p, int64_t poly, FILE *out)
{
    int64_t n = p->poly_first[poly + 1] - p->poly_first[poly];
    int wheel = p->part == 'w';

    fprintf(out, "header.begin\n  version        = 1\n  type           = %d                ! 0 rail, 1 wheel\nheader.end\nspline.begin\n", wheel);
    fprintf(out, "  approx.smooth  = 0.0\n  file           = ''\n  file.mtime     = 0\n");
    comment_put(p, poly, out);
    fprintf(out, "  type           = 0\n  point.dist.min = 0.0\n  shift.y        = 0.0\n  shift.z        = 0.0\n  rotate         = 0.0\n"
                 "  bound.y.min    = 1.0              ! bounds are active where min < max\n  bound.y.max    = 0.0\n"
                 "  bound.z.min    = 1.0\n  bound.z.max    = 0.0\n  mirror.y       = %d\n  mirror.z       = 0\n  inversion      = %d\n"
                 "  units.len.f    = 1000.0           ! mm\n  units.ang.f    = 1.0              ! rad\n  point.begin\n", wheel, wheel);
    for (int64_t j = 0; j < n; j++) {
        int64_t i = export_point(p, poly, j);
        fprintf(out, "    %17.9f %17.9f\n", (wheel ? -1e3 : 1e3) * export_y(p, i), 1e3 * p->z[i]);
    }
    fprintf(out, "  point.end\nspline.end\n");
}
