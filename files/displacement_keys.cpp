#include "files/detail/displacement_keys.h"

#include <deque>
#include <map>
#include <mutex>

#include "record/series_channel.h"

namespace raceway::files {

std::span<const Key> keys_of(const record::Channel* displacement, std::span<const Key> keys) {
  if (!displacement || !record::is_angle(*displacement)) return keys;
  static std::mutex mutex;
  static std::map<const Key*, std::vector<Key>> made;  // by the table that they are made of
  static std::deque<std::string> texts;                // addresses of its elements stay
  const std::scoped_lock lock(mutex);
  std::vector<Key>& own = made[keys.data()];
  if (own.empty())
    for (const Key& key : keys)
      own.push_back(key.as(texts.emplace_back(record::in_unit_of(*displacement, key.name)),
                           texts.emplace_back(record::in_unit_of(*displacement, key.form.unit))));
  return own;
}

}  // namespace raceway::files
