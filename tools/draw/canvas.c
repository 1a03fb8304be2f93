/* OSMesa behind the functions of canvas.h.  The driver is pinned to llvmpipe, which gives the same pixels on every run and
 * for every number of its threads. */
#include "tools/draw/canvas.h"

#include <GL/osmesa.h>
#include <math.h>
#include <stdlib.h>

#include "formats/reason.h"

enum { FINE = 4 };                      /* samples per pixel and direction */
enum { ROUND = 24 };                    /* corners of a disc */
static const double paper = 16 / 2.54 * 72;   /* pt, width of the picture in a report */
static const double turn = 0.99;        /* cosine of the angle above which a corner needs no rounding */

const char *canvas_new(struct canvas *c, int width, int height)
{
    static const int attributes[] = {OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 0, OSMESA_STENCIL_BITS, 8,
                                     OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};

    *c = (struct canvas){.width = width, .height = height, .point = width / paper};
    if (width < CANVAS_LEAST || height < CANVAS_LEAST || width > CANVAS_MOST || height > CANVAS_MOST)
        return reason("a picture of %d x %d pixels: sides must be %d to %d", width, height, CANVAS_LEAST, CANVAS_MOST);
    if (setenv("GALLIUM_DRIVER", "llvmpipe", 1) != 0)
        return REASON_MEMORY;
    c->rgb = calloc((size_t)width * (size_t)height, 3);
    c->fine = calloc((size_t)width * (size_t)height, 4 * FINE * FINE);
    if (!c->rgb || !c->fine) {
        canvas_free(c);
        return REASON_MEMORY;
    }
    c->context = OSMesaCreateContextAttribs(attributes, NULL);
    if (!c->context || !OSMesaMakeCurrent(c->context, c->fine, GL_UNSIGNED_BYTE, FINE * width, FINE * height)) {
        canvas_free(c);
        return "OSMesa makes no context";
    }
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    glViewport(0, 0, FINE * width, FINE * height);
    glOrtho(0, width, height, 0, -1, 1);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    return NULL;
}

void canvas_free(struct canvas *c)
{
    if (c->context)
        OSMesaDestroyContext(c->context);
    free(c->fine);
    free(c->rgb);
    *c = (struct canvas){0};
}

void canvas_colour(struct canvas *c, unsigned rgb)
{
    (void)c;
    glColor3ub((GLubyte)(rgb >> 16), (GLubyte)(rgb >> 8), (GLubyte)rgb);
}

void canvas_clip(struct canvas *c, double x, double y, double w, double h)
{
    glEnable(GL_SCISSOR_TEST);
    glScissor((int)lround(FINE * x), (int)lround(FINE * (c->height - y - h)), (int)lround(FINE * w), (int)lround(FINE * h));
}

void canvas_unclip(struct canvas *c)
{
    (void)c;
    glDisable(GL_SCISSOR_TEST);
}

/* Two triangles about the straight piece from a to b. */
static void piece(const double *a, const double *b, double width)
{
    double dx = b[0] - a[0], dy = b[1] - a[1], l = hypot(dx, dy);

    if (l == 0)
        return;
    double nx = -dy / l * width / 2, ny = dx / l * width / 2;
    glVertex2d(a[0] + nx, a[1] + ny);
    glVertex2d(a[0] - nx, a[1] - ny);
    glVertex2d(b[0] - nx, b[1] - ny);
    glVertex2d(b[0] - nx, b[1] - ny);
    glVertex2d(b[0] + nx, b[1] + ny);
    glVertex2d(a[0] + nx, a[1] + ny);
}

static void disc(double x, double y, double radius)
{
    for (int k = 0; k < ROUND; k++) {
        double from = 2 * M_PI * k / ROUND, to = 2 * M_PI * (k + 1) / ROUND;
        glVertex2d(x, y);
        glVertex2d(x + radius * cos(from), y + radius * sin(from));
        glVertex2d(x + radius * cos(to), y + radius * sin(to));
    }
}

/* a-b-c bends so much that the pieces leave a gap. */
static int bends(const double *a, const double *b, const double *c)
{
    double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - b[0], vy = c[1] - b[1];

    return ux * vx + uy * vy < turn * hypot(ux, uy) * hypot(vx, vy);
}

