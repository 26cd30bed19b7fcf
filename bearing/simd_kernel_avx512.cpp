#include "bearing/detail/simd_kernel_impl.h"

namespace raceway::bearing {

void solve_avx512(const KernelCall& call) { solve_in<xsimd::batch<double, xsimd::avx512dq>>(call); }

}  // namespace raceway::bearing
