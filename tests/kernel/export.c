/* What CSV, MAT and HDF5 files hold: each is taken apart here by what its format says. */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <hdf5.h>

#include "formats/export_csv.h"
#include "formats/export_hdf5.h"
#include "formats/export_mat.h"
#include "tests/kernel/tap.h"

static const double grid[2][3] = {{1, 2, 3}, {4, 5, 0.1}};
static const double cube[2][3][2] = {{{111, 112}, {121, 122}, {131, 132}}, {{211, 212}, {221, 222}, {231, 232}}};
static const float single[2] = {0.1f, -1};
static const int64_t whole[2] = {INT64_MIN, 7};
static const double wave[2][2] = {{1, -2}, {3, 0.5}};
static const char name[2][8] = {"stock", "a \"b\""};

static struct vxf_array item[] = {
    {.name = "grid", .unit = "m,rad", .type = VXF_F64, .ndim = 2, .dim = {2, 3}, .data = grid},
    {.name = "cube.x", .unit = "1", .type = VXF_F64, .ndim = 3, .dim = {2, 3, 2}, .data = cube},
    {.name = "single", .unit = "N", .type = VXF_F32, .ndim = 1, .dim = {2}, .data = single},
    {.name = "whole", .unit = "1", .type = VXF_I64, .ndim = 1, .dim = {2}, .data = whole},
    {.name = "wave", .unit = "m/N", .type = VXF_C128, .ndim = 1, .dim = {2}, .data = wave},
    {.name = "name", .unit = "text", .type = VXF_U8, .ndim = 2, .dim = {2, 8}, .data = name},
    {.name = "none", .unit = "m", .type = VXF_F64, .ndim = 2, .dim = {2, 0}},
};
static const struct vxf_list all = {.n = 7, .item = item};

static const char header[] = "SOFTWARE= Veksel\n";

/* ---- CSV ---- */

static void csv_is(const struct vxf_list *list, const char *want, const char *what)
{
    char *text = NULL;
    size_t n;
    FILE *out = open_memstream(&text, &n);
    const char *why = export_csv(list, out);

    fclose(out);
    if (!ok(!why && strcmp(text, want) == 0, "%s", what))
        printf("# got: %s\n# should be: %s\n", why ? why : text, want);
    free(text);
}

static void csv(void)
{
    const struct vxf_array mixed[] = {item[0], {.name = "s", .unit = "m", .type = VXF_F64, .data = grid}};
    const char *why;

    csv_is(&(struct vxf_list){1, item}, "\"grid[1] (m,rad)\",\"grid[2] (m,rad)\",\"grid[3] (m,rad)\"\n1,2,3\n4,5,0.10000000000000001\n",
           "two dims are columns; a comma in a unit is quoted; 17 digits");
    csv_is(&(struct vxf_list){1, item + 1}, "cube.x[1][1] (1),cube.x[1][2] (1),cube.x[2][1] (1),cube.x[2][2] (1),cube.x[3][1] (1),cube.x[3][2] (1)\n"
           "111,112,121,122,131,132\n211,212,221,222,231,232\n", "three dims are columns over the last two");
    csv_is(&(struct vxf_list){5, item + 2}, "single (N),whole (1),wave.re (m/N),wave.im (m/N),name (text)\n"
           "0.100000001,-9223372036854775808,1,-2,stock\n-1,7,3,0.5,\"a \"\"b\"\"\"\n", "columns side by side; an array without columns gives none");
    csv_is(&(struct vxf_list){1, (struct vxf_array *)mixed + 1}, "s (m)\n1\n", "a scalar is one row");
    why = export_csv(&(struct vxf_list){2, (struct vxf_array *)mixed}, stdout);
    ok(why && strcmp(why, "grid has 2 rows, s has 1: name arrays of one length") == 0, "arrays of two lengths are refused");
}

/* ---- MAT: a reader by the letter of the format ---- */

struct mat {
    const unsigned char *at;
    uint32_t class, dim[6];
    int ndim, is_complex;
    char name[64];
    const void *part[2];
    uint32_t type, bytes;
};