/* Lengths on and off in widths of the line, along the whole line. */
static void dashes(int n, const double *xy, double width, enum canvas_dash dash)
{
    static const double pattern[CANVAS_DASHES][4] = {
        [CANVAS_SOLID] = {1, 0, 1, 0}, [CANVAS_DASHED] = {5, 2.5, 5, 2.5}, [CANVAS_DOTTED] = {1.2, 1.8, 1.2, 1.8},
        [CANVAS_DASHDOT] = {6, 2, 1.2, 2}};
    int phase = 0;
    double change = pattern[dash][0] * width, length = 0;     /* where the phase ends, where a lies along the line */

    for (int i = 1; i < n; i++) {
        const double *a = xy + 2 * (i - 1), *b = xy + 2 * i;
        double l = hypot(b[0] - a[0], b[1] - a[1]), at = 0;
        while (l > 0) {
            double to = fmin(l, change - length);
            double p[2] = {a[0] + at / l * (b[0] - a[0]), a[1] + at / l * (b[1] - a[1])};
            double q[2] = {a[0] + to / l * (b[0] - a[0]), a[1] + to / l * (b[1] - a[1])};
            if (phase % 2 == 0)
                piece(p, q, width);
            if (to == l)
                break;
            at = to;
            phase = (phase + 1) % 4;
            change += pattern[dash][phase] * width;
        }
        length += l;
    }
}

void canvas_line(struct canvas *c, int n, const double *xy, double width, enum canvas_dash dash)
{
    (void)c;
    glBegin(GL_TRIANGLES);
    if (dash != CANVAS_SOLID)
        dashes(n, xy, width, dash);
    else
        for (int i = 1; i < n; i++) {
            piece(xy + 2 * (i - 1), xy + 2 * i, width);
            if (i + 1 < n && bends(xy + 2 * (i - 1), xy + 2 * i, xy + 2 * (i + 1)))
                disc(xy[2 * i], xy[2 * i + 1], width / 2);
        }
    glEnd();
}

static void box_about(int n, const double *xy)
{
    double left = xy[0], right = xy[0], top = xy[1], bottom = xy[1];

    for (int i = 1; i < n; i++) {
        left = fmin(left, xy[2 * i]);
        right = fmax(right, xy[2 * i]);
        top = fmin(top, xy[2 * i + 1]);
        bottom = fmax(bottom, xy[2 * i + 1]);
    }
    glRectd(left - 1, top - 1, right + 1, bottom + 1);
}

/* A fan of triangles turns one bit of the stencil over: it is set where an odd number of them lies. */
void canvas_fill(struct canvas *c, int n, const double *xy)
{
    (void)c;
    if (n < 3)
        return;
    glEnable(GL_STENCIL_TEST);
    glColorMask(0, 0, 0, 0);
    glStencilFunc(GL_ALWAYS, 0, 1);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
    glBegin(GL_TRIANGLE_FAN);
    for (int i = 0; i < n; i++)
        glVertex2dv(xy + 2 * i);
    glEnd();
    glColorMask(1, 1, 1, 1);
    glStencilFunc(GL_EQUAL, 1, 1);
    glStencilOp(GL_ZERO, GL_ZERO, GL_ZERO);
    box_about(n, xy);
    glDisable(GL_STENCIL_TEST);
}

void canvas_mark(struct canvas *c, enum canvas_mark mark, double x, double y, double size)
{
    double r = size / 2, t = size / 5;
    double ring[2 * (ROUND + 2)];

    switch (mark) {
    case CANVAS_NO_MARK:
        break;
    case CANVAS_DISC:
        glBegin(GL_TRIANGLES);
        disc(x, y, r);
        glEnd();
        break;
    case CANVAS_RING:
        for (int k = 0; k < ROUND + 2; k++) {
            ring[2 * k] = x + (r - t / 2) * cos(2 * M_PI * k / ROUND);
            ring[2 * k + 1] = y + (r - t / 2) * sin(2 * M_PI * k / ROUND);
        }
        canvas_line(c, ROUND + 2, ring, t, CANVAS_SOLID);
        break;
    case CANVAS_SQUARE:
        glRectd(x - 0.9 * r, y - 0.9 * r, x + 0.9 * r, y + 0.9 * r);
        break;
    case CANVAS_TRIANGLE:
        canvas_fill(c, 3, (double[]){x - r, y + 0.8 * r, x + r, y + 0.8 * r, x, y - r});
        break;
    case CANVAS_CROSS:
        canvas_line(c, 2, (double[]){x - r, y - r, x + r, y + r}, t, CANVAS_SOLID);
        canvas_line(c, 2, (double[]){x - r, y + r, x + r, y - r}, t, CANVAS_SOLID);
        break;
    }
}

void canvas_end(struct canvas *c)
{
    size_t row = (size_t)c->width * FINE * 4;

    glFinish();
    for (int y = 0; y < c->height; y++)
        for (int x = 0; x < c->width; x++)
            for (int k = 0; k < 3; k++) {
                const unsigned char *from = c->fine + (size_t)y * FINE * row + (size_t)x * FINE * 4 + k;
                unsigned sum = 0;
                for (size_t j = 0; j < FINE; j++)
                    for (size_t i = 0; i < FINE; i++)
                        sum += from[j * row + 4 * i];
                c->rgb[3 * ((size_t)y * (size_t)c->width + (size_t)x) + (size_t)k] =
                    (unsigned char)((sum + FINE * FINE / 2) / (FINE * FINE));
            }
}
