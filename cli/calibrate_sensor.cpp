#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <optional>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/output_flags.h"
#include "cli/text_table.h"
#include "files/sensor_file.h"
#include "session/sensor_calibration.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

struct SensorFlags : OutputFlags {
  std::string readings, degree = "auto";
  bool json = false;
  session::Reading reading;
};

std::optional<int> degree_of(const std::string& text) {
  if (text == "auto") return std::nullopt;
  if (text.size() == 1 && text[0] >= '1' && text[0] <= '0' + rig::highest_sensor_degree)
    return text[0] - '0';
  throw text::InputError(fmt::format("--degree = {}: must be 1, 2, 3 or auto", text),
                         {.key = "--degree"});
}

std::string p_text(double p) { return p < 1e-4 ? "p < 0.0001" : fmt::format("p = {:.2g}", p); }

std::string percent(const rig::SensorCalibration& c, double signal) {
  return fmt::format("{:.2g} % of the range", 100.0 * std::abs(signal) / c.signal_range);
}

void print_curve(const rig::SensorCalibration& c, const std::string& source) {
  const rig::TorqueSensor& s = c.sensor;
  fmt::print("signal = b0 + b1 M{}{}, signal in V, torque M in N m, fitted to {}\n",
             c.degree() > 1 ? " + b2 M^2" : "", c.degree() > 2 ? " + b3 M^3" : "", source);
  fmt::print("{} readings at {} torques, {:.6g} to {:.6g} N m, {:.6g} to {:.6g} V\n\n", c.readings,
             c.torques, s.lowest_torque, s.highest_torque, s.lowest_signal, s.highest_signal);
  TextTable table(
      {{"coefficient", "", true}, {"value", ""}, {"std error", ""}, {"unit", "", true}});
  for (int k = 0; k <= c.degree(); ++k)
    table.add({fmt::format("b{}", k), number(s.coefficients[k], 6), number(c.std(k), 2),
               files::coefficient_unit(k)});
  fmt::print("{}", table.text(terminal_width()));
  if (c.degree() == 1)
    fmt::print("M = (signal {} {:.6g} V) / {:.6g} V/Nm\n", s.coefficients[0] < 0.0 ? '+' : '-',
               std::abs(s.coefficients[0]), s.coefficients[1]);
}

void print_tests(const rig::SensorCalibration& c) {
  fmt::print("\nscatter     {} V of one reading, {}; standard error of the gain {:.2g} %\n",
             number(c.sensor.scatter, 3), percent(c, c.sensor.scatter),
             100.0 * c.range_std / c.signal_range);
  fmt::print("linearity   largest distance from the best straight line {} V, {}",
             number(c.off_line, 3), percent(c, c.off_line));
  if (c.degree() > 1) fmt::print("; from the fitted curve {} V", number(c.off_curve, 3));
  fmt::print("\n");
  const rig::LackOfFit& lack = c.lack_of_fit;
  if (std::isnan(lack.statistic))
    fmt::print("            lack of fit not tested: the readings do not allow the test\n");
  else
    fmt::print("            lack of fit F({}, {}) = {:.3g}, {}\n", lack.degrees, lack.error_degrees,
               lack.statistic, p_text(lack.p_value));
  const rig::Hysteresis& h = c.hysteresis;
  if (h.torques == 0)
    fmt::print("hysteresis  not known\n");
  else
    fmt::print("hysteresis  {} V (falling minus rising) at {:.4g} N m, {}{}\n",
               number(h.largest, 3), h.largest_at, percent(c, h.largest),
               !std::isnan(h.p_value) ? "; " + p_text(h.p_value)
                                      : "; measure at three torques or more to separate hysteresis "
                                        "from scatter");
}

/// What a record made with this sensor will have for its rows.
void print_errors(const rig::SensorCalibration& c) {
  const rig::TorqueSensor& s = c.sensor;
  if (s.scatter == 0.0) return;
  fmt::print("\n");
  TextTable table({{"torque", "N m"}, {"std of a reading", "N mm"}, {"common to all", "N mm"}});
  for (const double share : {0.0, 0.5, 1.0}) {
    const double torque = s.lowest_torque + share * (s.highest_torque - s.lowest_torque);
    const rig::SensedTorque one = rig::torque_of(s, rig::signal_at(s, torque));
    table.add({number(torque, 4), number(one.std / N_mm, 3), number(one.common / N_mm, 3)});
  }
  fmt::print("{}", table.text(terminal_width()));
}

int run(const SensorFlags& flags) {
  const std::optional<int> degree = degree_of(flags.degree);
  if (flags.readings == "-" && isatty(STDIN_FILENO) != 0)
    throw text::InputError(
        "raceway calibrate-sensor: CSV is -, but standard input is a terminal; name a file",
        {.key = "CSV"});
  refuse_two_on_stdout("calibrate-sensor", flags.json, flags.output);
  flags.require_writable();

  const session::CalibratedSensor found =
      session::calibrate_sensor(messages(), flags.readings, flags.reading, degree);
  if (flags.json) {
    put_document(found.json());
  } else if (flags.output != "-") {
    print_curve(found.calibration, found.source);
    print_tests(found.calibration);
    print_errors(found.calibration);
  }
  if (!flags.output.empty()) flags.put(found.text());
  return done;
}

}  // namespace

Run setup_calibrate_sensor(CLI::App& command) {
  auto flags = std::make_shared<SensorFlags>();
  command
      .add_option("CSV", flags->readings,
                  "CSV with reference_Nm and signal_V: readings at known torques, in the order of "
                  "the measurement; - for stdin")
      ->required()
      ->type_name("");
  command
      .add_option("--degree", flags->degree,
                  "degree of the curve: 1 line, 2 parabola, 3 cubic; auto: the lowest degree that "
                  "fits the readings")
      ->capture_default_str()
      ->type_name("N");
  flags->declare_output(command,
                        "file to write (TOML), with the table [torque_sensor]; - for stdout");
  declare(command, flags->reading);
  flags->declare_force(command);
  declare_json(command, flags->json);
  command.footer(
      "Copy the table [torque_sensor] into a model, or give the model a table\n[torque_sensor] "
      "that contains only file = \"sensor.toml\". All commands then\nconvert the column "
      "torque_signal_V of a record to the friction torque.\n\nExample:\n  raceway calibrate-sensor "
      "weights.csv -o sensor.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
