#include "cli/csv_style.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/messages.h"
#include "text/error.h"
#include "text/spreadsheet_csv.h"

namespace raceway::cli {
namespace {

/// run.csv: run_comments.txt
std::string comments_beside(const std::string& path) {
  const std::filesystem::path file(path);
  return (file.parent_path() / (file.stem().string() + "_comments.txt")).string();
}

text::SpreadsheetMarks marks_of(const CsvStyle& style) {
  text::SpreadsheetMarks marks;
  if (style.decimal_mark == "point") marks = {.separator = ',', .decimal = '.'};
  if (!style.separator.empty())
    marks.separator = style.separator == "tab" ? '\t' : style.separator == "comma" ? ',' : ';';
  return marks;
}

}  // namespace

void CsvStyle::declare(CLI::App& command, const std::vector<std::string>& others,
                       const std::string& help) {
  std::vector<std::string> names{"csv", "plain", "excel"};
  names.insert(names.end(), others.begin(), others.end());
  command
      .add_option("--format", format,
                  "csv (default; with the model in lines that start with #), plain (first line is "
                  "the header, comments in FILE_comments.txt; for pandas and MATLAB), " +
                      help +
                      "excel (like plain, with semicolons and decimal commas for a German Excel)")
      ->check(CLI::IsMember(names))
      ->type_name("NAME");
  command
      .add_option("--separator", separator,
                  "field separator for --format excel: semicolon, comma or tab; default: "
                  "semicolon, or comma with --decimal-mark point")
      ->check(CLI::IsMember({"semicolon", "comma", "tab"}))
      ->type_name("MARK");
  command
      .add_option("--decimal-mark", decimal_mark,
                  "decimal mark for --format excel: comma (default) or point")
      ->check(CLI::IsMember({"comma", "point"}))
      ->type_name("MARK");
}

void CsvStyle::check() const {
  for (const auto& [flag, value] :
       {std::pair<const char*, const std::string&>{"--separator", separator},
        {"--decimal-mark", decimal_mark}})
    if (!value.empty() && !for_spreadsheet())
      throw text::InputError(std::string(flag) + ": only possible with --format excel",
                             {.key = flag});
  const text::SpreadsheetMarks marks = marks_of(*this);
  if (marks.separator == marks.decimal)
    throw text::InputError(
        "--separator comma: not possible with decimal commas; add --decimal-mark point",
        {.key = "--separator"});
}

void CsvStyle::require_writable(const std::string& path, text::IfExists if_exists) const {
  check();
  if (path.empty() || path == "-") return;
  text::require_name_of(path, text::Written::table);
  text::require_writable(path, if_exists);
  if (has_comments_apart()) text::require_writable(comments_beside(path), if_exists);
}

void CsvStyle::put(const std::string& path, const std::string& csv, text::IfExists if_exists,
                   std::string_view what) const {
  if (path.empty()) return;
  if (!has_comments_apart()) {
    if (path == "-") return fmt::print("{}", csv);
    text::write_text(path, csv, if_exists);
    return say(fmt::format("{} written{}", path, what));
  }
  const text::PlainCsv sheet =
      for_spreadsheet() ? text::spreadsheet_csv(csv, marks_of(*this)) : text::plain_csv(csv);
  if (path == "-") return fmt::print("{}", sheet.table);
  if (sheet.comments.empty()) {
    text::write_text(path, sheet.table, if_exists);
    return say(fmt::format("{} written{}", path, what));
  }
  const std::string beside = comments_beside(path);
  text::write_files({{path, sheet.table}, {beside, sheet.comments}}, if_exists);
  say(fmt::format("{} written{}; {} written", path, what, beside));
}

}  // namespace raceway::cli
