#include "cli/merge.h"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <string_view>
#include <system_error>

#include "cli/table_memory.h"
#include "files/table_file.h"
#include "text/csv.h"
#include "text/error.h"
#include "text/input_file.h"

namespace raceway::cli {

friction::TableSlab slab_of(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  const auto whole = [&](std::string_view part) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    return error == std::errc() && end == part.data() + part.size() ? value : 0;
  };
  const std::string_view all = text;
  const std::size_t index = slash == text.npos ? 0 : whole(all.substr(0, slash));
  const std::size_t count = slash == text.npos ? 0 : whole(all.substr(slash + 1));
  constexpr std::size_t most = 1000000;
  if (index == 0 || index > count || count > most)
    throw text::InputError("--slab: " + text::quoted(text) +
                               ": write i/N with i from 1 to N and N up to a million, such as 2/4",
                           {.key = "--slab"});
  return {.index = index - 1, .count = count};
}

void merge_slabs(const std::vector<std::string>& slabs, const std::string& output,
                 const CsvStyle& csv, text::IfExists if_exists) {
  if (output.empty())
    throw text::InputError(
        "raceway table: --output is missing; --merge writes the table to this file",
        {.key = "--output"});
  if (csv.format != "csv" && csv.format != "excel")
    throw text::InputError("raceway table: --merge writes only --format csv or excel",
                           {.key = "--format"});
  csv.require_writable(output, if_exists);
  require_memory_to_merge(slabs);
  std::vector<files::SlabText> texts;
  for (const std::string& name : slabs)
    texts.push_back({text::input_name(name), text::read_text(name)});
  const std::string text = files::merged_table_text(texts);
  texts.clear();
  csv.put(output, text, if_exists, fmt::format(" from {} slabs", slabs.size()));
}

}  // namespace raceway::cli
