#include "io/json_text.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "bearing/units.h"

namespace raceway::io {
namespace {

void round_to_15_digits(json& value) {
  if (value.is_number_float()) {
    const double exact = value.get<double>();
    if (std::isfinite(exact)) value = std::strtod(fmt::format("{:.15g}", exact).c_str(), nullptr);
  } else if (value.is_structured()) {
    for (json& element : value) round_to_15_digits(element);
  }
}

}  // namespace

std::string exact_text(const json& document) {
  return document.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string text(json document) {
  round_to_15_digits(document);
  return exact_text(document);
}

json report_json(const bearing::SolveReport& report) {
  return {{"status", bearing::name(report.status)},
          {"iterations", report.iterations},
          {"residual", report.residual},
          {"recovered_load_error", report.recovered_load_error}};
}

json friction_json(const fit::Model& model, const fit::FrictionPrediction& f) {
  json parts = {{"load_Nmm", f.load / N_mm}, {"viscous_Nmm", f.viscous / N_mm}};
  for (std::size_t i = 0; i < f.effects.size(); ++i)
    parts[std::string(model.effects[i].description->id) + "_Nmm"] = f.effects[i] / N_mm;
  return parts;
}

}  // namespace raceway::io
