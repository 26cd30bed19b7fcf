#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

// Last: see text/detail/toml_text.h.
#include "files/detail/marked_values.h"

namespace raceway::files {
namespace {

constexpr std::array<std::string_view, 2> marks{"assumed", "estimated"};

/// The first comment from byte `from` on in its line, without `#`; empty unless it marks a guess.
std::string_view mark_behind(std::string_view text, std::size_t from) {
  const std::size_t end = std::min(text.find('\n', from), text.size());
  std::string_view comment = text.substr(from, end - from);
  comment.remove_prefix(std::min(comment.find('#'), comment.size()));
  if (std::none_of(marks.begin(), marks.end(),
                   [&](std::string_view mark) { return comment.find(mark) != comment.npos; }))
    return {};
  comment.remove_prefix(std::min(comment.find_first_not_of("# "), comment.size()));
  return comment.substr(0, comment.find_last_not_of(" \t\r") + 1);
}

/// True of a table or a list of tables with headers of their own.
bool has_header(const toml::node& node) {
  if (const toml::table* const table = node.as_table()) return !table->is_inline();
  const toml::array* const list = node.as_array();
  return list && list->is_array_of_tables() && !list->front().as_table()->is_inline();
}

class MarkedValues {
 public:
  explicit MarkedValues(std::string_view text) : text_(text) {}

  void collect(const toml::table& table, const std::string& name) {
    const std::string_view of_table =
        name.empty() ? std::string_view()
                     : mark_behind(text_, text::line_start(text_, table.source().begin.line));
    for (const auto& [key, node] : table) {
      const std::string path =
          name.empty() ? std::string(key.str()) : fmt::format("{}.{}", name, key.str());
      if (!has_header(node)) {
        const std::string_view mark = mark_behind(text_, text::byte_of(text_, node.source().end));
        if (const std::string_view why = mark.empty() ? of_table : mark; !why.empty())
          found_.emplace_back(node.source().begin.line,
                              UsedDefault{name, std::string(key.str()), text::shown(node),
                                          UsedDefault::Origin::marked, std::string(why)});
      } else if (const toml::array* const list = node.as_array()) {
        for (std::size_t k = 0; k < list->size(); ++k)
          collect(*list->get(k)->as_table(), fmt::format("{}[{}]", path, k));
      } else {
        collect(*node.as_table(), path);
      }
    }
  }

  std::vector<UsedDefault> take() {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<UsedDefault> values;
    for (auto& [line, one] : found_) values.push_back(std::move(one));
    return values;
  }

 private:
  std::string_view text_;
  std::vector<std::pair<toml::source_index, UsedDefault>> found_;
};

}  // namespace

std::vector<UsedDefault> marked_values(const toml::table& root, std::string_view text) {
  MarkedValues values(text);
  values.collect(root, "");
  return values.take();
}

std::string without_mark(std::string text, std::size_t value_end) {
  if (mark_behind(text, value_end).empty()) return text;
  const std::size_t end = std::min(text.find_first_of("\r\n", value_end), text.size());
  const std::size_t comment = text.find('#', value_end);
  const std::size_t begin = text.find_last_not_of(" \t", comment - 1) + 1;
  return text.erase(begin, end - begin);
}

}  // namespace raceway::files
