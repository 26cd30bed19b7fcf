#include "io/json_text.h"

#include <fmt/format.h>

#include <cmath>

#include "io/format_number.h"
#include "io/units.h"
#include "model/band.h"
#include "record/units.h"

namespace raceway::io {
namespace {

/// With a point or an exponent, so that it reads back as a number of the same kind.
std::string number_text(double value) {
  if (!std::isfinite(value)) return "null";
  std::string text = fmt::format("{:.15g}", value);
  if (text.find_first_of(".e") == text.npos) text += ".0";
  return text;
}

std::string scalar_text(const json& value) {
  if (value.is_number_float()) return number_text(value.get<double>());
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// The library's own writer gives some numbers one digit too many, so that of numbers is ours.
/// `indent` below zero: all on one line.
void append(std::string& out, const json& value, int indent, int depth) {
  if (!value.is_structured() || value.empty()) {
    out += value.is_structured() ? (value.is_object() ? "{}" : "[]") : scalar_text(value);
    return;
  }
  const auto new_line = [&](int levels) {
    if (indent < 0) return;
    out += '\n';
    out.append(static_cast<std::size_t>(indent * levels), ' ');
  };
  const bool object = value.is_object();
  out += object ? '{' : '[';
  bool first = true;
  for (const auto& [key, element] : value.items()) {
    if (!first) out += ',';
    first = false;
    new_line(depth + 1);
    if (object) out += scalar_text(key) + (indent < 0 ? ":" : ": ");
    append(out, element, indent, depth + 1);
  }
  new_line(depth);
  out += object ? '}' : ']';
}

}  // namespace

std::string text(const json& document) {
  std::string out = fmt::format("{{\n  \"format\": {}", format_number);
  for (const auto& [key, element] : document.items()) {
    out += ",\n  " + scalar_text(key) + ": ";
    append(out, element, 2, 1);
  }
  return out + "\n}\n";
}

std::string line_text(const json& value) {
  std::string out;
  append(out, value, -1, 0);
  return out;
}

json report_json(const bearing::SolveReport& report) {
  return {{"status", bearing::name(report.status)},
          {"iterations", report.iterations},
          {"residual", report.residual},
          {"recovered_load_error", report.recovered_load_error}};
}

json band_json(const BandOfResult& band) {
  return {{"level", model::Band::level}, {"parameters", band.parameters}};
}

void add_band(json& row, const BandOfResult& band, std::size_t index) {
  for (std::size_t k = 0; k < band.names.size(); ++k)
    row[band.names[k]] =
        band.half_widths[index * band.names.size() + k] / column_unit(band.names[k]);
}

json friction_json(const model::Model& model, const model::FrictionPrediction& f) {
  json parts = json::object();
  const std::vector<std::string> names = torque_parts(model);
  const std::vector<double> moments = moments_of_parts(model, f);
  for (std::size_t i = 0; i < names.size(); ++i) parts[names[i] + "_Nmm"] = moments[i] / N_mm;
  return parts;
}

}  // namespace raceway::io
