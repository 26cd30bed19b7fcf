#include "record/kept_channel.h"

#include <deque>
#include <mutex>
#include <string>

namespace raceway::record {
namespace {

/// A channel with the texts that its views are of.
struct OwnedHeader {
  std::string name, unit;
  Channel channel;
};

}  // namespace

const Channel& kept_channel(std::string_view header, std::string_view unit) {
  static std::mutex mutex;
  static std::deque<OwnedHeader> made;  // addresses of its elements stay
  const std::scoped_lock lock(mutex);
  for (const OwnedHeader& one : made)
    if (one.name == header && one.unit == unit) return one.channel;
  OwnedHeader& one = made.emplace_back();
  one.name = header;
  one.unit = unit;
  one.channel = {
      .name = one.name, .unit = one.unit, .lower = -endless, .upper = endless, .role = Role::kept};
  return one.channel;
}

}  // namespace raceway::record
