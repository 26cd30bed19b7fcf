#include "files/model_parts.h"

#include "text/error.h"
#include "text/input_file.h"

// Last: see text/detail/toml_text.h.
#include "text/detail/toml_text.h"

namespace raceway::files {

ModelParts parts_of(const std::string& text) try {
  const toml::table root = text::parse_toml(text, "model");
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
} catch (const text::InputError&) {
  return {};
}

ModelParts parts_of_file(const std::string& path) try {
  return parts_of(text::peek_text(path));
} catch (const text::InputError&) {
  return {};
}

}  // namespace raceway::files
