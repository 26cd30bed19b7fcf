#include "report/report_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "text/detail/json_text.h"

namespace raceway::report {
namespace {

void append(std::string& text, double value) {
  if (std::isfinite(value))
    fmt::format_to(std::back_inserter(text), "{:.7g}", value + 0.0);
  else
    text += "null";
}

bool constant(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [&](double v) {
    return v == values.front() || (std::isnan(v) && std::isnan(values.front()));
  });
}

}  // namespace

void ReportColumns::add(std::string name, std::vector<double> values) {
  if (values.size() != rows_)
    throw std::invalid_argument("report: a column " + name + " of another length");
  columns_.push_back({std::move(name), std::move(values)});
}

void ReportColumns::keep_extremes(const std::vector<double>& values) {
  constexpr std::size_t stretches = 500;
  for (std::size_t s = 0; s < stretches; ++s) {
    std::size_t low = values.size(), high = low;
    for (std::size_t k = s * values.size() / stretches; k < (s + 1) * values.size() / stretches;
         ++k) {
      if (std::isnan(values[k])) continue;
      if (low == values.size() || values[k] < values[low]) low = k;
      if (high == values.size() || values[k] > values[high]) high = k;
    }
    if (low == values.size()) continue;
    keep(low);
    keep(high);
  }
}

std::vector<std::size_t> ReportColumns::kept() const {
  const std::size_t varying = std::max<std::size_t>(
      1,
      static_cast<std::size_t>(std::count_if(columns_.begin(), columns_.end(),
                                             [](const Column& c) { return !constant(c.values); })));
  const std::size_t most = std::min(most_rows, most_numbers / varying);
  std::vector<std::size_t> rows;
  if (rows_ <= most) {
    rows.resize(rows_);
    for (std::size_t i = 0; i < rows_; ++i) rows[i] = i;
    return rows;
  }
  for (std::size_t i = 0; i < most; ++i) rows.push_back(i * rows_ / most);
  rows.insert(rows.end(), wanted_.begin(), wanted_.end());
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

std::string ReportColumns::json() const {
  const std::vector<std::size_t> rows = kept();
  std::string text = fmt::format("{{\"total\":{},\"rows\":{},\"columns\":[", rows_, rows.size());
  for (const Column& column : columns_) {
    if (&column != &columns_.front()) text += ",\n";
    text += "{\"name\":" + text::json(column.name).dump();
    if (!rows.empty() && constant(column.values)) {
      text += ",\"constant\":";
      append(text, column.values.front());
    } else {
      text += ",\"values\":[";
      for (std::size_t k = 0; k < rows.size(); ++k) {
        if (k > 0) text += ',';
        append(text, column.values[rows[k]]);
      }
      text += ']';
    }
    text += '}';
  }
  return text + "]}";
}

}  // namespace raceway::report
