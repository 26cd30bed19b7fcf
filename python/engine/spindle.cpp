#include <pybind11/stl.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>

#include "files/correction_file.h"
#include "files/plausible.h"
#include "python/engine/answer.h"
#include "python/engine/interruptible.h"
#include "python/engine/model.h"
#include "results/step_correction.h"
#include "session/spindle_deflection.h"
#include "session/spindle_modes.h"
#include "session/spindle_run.h"
#include "session/spindle_steady.h"
#include "session/spindle_steps.h"
#include "text/error.h"
#include "text/number_range.h"
#include "text/number_text.h"

namespace raceway::python {
namespace {

using Text = std::function<std::string()>;
using NamedText = std::pair<std::string, std::string>;  // its name, what it holds

/// What is known of a spindle: texts, each made when it is asked for. Those that the question does
/// not have are empty.
struct SpindleAnswer {
  Text json{}, csv{}, page{}, end_state{}, field{}, shapes{};
  bool converged = true;
  std::vector<record::Note> notes{}, warnings{};
};

constexpr double no_limit = std::numeric_limits<double>::infinity();  // [s]

/// Runs `ask(heard, cancelled)` where KeyboardInterrupt and a time limit stop it.
template <typename Ask>
auto asked(Heard& heard, double time_limit_s, const Ask& ask) {
  std::atomic<bool> cancelled = false;
  return interruptible(cancelled, Progress(), {.time_limit = time_limit_s},
                       [&] { return ask(heard, cancelled); });
}

/// The texts of what was found, which lives as long as they do.
template <typename Found>
SpindleAnswer answer_of(const std::shared_ptr<const Found>& found, Heard& heard) {
  SpindleAnswer answer{.json = [found] { return found->json(); },
                       .csv = [found] { return found->csv(); },
                       .page = [found] { return found->page(); },
                       .converged = found->converged(),
                       .notes = std::move(heard.notes),
                       .warnings = std::move(heard.warnings)};
  append(answer.warnings, found->warnings());
  return answer;
}

std::vector<double> growing(const std::vector<double>& values, const text::NumberRange& range,
                            const std::string& name) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    text::require_range(values[k], range, name);
    if (k > 0 && values[k] <= values[k - 1])
      throw text::InputError(name + ": the values must be in ascending order, but " +
                                 text::number(values[k]) + " is not above the value before it",
                             {.key = name});
  }
  return values;
}

std::vector<double> in_rad_s(std::vector<double> speed_rpm) {
  for (double& speed : speed_rpm) speed *= rpm;
  return speed_rpm;
}

std::vector<double> speeds_of(const std::vector<double>& speed_rpm) {
  if (speed_rpm.empty()) throw text::InputError("speed_rpm is missing", {.key = "speed_rpm"});
  return in_rad_s(growing(speed_rpm, text::speed_range, "speed_rpm"));
}

/// [K]; NaN stays what it is.
double ambient_of(Heard& heard, double ambient_temperature_C) {
  if (std::isnan(ambient_temperature_C)) return unset;
  text::require_range(ambient_temperature_C, text::temperature_range, "ambient_temperature_C");
  const std::string doubt =
      files::looks_like_kelvin("ambient_temperature_C", ambient_temperature_C);
  if (!doubt.empty()) heard.say(record::note::unit(doubt, {.key = "ambient_temperature_C"}));
  return kelvin(ambient_temperature_C);
}

SpindleAnswer steady(const EngineModel& model, const std::vector<double>& speed_rpm, bool coolant,
                     double ambient_temperature_C, double axial_load_N, double radial_load_N,
                     double moment_Nm, double belt_force_N, double motor_power_W, bool assumptions,
                     double time_limit_s) {
  if (!std::isnan(axial_load_N))
    text::require_range(axial_load_N, text::signed_load_range, "axial_load_N");
  text::require_range(radial_load_N, text::signed_load_range, "radial_load_N");
  text::require_range(moment_Nm, session::moment_load_range, "moment_Nm");
  if (!std::isnan(belt_force_N))
    text::require_range(belt_force_N, text::load_range, "belt_force_N");
  if (!std::isnan(motor_power_W))
    text::require_range(motor_power_W, text::power_range, "motor_power_W");
  Heard heard;
  session::SteadyQuestion question{.speeds = speeds_of(speed_rpm),
                                   .ambient_temperature = ambient_of(heard, ambient_temperature_C),
                                   .coolant_on = coolant,
                                   .axial_load = axial_load_N,
                                   .radial_load = radial_load_N,
                                   .moment = moment_Nm,
                                   .belt_force = belt_force_N,
                                   .motor_power = motor_power_W,
                                   .assumptions = assumptions};
  const auto found = asked(heard, time_limit_s, [&](Heard&, const std::atomic<bool>& cancelled) {
    question.cancelled = &cancelled;
    return std::make_shared<const session::SteadySpindle>(
        session::steady_spindle(model.file(), question));
  });
  heard.say(notes_of(record::note::load_limit, found->notes()));
  SpindleAnswer answer = answer_of(found, heard);
  if (found->states.size() > 1 || found->end.temperatures.empty()) return answer;
  answer.end_state = [found] { return found->end_state(); };
  answer.field = [found] { return found->field_csv(); };
  return answer;
}

