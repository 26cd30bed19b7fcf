// Compiled for each instruction set, with its name in RACEWAY_LIMIT and its xsimd type in
// RACEWAY_LIMIT_ARCH.

#include "bench/limit_kernel.h"

#include <xsimd/xsimd.hpp>

namespace raceway::limit {
namespace {

using Batch = xsimd::batch<double, RACEWAY_LIMIT_ARCH>;

/// The compiler takes x for used and for changed.
[[gnu::always_inline]] inline void touch(Batch& x) {
#ifdef __AVX512F__
  asm volatile("" : "+v"(x.data));
#else
  asm volatile("" : "+x"(x.data));
#endif
}

}  // namespace

void RACEWAY_LIMIT(const Operations& each, long count) {
  Batch root(2.0), quotient(3.0), factor(1.0), term(0.0);
  Batch sum[8];
  for (Batch& s : sum) s = Batch(1.0);
  for (long i = 0; i < count; ++i) {
    for (long k = 0; k < each.roots; ++k) {
      Batch x = root;
      touch(x);
      x = sqrt(x);
      touch(x);
    }
    for (long k = 0; k < each.divisions; ++k) {
      Batch x = quotient;
      touch(x);
      x = quotient / x;
      touch(x);
    }
    for (long k = 0; k < each.fused; k += 8) {
      for (Batch& s : sum) {
        s = s * factor + term;
        touch(s);
      }
    }
  }
}

}  // namespace raceway::limit
