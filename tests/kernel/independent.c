/* Receptance of small tracks with random parameters against a calculation that shares no code with the programs: matrices written out
 * densely from the numbers drawn here, in an order of their own and with the slope dw/dx for the pitch, and solved by Gauss with
 * partial pivoting.  Lumped Euler-Bernoulli rails.  Run from the root. */
#include "tests/kernel/tap.h"

#include <complex.h>
#include <string.h>

#include "tests/kernel/random.h"
#include "tests/kernel/table1.h"
#include "tools/receptance/direct.h"

enum { SLEEPERS = 10, BAY = 3, NODES = (SLEEPERS - 1) * BAY + 1, DOFS = 4 * NODES + 2 * SLEEPERS, TEXT = 700, SETS = 40 };

static const double TOLERANCE = 1e-9;     /* of the largest response at that frequency */
static const double FREQUENCY[] = {0, 5, 31.5, 129, 240, 505, 907, 1500};   /* Hz */

/* One track as numbers, SI; by sleeper where it may vary. */
struct sample {
    int sleepers, bay;                              /* elements in a bay */
    double spacing, rail_spacing, edge;
    double bending[2];                              /* left, right */
    double rail_mass[2][2], pitch[2][2];            /* left, right; at the beginning and the end of the track, straight between */
    double mass[SLEEPERS], roll[SLEEPERS], length[SLEEPERS], centre[SLEEPERS];
    double pad_k[SLEEPERS], pad_c[SLEEPERS];
    double ballast_k[3][SLEEPERS], ballast_c[3][SLEEPERS];   /* left, middle, right */
    int missing[2];                                 /* sleeper whose left or right railpad is not there; -1: none */
};

/* ---- the sample ---- */

/* All of Table 1 times one number. */
static struct sample scaled(int sleepers, int bay, double by)
{
    struct sample s = {.sleepers = sleepers, .bay = bay, .spacing = 0.6 * by, .rail_spacing = 1.5, .edge = 0.35,
                       .bending = {6.11e6 * by, 6.11e6 * by}, .missing = {-1, -1}};

    for (int k = 0; k < 4; k++) {
        s.rail_mass[k / 2][k % 2] = 60 * by;
        s.pitch[k / 2][k % 2] = 1.25 * by;
    }
    for (int k = 0; k < sleepers; k++) {
        s.mass[k] = 380 * by;
        s.roll[k] = 155.09 * by;
        s.length[k] = 2.6;
        s.pad_k[k] = 300e6 * by;
        s.pad_c[k] = 50e3 * by;
        for (int b = 0; b < 3; b++) {
            s.ballast_k[b][k] = 280e6 / 3 * by;
            s.ballast_c[b][k] = 40e3 * by;
        }
    }
    return s;
}

/* A factor of 0.3 to 3, as often below 1 as above. */
static double factor(void)
{
    return 0.3 * pow(10, random_number());
}

static struct sample random_sample(void)
{
    const int sleepers = 6 + (int)(5 * random_number()), bay = 1 + (int)(BAY * random_number());
    struct sample s = scaled(sleepers < SLEEPERS ? sleepers : SLEEPERS, bay < BAY ? bay : BAY, 1);

    s.spacing *= factor();
    for (int rail = 0; rail < 2; rail++) {
        s.bending[rail] *= factor();
        s.missing[rail] = (int)(2.0 * s.sleepers * random_number()) - s.sleepers;
        for (int end = 0; end < 2; end++) {
            s.rail_mass[rail][end] *= factor();
            s.pitch[rail][end] *= factor();
        }
    }
    s.rail_spacing = 1 + random_number();
    s.edge = 0.1 + 0.3 * random_number();
    for (int k = 0; k < s.sleepers; k++) {
        s.mass[k] *= factor();
        s.roll[k] *= factor();
        s.length[k] = 3 + 2 * random_number();
        s.centre[k] = random_number() - 0.5;
        s.pad_k[k] *= factor();
        s.pad_c[k] *= factor();
        for (int b = 0; b < 3; b++) {
            s.ballast_k[b][k] *= factor();
            s.ballast_c[b][k] *= factor();
        }
    }
    return s;
}

