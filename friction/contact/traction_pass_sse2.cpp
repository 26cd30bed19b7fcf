#include "friction/contact/detail/traction_pass_impl.h"

namespace raceway::friction::contact {

TractionKernel traction_kernel_sse2() { return traction_kernel_in<xsimd::sse2>(); }

}  // namespace raceway::friction::contact
