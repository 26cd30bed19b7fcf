#include "session/period.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "text/csv.h"
#include "text/error.h"
#include "text/units.h"

namespace raceway::session {
namespace {

/// "22h" [s]
double seconds_of(const std::string& text, const std::string& flag) {
  double value = unset;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  const std::string_view name(end, static_cast<std::size_t>(last - end));
  const text::Unit* const unit = error == std::errc() ? text::find_unit(name) : nullptr;
  if (!unit || unit->dimension != text::Dimension::time || !(value >= 0.0) || !std::isfinite(value))
    throw text::InputError(
        fmt::format(
            "{}: {}: write a time since the first row with its unit, such as 22h, 90min or 3600s",
            flag, text::quoted(text)),
        {.key = flag});
  return value * unit->factor;
}

}  // namespace

void Period::apply(record::Record& record,
                   const std::vector<const record::Channel*>& measured) const {
  if (!is_given()) return;
  const double lowest = from.empty() ? 0.0 : seconds_of(from, "--from");
  const double highest =
      until.empty() ? std::numeric_limits<double>::infinity() : seconds_of(until, "--until");
  const std::span<const double> time = record.values(record::time);
  std::size_t all = 0, left = 0;
  std::vector<const record::Channel*> seen;  // several models may predict one reading
  for (const record::Channel* channel : measured) {
    record::Column* const column = record.find(*channel);
    if (!column || std::find(seen.begin(), seen.end(), channel) != seen.end()) continue;
    seen.push_back(channel);
    for (std::size_t k = 0; k < time.size(); ++k) {
      double& reading = column->values[k];
      if (std::isnan(reading)) continue;
      ++all;
      const double since = time[k] - time.front();
      if (since >= lowest && since <= highest)
        ++left;
      else
        reading = std::numeric_limits<double>::quiet_NaN();
    }
  }
  if (all == 0) return;  // the command names the missing column
  if (left == 0)
    throw text::InputError(
        fmt::format("{}: no reading {}{}{}{}: the record goes from 0 to {:.4g} h", record.source,
                    from.empty() ? "" : "from " + from, !from.empty() && !until.empty() ? " " : "",
                    until.empty() ? "" : "until " + until, " is used",
                    (time.back() - time.front()) / 3600.0),
        {.file = record.source, .key = from.empty() ? "--until" : "--from"});
  record.notes.push_back(record::note::left_out(
      fmt::format("the program uses the readings in the chosen period: {} of {}", left, all)));
}

}  // namespace raceway::session