SpindleAnswer simulate(const EngineModel& model, const Data& programme,
                       const std::optional<std::string>& columns, bool drop_nan,
                       const std::optional<NamedText>& start, bool coolant,
                       double ambient_temperature_C, bool assumptions, double time_limit_s) {
  Heard heard;
  session::RunQuestion question{.programme = *programme,
                                .ambient_temperature = ambient_of(heard, ambient_temperature_C),
                                .coolant_on = coolant,
                                .assumptions = assumptions};
  question.reading.columns_text = columns.value_or("");
  question.reading.drop_nan = drop_nan;
  if (start) question.start = session::Source(start->first, start->second);
  const auto found = asked(heard, time_limit_s, [&](Heard& h, const std::atomic<bool>& cancelled) {
    question.cancelled = &cancelled;
    return std::make_shared<const session::SpindleRun>(
        session::simulate_spindle(h, model.file(), question));
  });
  heard.say(notes_of(record::note::load_limit, found->notes()));
  SpindleAnswer answer = answer_of(found, heard);
  answer.end_state = [found] { return found->end_state(); };
  answer.field = [found] { return found->field_csv(); };
  return answer;
}

SpindleAnswer modes(const EngineModel& model, const std::vector<double>& speed_rpm, bool warm,
                    bool coolant, int count, double damping_ratio, double unbalance_gmm,
                    double unbalance_at_mm) {
  constexpr text::NumberRange count_range{1, 40, "modes"};
  text::require_range(count, count_range, "count");
  Heard heard;
  session::ModesQuestion question{.speeds = speeds_of(speed_rpm),
                                  .warm = warm,
                                  .coolant_on = coolant,
                                  .count = count,
                                  .damping_ratio = damping_ratio};
  if (!std::isnan(unbalance_gmm))
    question.unbalance = spindle::Unbalance{.size = unbalance_gmm * 1e-3 * mm,
                                            .position = unbalance_at_mm * mm,
                                            .damping_ratio = damping_ratio};
  const auto found = asked(heard, no_limit, [&](Heard& h, const std::atomic<bool>& cancelled) {
    question.cancelled = &cancelled;
    auto answer = std::make_shared<const session::SpindleModes>(
        session::spindle_modes(model.file(), question));
    h.say(notes_of(record::note::assumed, answer->notes()));
    return answer;
  });
  SpindleAnswer answer = answer_of(found, heard);
  answer.shapes = [found] { return found->shapes_csv(); };
  return answer;
}

SpindleAnswer deflection(const EngineModel& model, double force_N, bool axial, double axial_force_N,
                         double moment_Nm, double at_mm, double speed_rpm, bool warm,
                         bool coolant) {
  text::require_range(force_N, text::signed_load_range, "force_N");
  text::require_range(axial_force_N, text::signed_load_range, "axial_force_N");
  text::require_range(moment_Nm, session::moment_load_range, "moment_Nm");
  text::require_range(at_mm, session::at_range, "at_mm");
  text::require_range(speed_rpm, text::speed_range, "speed_rpm");
  session::DeflectionQuestion question{.force = force_N,
                                       .axial = axial,
                                       .axial_force = axial_force_N,
                                       .moment = moment_Nm,
                                       .at = at_mm * mm,
                                       .speed = speed_rpm * rpm,
                                       .warm = warm,
                                       .coolant_on = coolant};
  Heard heard;
  const auto found = asked(heard, no_limit, [&](Heard& h, const std::atomic<bool>& cancelled) {
    question.cancelled = &cancelled;
    auto answer = std::make_shared<const session::SpindleDeflection>(
        session::spindle_deflection(model.file(), question));
    h.say(notes_of(record::note::assumed, answer->notes()));
    return answer;
  });
  return answer_of(found, heard);
}

using Steps = std::shared_ptr<const session::SpindleSteps>;

/// Step responses, of which a correction can be made.
struct StepAnswer : SpindleAnswer {
  Steps steps{};
};

StepAnswer step_answer(const Steps& steps, Heard& heard) {
  heard.say(steps->notes);
  StepAnswer answer{answer_of(steps, heard), steps};
  return answer;
}

/// What the library takes for wrong without a file to name is wrong in the model here.
template <typename Ask>
auto in_words_of(const files::ModelFile& file, const Ask& ask) {
  try {
    return ask();
  } catch (const std::invalid_argument& e) {
    throw text::InputError(file.source + ": " + e.what(), {.file = file.source});
  }
}

