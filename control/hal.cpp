#include <fmt/format.h>

#include <cmath>

#include "control/detail/text.h"
#include "control/formats.h"
#include "text/error.h"

namespace raceway::control {

std::string control_hal(const ControlPlan& plan, std::string_view name, std::string_view program) {
  std::string text = control_heading(plan, "# ");
  text += fmt::format(
      "# Add to the INI:\n#   [HAL]\n#   HALFILE = {0}.hal\n#   SHUTDOWN = {0}_shutdown.hal\n",
      name);
  std::string nets;
  for (const ControlAxis& a : plan.axes) {
    if (a.letter.empty())
      throw text::InputError(fmt::format("{}: {}: this displacement has no axis of LinuxCNC; give "
                                         "the axis, for example [export] axis = {{ {} = \"z\" }}",
                                         plan.source, a.column, a.column),
                             {.file = plan.source, .key = "axis"});
    std::string capital = a.letter;
    capital.front() = static_cast<char>(capital.front() - 'a' + 'A');
    text += fmt::format("#   [AXIS_{}]\n#   OFFSET_AV_RATIO = 0.2\n", capital);
    for (const char* pin : {"counts", "scale", "enable", "clear"})
      nets +=
          fmt::format("net {0}-{1}-{2} {0}.{1}-{2} => axis.{1}.eoffset-{2}\n", name, a.letter, pin);
    nets +=
        fmt::format("net {0}-{1}-eoffset axis.{1}.eoffset => {0}.{1}-eoffset\n", name, a.letter);
  }
  text += fmt::format("loadusr -Wn {0} /usr/bin/python3 {1} --hal --state {0}.state\n{2}", name,
                      program, nets);
  text += fmt::format(
      "net {0}-motion-on motion.motion-enabled => {0}.motion-on\n"
      "net {0}-homed motion.is-all-homed => {0}.homed\n"
      "# Connect the sensors and other inputs here; then set {0}.enable. Temperature rises are "
      "measured from the first call.\n",
      name);
  for (const ControlInput& in : plan.inputs)
    text += fmt::format(
        "#   net SIGNAL => {}.{}   # {}{}\n", name, in.column, in.unit,
        std::isnan(in.lowest)
            ? std::string()
            : fmt::format(", {:.6g} to {:.6g} in the training data", in.lowest, in.highest));
  text += fmt::format(
      "#   net SIGNAL => {0}.enable\n#   net SIGNAL => {0}.touch-off\n"
      "#   net SIGNAL <= {0}.alarm\n",
      name);
  return text;
}

std::string control_hal_shutdown(const ControlPlan& plan, std::string_view name,
                                 std::string_view program) {
  return fmt::format(
      "{}# Before LinuxCNC stops: the applied offsets go back to 0.\nsetp {}.stop 1\n"
      "loadusr -w /usr/bin/python3 {} --wait-until-done\n",
      control_heading(plan, "# "), name, program);
}

}  // namespace raceway::control
