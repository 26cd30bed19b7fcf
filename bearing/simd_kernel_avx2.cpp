#include "bearing/detail/simd_kernel_impl.h"

namespace raceway::bearing {

void solve_avx2(const KernelCall& call) {
  solve_in<xsimd::batch<double, xsimd::fma3<xsimd::avx2>>>(call);
}

}  // namespace raceway::bearing
