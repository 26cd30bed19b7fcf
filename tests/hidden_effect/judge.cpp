#include "tests/hidden_effect/judge.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <sstream>
#include <utility>

#include "effects/catalogue.h"
#include "files/data_file.h"
#include "files/doubts.h"
#include "files/model_file.h"
#include "files/subject.h"
#include "fit/dwells.h"
#include "fit/several_records.h"
#include "loop/loop.h"

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
  for (const fit::Parameter& c : shape.coefficients)
    for (std::size_t k = 0; k < 3; ++k)
      if (c.name == names[k]) out[k] = c.value;
  return out;
}

std::shared_ptr<const model::ModelSubject> subject_of(const std::string& model_text) {
  return files::make_subject(files::parse_model(model_text, "model.toml").model);
}

record::Record read(const std::string& csv, const model::ModelSubject& subject,
                    const std::string& file = "train.csv") {
  record::Record record = files::read_record({file, csv}, subject);
  // As the program does it before any question.
  fit::Averaged averaged = fit::average_dwells(record);
  return averaged.any() ? std::move(averaged.record) : record;
}

/// A suggested point in the generator's units.
Point point_of(const verdict::SuggestedMeasurement& m) {
  const auto value = [&](const record::Channel& channel) {
    for (const fit::Setting& s : m.point)
      if (*s.channel == channel) return channel.in_unit(s.value);
    return unset;
  };
  return {value(record::speed), value(record::axial_load), value(record::temperature), 0.0};
}

void fill(Answer& answer, const verdict::Diagnosis& d) {
  answer.verdict = verdict::name(d.verdict);
  answer.sentence = d.sentence;
  for (const verdict::RankedEffect& e : d.effects)
    if (e.in_verdict) {
      answer.names.push_back(e.id);
      answer.intervals.push_back(e.parameters[e.size].interval);
    }
  // By rank: a verdict lists the base law's own exponents first whatever their gain.
  const auto best =
      std::max_element(d.effects.begin(), d.effects.end(),
                       [](const verdict::RankedEffect& a, const verdict::RankedEffect& b) {
                         return a.gain < b.gain;
                       });
  if (best != d.effects.end()) answer.first = best->id;
  for (const verdict::SuggestedMeasurement& m : d.suggested_measurements)
    answer.suggested.insert(answer.suggested.end(), static_cast<std::size_t>(m.repeats),
                            point_of(m));
  for (const verdict::DetectableSize& s : d.would_have_been_found)
    answer.stated.emplace_back(s.id, s.share_of_reading);
  for (const verdict::OtherBaseTried& base : d.other_bases) answer.tried_laws.push_back(base.id);
  // A fitted form is no law: what it describes has no explanation yet.
  if (!d.other_bases.empty() && d.other_bases.front().explains &&
      !d.other_bases.front().fitted_form)
    answer.other_law = d.other_bases.front().id.substr(std::string_view("law:").size());
  if (d.given_other_base)
    for (const verdict::RankedEffect& e : d.given_other_base->effects)
      if (e.in_verdict) answer.names_given_it.push_back(e.id);
  if (d.shape) {
    answer.shape = d.shape->formula;
    answer.exponents = exponents_of(*d.shape);
  }
}

/// Root mean square of prediction minus reading over sigma; `relative`: of prediction over true
/// torque - 1.
double rms_error(const fit::Subject& subject, const record::Record& record,
                 const std::vector<Reading>& rows, bool relative) {
  const std::vector<double> predicted = fit::predict(subject, record);
  double sum = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double torque = predicted[i] / N_mm;
    const double error =
        relative ? torque / rows[i].torque - 1.0 : (torque - rows[i].measured) / rows[i].sigma;
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(rows.size()));
}

}  // namespace

Answer ask(const std::string& model_text, const std::string& train_text,
           const Presentation& presentation) {
  Answer answer;
  try {
    const auto subject =
        subject_of(presentation.other_start ? with_other_start(model_text) : model_text);
    const record::Record data =
        read(presentation.reversed_rows ? reversed_rows(train_text) : train_text, *subject);
    for (files::Doubt& doubt : files::doubts(*subject, data))
      answer.questions.push_back(std::move(doubt.text));
    verdict::DiagnoseOptions options;
    if (presentation.reversed_catalogue)
      for (const fit::Candidate& c : subject->candidates())
        options.candidates.insert(options.candidates.begin(), c.id);
    const std::clock_t start = std::clock();
    const verdict::Diagnosis d = loop::diagnose(*subject, data, options);
    answer.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    fill(answer, d);
  } catch (const std::exception& e) {
    answer.verdict = "failed";
    answer.message = e.what();
  }
  return answer;
}

namespace {

/// Two records of one model, each with its own f0 and z.
Answer ask_both(const Rig& rig, std::span<const Reading> readings) {
  Answer answer;
  try {
    const auto subject = subject_of(model_text(rig));
    const record::Record both = record::joined(
        {read(measurement_text(rig, readings.first(rig.second_record)), *subject),
         read(measurement_text(rig, readings.subspan(rig.second_record)), *subject, "second.csv")});
    fill(answer, loop::diagnose(fit::SeveralRecords(subject, both, {"f0", "z"}), both, {}));
  } catch (const std::exception& e) {
    answer.verdict = "failed";
    answer.message = e.what();
  }
  return answer;
}

}  // namespace

Answer ask(const Rig& rig, std::span<const Reading> readings, const Presentation& presentation) {
  if (rig.second_record > 0) return ask_both(rig, readings);
  return ask(model_text(rig), measurement_text(rig, readings), presentation);
}

Improvement improve(const Rig& rig, std::span<const std::string> names) {
  Improvement out;
  model::Model model = files::parse_model(model_text(rig), "model.toml").model;
  for (const std::string& id : names) {
    const effects::Description* d = effects::find(id);
    if (d == nullptr) return out;
    model.effects.push_back({.description = d, .values = effects::initial_values(*d)});
    for (const effects::Parameter& p : d->parameters)
      model.free.push_back(id + "." + std::string(p.name));
  }
  const auto subject = files::make_subject(model);
  record::Record data = read(measurement_text(rig, rig.train), *subject);
  std::vector<double> sigma;
  for (const Reading& r : rig.train) sigma.push_back(r.sigma * N_mm);
  data.set(record::torque_deviation, std::move(sigma)).known = true;
  const verdict::Calibration fitted = loop::calibrate(*subject, data);
  out.converged = fitted.converged();
  // Those of the law stand before those of the effects.
  const std::size_t count = free_values(rig.setup.law).size();
  for (std::size_t k = 0; k < count; ++k) out.free.push_back(fitted.parameters[k].value);
  out.in_sample = rms_error(*fitted.subject, data, rig.train, false);
  out.validation =
      rms_error(*fitted.subject, read(measurement_text(rig, rig.test), *subject), rig.test, true);
  return out;
}

bool joins_contacts(std::string_view id) {
  return is_known(id) && effects::find(id)->within_contacts.empty();
}
bool is_known(std::string_view id) { return effects::find(id) != nullptr; }
bool is_empirical(std::string_view id) { return is_known(id) && effects::find(id)->empirical; }
bool is_datum(std::string_view id) { return is_known(id) && !effects::find(id)->datum.empty(); }

}  // namespace hidden_effect
