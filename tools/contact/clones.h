/* A kernel compiled for several widths of vector.  With contraction off and no reassociation every clone gives the
 * same bits; clang wants clones static and called from the file that defines them.  Not under the address sanitizer, whose
 * runtime is not up when a clone is chosen. */
#ifndef VX_CONTACT_CLONES_H
#define VX_CONTACT_CLONES_H

#if defined __x86_64__ && defined __GNUC__ && !defined __SANITIZE_ADDRESS__
#define CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define CLONES
#endif

#endif
