#include "cli/merge.h"

#include <fmt/format.h>

#include "cli/table_memory.h"
#include "files/table_file.h"
#include "text/error.h"
#include "text/input_file.h"

namespace raceway::cli {

void merge_slabs(const std::vector<std::string>& slabs, const std::string& output,
                 const CsvStyle& csv, text::IfExists if_exists) {
  if (output.empty())
    throw text::InputError("raceway table: --merge writes a file: --output is missing",
                           {.key = "--output"});
  if (csv.format != "csv" && csv.format != "excel")
    throw text::InputError("raceway table: --merge writes --format csv or excel",
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
