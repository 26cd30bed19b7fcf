#include "io/model_parts.h"

#include "io/error.h"
#include "io/input_file.h"

// Last: see io/toml_text.h.
#include "io/toml_text.h"

namespace raceway::io {

ModelParts parts_of(const std::string& text) try {
  const toml::table root = parse_toml(text, "model");
  ModelParts parts{.bearing = root.contains("bearing")};
  const auto add = [&](const toml::table& correction) {
    parts.displacements.push_back(
        correction["displacement"].value_or(std::string("its displacement")));
  };
  if (const toml::node* const node = root.get("correction")) {
    if (const toml::table* const one = node->as_table()) add(*one);
    if (const toml::array* const several = node->as_array())
      for (const toml::node& one : *several)
        if (const toml::table* const table = one.as_table()) add(*table);
    if (parts.displacements.empty()) parts.displacements.emplace_back();  // its reader says why
  }
  return parts;
} catch (const InputError&) {
  return {};
}

ModelParts parts_of_file(const std::string& path) try {
  return parts_of(peek_text(path));
} catch (const InputError&) {
  return {};
}

}  // namespace raceway::io
