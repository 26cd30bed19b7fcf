#include "friction/contact/detail/traction_pass_impl.h"

namespace raceway::friction::contact {

TractionKernel traction_kernel_avx512() { return traction_kernel_in<xsimd::avx512dq>(); }

}  // namespace raceway::friction::contact
