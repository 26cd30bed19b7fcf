#include "report/step_report.h"

#include <cmath>
#include <functional>

#include "record/digits.h"
#include "record/units.h"
#include "report/detail/model_facts.h"
#include "report/detail/report_document.h"
#include "report/report_columns.h"

namespace raceway::report {
namespace {

constexpr int drawn_digits = 6;
constexpr double drawn_beyond = 1.15;  // of the largest power: how far laws are drawn

text::json drawn_values(const std::vector<double>& values, double unit) {
  text::json list = text::json::array();
  for (const double v : values) list.push_back(record::with_digits(v / unit, drawn_digits));
  return list;
}

void add_courses(const std::vector<spindle::StepResponse>& steps, text::json& list) {
  for (const spindle::StepResponse& s : steps)
    list.push_back({{"time_s", drawn_values(s.time, 1.0)},
                    {"displacement_um", drawn_values(s.displacement, um)}});
}

/// The laws between rest and beyond the largest power, for lines: P, the straight line, the power
/// law and the curve. Lines end where they are no longer valid.
text::json law_courses(const spindle::StepResponses& responses, const spindle::PowerLaws& laws) {
  const std::vector<spindle::LagAt> points = at_powers(responses.steps);
  double most = 0.0;
  for (const spindle::LagAt& p : points) most = std::fmax(most, p.input);
  if (!(most > 0.0)) return nullptr;
  const spindle::MonotoneCurve gain = spindle::gain_curve(points);
  const spindle::MonotoneCurve time = spindle::time_curve(points, responses.cool_down.one);
  constexpr int steps = 120;
  std::vector<double> power;
  for (int k = 0; k <= steps; ++k) power.push_back(drawn_beyond * most * k / steps);
  const auto course = [&](const std::function<double(double)>& law, double unit) {
    std::vector<double> values;
    for (const double p : power) values.push_back(law(p));
    return drawn_values(values, unit);
  };
  const auto valid = [&](const spindle::StraightLine& line) {
    return [&laws, &line](double p) {
      return p >= laws.valid_from && p <= laws.valid_to ? line(p) : unset;
    };
  };
  const auto positive = [](const spindle::PowerLaw& law) {
    return [&law](double p) { return p > 0.0 ? law(p) : unset; };
  };
  return {{"power_W", drawn_values(power, 1.0)},
          {"K_line_um", course(valid(laws.gain_line), um)},
          {"K_power_um", course(positive(laws.gain_power), um)},
          {"K_curve_um", course([&](double p) { return gain(p); }, um)},
          {"T_line_min", course(valid(laws.time_line), spindle::one_minute)},
          {"T_power_min", course(positive(laws.time_power), spindle::one_minute)},
          {"T_curve_min", course([&](double p) { return time(p); }, spindle::one_minute)}};
}

void add_superposition(Document& document, const results::Superposition& s,
                       const std::string& programme) {
  document.add("programme", programme);
  ReportColumns columns(s.time.size());
  std::vector<double> hours = s.time, speed = s.speed, simulated = s.simulated,
                      corrected = s.corrected, error;
  for (std::size_t k = 0; k < hours.size(); ++k) {
    hours[k] /= 3600.0;
    speed[k] /= rpm;
    simulated[k] /= um;
    corrected[k] /= um;
    error.push_back(corrected[k] - simulated[k]);
  }
  columns.add("hours", std::move(hours));
  columns.add("time_s", s.time);
  columns.add_course("speed_rpm", std::move(speed));
  columns.add_course("simulated_um", std::move(simulated));
  columns.add_course("corrected_um", std::move(corrected));
  columns.add_course("error_um", std::move(error));
  document.add_text("rows", columns.json());
}

}  // namespace

std::string step_report(const std::string& source, const spindle::StepResponses& responses,
                        const spindle::PowerLaws& laws, const std::vector<record::Note>& notes,
                        const results::Superposition* error, const std::string& programme,
                        const std::vector<ModelOfPage>& facts) {
  Document document("steps");
  document.add("assumed", model_facts(facts));
  document.add("source", source);
  document.add_text("results", results::step_responses_json(responses, laws, notes, error));
  text::json courses = text::json::array(), load_courses = text::json::array();
  add_courses(responses.steps, courses);
  for (const spindle::LoadSteps& at : responses.loads) add_courses(at.steps, load_courses);
  document.add("courses", courses);
  if (!load_courses.empty()) document.add("load_courses", load_courses);
  document.add("laws", law_courses(responses, laws));
  if (error && error->report.converged()) add_superposition(document, *error, programme);
  return report_page(document.text());
}

}  // namespace raceway::report
