#include "friction/contact/detail/contact_kernel_impl.h"

namespace raceway::friction::contact {

void contact_kernel_avx512(const KernelRace& race, bool spins, ContactBlock* blocks,
                           std::size_t count) {
  contact_kernel_in<xsimd::avx512dq>(race, spins, blocks, count);
}

}  // namespace raceway::friction::contact