static uint32_t word(const unsigned char *p)
{
    return p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

/* The element at p: its type, data and bytes; returns the next, on a boundary of 8. */
static const unsigned char *element(const unsigned char *p, uint32_t *type, const void **data, uint32_t *bytes)
{
    *type = word(p);
    *bytes = word(p + 4);
    *data = p + 8;
    return p + 8 + (*bytes + 7) / 8 * 8;
}

/* The variable at p into v; NULL where its length does not fit its parts. */
static const unsigned char *variable(const unsigned char *p, struct mat *v)
{
    uint32_t type, bytes, n;
    const void *data;
    const unsigned char *end = element(p, &type, &data, &bytes), *q = data;

    memset(v, 0, sizeof *v);
    if (type != 14)
        return NULL;
    q = element(q, &type, &data, &bytes);
    v->class = word(data) & 0xff;
    v->is_complex = (word(data) & 0x800) != 0;
    if (type != 6 || bytes != 8)
        return NULL;
    q = element(q, &type, &data, &bytes);
    v->ndim = (int)bytes / 4;
    for (int k = 0; k < v->ndim; k++)
        v->dim[k] = word((const unsigned char *)data + 4 * k);
    if (type != 5)
        return NULL;
    q = element(q, &type, &data, &n);
    memcpy(v->name, data, n);
    if (type != 1)
        return NULL;
    for (int k = 0; k <= v->is_complex; k++)
        q = element(q, &v->type, &v->part[k], &v->bytes);
    return q == end ? end : NULL;
}

static void mat(void)
{
    char *text = NULL;
    size_t n;
    FILE *out = open_memstream(&text, &n);
    const char *why = export_mat(&all, header, out);
    const unsigned char *p, *next;
    struct mat v[8] = {0};
    int read = 0;

    fclose(out);
    p = (unsigned char *)text + 128;
    ok(!why && n > 128 && memcmp(text, "MATLAB 5.0 MAT-file", 19) == 0 && memcmp(text + 116, "\0\0\0\0\0\0\0\0\0\001IM", 12) == 0,
       "MAT: version 5, little-endian, no subsystem data");
    while (read < 8 && p < (unsigned char *)text + n && (next = variable(p, &v[read]))) {
        p = next;
        read++;
    }
    ok(read == 8 && p == (unsigned char *)text + n, "MAT: eight variables fill the file");
    ok(strcmp(v[0].name, "grid") == 0 && v[0].class == 6 && v[0].ndim == 2 && v[0].dim[0] == 2 && v[0].dim[1] == 3 && v[0].type == 9,
       "MAT: a 2x3 array is a 2x3 matrix of doubles");
    int right = 1;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 3; j++)
            right = right && ((const double *)v[0].part[0])[i + 2 * j] == grid[i][j];
    ok(right, "MAT: element (i,j) is ours, stored by column");
    right = strcmp(v[1].name, "cube_x") == 0 && v[1].ndim == 3;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 2; k++)
                right = right && ((const double *)v[1].part[0])[i + 2 * (j + 3 * k)] == cube[i][j][k];
    ok(right, "MAT: element (i,j,k) too; the dot of a name is _");
    ok(v[2].class == 7 && v[2].type == 7 && v[2].dim[0] == 2 && v[2].dim[1] == 1 && memcmp(v[2].part[0], single, sizeof single) == 0,
       "MAT: one dim is a column of singles");
    ok(v[3].class == 14 && v[3].type == 12 && memcmp(v[3].part[0], whole, sizeof whole) == 0, "MAT: int64");
    ok(v[4].class == 6 && v[4].is_complex && ((const double *)v[4].part[0])[1] == 3 && ((const double *)v[4].part[1])[1] == 0.5,
       "MAT: complex, real parts first");
    ok(v[5].class == 4 && v[5].dim[0] == 2 && v[5].dim[1] == 8 && memcmp(v[5].part[0], "sat o\"cbk\"", 10) == 0, "MAT: text is a character matrix");
    ok(v[6].dim[0] == 2 && v[6].dim[1] == 0 && v[6].bytes == 0, "MAT: an empty array");
    ok(strcmp(v[7].name, "vxf_header") == 0 && v[7].bytes == sizeof header - 1 && memcmp(v[7].part[0], header, sizeof header - 1) == 0,
       "MAT: the header text");
    free(text);

    struct vxf_array two[2] = {item[2], item[2]};
    memcpy(two[0].name, "a.b", 4);
    memcpy(two[1].name, "a-b", 4);
    why = export_mat(&(struct vxf_list){2, two}, header, stdout);
    ok(why && strcmp(why, "two variables would be called a_b") == 0, "MAT: names that become one are refused");
    two[0].dim[0] = INT32_MAX;
    why = export_mat(&(struct vxf_list){1, two}, header, stdout);
    ok(why && strcmp(why, "a.b is too large for a MAT file of version 5, use --hdf5") == 0, "MAT: an array beyond 2 GB is refused");
}

