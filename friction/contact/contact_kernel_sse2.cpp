#include "friction/contact/detail/contact_kernel_impl.h"

namespace raceway::friction::contact {

void contact_kernel_sse2(const KernelRace& race, bool spins, ContactBlock* blocks,
                         std::size_t count) {
  contact_kernel_in<xsimd::sse2>(race, spins, blocks, count);
}

}  // namespace raceway::friction::contact
