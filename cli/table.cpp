#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include "cli/axis_flag.h"
#include "cli/band_flag.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/number_flag.h"
#include "cli/progress.h"
#include "cli/report_flag.h"
#include "cli/shared_flags.h"
#include "cli/table_memory.h"
#include "cli/text_table.h"
#include "friction/stribeck_table.h"
#include "io/csv.h"
#include "io/error.h"
#include "io/output_file.h"
#include "io/report.h"
#include "io/results.h"
#include "io/subject.h"
#include "io/table_exchange.h"
#include "io/table_file.h"
#include "io/table_plot.h"
#include "session/bands.h"
#include "session/contact_statement.h"
#include "session/open_input.h"
#include "session/reading.h"
#include "session/shaft_answers.h"
#include "session/table_columns.h"

namespace raceway::cli {
namespace {

struct TableFlags {
  std::string model, output;
  std::string speed, axial_load, radial_load, temperature;
  std::string data, slab, format = "csv", plot;
  bool json = false, force = false;
  ReportFlag report;
  BandFlag band;
  session::Reading reading;
};

friction::TableAxes axes(const TableFlags& f, const model::Model& model) {
  const model::Rig& rig = model.rig;
  const double axial_load = model.shaft ? model.shaft->external_load : rig.axial_load;
  if (model.shaft && !f.radial_load.empty())
    throw io::InputError(
        "raceway table: " + f.model + " has an [arrangement]: a shaft takes --axial-load alone",
        {.file = f.model, .key = "--radial-load"});
  friction::TableAxes a;
  a.speed = axis(f.speed, "--speed");
  require_all(a.speed, speed_range, "--speed");
  for (double& v : a.speed) v *= rpm;
  if (f.axial_load.empty() && std::isnan(axial_load))
    throw io::InputError("raceway table: --axial-load is missing, and " + f.model +
                             " has no axial_load_N under [rig]",
                         {.file = f.model, .key = "--axial-load"});
  a.axial_load =
      f.axial_load.empty() ? std::vector{axial_load} : axis(f.axial_load, "--axial-load");
  require_all(a.axial_load, model.shaft ? signed_load_range : load_range, "--axial-load");
  a.radial_load = f.radial_load.empty() ? std::vector{model.shaft ? 0.0 : rig.radial_load}
                                        : axis(f.radial_load, "--radial-load");
  require_all(a.radial_load, load_range, "--radial-load");
  a.temperature = f.temperature.empty() ? std::vector{celsius(rig.temperature)}
                                        : axis(f.temperature, "--temperature");
  require_all(a.temperature, temperature_range, "--temperature");
  if (!f.temperature.empty()) session::tell_of_kelvin(messages(), a.temperature);
  for (double& v : a.temperature) v = kelvin(v);
  return a;
}

/// "2/4" is the second of four.
friction::TableSlab slab(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  const auto whole = [&](std::string_view part) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    return error == std::errc() && end == part.data() + part.size() ? value : 0;
  };
  const std::string_view all = text;
  const std::size_t index = slash == text.npos ? 0 : whole(all.substr(0, slash));
  const std::size_t count = slash == text.npos ? 0 : whole(all.substr(slash + 1));
  constexpr std::size_t most = 1000000;
  if (index == 0 || index > count || count > most)
    throw io::InputError(
        "--slab: " + io::quoted(text) + ": write i/N with i from 1 to N, N up to a million, as 2/4",
        {.key = "--slab"});
  return {.index = index - 1, .count = count};
}

/// Speed down, axial load across, a block for each radial load and temperature.
void print(const model::Model& model, const friction::StribeckTable& t) {
  fmt::print("Friction torque [N mm] of {}\n", model.name);
  const auto of_band = static_cast<std::size_t>(
      std::find(t.columns.begin(), t.columns.end(), "friction_torque_band_Nmm") -
      t.columns.begin());
  const auto torque = [&](std::size_t point) {
    const std::string text = number(t.friction_moment[point] / N_mm, 4);
    if (of_band == t.columns.size() || std::isnan(t.friction_moment[point])) return text;
    return text + " " + band_text(t.row(point)[of_band], N_mm);
  };
  for (std::size_t k = 0; k < t.axes.temperature.size(); ++k) {
    for (std::size_t r = 0; r < t.axes.radial_load.size(); ++r) {
      fmt::print("\nradial load {:.6g} N, {:.4g} C, axial load across\n", t.axes.radial_load[r],
                 celsius(t.axes.temperature[k]));
      std::vector<TextTable::Column> heads{{"speed", "rpm"}};
      for (const double load : t.axes.axial_load)
        heads.push_back({fmt::format("{:.6g} N", load), "N mm"});
      TextTable table(heads);
      for (std::size_t s = 0; s < t.axes.speed.size(); ++s) {
        std::vector<std::string> row{fmt::format("{:.6g}", t.axes.speed[s] / rpm)};
        for (std::size_t a = 0; a < t.axes.axial_load.size(); ++a)
          row.push_back(torque(t.index(s, a, r, k)));
        table.add(row);
      }
      fmt::print("{}", table.text(terminal_width()));
    }
  }
}

/// At most `most` values of an axis, evenly spread, both ends among them.
std::vector<double> spread(const std::vector<double>& values, std::size_t most) {
  if (values.size() <= most) return values;
  std::vector<double> few;
  for (std::size_t i = 0; i < most; ++i)
    few.push_back(values[i * (values.size() - 1) / (most - 1)]);
  return few;
}

/// Points whose balls a report draws: some speeds at some pairs of loads. None for a shaft, whose
/// bearings do not carry the loads of the grid.
io::BearingStates states_to_draw(const model::Model& model, const friction::TableAxes& grid) {
  if (model.shaft) return {};
  std::vector<bearing::OperatingPoint> points;
  for (const double radial : spread(grid.radial_load, 3))
    for (const double axial : spread(grid.axial_load, 4))
      for (const double speed : spread(grid.speed, 25))
        points.push_back({.speed = speed,
                          .axial_load = axial,
                          .radial_load = radial,
                          .temperature = grid.temperature.front()});
  std::vector<model::FrictionPrediction> predictions(points.size());
  model::predict_sweep(model, points, predictions, true);
  io::BearingStates states;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (predictions[i].equilibrium && predictions[i].equilibrium->report.converged())
      states.emplace_back(points[i], std::move(predictions[i]));
  return states;
}

std::string why(const model::Model& model, const bearing::OperatingPoint& point,
                bearing::SolveStatus status) {
  if (model.shaft || status != bearing::SolveStatus::not_finite)
    return std::string(bearing::name(status));
  return why_not_converged(model, model::predict_friction(model, point, true));
}

/// Says how many points have not converged, and why; gives the exit status. A torque without
/// balance is one, where the law needs no balls.
int tell_of_failures(const model::Model& model, const friction::StribeckTable& table) {
  struct Failure {
    std::size_t points = 0, first = 0;
  };
  std::map<std::pair<bool, bearing::SolveStatus>, Failure> failures;  // with a torque or without
  for (std::size_t i = 0; i < table.points(); ++i) {
    if (table.status[i] == bearing::SolveStatus::converged) continue;
    const bool torque = !std::isnan(table.friction_moment[i]);
    ++failures.try_emplace({torque, table.status[i]}, Failure{0, i}).first->second.points;
  }
  int result = done;
  for (const auto& [kind, failure] : failures) {
    const bearing::OperatingPoint p = table.point(table.first() + failure.first);
    const auto& [torque, status] = kind;
    warn(
        {fmt::format("{} of {} points have no {}: {}, the first at {:.6g} rpm, {:.6g} N axial, "
                     "{:.6g} N radial",
                     failure.points, table.points(),
                     torque ? "balance, but a torque, which needs none" : "value",
                     why(model, p, status), p.speed / rpm, p.axial_load, p.radial_load)});
    if (!torque) result = not_converged;
  }
  return result;
}

std::string text_of(const TableFlags& flags, const friction::StribeckTable& table,
                    const io::ModelFile& file, const std::function<void(double)>& progress) {
  if (flags.format == "plain") return io::plain_table_text(table);
  if (flags.format == "modelica") return io::modelica_table_text(table, file.model.name);
  return io::table_text(table, file.model.name, file.text, progress);
}

int run(const TableFlags& flags) {
  if (flags.format != "csv" && flags.output.empty())
    throw io::InputError("raceway table: --format is that of the file: --output is missing",
                         {.key = "--format"});
  if (flags.format != "csv" && !flags.slab.empty())
    throw io::InputError("raceway table: a slab is to be merged, which takes --format csv alone",
                         {.key = "--slab"});
  if (flags.json && flags.output == "-")
    throw io::InputError("raceway table: --json and --output - both write to stdout; take one",
                         {.key = "--output"});
  const friction::TableSlab part = slab(flags.slab);
  if (!flags.slab.empty() && (flags.output.empty() || flags.json))
    throw io::InputError("raceway table: a slab is for a file to be merged: --slab needs --output",
                         {.key = "--slab"});
  const bool to_file = !flags.output.empty() && flags.output != "-";
  const auto if_exists = flags.force ? io::IfExists::replace : io::IfExists::refuse;
  if (to_file) io::require_writable(flags.output, if_exists);
  if (!flags.plot.empty()) io::require_writable(flags.plot, if_exists);
  if (!flags.data.empty() && flags.report.path.empty())
    throw io::InputError("raceway table: --data is drawn in a report: --report is missing",
                         {.key = "--report"});
  flags.report.check(flags.force);
  const io::ModelFile file =
      session::open_model(messages(), flags.model, session::Accepts::rig_or_shaft);
  const model::Model& model = file.model;
  session::warn_of_ignored_data(messages(), file);
  std::optional<record::Record> measured;
  if (!flags.data.empty())
    measured = session::open_data(messages(), flags.data, *io::make_subject(model),
                                  flags.reading.options(file));
  const friction::TableAxes grid = axes(flags, model);
  const std::optional<model::Band> band = flags.band.of(file);
  std::vector<std::string> names = session::table_columns(model);
  if (band)
    for (std::string& name : session::band_columns(model)) names.push_back(std::move(name));
  require_memory(grid, part, names.size(),
                 flags.json             ? TableForm::json
                 : flags.output.empty() ? TableForm::text
                                        : TableForm::file);
  const std::size_t points = part.points(grid.size());
  std::optional<Progress> bar;
  if (shows_progress() && points >= 20000) bar.emplace();
  // Of the time a file takes, as measured: solving, making the text, and the disk.
  const double solved = flags.output.empty() ? 1.0 : 0.8, made = flags.output.empty() ? 1.0 : 0.95;
  const auto progress = [&](double from, double to, std::string_view step) {
    return !bar ? std::function<void(double)>() : [&bar, from, to, step](double share) {
      bar->show(std::min(from + share * (to - from), 0.999), step);
    };
  };
  const friction::StribeckTable table = friction::build_stribeck_table(
      grid, std::move(names),
      [&](auto given, auto out) {
        session::fill_table_line(model, given, out);
        if (band) session::fill_band(model, *band, given, out);
      },
      progress(0.0, solved, {}), part);
  if (!flags.output.empty()) {
    const std::string text = text_of(flags, table, file, progress(solved, made, "writing"));
    if (to_file)
      io::write_text(flags.output, text, if_exists);
    else
      fmt::print("{}", text);
  }
  if (bar) bar->show(1.0);
  bar.reset();
  if (to_file) say(fmt::format("{} written, {} points", flags.output, points));
  if (!flags.plot.empty()) {
    io::write_text(flags.plot, io::table_svg(table, model.name), if_exists);
    say(flags.plot + " written");
  }
  if (flags.json) {
    const io::BandOfResult of_band{.parameters = band ? band->fitted() : std::vector<std::string>(),
                                   .names = {},
                                   .half_widths = {}};
    put_document(io::table_json(model, table, band ? &of_band : nullptr));
  } else if (flags.output.empty()) {
    print(model, table);
    if (band) fmt::print("\n+-: {}\n", session::band_statement(*band));
  }
  if (band && (flags.json || !flags.output.empty()))
    tell({"band: " + session::band_statement(*band)});
  flags.report.write(
      [&] {
        return io::table_report(file.source, model, table, states_to_draw(model, grid),
                                measured ? &*measured : nullptr, {session::of_page(file, model)});
      },
      flags.force);
  tell(session::table_notes(model, table));
  if (table.points() > 0)  // at the highest speed of the first loads
    if (const std::string why = session::balls_statement(model, table.point(grid.speed.size() - 1));
        !why.empty())
      tell({why});
  return tell_of_failures(model, table);
}

}  // namespace

