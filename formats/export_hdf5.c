/* HDF5 by its core driver.  Only this file includes hdf5.h. */
#include "formats/export_hdf5.h"

#include <stdlib.h>
#include <string.h>

#include <hdf5.h>

#include "formats/reason.h"

enum { GROW = 1 << 20 };     /* bytes by which the image in memory grows */

static int is_text(const struct vxf_array *a)
{
    return a->type == VXF_U8 && a->ndim > 0 && strcmp(a->unit, "text") == 0;
}

static hid_t string_type(size_t size)
{
    hid_t type = H5Tcopy(H5T_C_S1);

    H5Tset_size(type, size ? size : 1);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    return type;
}

static hid_t complex_type(void)
{
    hid_t type = H5Tcreate(H5T_COMPOUND, 2 * sizeof(double));

    H5Tinsert(type, "r", 0, H5T_IEEE_F64LE);
    H5Tinsert(type, "i", sizeof(double), H5T_IEEE_F64LE);
    return type;
}

static hid_t element_type(const struct vxf_array *a)
{
    if (is_text(a))
        return string_type((size_t)a->dim[a->ndim - 1]);
    switch (a->type) {
    case VXF_F64:
        return H5Tcopy(H5T_IEEE_F64LE);
    case VXF_F32:
        return H5Tcopy(H5T_IEEE_F32LE);
    case VXF_I64:
        return H5Tcopy(H5T_STD_I64LE);
    case VXF_I32:
        return H5Tcopy(H5T_STD_I32LE);
    case VXF_U8:
        return H5Tcopy(H5T_STD_U8LE);
    case VXF_C128:
        return complex_type();
    case VXF_TYPES:
        break;
    }
    return H5I_INVALID_HID;
}

static herr_t put_unit(hid_t set, const char *unit)
{
    hid_t type = string_type(strlen(unit)), space = H5Screate(H5S_SCALAR);
    hid_t attribute = H5Acreate2(set, "unit", type, space, H5P_DEFAULT, H5P_DEFAULT);
    herr_t bad = H5Awrite(attribute, type, unit);

    H5Aclose(attribute);
    H5Sclose(space);
    H5Tclose(type);
    return bad;
}

static const char *put_array(hid_t file, hid_t plain, const struct vxf_array *a)
{
    int ndim = a->ndim - is_text(a);
    hsize_t dim[VXF_DIMS];
    hid_t type = element_type(a), space, set;
    herr_t bad;

    for (int k = 0; k < ndim; k++)
        dim[k] = (hsize_t)a->dim[k];
    space = ndim ? H5Screate_simple(ndim, dim, NULL) : H5Screate(H5S_SCALAR);
    set = strchr(a->name, '/') ? H5I_INVALID_HID : H5Dcreate2(file, a->name, type, space, H5P_DEFAULT, plain, H5P_DEFAULT);
    bad = set < 0 || (vxf_count(a) && H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, a->data) < 0) || put_unit(set, a->unit) < 0;
    if (set >= 0)
        H5Dclose(set);
    H5Sclose(space);
    H5Tclose(type);
    return bad ? reason("HDF5 does not take array %s", a->name) : NULL;
}

static const char *write_image(hid_t file, FILE *out)
{
    ssize_t size = H5Fflush(file, H5F_SCOPE_GLOBAL) < 0 ? -1 : H5Fget_file_image(file, NULL, 0);
    const char *why = NULL;
    void *image;

    if (size < 0)
        return "HDF5 cannot make the file";
    if (!(image = malloc((size_t)size + 1)))
        return REASON_MEMORY;
    if (H5Fget_file_image(file, image, (size_t)size) != size)
        why = "HDF5 cannot make the file";
    else
        fwrite(image, 1, (size_t)size, out);
    free(image);
    return why;
}

const char *export_hdf5(const struct vxf_list *list, const char *header, FILE *out)
{
    struct vxf_array text = {.name = "vxf_header", .unit = "text", .type = VXF_U8, .ndim = 1, .dim = {(int64_t)strlen(header)}, .data = header};
    hid_t access, create, plain, file;
    const char *why = NULL;

    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    access = H5Pcreate(H5P_FILE_ACCESS);
    create = H5Pcreate(H5P_FILE_CREATE);
    plain = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_fapl_core(access, GROW, 0);
    H5Pset_obj_track_times(create, 0);
    H5Pset_obj_track_times(plain, 0);
    file = H5Fcreate("vxdump", H5F_ACC_TRUNC, create, access);
    if (file < 0)
        why = "HDF5 cannot make the file";
    for (int i = 0; i < list->n && !why; i++)
        why = put_array(file, plain, &list->item[i]);
    if (!why)
        why = put_array(file, plain, &text);
    if (!why)
        why = write_image(file, out);
    if (file >= 0)
        H5Fclose(file);
    H5Pclose(plain);
    H5Pclose(create);
    H5Pclose(access);
    return why;
}
