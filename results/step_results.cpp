#include "results/step_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "text/detail/csv_text.h"
#include "text/detail/json_text.h"
#include "text/number_text.h"
#include "text/printable.h"

namespace raceway::results {
namespace {

using spindle::Stepped;
using spindle::StepResponse;

struct StepColumn {
  const char* name;
  double (*value)(const StepResponse& step);
};

constexpr StepColumn step_columns[] = {
    {"speed_rpm", [](const StepResponse& s) { return text::with_15_digits(s.speed / rpm); }},
    {"power_start_W", [](const StepResponse& s) { return s.power_start; }},
    {"power_end_W", [](const StepResponse& s) { return s.power_end; }},
    {"kinematic_um", [](const StepResponse& s) { return s.kinematic / um; }},
    {"K_um", [](const StepResponse& s) { return s.fit.one.gain / um; }},
    {"T_min", [](const StepResponse& s) { return s.fit.one.time_constant / spindle::one_minute; }},
    {"fit_rms_um", [](const StepResponse& s) { return s.fit.rms / um; }},
    {"K1_um", [](const StepResponse& s) { return s.fit.fast.gain / um; }},
    {"T1_min",
     [](const StepResponse& s) { return s.fit.fast.time_constant / spindle::one_minute; }},
    {"K2_um", [](const StepResponse& s) { return s.fit.slow.gain / um; }},
    {"T2_min",
     [](const StepResponse& s) { return s.fit.slow.time_constant / spindle::one_minute; }},
    {"fit_rms_two_um", [](const StepResponse& s) { return s.fit.rms_of_two / um; }},
    {"end_um", [](const StepResponse& s) { return s.end / um; }},
    {"front_force_N", [](const StepResponse& s) { return s.front_force; }},
    {"highest_front_force_N", [](const StepResponse& s) { return s.highest_force; }}};

/// Columns of the load, where loads step; an empty cell is none.
constexpr StepColumn load_columns[] = {
    {"axial_load_N",
     [](const StepResponse& s) { return s.stepped == Stepped::axial_load ? s.load : unset; }},
    {"radial_load_N",
     [](const StepResponse& s) { return s.stepped == Stepped::radial_load ? s.load : unset; }}};

/// Steps of speeds, then of loads.
std::vector<const StepResponse*> all_steps(const spindle::StepResponses& responses) {
  std::vector<const StepResponse*> list;
  for (const StepResponse& step : responses.steps) list.push_back(&step);
  for (const spindle::LoadSteps& at : responses.loads)
    for (const StepResponse& step : at.steps) list.push_back(&step);
  return list;
}

bool steps_were_read(const spindle::StepResponses& responses) {
  return std::any_of(responses.steps.begin(), responses.steps.end(),
                     [](const StepResponse& s) { return !s.load_case.empty(); });
}

text::json step_row_json(const StepResponse& step) {
  text::json row = text::json::object();
  for (const StepColumn& column : step_columns) row[column.name] = column.value(step);
  row["two_needed"] = step.fit.two_needed;
  row["settled"] = step.fit.settled;
  row["status"] = spindle::name(step.status);
  if (!step.message.empty()) row["message"] = step.message;
  return row;
}

text::json load_rows_json(const std::vector<spindle::LoadSteps>& loads) {
  text::json rows = text::json::array();
  for (const spindle::LoadSteps& at : loads)
    for (const StepResponse& step : at.steps) {
      text::json row = step_row_json(step);
      for (const StepColumn& column : load_columns) row[column.name] = column.value(step);
      row["T_without_load_min"] = at.unloaded / spindle::one_minute;
      rows.push_back(std::move(row));
    }
  return rows;
}

text::json step_line_json(const spindle::StraightLine& line, const char* unit, double factor) {
  const std::string slope = fmt::format("slope_{}_W", unit),
                    intercept = fmt::format("offset_{}", unit);
  return {{slope, line.slope / factor},
          {intercept, line.offset / factor},
          {slope + "_std", line.slope_std / factor},
          {intercept + "_std", line.offset_std / factor}};
}

text::json step_power_json(const spindle::PowerLaw& law, const char* unit, double factor) {
  return {{fmt::format("factor_{}", unit), law.factor / factor},
          {"exponent", law.exponent},
          {"exponent_std", law.exponent_std},
          {"rms_percent", 100.0 * law.rms}};
}

}  // namespace

std::string step_responses_text(const spindle::StepResponses& responses, std::string_view source,
                                std::string_view model_text) {
  fmt::memory_buffer out;
  fmt::format_to(
      std::back_inserter(out),
      "# Step responses from rest, of {}\n# raceway {}\n# displacement u = kinematic + K (1 - "
      "exp(-t/T)) after the time t; K and T belong to the power at the end of the step\n",
      text::printable(source), RACEWAY_VERSION);
  if (!responses.loads.empty())
    out.append(std::string_view(
        "# Rows with a load: steps of this load from the steady state; the column kinematic "
        "contains the immediate displacement\n"));
  if (!model_text.empty()) text::append_model(out, model_text);
  const bool with_name = steps_were_read(responses);
  std::vector<StepColumn> columns(std::begin(step_columns), std::end(step_columns));
  if (!responses.loads.empty())
    columns.insert(columns.begin() + 1, std::begin(load_columns), std::end(load_columns));
  for (const StepColumn& column : columns)
    fmt::format_to(std::back_inserter(out), "{},", column.name);
  fmt::format_to(std::back_inserter(out), "status{}\n", with_name ? ",load_case" : "");
  for (const StepResponse* const step : all_steps(responses)) {
    for (const StepColumn& column : columns) {
      text::append_value(out, column.value(*step));
      out.push_back(',');
    }
    text::append_text(out, spindle::name(step->status));
    if (with_name) {
      out.push_back(',');
      text::append_text(out, step->load_case);
    }
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

std::string step_responses_json(const spindle::StepResponses& responses,
                                const spindle::PowerLaws& laws,
                                const std::vector<record::Note>& notes,
                                const Superposition* error) {
  text::json rows = text::json::array();
  double from = unset, to = unset;
  for (const StepResponse& step : responses.steps) {
    text::json row = step_row_json(step);
    if (steps_were_read(responses)) row["load_case"] = step.load_case;
    rows.push_back(std::move(row));
    if (!step.converged()) continue;
    from = std::fmin(from, step.power_end);
    to = std::fmax(to, step.power_end);
  }
  text::json document = {
      {"rows", std::move(rows)},
      {"K_of_P", step_line_json(laws.gain_line, "um", um)},
      {"T_of_P", step_line_json(laws.time_line, "min", spindle::one_minute)},
      {"K_power_law", step_power_json(laws.gain_power, "um", um)},
      {"T_power_law", step_power_json(laws.time_power, "min", spindle::one_minute)},
      {"valid_from_W", laws.valid_from},
      {"valid_to_W", laws.valid_to},
      {"seen_from_W", from},
      {"seen_to_W", to},
      {"two_needed", spindle::need_two(responses.steps)}};
  if (!responses.loads.empty()) document["load_rows"] = load_rows_json(responses.loads);
  const spindle::CoolDown& down = responses.cool_down;
  if (down.known())
    document["cool_down"] = {{"K_um", down.fit.one.gain / um},
                             {"T_min", down.fit.one.time_constant / spindle::one_minute},
                             {"fit_rms_um", down.fit.rms / um},
                             {"T_at_rest_min", down.one / spindle::one_minute},
                             {"T1_at_rest_min", down.fast / spindle::one_minute},
                             {"T2_at_rest_min", down.slow / spindle::one_minute}};
  if (error)
    document["superposition"] = {{"rows", error->rows},
                                 {"rms_um", error->rms / um},
                                 {"largest_um", error->largest / um},
                                 {"time_of_largest_s", error->time_of_largest},
                                 {"lowest_um", error->lowest / um},
                                 {"highest_um", error->highest / um},
                                 {"status", spindle::name(error->report.status)}};
  text::put_notes(document, "notes", notes);
  return text::text(document);
}

}  // namespace raceway::results
