#include "formats/export_points.h"

#include <string.h>

#include "formats/reason.h"

const char *export_poly(const struct prof *p, const double *at, const char *body, int64_t *poly)
{
    int64_t section = at ? prof_nearest(p, *at) : 0, found = 0;

    if (!at && p->sections > 1)
        return reason("it holds %lld sections: say at which station", (long long)p->sections);
    for (int64_t i = 0; i < p->polys; i++)
        if (p->poly_section[i] == section && (!body || strcmp(body, p->body[p->poly_body[i]]) == 0)) {
            *poly = i;
            found++;
        }
    if (found > 1)
        return reason("the section at %g m holds %lld bodies: say which", p->station[section], (long long)found);
    return found ? NULL : reason("the section at %g m holds no body \"%s\"", p->station[section], body);
}

double export_y(const struct prof *p, int64_t i)
{
    return p->side == 'l' ? -p->y[i] : p->y[i];
}

int64_t export_point(const struct prof *p, int64_t poly, int64_t j)
{
    return p->side == 'l' ? p->poly_first[poly + 1] - 1 - j : p->poly_first[poly] + j;
}

void export_points(const struct prof *p, int64_t poly, FILE *out)
{
    int64_t n = p->poly_first[poly + 1] - p->poly_first[poly];

    fprintf(out, "# %s, %s, %s, station %.9g m; as on a right side: y to the right, z down\n# y (mm), z (mm)\n", p->name,
            p->part == 'w' ? "wheel" : "rail", p->body[p->poly_body[poly]], p->station[p->poly_section[poly]]);
    for (int64_t j = 0; j < n; j++) {
        int64_t i = export_point(p, poly, j);
        fprintf(out, "%.9f %.9f\n", 1e3 * export_y(p, i), 1e3 * p->z[i]);
    }
}
