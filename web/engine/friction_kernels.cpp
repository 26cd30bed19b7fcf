#include <stdexcept>

#include "friction/contact/detail/contact_kernel.h"
#include "friction/contact/detail/traction_pass.h"

namespace raceway::friction::contact {

// As bearing_kernels.cpp: wider vectors than those of SSE2 are not there and not asked for.

TractionKernel traction_kernel_avx2() {
  throw std::logic_error("traction_kernel_avx2: WebAssembly does not have AVX2 instructions");
}

void contact_kernel_avx2(const KernelRace&, bool, ContactBlock*, std::size_t) {
  throw std::logic_error("contact_kernel_avx2: WebAssembly does not have AVX2 instructions");
}

TractionKernel traction_kernel_avx512() {
  throw std::logic_error("traction_kernel_avx512: WebAssembly does not have AVX-512 instructions");
}

void contact_kernel_avx512(const KernelRace&, bool, ContactBlock*, std::size_t) {
  throw std::logic_error("contact_kernel_avx512: WebAssembly does not have AVX-512 instructions");
}

}  // namespace raceway::friction::contact
