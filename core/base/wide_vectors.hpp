#pragma once

/// Before a function: the compiler makes it twice, for processors with AVX2 and for any, and the right one is chosen when the
/// program starts. Only for loops whose numbers do not depend on the width of vectors (no sums of floats). Not where a sanitizer
/// or another compiler is at work: then there is one.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__gnu_linux__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define STEMWISE_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define STEMWISE_WIDE_VECTORS
#endif
