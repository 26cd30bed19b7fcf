#include "io/key_meanings.h"

#include <array>

namespace raceway::io {
namespace {

constexpr std::array meanings{
    KeyMeaning{"bearing", "name", "of the bearing, for results"},
};

}  // namespace

std::span<const KeyMeaning> key_meanings() { return meanings; }

}  // namespace raceway::io