/* ---- HDF5, by its own library ---- */

static hid_t open_hdf5(char **image, size_t *n)
{
    FILE *out = open_memstream(image, n);
    const char *why = export_hdf5(&all, header, out);
    hid_t access = H5Pcreate(H5P_FILE_ACCESS), file;

    fclose(out);
    H5Pset_fapl_core(access, 1 << 16, 0);
    H5Pset_file_image(access, *image, *n);
    file = why ? H5I_INVALID_HID : H5Fopen("image", H5F_ACC_RDONLY, access);
    H5Pclose(access);
    return file;
}

static int hdf5_holds(hid_t file, const char *set_name, hid_t type, const void *data, size_t size, int ndim, const hsize_t *dim,
                      const char *unit)
{
    hid_t set = H5Dopen2(file, set_name, H5P_DEFAULT), space = H5Dget_space(set);
    hid_t attribute = H5Aopen(set, "unit", H5P_DEFAULT), text = H5Aget_type(attribute);
    unsigned char *got = calloc(size + 1, 1);
    char got_unit[32] = "";
    hsize_t got_dim[6] = {0};
    int same = H5Sget_simple_extent_ndims(space) == ndim && H5Sget_simple_extent_dims(space, got_dim, NULL) == ndim &&
               memcmp(got_dim, dim, (size_t)ndim * sizeof *dim) == 0 && H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, got) >= 0 &&
               memcmp(got, data, size) == 0 && H5Aread(attribute, text, got_unit) >= 0 && strcmp(got_unit, unit) == 0;

    free(got);
    H5Tclose(text);
    H5Aclose(attribute);
    H5Sclose(space);
    H5Dclose(set);
    return same;
}

static void hdf5(void)
{
    char *image = NULL, *again = NULL;
    size_t n, m;
    hid_t file = open_hdf5(&image, &n), other, text = H5Tcopy(H5T_C_S1), pair = H5Tcreate(H5T_COMPOUND, 16);

    H5Tset_size(text, 8);
    H5Tset_strpad(text, H5T_STR_NULLPAD);
    H5Tinsert(pair, "r", 0, H5T_NATIVE_DOUBLE);
    H5Tinsert(pair, "i", 8, H5T_NATIVE_DOUBLE);
    ok(file >= 0, "HDF5: the library reads the file");
    ok(hdf5_holds(file, "grid", H5T_NATIVE_DOUBLE, grid, sizeof grid, 2, (hsize_t[]){2, 3}, "m,rad"), "HDF5: a 2x3 array with its unit");
    ok(hdf5_holds(file, "cube.x", H5T_NATIVE_DOUBLE, cube, sizeof cube, 3, (hsize_t[]){2, 3, 2}, "1"), "HDF5: three dims");
    ok(hdf5_holds(file, "single", H5T_NATIVE_FLOAT, single, sizeof single, 1, (hsize_t[]){2}, "N"), "HDF5: f32");
    ok(hdf5_holds(file, "whole", H5T_NATIVE_INT64, whole, sizeof whole, 1, (hsize_t[]){2}, "1"), "HDF5: i64");
    ok(hdf5_holds(file, "wave", pair, wave, sizeof wave, 1, (hsize_t[]){2}, "m/N"), "HDF5: complex as r and i");
    ok(hdf5_holds(file, "name", text, name, sizeof name, 1, (hsize_t[]){2}, "text"), "HDF5: text as strings");
    ok(hdf5_holds(file, "none", H5T_NATIVE_DOUBLE, "", 0, 2, (hsize_t[]){2, 0}, "m"), "HDF5: an empty array");
    H5Fclose(file);
    H5Tclose(text);
    H5Tclose(pair);
    sleep(1);
    other = open_hdf5(&again, &m);
    ok(n == m && memcmp(image, again, n) == 0, "HDF5: the same bytes a second later");
    H5Fclose(other);
    free(image);
    free(again);
}

int main(void)
{
    csv();
    mat();
    hdf5();
    return done();
}
