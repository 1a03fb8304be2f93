/* Opening a container that others may replace, remove or cut short meanwhile, on this machine or another: read, because a page of a
 * mapped file that is no longer there ends the program. */
#include "formats/reason.h"
#include "formats/vxf_disk.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* n bytes from the start of fd. */
static const char *read_start(int fd, void *to, size_t n)
{
    for (size_t have = 0; have < n;) {
        ssize_t got = pread(fd, (unsigned char *)to + have, n - have, (off_t)have);
        if (got == 0)
            return "truncated while it was read";
        if (got < 0 && errno != EINTR)
            return strerror(errno);
        have += got > 0 ? (size_t)got : 0;
    }
    return NULL;
}

static const char *regular_size(int fd, size_t *size)
{
    struct stat st;

    if (fstat(fd, &st) != 0)
        return strerror(errno);
    if (!S_ISREG(st.st_mode))
        return "not a regular file";
    *size = (size_t)st.st_size;
    return *size ? NULL : "empty file";
}

const char *vxf_open_fd(struct vxf *f, int fd)
{
    const char *why;

    memset(f, 0, sizeof *f);
    why = regular_size(fd, &f->size);
    if (!why && !(f->base = malloc(f->size)))
        why = REASON_MEMORY;
    if (!why && !(why = read_start(fd, f->base, f->size)))
        why = vxf_check(f);
    if (why)
        vxf_close(f);
    return why;
}

const char *vxf_open_header(struct vxf *f, int fd)
{
    struct vxf_preamble p = {0};
    const char *why;

    memset(f, 0, sizeof *f);
    why = regular_size(fd, &f->size);
    if (!why && f->size >= sizeof p)
        why = read_start(fd, &p, sizeof p);
    size_t n = sizeof p + (p.header <= VXF_HEADER_MAX ? p.header : 0);
    n = n < f->size ? n : f->size;
    if (!why && !(f->base = malloc(n + 1)))
        why = REASON_MEMORY;
    if (!why && !(why = read_start(fd, f->base, n)) && !(why = vxf_check_preamble(f, &p)))
        why = vxf_parse_header(f, &p);
    if (why)
        vxf_close(f);
    return why;
}