StepAnswer step_response(const EngineModel& model, const std::vector<double>& speed_rpm,
                         const std::vector<double>& axial_load_N,
                         const std::vector<double>& radial_load_N,
                         const std::vector<double>& load_speed_rpm, double duration_h, bool coolant,
                         double time_limit_s) {
  text::require_range(duration_h, session::step_hours_range, "duration_h");
  session::StepQuestion question{
      .speeds = speeds_of(speed_rpm),
      .axial_loads = growing(axial_load_N, text::signed_load_range, "axial_load_N"),
      .radial_loads = growing(radial_load_N, text::signed_load_range, "radial_load_N"),
      .load_speeds = in_rad_s(growing(load_speed_rpm, text::speed_range, "load_speed_rpm")),
      .duration = duration_h * 3600.0,
      .coolant_on = coolant};
  Heard heard;
  session::require_spindle(model.file());
  const Steps steps = asked(heard, time_limit_s, [&](Heard& h, const std::atomic<bool>& cancelled) {
    question.cancelled = &cancelled;
    return in_words_of(model.file(), [&] {
      return std::make_shared<const session::SpindleSteps>(
          session::simulated_steps(h, model.file(), question));
    });
  });
  return step_answer(steps, heard);
}

/// Of load cases that another program computed.
StepAnswer imported_steps(const EngineModel& model, const NamedText& cases, double temperature_C) {
  if (!std::isnan(temperature_C))
    text::require_range(temperature_C, text::temperature_range, "temperature_C");
  Heard heard;
  const Steps steps = asked(heard, no_limit, [&](Heard&, const std::atomic<bool>&) {
    return in_words_of(model.file(), [&] {
      return std::make_shared<const session::SpindleSteps>(
          session::imported_steps(files::parse_load_cases(cases.second, cases.first), cases.first,
                                  &model.file(), temperature_C));
    });
  });
  return step_answer(steps, heard);
}

/// The correction of step responses as files by their names, the model first; notes.
py::tuple correction_files(const StepAnswer& answer, const std::string& path,
                           const std::string& law, const std::string& lags) {
  Heard heard;
  const results::StepCorrection made =
      asked(heard, no_limit, [&](Heard& h, const std::atomic<bool>& cancelled) {
        try {
          return results::step_correction(
              session::correction_of_steps(h, *answer.steps,
                                           {.law = law, .lags = lags, .cancelled = &cancelled}),
              path);
        } catch (const std::invalid_argument& e) {
          throw text::InputError(std::string("raceway step-response: correction: ") + e.what());
        }
      });
  return py::make_tuple(made.model, made.tables, heard.notes);
}

/// A correction that was written against the whole simulation, over a programme: the document with
/// its superposition.
std::string superposition(const StepAnswer& answer, const std::string& correction,
                          const Data& programme) {
  if (!answer.steps->simulated)
    throw text::InputError(answer.steps->source +
                           ": not possible, because the load cases were read and not simulated");
  Heard heard;
  return asked(heard, no_limit, [&](Heard& h, const std::atomic<bool>& cancelled) {
    const files::CorrectionFile written = files::read_correction(correction);
    try {
      const results::Superposition error = session::superposition_of_steps(
          h, *answer.steps, written.models.front(), *programme, &cancelled);
      return answer.steps->json(&error);
    } catch (const std::invalid_argument& e) {
      throw text::InputError(programme->name + ": " + e.what(), {.file = programme->name});
    }
  });
}

/// A text of an answer, made without the lock of the interpreter.
auto made(Text SpindleAnswer::*text, const char* missing) {
  return [text, missing](const SpindleAnswer& answer) {
    if (!(answer.*text)) throw py::value_error(missing);
    const py::gil_scoped_release others;
    return (answer.*text)();
  };
}

}  // namespace

void bind_spindle(py::module_& module) {
  constexpr const char* of_one_speed =
      "the end state and its temperature field need a single speed with a steady state";
  py::class_<SpindleAnswer>(module, "SpindleAnswer")
      .def("json", made(&SpindleAnswer::json, ""))
      .def("csv", made(&SpindleAnswer::csv, ""))
      .def("page", made(&SpindleAnswer::page, ""))
      .def("end_state", made(&SpindleAnswer::end_state, of_one_speed))
      .def("field", made(&SpindleAnswer::field, of_one_speed))
      .def("shapes", made(&SpindleAnswer::shapes, ""))
      .def_readonly("converged", &SpindleAnswer::converged)
      .def_readonly("notes", &SpindleAnswer::notes)
      .def_readonly("warnings", &SpindleAnswer::warnings);
  py::class_<StepAnswer, SpindleAnswer>(module, "StepAnswer")
      .def("correction", &correction_files)
      .def("superposition", &superposition);
  module.def("steady", &steady);
  module.def("simulate", &simulate);
  module.def("modes", &modes);
  module.def("deflection", &deflection);
  module.def("step_response", &step_response);
  module.def("imported_steps", &imported_steps);
}

}  // namespace raceway::python
