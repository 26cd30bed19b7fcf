#include "spindle/spindle.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/axis_flag.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/report_flag.h"
#include "cli/shared_flags.h"
#include "cli/spindle_steady.h"
#include "cli/text_table.h"
#include "io/error.h"
#include "io/output_file.h"
#include "io/spindle_record.h"
#include "io/spindle_report.h"
#include "session/open_input.h"
#include "session/reading.h"
#include "spindle/drawn_run.h"
#include "spindle/record_rows.h"

namespace raceway::cli {
namespace {

struct SpindleFlags {
  std::string model, profile, speed, output, start, end_state, field;
  std::string coolant = "on";
  bool steady = false, json = false, force = false;
  double ambient = unset;
  session::Reading reading;
  ReportFlag report;

  [[nodiscard]] io::IfExists if_exists() const {
    return force ? io::IfExists::replace : io::IfExists::refuse;
  }
};

void check_flags(const SpindleFlags& f) {
  const auto fail = [](const std::string& why, const char* flag) {
    throw io::InputError("raceway spindle: " + why, {.key = flag});
  };
  if (f.profile.empty() == f.speed.empty())
    fail("must have one of --speed-profile and --speed with --steady", "--speed");
  if (!f.speed.empty() && !f.steady)
    fail("--speed is of a state that is steady: add --steady, or give a --speed-profile",
         "--steady");
  if (f.steady && !f.profile.empty())
    fail("--steady knows no course in time; take --speed in place of --speed-profile", "--steady");
  if (f.steady && !f.start.empty())
    fail("--start: a steady state does not know where it came from", "--start");
  if (f.json && f.output == "-")
    fail("--json and --output - both write to stdout; take one", "--output");
  for (const std::string& path : {f.output, f.end_state, f.field})
    if (!path.empty() && path != "-") io::require_writable(path, f.if_exists());
  f.report.check(f.force);
}

io::ModelFile open_spindle(const std::string& path) {
  io::ModelFile file = session::open_model(messages(), path, session::Accepts::rig_or_shaft);
  if (!file.model.spindle)
    throw io::InputError(path +
                             ": is no spindle: with [shaft] and [housing] beside its [arrangement] "
                             "a model is one",
                         {.file = path, .key = "shaft"});
  return file;
}

/// Writes onto stdout for "-", else a file; nothing for no name.
void put_file(const SpindleFlags& f, const std::string& path, const std::string& text,
              const std::string& what) {
  if (path.empty()) return;
  if (path == "-") {
    fmt::print("{}", text);
    return;
  }
  io::write_text(path, text, f.if_exists());
  say(fmt::format("{} written, {}", path, what));
}

void put_ends(const SpindleFlags& f, const model::Model& model, spindle::Simulator& simulator,
              const spindle::State& end) {
  put_file(f, f.end_state, io::spindle_state_json(model, end),
           fmt::format("{} temperatures", end.temperatures.size()));
  if (f.field.empty()) return;
  const std::vector<spindle::FieldCell> cells = simulator.field(end);
  put_file(f, f.field, io::spindle_field_text(cells, model.spindle->name),
           fmt::format("{} cells", cells.size()));
}

spindle::Simulator simulator_of(const io::ModelFile& file) {
  try {
    return spindle::Simulator(file.model);
  } catch (const std::invalid_argument& e) {
    throw io::InputError(fmt::format("{}: {}", file.source, e.what()), {.file = file.source});
  }
}

/// Sections for the page, of up to a dozen of the speeds that have a steady state.
std::vector<io::DrawnField> fields_of(spindle::Simulator& simulator,
                                      const std::vector<io::SteadyState>& states) {
  constexpr std::size_t most = 12;
  std::vector<const io::SteadyState*> found;
  for (const io::SteadyState& s : states)
    if (s.report.converged()) found.push_back(&s);
  std::vector<io::DrawnField> fields;
  const std::size_t count = std::min(most, found.size());
  for (std::size_t k = 0; k < count; ++k) {
    const io::SteadyState& s = *found[count == 1 ? 0 : k * (found.size() - 1) / (count - 1)];
    spindle::Report report;
    static_cast<void>(simulator.steady(s.inputs, report));
    fields.push_back({.speed = s.inputs.speed, .cells = simulator.field(simulator.state())});
  }
  return fields;
}

int run_steady(const SpindleFlags& f, const io::ModelFile& file) {
  const std::vector<double> speeds = axis(f.speed, "--speed");
  require_all(speeds, speed_range, "--speed");
  if ((!f.field.empty() || !f.end_state.empty()) && speeds.size() > 1)
    throw io::InputError("raceway spindle: --field and --end-state are of one speed",
                         {.key = "--speed"});
  std::vector<spindle::Inputs> asked;
  for (const double speed : speeds)
    asked.push_back({.speed = speed * rpm,
                     .ambient_temperature = std::isnan(f.ambient) ? unset : kelvin(f.ambient),
                     .axial_load = file.model.shaft->external_load,
                     .coolant_on = f.coolant == "on"});
  spindle::Simulator simulator = simulator_of(file);
  const std::vector<io::SteadyState> states = steady_states(simulator, asked);
  const auto last = std::find_if(states.rbegin(), states.rend(),
                                 [](const auto& s) { return s.report.converged(); });
  const io::MeshEstimate mesh = last == states.rend() ? io::MeshEstimate{.cells = simulator.cells()}
                                                      : mesh_estimate(file.model, last->inputs);
  put_file(f, f.output, io::spindle_steady_text(file.model, states, file.text),
           fmt::format("{} speed{}", states.size(), states.size() == 1 ? "" : "s"));
  if (states.back().report.converged()) put_ends(f, file.model, simulator, simulator.state());
  if (f.json)
    put_document(io::spindle_steady_json(file.model, states, mesh));
  else if (f.output != "-")
    print_steady(file.model, states, mesh);
  f.report.write(
      [&] {
        return io::spindle_steady_report(session::of_page(file, file.model), states,
                                         fields_of(simulator, states), mesh, words(mesh));
      },
      f.force);
  bool all = true;
  for (const io::SteadyState& s : states) {
    if (s.report.converged()) continue;
    warn(fmt::format("{:.6g} rpm: {}: {}", s.inputs.speed / rpm, spindle::name(s.report.status),
                     s.report.message));
    all = false;
  }
  return all ? done : not_converged;
}

std::vector<spindle::ProfileRow> read_profile(const SpindleFlags& f, const io::ModelFile& file) {
  const record::Record record =
      io::read_spindle_record(f.profile, *file.model.spindle, f.reading.options(file));
  tell(record.notes);
  if (record.runs.size() > 1)
    throw io::InputError(
        fmt::format("{}: has {} runs; a speed programme is one", f.profile, record.runs.size()),
        {.file = f.profile, .key = "run_id"});
  try {
    std::vector<spindle::ProfileRow> profile = spindle::profile_of(record);
    for (spindle::ProfileRow& row : profile) {
      if (f.coolant == "off") row.inputs.coolant_on = false;
      if (!std::isnan(f.ambient)) row.inputs.ambient_temperature = kelvin(f.ambient);
      if (!record.has(record::axial_load)) row.inputs.axial_load = file.model.shaft->external_load;
    }
    return profile;
  } catch (const std::invalid_argument& e) {
    throw io::InputError(e.what(), {.file = f.profile});
  }
}

/// What to begin with; a programme that begins before it counts its time anew.
std::optional<spindle::State> read_start(const SpindleFlags& f, double first_row) {
  if (f.start.empty()) {
    if (first_row < 0.0)
      throw io::InputError(
          fmt::format("{}: time_s = {:.6g} s: a programme begins at 0 s", f.profile, first_row),
          {.file = f.profile, .key = "time_s"});
    return std::nullopt;
  }
  spindle::State start = io::read_spindle_state(f.start);
  if (first_row < start.time) {
    tell(
        {fmt::format("{} is of {:.6g} s, and the programme begins at {:.6g} s: its time counts "
                     "from that state on",
                     f.start, start.time, first_row)});
    start.time = std::min(0.0, first_row);
  }
  return start;
}

void print_run(const model::Model& model, const spindle::Run& run, std::size_t asked,
               const io::MeshEstimate& mesh) {
  fmt::print("{}: {} of {} rows, {} steps, {} of them taken back\n", model.spindle->name,
             run.moments.size(), asked, run.report.steps + run.report.rejected,
             run.report.rejected);
  if (run.moments.empty()) return;
  const spindle::Moment& m = run.moments.back();
  if (!model.spindle->network) {
    const auto by_displacement = [](const spindle::Moment& a, const spindle::Moment& b) {
      return a.displacement < b.displacement;
    };
    const auto [least, most] =
        std::minmax_element(run.moments.begin(), run.moments.end(), by_displacement);
    fmt::print(
        "nose against flange: {} um at the end, from {} um at {:.6g} s to {} um at {:.6g} s\n",
        number(m.displacement / um), number(least->displacement / um), least->time,
        number(most->displacement / um), most->time);
    fmt::print("front force: {} N at the end, {} N at the highest, at {:.6g} s\n",
               number(m.front_force), number(run.highest_front_force), run.time_of_highest_force);
  }
  fmt::print("friction {} W at the end; energy kept within {:.1g} of the turnover\n",
             number(m.heat.friction), run.report.energy_error);
  fmt::print("{}\n", words(mesh));
}

std::string page_of(const SpindleFlags& f, const io::ModelFile& file, spindle::Simulator& simulator,
                    std::span<const spindle::ProfileRow> profile, const spindle::State* start,
                    const spindle::Run& run, const io::MeshEstimate& mesh) {
  const spindle::DrawnRun drawn = spindle::drawn_run(simulator, profile, start, run);
  std::vector<io::DrawnField> fields;
  for (const spindle::State& state : drawn.states) {
    const auto row = std::lower_bound(drawn.rows.begin(), drawn.rows.end(), state.time,
                                      [](const auto& r, double time) { return r.time < time; });
    fields.push_back({.time = state.time,
                      .speed = row == drawn.rows.end() ? unset : row->inputs.speed,
                      .cells = simulator.field(state)});
  }
  return io::spindle_run_report(session::of_page(file, file.model), f.profile, profile.size(), run,
                                drawn, fields, mesh, words(mesh));
}

int run_profile(const SpindleFlags& f, const io::ModelFile& file) {
  const std::vector<spindle::ProfileRow> profile = read_profile(f, file);
  const std::optional<spindle::State> start = read_start(f, profile.front().time);
  spindle::Simulator simulator = simulator_of(file);
  spindle::Run run;
  try {
    run = simulator.simulate(profile, start ? &*start : nullptr);
  } catch (const std::invalid_argument& e) {
    throw io::InputError(fmt::format("{} with {}: {}", f.profile, file.source, e.what()),
                         {.file = f.start.empty() ? f.profile : f.start});
  }
  const auto fastest = std::max_element(
      profile.begin(), profile.end(),
      [](const auto& a, const auto& b) { return a.inputs.speed < b.inputs.speed; });
  const io::MeshEstimate mesh = f.json || f.output != "-" || !f.report.path.empty()
                                    ? mesh_estimate(file.model, fastest->inputs)
                                    : io::MeshEstimate{.cells = simulator.cells()};
  put_file(f, f.output, io::spindle_run_text(file.model, profile, run, file.text),
           fmt::format("{} rows", run.moments.size()));
  put_ends(f, file.model, simulator, run.end);
  if (f.json)
    put_document(io::spindle_run_json(file.model, profile, run, mesh));
  else if (f.output != "-")
    print_run(file.model, run, profile.size(), mesh);
  f.report.write(
      [&] { return page_of(f, file, simulator, profile, start ? &*start : nullptr, run, mesh); },
      f.force);
  if (run.report.converged()) return done;
  warn(fmt::format("{}: {} at {:.6g} s; {} of {} rows are there", spindle::name(run.report.status),
                   run.report.message, run.end.time, run.moments.size(), profile.size()));
  return not_converged;
}

int run(const SpindleFlags& flags) {
  check_flags(flags);
  const io::ModelFile file = open_spindle(flags.model);
  return flags.steady ? run_steady(flags, file) : run_profile(flags, file);
}

}  // namespace

Run setup_spindle(CLI::App& command) {
  auto flags = std::make_shared<SpindleFlags>();
  command.add_option("MODEL", flags->model, "model file (TOML) with [shaft] and [housing]")
      ->required()
      ->type_name("");
  command
      .add_option("--speed-profile", flags->profile,
                  "CSV with time_s, speed_rpm and, where they are known, coolant_on,\n"
                  "ambient_temperature_C, machine_temperature_C, coolant_inlet_temperature_C,\n"
                  "axial_load_N, radial_load_N, motor_heat_W; a row's hold from the row before it")
      ->type_name("FILE");
  command.add_option("--speed", flags->speed, "[rpm], as 6000 or as from:to:step; with --steady")
      ->type_name("VALUES");
  command.add_flag("--steady", flags->steady, "where all has come to rest, at each --speed");
  command.add_option("--coolant", flags->coolant, "on or off; off: in every row")
      ->check(CLI::IsMember({"on", "off"}))
      ->type_name("STATE");
  add_number(command, "--ambient", flags->ambient, temperature_range,
             "[C] in every row; default: its column, else [ambient] of the model");
  command
      .add_option("-o,--output", flags->output,
                  "CSV file to write, - for stdout: displacement, forces, heat and temperatures")
      ->type_name("FILE");
  command
      .add_option("--start", flags->start,
                  "state to begin with, as --end-state writes it; default: all as warm as the room")
      ->type_name("FILE");
  command.add_option("--end-state", flags->end_state, "write the temperatures at the end (JSON)")
      ->type_name("FILE");
  command
      .add_option("--field", flags->field, "write the temperature of each cell at the end (CSV)")
      ->type_name("FILE");
  declare(command, flags->reading);
  command.add_flag("--force", flags->force, "replace files that exist");
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  flags->report.declare(command);
  command.footer(
      "Examples:\n  raceway spindle my.toml --speed 6000 --steady\n"
      "  raceway spindle my.toml --speed-profile day.csv -o run.csv --report page.html");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
