#include "session/sensitivity.h"

#include <pybind11/stl.h>

#include <map>

#include "fit/problem.h"
#include "python/engine/answer.h"
#include "python/engine/model.h"

namespace raceway::python {
namespace {

EngineAnswer sensitivity(const EngineModel& model, const std::vector<std::string>& of,
                         const std::vector<std::vector<double>>& axes, bool steady, bool coolant,
                         const std::vector<std::pair<std::string, std::string>>& spreads,
                         const std::vector<std::string>& data, std::size_t samples,
                         std::uint64_t seed, double time_limit_s, const py::object& told) {
  std::atomic<bool> cancelled = false;
  Progress progress;
  session::SensitivityQuestion question{
      .predictions = of,
      .speeds_rpm = axes.at(0),
      .axial_loads_N = axes.at(1),
      .radial_loads_N = axes.at(2),
      .temperatures_C = axes.at(3),
      .steady = steady,
      .coolant_on = coolant,
      .data = data,
      .samples = samples,
      .seed = seed,
      .wording = session::Wording::arguments,
      .amend = [&](files::ModelFile& file) { model.amend(file); },
      .cancelled = &cancelled,
      .progress = [&](double share) { progress.set(share, "varying the data"); }};
  for (const auto& [name, text] : spreads) question.spreads.push_back({name, text});
  return answered(
      {.time_limit = time_limit_s, .progress = told}, cancelled, progress, [&](Heard& heard) {
        const results::Sensitivity found = session::sensitivity(heard, model.file(), question);
        EngineAnswer answer{.json = results::sensitivity_json(found),
                            .converged = found.converged()};
        answer.warnings =
            notes_of(record::note::no_prediction, session::sensitivity_warnings(found));
        return answer;
      });
}

}  // namespace

void bind_sensitivity(py::module_& module) { module.def("sensitivity", &sensitivity); }

}  // namespace raceway::python