/* ---- the same, as the programs read it ---- */

static void set_number(char text[SETS][TEXT], int *n, const char *key, double value)
{
    snprintf(text[(*n)++], TEXT, "%s=%.17g", key, value);
}

static void set_table(char text[SETS][TEXT], int *n, const char *key, int count, const double *value)
{
    char *to = text[(*n)++];
    int at = snprintf(to, TEXT, "%s={number: [1", key);

    for (int k = 1; k < count; k++)
        at += snprintf(to + at, (size_t)(TEXT - at), ", %d", k + 1);
    for (int k = 0; k < count; k++)
        at += snprintf(to + at, (size_t)(TEXT - at), "%s%.17g", k ? ", " : "], value: [", value[k]);
    snprintf(to + at, (size_t)(TEXT - at), "]}");
}

static void set_ends(char text[SETS][TEXT], int *n, const char *key, double length, const double value[2])
{
    snprintf(text[(*n)++], TEXT, "%s={station: [0, %.17g], value: [%.17g, %.17g]}", key, length, value[0], value[1]);
}

/* What rails and springs have of their own. */
static void set_own(char text[SETS][TEXT], int *n, const struct sample *s)
{
    static const char *const rail[] = {"left", "right"}, *const spring[] = {"left", "middle", "right"};
    char key[40];
    int missing = 0;

    for (int i = 0; i < 2; i++) {
        snprintf(key, sizeof key, "rail.%s.mass", rail[i]);
        set_ends(text, n, key, s->sleepers * s->spacing, s->rail_mass[i]);
        snprintf(key, sizeof key, "rail.%s.pitch_inertia", rail[i]);
        set_ends(text, n, key, s->sleepers * s->spacing, s->pitch[i]);
    }
    for (int i = 0; i < 3; i++) {
        snprintf(key, sizeof key, "ballast.%s.stiffness", spring[i]);
        set_table(text, n, key, s->sleepers, s->ballast_k[i]);
        snprintf(key, sizeof key, "ballast.%s.damping", spring[i]);
        set_table(text, n, key, s->sleepers, s->ballast_c[i]);
    }
    for (int i = 0; i < 2; i++)
        if (s->missing[i] >= 0) {
            const int number = s->missing[i] + 1;
            if (!missing++)
                snprintf(text[*n], TEXT, "railpad.missing=[{sleepers: [[%d, %d]], rail: %s}]", number, number, rail[i]);
            else
                snprintf(strchr(text[*n], 0) - 1, TEXT / 2, ", {sleepers: [[%d, %d]], rail: %s}]", number, number, rail[i]);
        }
    *n += missing > 0;
}

static const char *build(struct trk *t, const struct sample *s)
{
    char text[SETS][TEXT];
    const char *set[SETS];
    int n = 0;

    set_number(text, &n, "from", 0);
    set_number(text, &n, "length", s->sleepers * s->spacing);
    set_number(text, &n, "rail_spacing", s->rail_spacing);
    set_number(text, &n, "ballast.edge", s->edge);
    set_number(text, &n, "rail.elements_per_bay", s->bay);
    set_number(text, &n, "rail.left.bending_stiffness", s->bending[0]);
    set_number(text, &n, "rail.right.bending_stiffness", s->bending[1]);
    set_number(text, &n, "sleeper.spacing", s->spacing);
    set_table(text, &n, "sleeper.mass", s->sleepers, s->mass);
    set_table(text, &n, "sleeper.roll_inertia", s->sleepers, s->roll);
    set_table(text, &n, "sleeper.length", s->sleepers, s->length);
    set_table(text, &n, "sleeper.centre", s->sleepers, s->centre);
    set_table(text, &n, "railpad.stiffness", s->sleepers, s->pad_k);
    set_table(text, &n, "railpad.damping", s->sleepers, s->pad_c);
    set_own(text, &n, s);
    for (int k = 0; k < n; k++)
        set[k] = text[k];
    return table1(t, set, n);
}

/* ---- the dense calculation ---- */

static int nodes_of(const struct sample *s)
{
    return (s->sleepers - 1) * s->bay + 1;
}

