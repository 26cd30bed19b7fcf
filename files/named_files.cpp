#include "files/named_files.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string_view>
#include <utility>

#include "text/input_file.h"
#include "text/names.h"

// Last: see text/detail/toml_text.h.
#include "text/detail/toml_text.h"

namespace raceway::files {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> keys_of_files{"friction_table", "table", "file"};

/// Without links, so that ".." leads to the folder above.
fs::path from_root(const fs::path& folder) {
  return fs::weakly_canonical(fs::current_path() / folder);
}

}  // namespace

NamedFiles::NamedFiles(const std::string& model, std::vector<NamedFile> held)
    : folder_(fs::path(model).parent_path()), held_(std::move(held)) {}

std::string NamedFiles::shown(const std::string& name) const {
  return (folder_ / fs::path(name)).string();
}

const NamedFile& NamedFiles::read(const std::string& name) {
  const auto has_name = [&](const NamedFile& file) { return file.name == name; };
  if (const auto done = std::find_if(read_.begin(), read_.end(), has_name); done != read_.end())
    return *done;
  const auto known = std::find_if(held_.begin(), held_.end(), has_name);
  if (known != held_.end()) return read_.emplace_back(*known);
  const std::string path = shown(name);
  std::string text = text::read_text(path);
  return read_.emplace_back(
      NamedFile{name, (from_root(folder_) / name).lexically_normal().string(), std::move(text)});
}

std::string with_names_from(std::string text, const std::vector<NamedFile>& files,
                            const std::string& path) {
  std::map<std::string, std::string> names;  // old, new
  for (const NamedFile& file : files) {
    if (fs::path(file.name).is_absolute()) continue;
    const fs::path at(file.path);
    const fs::path relative =
        path.empty() ? at : at.lexically_relative(from_root(fs::path(path).parent_path()));
    names[file.name] = (relative.empty() ? at : relative).generic_string();
  }
  // From the last to the first, so that places before them stay.
  std::map<std::size_t, std::pair<std::size_t, std::string>> changes;
  const toml::table root = text::parse_toml(text, "model");
  const std::function<void(const toml::node&)> look = [&](const toml::node& node) {
    if (const toml::array* const list = node.as_array())
      for (const toml::node& one : *list) look(one);
    const toml::table* const table = node.as_table();
    if (!table) return;
    for (const auto& [key, value] : *table) {
      look(value);
      const auto name = value.value<std::string>();
      if (!name ||
          std::find(keys_of_files.begin(), keys_of_files.end(), key.str()) == keys_of_files.end())
        continue;
      const auto known = names.find(*name);
      if (known == names.end() ||
          known->second == fs::path(*name).lexically_normal().generic_string())
        continue;
      const std::size_t begin = text::byte_of(text, value.source().begin);
      changes[begin] = {text::byte_of(text, value.source().end), text::in_quotes(known->second)};
    }
  };
  look(root);
  for (auto change = changes.rbegin(); change != changes.rend(); ++change)
    text.replace(change->first, change->second.first - change->first, change->second.second);
  return text;
}

}  // namespace raceway::files