Run setup_table(CLI::App& command) {
  auto flags = std::make_shared<TableFlags>();
  command.add_option("MODEL", flags->model, "model file (TOML)")->required()->type_name("");
  command
      .add_option("--speed", flags->speed,
                  "[rpm]; like all axes as 100,300,900 or as from:to:step, 0:12000:250")
      ->required()
      ->type_name("VALUES");
  command
      .add_option("--axial-load", flags->axial_load,
                  "[N], on a shaft positive towards the tool; default: of the model")
      ->type_name("VALUES");
  command
      .add_option("--radial-load", flags->radial_load, "[N]; default: [rig] of the model, else 0")
      ->type_name("VALUES");
  command
      .add_option("--temperature", flags->temperature,
                  "of the lubricant [C]; default: [rig] of the model, else 40")
      ->type_name("VALUES");
  command.add_option("-o,--output", flags->output, "CSV file to write; - for stdout")
      ->type_name("FILE");
  command
      .add_option("--slab", flags->slab,
                  "i/N: only the i-th of N parts, to be joined by raceway merge")
      ->type_name("i/N");
  command
      .add_option("--format", flags->format,
                  "csv (with the model in # lines; the default), plain (one header line\n"
                  "of identifiers, for pandas and MATLAB) or modelica (CombiTable, SI)")
      ->check(CLI::IsMember({"csv", "plain", "modelica"}))
      ->type_name("NAME");
  command.add_option("--plot", flags->plot, "torque over speed as a picture (SVG)")
      ->type_name("FILE");
  command.add_flag("--force", flags->force, "replace the file if it exists");
  flags->band.declare(command);
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  flags->report.declare(command);
  command
      .add_option("--data", flags->data, "measurements (CSV) to draw into the curves of the report")
      ->type_name("FILE");
  declare(command, flags->reading);
  command.footer(
      "Example:\n  raceway table my.toml --speed 0:12000:250 --axial-load 100,300,900 "
      "-o stribeck.csv");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
