#include <stdexcept>

#include "bearing/simd_kernel.h"

namespace raceway::bearing {

// WebAssembly has vectors of 128 bits, which the kernel of SSE2 fills. available() says so.

void solve_avx2(const KernelCall&) {
  throw std::logic_error("solve_avx2: WebAssembly does not have AVX2 instructions");
}

void solve_avx512(const KernelCall&) {
  throw std::logic_error("solve_avx512: WebAssembly does not have AVX-512 instructions");
}

}  // namespace raceway::bearing
