// Hot loops for processors with wider vectors: PHS_WIDE before a function compiles it twice, and the
// program takes the one that the processor can. Both do the same operations (no fused ones), so the
// bits are the same.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PHS_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define PHS_WIDE
#endif
/// What such a function calls and has to be compiled with it.
#define PHS_WITHIN_WIDE inline __attribute__((always_inline))
