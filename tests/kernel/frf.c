/* Receptances and modes written and read again are the same; what a reader relies on is refused where it does not hold. */
#include "formats/frf.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "formats/mod.h"
#include "tests/kernel/tap.h"

static const char *reopen(struct vxf_out *o, struct vxf *f)
{
    char path[] = "/tmp/veksel-frf-XXXXXX";
    int fd = mkstemp(path);
    FILE *stream = fd < 0 ? NULL : fdopen(fd, "wb");
    const char *why = stream ? vxf_write(o, stream) : "no temporary file";

    if (stream)
        fclose(stream);
    if (!why)
        why = vxf_open(f, path);
    unlink(path);
    return why;
}

static void receptance(void)
{
    static const double f[3] = {10, 20, 30}, H[6] = {1e-9, -1e-9, 2e-9, -2e-9, 3e-9, -3e-9}, wrong[3] = {10, 10, 30};
    struct frf r = {.quantity = FRF_MOBILITY, .force = {.on = "both", .at = "sleeper", .x = -0.3, .lateral = 1},
                    .motion = {.on = "left", .at = "station", .x = 0.1}, .n = 3, .frequency = f, .H = H, .hermite = H}, back;
    struct vxf_out o;
    struct vxf file;

    vxf_out_begin(&o, "frf");
    ok(frf_put(&r, &o) == NULL && reopen(&o, &file) == NULL && frf_read(&back, &file) == NULL, "a receptance goes and comes");
    ok(back.quantity == FRF_MOBILITY && strcmp(back.force.on, "both") == 0 && strcmp(back.force.at, "sleeper") == 0 &&
           back.force.x == -0.3 && strcmp(back.motion.on, "left") == 0 && strcmp(back.motion.at, "station") == 0 && back.motion.x == 0.1 &&
           back.force.lateral && !back.motion.lateral &&
           back.n == 3 && back.hermites == 0 && memcmp(back.H, H, sizeof H) == 0,
       "unchanged");
    struct mod m;
    ok(mod_read(&m, &file) != NULL, "it is no file of modes");
    frf_free(&back);
    vxf_close(&file);
    r.frequency = wrong;
    ok(frf_put(&r, &o) != NULL, "a frequency twice is refused");
    r.frequency = f;
    r.hermites = 2;
    ok(frf_put(&r, &o) != NULL, "as are two values for three frequencies");
    r.hermites = 0;
    r.motion = r.force;
    ok(frf_put(&r, &o) != NULL, "as is the one motion of two rails");
    vxf_out_free(&o);
}

static void modes(void)
{
    static const char name[2][32] = {"bounce", "pitch"}, endless[2][32] = {"bounce", "0123456789012345678901234567890"};
    static const double f[2] = {1, 2}, ratio[2] = {0.1, 0.2}, shape[6] = {1, 2, 3, 4, 5, 6}, falling[2] = {2, 1};
    struct mod m = {.of = "veh", .n = 2, .dofs = 3, .frequency = f, .damping = ratio, .name = name, .shape = shape}, back;
    struct vxf_out o;
    struct vxf file;

    vxf_out_begin(&o, "mod");
    ok(mod_put(&m, &o) == NULL && reopen(&o, &file) == NULL && mod_read(&back, &file) == NULL, "modes go and come");
    ok(strcmp(back.of, "veh") == 0 && back.n == 2 && back.dofs == 3 && strcmp(back.name[1], "pitch") == 0 && back.shape[5] == 6 &&
           back.damping[1] == 0.2,
       "unchanged");
    mod_free(&back);
    vxf_close(&file);
    m.imaginaries = 1;
    ok(mod_put(&m, &o) != NULL, "one complex shape of two modes is refused");
    m.imaginaries = 0;
    m.frequency = falling;
    ok(mod_put(&m, &o) != NULL, "falling frequencies are refused");
    m.frequency = f;
    m.name = endless;
    ok(mod_put(&m, &o) == NULL, "31 letters are a name");
    vxf_out_free(&o);
}

int main(void)
{
    receptance();
    modes();
    return done();
}
