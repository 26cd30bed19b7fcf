#include "friction/contact/detail/traction_pass_impl.h"

namespace raceway::friction::contact {

TractionKernel traction_kernel_avx2() { return traction_kernel_in<xsimd::fma3<xsimd::avx2>>(); }

}  // namespace raceway::friction::contact
