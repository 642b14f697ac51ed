#ifndef asperity_base_vector_widths_h
#define asperity_base_vector_widths_h

/**
 * Before a function: one version of it for every width of vector registers,
 * chosen when the program is loaded, since a package for all processors is
 * compiled for the oldest. Sanitizers start too late for that choice. The
 * version in the middle is named by what it needs: a processor's name would
 * leave out those of other makers.
 */
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && \
  !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#  define ASPERITY_ALL_VECTOR_WIDTHS \
    __attribute__((target_clones("avx512f", "arch=x86-64-v3", "default")))
#else
#  define ASPERITY_ALL_VECTOR_WIDTHS
#endif

/** Before such a function, too: what it calls becomes part of it, so that there
 *  is a version of that for every width as well. */
#if defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__)
#  define ASPERITY_INLINE_ALL __attribute__((flatten))
#else
#  define ASPERITY_INLINE_ALL
#endif

#endif