/* Order: w and slope of each node of the left rail, of the right rail, then z of all sleepers, then their rolls. */
static int deflection(const struct sample *s, int rail, int node)
{
    return 2 * (rail * nodes_of(s) + node);
}

static int sleeper_z(const struct sample *s, int k)
{
    return 4 * nodes_of(s) + k;
}

static int dofs_of(const struct sample *s)
{
    return 4 * nodes_of(s) + 2 * s->sleepers;
}

/* The element's energy EI/2 int w''^2 dx, w cubic: 12 6h -12 6h; ... */
static void dense_beam(double complex A[DOFS][DOFS], int w, double EI, double h)
{
    const double row[4][4] = {{12, 6 * h, -12, 6 * h},
                              {6 * h, 4 * h * h, -6 * h, 2 * h * h},
                              {-12, -6 * h, 12, -6 * h},
                              {6 * h, 2 * h * h, -6 * h, 4 * h * h}};

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            A[w + i][w + j] += EI / (h * h * h) * row[i][j];
}

/* Springs and dampers of sleeper k, its mass, and the railpads above. */
static void dense_sleeper(double complex A[DOFS][DOFS], const struct sample *s, int k, double complex p)
{
    const int z = sleeper_z(s, k), roll = z + s->sleepers;
    const double a = s->length[k] / 2 - s->edge;

    A[z][z] += p * p * s->mass[k];
    A[roll][roll] += p * p * s->roll[k];
    for (int b = 0; b < 3; b++) {
        const double complex spring = s->ballast_k[b][k] + p * s->ballast_c[b][k];
        const double y = b == 0 ? -a : b == 1 ? 0 : a;
        A[z][z] += spring;
        A[z][roll] += spring * y;
        A[roll][z] += spring * y;
        A[roll][roll] += spring * y * y;
    }
    for (int rail = 0; rail < 2; rail++) {
        const double complex pad = s->missing[rail] == k ? 0 : s->pad_k[k] + p * s->pad_c[k];
        const int w = deflection(s, rail, k * s->bay);
        const double y = (rail ? s->rail_spacing : -s->rail_spacing) / 2 - s->centre[k];
        A[w][w] += pad;
        A[z][z] += pad;
        A[roll][roll] += pad * y * y;
        A[w][z] -= pad;
        A[z][w] -= pad;
        A[w][roll] -= pad * y;
        A[roll][w] -= pad * y;
        A[z][roll] += pad * y;
        A[roll][z] += pad * y;
    }
}

/* Straight from one end of the track to the other, part of the way along. */
static double between(const double end[2], double part)
{
    return end[0] + part * (end[1] - end[0]);
}

/* K + p C + p^2 M. */
static void dense_matrix(double complex A[DOFS][DOFS], const struct sample *s, double complex p)
{
    const double h = s->spacing / s->bay, length = s->sleepers * s->spacing;
    const int last = nodes_of(s) - 1;

    for (int i = 0; i < DOFS; i++)
        for (int j = 0; j < DOFS; j++)
            A[i][j] = 0;
    for (int rail = 0; rail < 2; rail++)
        for (int i = 0; i <= last; i++) {
            const int w = deflection(s, rail, i);
            if (i < last)
                dense_beam(A, w, s->bending[rail], h);
            const double from = i == 0 ? 0 : s->spacing / 2 + (i - 0.5) * h, to = i == last ? length : s->spacing / 2 + (i + 0.5) * h;
            A[w][w] += p * p * (to - from) * between(s->rail_mass[rail], (from + to) / 2 / length);
            A[w + 1][w + 1] += p * p * between(s->pitch[rail], (s->spacing / 2 + i * h) / length);
        }
    for (int k = 0; k < s->sleepers; k++)
        dense_sleeper(A, s, k, p);
}

