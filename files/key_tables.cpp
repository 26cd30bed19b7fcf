#include "files/key_tables.h"

#include <algorithm>
#include <cmath>

#include "text/detail/json_text.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/column_section.h"
#include "files/detail/contact_section.h"
#include "files/detail/correction_prior.h"
#include "files/detail/correction_trust.h"
#include "files/detail/effect_section.h"
#include "files/detail/export_section.h"
#include "files/detail/formula_section.h"
#include "files/detail/friction_section.h"
#include "files/detail/loop_section.h"
#include "files/detail/rig_section.h"
#include "files/detail/roller_section.h"
#include "files/detail/sensor_section.h"
#include "files/detail/shaft_section.h"
#include "files/detail/spindle_parts.h"
#include "files/detail/spindle_section.h"
#include "files/detail/transducer_section.h"

namespace raceway::files {

std::string ListedKey::meaning() const {
  return only.empty() ? std::string(key.meaning) : fmt::format("{}: {}", only, key.meaning);
}

std::string ListedKey::fallback() const {
  const auto& [value, words, required] = key.fallback;
  if (!std::isnan(value)) return fmt::format("{:.10g}", value);
  const Names choices = key.form.choices();
  const bool is_choice = std::find(choices.begin(), choices.end(), words) != choices.end();
  return is_choice ? fmt::format("\"{}\"", words) : std::string(words);
}

std::vector<ListedKey> model_keys() {
  std::vector<KeyTable> tables;
  for (const auto& of_reader :
       {bearing_tables(),    contact_tables(),       friction_tables(),    effect_tables(),
        formula_tables(),    rig_tables(),           loop_tables(),        column_tables(),
        transducer_tables(), torque_sensor_tables(), arrangement_tables(), spindle_tables(),
        body_tables(),       surroundings_tables(),  network_tables(),     correction_tables(),
        prior_tables(),      trust_tables(),         export_tables(),      roller_tables()})
    tables.insert(tables.end(), of_reader.begin(), of_reader.end());
  std::vector<ListedKey> list;
  for (auto first = tables.begin(); first != tables.end();) {
    // All parts of one table, wherever they are read.
    const auto last = std::stable_partition(
        first, tables.end(), [name = first->name](const KeyTable& t) { return t.name == name; });
    for (; first != last; ++first)
      for (const Key& key : first->keys) list.push_back({first->name, first->only, key});
  }
  return list;
}

std::string model_keys_json(std::span<const ListedKey> keys) {
  const auto or_null = [](std::string_view words) {
    return words.empty() ? text::json(nullptr) : text::json(words);
  };
  text::json list = text::json::array();
  for (const ListedKey& one : keys)
    list.push_back({{"table", one.table},
                    {"key", one.key.name},
                    {"kind", one.key.form.kind},
                    {"unit", or_null(one.key.form.unit)},
                    {"from", one.key.form.lower},
                    {"to", one.key.form.upper},
                    {"whole_number", one.key.form.whole},
                    {"required", one.key.fallback.required},
                    {"choices", one.key.form.choices()},
                    {"default", or_null(one.fallback())},
                    {"only", or_null(one.only)},
                    {"meaning", one.meaning()}});
  return text::text({{"keys", list}});
}

}  // namespace raceway::files
