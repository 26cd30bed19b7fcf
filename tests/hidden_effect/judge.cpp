#include "tests/hidden_effect/judge.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <sstream>
#include <utility>

#include "bearing/units.h"
#include "effects/catalogue.h"
#include "fit/calibrate.h"
#include "fit/diagnose.h"
#include "fit/prediction.h"
#include "io/data_file.h"
#include "io/model_file.h"

namespace hidden_effect {
namespace {

using namespace raceway;

std::string reversed_rows(const std::string& csv) {
  std::istringstream stream(csv);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  std::reverse(lines.begin() + 1, lines.end());
  std::string out;
  for (const std::string& line : lines) out += line + '\n';
  return out;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string with_other_start(std::string model) {
  model = replaced(std::move(model), "\nf0 = 2.0", "\nf0 = 1.1");
  model = replaced(std::move(model), "\nz = 0.0008", "\nz = 0.0013");
  return replaced(std::move(model), "\"f0\", \"z\"", "\"z\", \"f0\"");
}

/// Exponents of speed, load and viscosity of a shape c n^a F^b nu^d, zero where it has none.
std::vector<double> exponents_of(const fit::Shape& shape) {
  std::vector<double> out(3, 0.0);
  constexpr std::string_view names[] = {"a", "b", "d"};
  for (const fit::EffectSize& c : shape.coefficients)
    for (std::size_t k = 0; k < 3; ++k)
      if (c.name == names[k]) out[k] = c.value;
  return out;
}

fit::DataSet read(const std::string& csv, const fit::Rig& rig) {
  return std::get<fit::DataSet>(io::parse_measurement(csv, "train.csv", rig));
}

}  // namespace

Answer ask(const std::string& model_text, const std::string& train_text,
           const Presentation& presentation) {
  Answer answer;
  try {
    const fit::Model model =
        io::parse_model(presentation.other_start ? with_other_start(model_text) : model_text,
                        "model.toml")
            .model;
    const fit::DataSet data =
        read(presentation.reversed_rows ? reversed_rows(train_text) : train_text, model.rig);
    fit::DiagnoseOptions options;
    if (presentation.reversed_catalogue) {
      for (const effects::Description& d : effects::catalogue())
        options.candidates.insert(options.candidates.begin(), &d);
    }
    const std::clock_t start = std::clock();
    const fit::Diagnosis d = fit::diagnose(model, data, options);
    answer.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    answer.verdict = fit::name(d.verdict);
    answer.sentence = d.sentence;
    for (const fit::RankedEffect& e : d.effects)
      if (e.in_verdict) answer.names.push_back(e.id);
    // By rank: a verdict lists the base law's own exponents first whatever their gain.
    const auto best = std::max_element(
        d.effects.begin(), d.effects.end(),
        [](const fit::RankedEffect& a, const fit::RankedEffect& b) { return a.gain < b.gain; });
    if (best != d.effects.end()) answer.first = best->id;
    for (const fit::SuggestedMeasurement& m : d.suggested_measurements)
      for (int i = 0; i < m.repeats; ++i)
        answer.suggested.push_back(
            {m.point.speed / rpm, m.point.axial_load, m.point.temperature - celsius_zero, 0.0});
    if (d.shape) {
      answer.shape = d.shape->formula;
      answer.exponents = exponents_of(*d.shape);
    }
  } catch (const std::exception& e) {
    answer.verdict = "failed";
    answer.message = e.what();
  }
  return answer;
}

Answer ask(const Rig& rig, std::span<const Reading> readings, const Presentation& presentation) {
  return ask(model_text(rig), measurement_text(readings), presentation);
}

Improvement improve(const Rig& rig, std::span<const std::string> names) {
  Improvement out;
  fit::Model model = io::parse_model(model_text(rig), "model.toml").model;
  for (const std::string& id : names) {
    const effects::Description* d = effects::find(id);
    if (d == nullptr) return out;
    model.effects.push_back({.description = d, .values = effects::initial_values(*d)});
    for (const effects::Parameter& p : d->parameters)
      model.free.push_back(id + "." + std::string(p.name));
  }
  fit::DataSet data = read(measurement_text(rig.train), model.rig);
  data.noise = fit::NoiseSource::declared;
  for (std::size_t i = 0; i < data.rows.size(); ++i) data.rows[i].std = rig.train[i].sigma * N_mm;
  const fit::Calibration fitted = fit::calibrate(model, data);
  out.converged = fitted.converged();
  out.f0 = fitted.model.law_values[0];
  out.z = fitted.model.law_values[1];
  const auto rms_of = [&](const std::vector<Reading>& rows, const fit::DataSet& set,
                          bool relative) {
    const std::vector<fit::FrictionPrediction> p = fit::predict_rows(fitted.model, set);
    double sum = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double torque = p[i].reading / N_mm;
      const double error =
          relative ? torque / rows[i].torque - 1.0 : (torque - rows[i].measured) / rows[i].sigma;
      sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(rows.size()));
  };
  out.in_sample = rms_of(rig.train, data, false);
  out.validation = rms_of(rig.test, read(measurement_text(rig.test), model.rig), true);
  return out;
}

bool is_known(std::string_view id) { return effects::find(id) != nullptr; }

}  // namespace hidden_effect
