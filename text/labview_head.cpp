#include "text/labview_head.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/csv.h"
#include "text/names.h"

namespace raceway::text {

void LabviewHead::take(std::string_view line) {
  const std::size_t tab = line.find_first_of("\t,");
  const std::string_view key = trimmed(line.substr(0, tab));
  if (key == "LabVIEW Measurement") is_lvm_ = true;
  if (!is_lvm_ || tab == line.npos) return;
  const std::string_view rest = line.substr(tab + 1);
  // The comma itself, where it is the decimal mark.
  const std::string_view value = trimmed(rest.substr(0, rest.find('\t')));
  if (key == "Decimal_Separator" && value.starts_with(',')) decimal_mark_ = ',';
  if (key == "X0") begin_ = value;
  if (key == "Delta_X") step_ = value;
}

std::optional<std::string> LabviewHead::time_of(std::size_t row) const {
  if (!is_lvm_ || step_.empty()) return std::nullopt;
  const ParsedNumber begin = parse_number(begin_, true), step = parse_number(step_, true);
  if (!begin.problem.empty() || !step.problem.empty() || !(step.value > 0.0)) return std::nullopt;
  std::string text = fmt::format("{:.12g}", begin.value + static_cast<double>(row) * step.value);
  std::replace(text.begin(), text.end(), '.', decimal_mark_);
  return text;
}

}  // namespace raceway::text
