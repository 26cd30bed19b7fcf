#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "cli/commands.h"
#include "cli/open_input.h"
#include "cli/text_table.h"
#include "effects/catalogue.h"
#include "fit/calibrate.h"
#include "fit/free_parameters.h"
#include "fit/needs.h"
#include "fit/noise.h"
#include "fit/quantity.h"
#include "io/results.h"

namespace raceway::cli {
namespace {

template <typename Get>
void add_column(io::CheckSummary& summary, const fit::DataSet& data, const char* name, Get get) {
  std::set<long long> levels;
  io::ColumnSummary c{.name = name};
  for (const fit::Row& row : data.rows) {
    const double v = get(row);
    if (std::isnan(v)) continue;
    c.lower = std::fmin(c.lower, v);
    c.upper = std::fmax(c.upper, v);
    levels.insert(std::llround(v * 1e3));
  }
  c.levels = static_cast<int>(levels.size());
  if (c.levels > 0) summary.columns.push_back(c);
}

io::CheckSummary summarise(const io::ModelFile& file, const fit::DataSet& data) {
  const fit::Model& model = file.model;
  const bool torque = data.quantity == fit::Quantity::friction_torque;
  const fit::Noise noise = fit::estimate_noise(data);
  io::CheckSummary s;
  s.model_name = model.name;
  s.quantity = fit::text_of(data.quantity).name;
  s.rows = static_cast<int>(data.rows.size());
  s.runs = static_cast<int>(data.runs.size());
  s.noise_source = fit::name(noise.source);
  s.noise = noise.rms;
  s.defaults = file.defaults;
  s.notes = data.notes;
  add_column(s, data, "speed_rpm", [](const fit::Row& r) { return r.point.speed / rpm; });
  add_column(s, data, "axial_load_N", [](const fit::Row& r) { return r.point.axial_load; });
  add_column(s, data, "radial_load_N", [](const fit::Row& r) { return r.point.radial_load; });
  add_column(s, data, "temperature_C",
             [](const fit::Row& r) { return celsius(r.point.temperature); });
  add_column(s, data, "inner_ring_temperature_C",
             [](const fit::Row& r) { return celsius(r.inner_ring_temperature); });
  add_column(s, data, "outer_ring_temperature_C",
             [](const fit::Row& r) { return celsius(r.outer_ring_temperature); });
  add_column(s, data, "preload_N", [](const fit::Row& r) { return r.preload; });
  add_column(s, data, "time_s", [](const fit::Row& r) { return r.time; });
  if (torque) {
    add_column(s, data, "friction_torque_Nmm", [](const fit::Row& r) { return r.measured / N_mm; });
    add_column(s, data, "std_Nmm", [](const fit::Row& r) { return r.std / N_mm; });
  } else {
    add_column(s, data, "axial_displacement_um", [](const fit::Row& r) { return r.measured / um; });
    add_column(s, data, "std_um", [](const fit::Row& r) { return r.std / um; });
  }
  if (torque || model.shaft) {
    try {
      for (const fit::FittedParameter& p : fit::calibrate(model, data).parameters)
        s.free_parameters.push_back({p.name, p.identifiable});
    } catch (const std::invalid_argument& e) {
      s.notes.emplace_back(e.what());  // fewer rows than parameters, for example
      tell({s.notes.back()});
      for (const std::string& name : model.free) s.free_parameters.push_back({name, false});
    }
  }
  for (const effects::Description& e : effects::catalogue(fit::subject_of(data.quantity)))
    s.effects.push_back({std::string(e.id), fit::missing_need(e, model, data),
                         fit::missing_levels(e, model, data)});
  return s;
}

void print(const io::CheckSummary& s, const std::string& data) {
  const bool torque = s.quantity == "friction_torque";
  fmt::print("{}: {} row{} of {}", data, s.rows, s.rows == 1 ? "" : "s",
             torque ? "friction torque" : "axial displacement");
  fmt::print("{}\n", s.runs == 0   ? ""
                     : s.runs == 1 ? ", one run"
                                   : fmt::format(", {} runs", s.runs));
  fmt::print("noise: {}\n\n",
             std::isnan(s.noise)
                 ? "not known (no std column, no repeated rows)"
                 : fmt::format("{} {} rms ({})", number(torque ? s.noise / N_mm : s.noise / um, 3),
                               torque ? "N mm" : "um", s.noise_source));
  TextTable columns({{"column", "", true}, {"from", ""}, {"to", ""}, {"levels", ""}});
  for (const io::ColumnSummary& c : s.columns)
    columns.add({c.name, number(c.lower, 5), number(c.upper, 5), fmt::format("{}", c.levels)});
  fmt::print("{}\n", columns.text(terminal_width()));
  for (const io::CheckSummary::Free& f : s.free_parameters)
    fmt::print("free parameter {}: {}\n", f.name,
               f.identifiable ? "can be fitted" : "cannot be told from these data");
  for (const io::CheckSummary::Testable& t : s.effects)
    fmt::print("effect {}: {}\n", t.id,
               !t.missing.empty()  ? "needs " + t.missing
               : !t.levels.empty() ? "testable, but hard to tell apart without " + t.levels
                                   : "testable");
}

}  // namespace

Run setup_check(CLI::App& command) {
  struct Flags {
    std::string model, data;
    bool json = false;
  };
  auto flags = std::make_shared<Flags>();
  command.add_option("MODEL", flags->model, "model file (TOML)")->required()->type_name("");
  command.add_option("DATA", flags->data, "measurements (CSV)")->required()->type_name("");
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  command.footer("Example:\n  raceway check my.toml rig.csv");
  return [flags] {
    const io::ModelFile file = open_model(flags->model, Subject::bearing_or_shaft);
    const fit::DataSet data = open_data(flags->data, file.model);
    const io::CheckSummary summary = summarise(file, data);
    if (flags->json) {
      fmt::print("{}", io::check_json(summary));
    } else {
      print(summary, flags->data);
    }
    return static_cast<int>(done);
  };
}

}  // namespace raceway::cli