/* A x = b by Gauss with partial pivoting; A and b are used up, b becomes x. */
static void dense_solve(double complex A[DOFS][DOFS], double complex *b, int n)
{
    for (int c = 0; c < n; c++) {
        int best = c;
        for (int i = c + 1; i < n; i++)
            if (cabs(A[i][c]) > cabs(A[best][c]))
                best = i;
        for (int j = c; j < n; j++) {
            const double complex keep = A[c][j];
            A[c][j] = A[best][j];
            A[best][j] = keep;
        }
        const double complex keep = b[c];
        b[c] = b[best];
        b[best] = keep;
        for (int i = c + 1; i < n; i++) {
            const double complex m = A[i][c] / A[c][c];
            for (int j = c; j < n && m != 0; j++)
                A[i][j] -= m * A[c][j];
            b[i] -= m * b[c];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++)
            b[i] -= A[i][j] * b[j];
        b[i] /= A[i][i];
    }
}

/* ---- one against the other ---- */

static double complex of(const double *u, int64_t dof)
{
    return u[2 * dof] + I * u[2 * dof + 1];
}

/* Largest difference of all deflections and of the sleepers' rolls, of the largest deflection; x is dense, u the program's. */
static double difference(const struct sample *s, const struct trk *t, const double complex *x, const double *u)
{
    double most = 0, largest = 0;

    for (int i = 0; i < nodes_of(s); i++)
        for (int rail = 0; rail < 2; rail++) {
            const int w = deflection(s, rail, i);
            most = fmax(most, cabs(x[w] - of(u, t->node_dof[i] + 2 * rail)));
            most = fmax(most, cabs(x[w + 1] + of(u, t->node_dof[i] + 2 * rail + 1)));
            largest = fmax(largest, cabs(x[w]));
        }
    for (int k = 0; k < s->sleepers; k++) {
        most = fmax(most, cabs(x[sleeper_z(s, k)] - of(u, t->sleeper_dof[k])));
        most = fmax(most, cabs(x[sleeper_z(s, k) + s->sleepers] - of(u, t->sleeper_dof[k] + 1)));
    }
    return most / largest;
}

/* 1 N on one node of one rail; NAN where the program cannot. */
static double compare(const struct sample *s, const struct trk *t, struct direct *d, double frequency)
{
    static double complex A[DOFS][DOFS];
    double complex x[DOFS] = {0}, p = 2 * M_PI * frequency * I;
    double u[2 * DOFS] = {0};
    const int rail = random_number() < 0.5, node = (int)(0.999 * random_number() * nodes_of(s));

    dense_matrix(A, s, p);
    x[deflection(s, rail, node)] = 1;
    dense_solve(A, x, dofs_of(s));
    u[2 * (t->node_dof[node] + 2 * rail)] = 1;
    return direct_factor(d, p) || direct_solve(d, u) ? NAN : difference(s, t, x, u);
}

static double worst_of(const struct sample *s)
{
    struct trk t;
    struct direct d;
    double worst = 0;

    const char *why = build(&t, s);
    if (!why && (t.dofs != dofs_of(s) || (why = direct_new(&d, &t))))
        why = why ? why : "another number of degrees of freedom";
    if (why) {
        printf("# %s\n", why);
        trk_free(&t);
        return NAN;
    }
    for (size_t i = 0; i < sizeof FREQUENCY / sizeof *FREQUENCY && !isnan(worst); i++) {
        const double now = compare(s, &t, &d, FREQUENCY[i]);
        worst = now <= worst ? worst : now;                        /* a NAN stays */
    }
    direct_free(&d);
    trk_free(&t);
    return worst;
}

int main(void)
{
    static const struct { const char *name; double by; } plain[] = {{"Table 1", 1}, {"doubled", 2}, {"halved", 0.5}};

    for (size_t i = 0; i < sizeof plain / sizeof *plain; i++)
        for (int bay = 1; bay <= BAY; bay++) {
            const struct sample s = scaled(SLEEPERS - 2, bay, plain[i].by);
            const double worst = worst_of(&s);
            ok(worst < TOLERANCE, "%s, %d a bay: receptances of the dense calculation within %.1e", plain[i].name, bay, worst);
        }
    for (int i = 0; i < 40; i++) {
        const struct sample s = random_sample();
        const double worst = worst_of(&s);
        ok(worst < TOLERANCE, "random track %d, %d sleepers, %d a bay: within %.1e", i + 1, s.sleepers, s.bay, worst);
    }
    return done();
}
