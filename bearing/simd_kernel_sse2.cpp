#include "bearing/detail/simd_kernel_impl.h"

namespace raceway::bearing {

void solve_sse2(const KernelCall& call) { solve_in<xsimd::batch<double, xsimd::sse2>>(call); }

}  // namespace raceway::bearing
