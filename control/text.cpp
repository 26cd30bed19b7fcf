#include "control/detail/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "control/formats.h"
#include "text/format_number.h"

namespace raceway::control {

std::string harmless(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && byte < 0xC0) continue;  // one sign of UTF-8 is one "_"
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    result +=
        letter || std::string_view(" _-.,:;()[]=<>+/").find(c) != std::string_view::npos ? c : '_';
  }
  return result;
}

std::string control_number(double value, std::string_view endless) {
  return std::isfinite(value) ? fmt::format("{:.15g}", value) : std::string(endless);
}

std::string control_numbers(const std::vector<double>& values, std::string_view before,
                            std::string_view after) {
  std::string text;
  for (const double v : values)
    text += fmt::format("{}{}{:.15g}{}", text.empty() ? "" : ", ", before, v, after);
  return text;
}

std::vector<TableAxis> axes_of(const ControlPlan& plan, const ControlDrive& power) {
  const ControlTable& t = plan.tables[power.table];
  std::vector<TableAxis> axes{{plan.speed, t.speed_rpm}};
  const auto add_load = [&](std::size_t input, const std::vector<double>& loads) {
    if (input != nowhere) axes.push_back({input, loads, loads.front() >= 0.0});
  };
  add_load(power.axial_load, t.axial_load_N);
  add_load(power.radial_load, t.radial_load_N);
  if (power.temperature != nowhere) axes.push_back({power.temperature, t.temperature_C});
  return axes;
}

std::string fixed_load(const ControlPlan& plan, const ControlDrive& power) {
  if (power.axial_load != nowhere) return {};
  return fmt::format(" at {:g} N", plan.tables[power.table].axial_load_N.front());
}

std::uint32_t stamp(const ControlPlan& plan) {
  ControlPlan bare = plan;  // the numbers count, not where they come from
  bare.source.clear();
  bare.notes.clear();
  bare.warnings.clear();
  bare.check = {};
  for (ControlAxis& axis : bare.axes) axis.trust = axis.trust_because = {};
  std::uint32_t hash =
      2166136261U + text::format_number - 1;  // FNV-1a; another format, another stamp
  for (const char c : control_csv(bare)) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

namespace {

constexpr std::string_view written_by = "Thermal correction, written by raceway ",
                           of_model = " from ";
constexpr std::string_view before_note = "Note: ", before_warning = "Warning: ";

/// The rest of a line without the dot at its end; empty where it does not begin so.
std::string_view rest_of(std::string_view line, std::string_view mark, std::string_view begin) {
  if (!line.starts_with(mark) || !line.substr(mark.size()).starts_with(begin)) return {};
  line.remove_prefix(mark.size() + begin.size());
  return line.ends_with('.') ? line.substr(0, line.size() - 1) : std::string_view();
}

}  // namespace

std::string units_of(const ControlPlan& plan) {
  std::string units;
  for (const std::string_view unit : {"um", "urad"})
    if (std::any_of(plan.axes.begin(), plan.axes.end(),
                    [&](const ControlAxis& a) { return unit_of(a) == unit; }))
      units += (units.empty() ? "" : " or ") + std::string(unit);
  return units;
}

std::string control_heading(const ControlPlan& plan, std::string_view mark) {
  std::string text = fmt::format("{}{}{}{}{}.\n", mark, written_by, RACEWAY_VERSION, of_model,
                                 harmless(plan.source));
  for (const ControlAxis& axis : plan.axes)
    if (!axis.trust.empty())
      text += fmt::format("{}Trust in {}: {}.\n", mark, axis.column, harmless(trust_line(axis)));
  if (std::any_of(plan.axes.begin(), plan.axes.end(), [](const auto& a) { return a.angle; }))
    text += fmt::format(
        "{}Displacements whose names end in urad are angles: for these, read urad instead of um.\n",
        mark);
  for (const std::string& warning : plan.warnings)
    text += fmt::format("{}{}{}.\n", mark, before_warning, harmless(warning));
  for (const std::string& note : plan.notes)
    text += fmt::format("{}{}{}.\n", mark, before_note, harmless(note));
  return text;
}

std::string source_in_heading(std::string_view line, std::string_view mark) {
  const std::string_view rest = rest_of(line, mark, written_by);
  const std::size_t at = rest.find(of_model);
  return at == rest.npos ? std::string() : std::string(rest.substr(at + of_model.size()));
}

std::string note_in_heading(std::string_view line, std::string_view mark) {
  return std::string(rest_of(line, mark, before_note));
}

std::string warning_in_heading(std::string_view line, std::string_view mark) {
  return std::string(rest_of(line, mark, before_warning));
}

std::string filled(std::string_view text, const std::vector<Replacement>& values) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find('@', at);
    const std::size_t end = begin == text.npos ? text.npos : text.find('@', begin + 1);
    if (end == text.npos) return result += text.substr(at);
    const std::string_view key = text.substr(begin + 1, end - begin - 1);
    result += text.substr(at, begin - at);
    bool known = false;
    for (const Replacement& r : values)
      if (r.key == key) {
        result += r.text;
        known = true;
      }
    if (!known) {
      // An "@" of its own; the next one may begin a key.
      result += '@';
      at = begin + 1;
      continue;
    }
    at = end + 1;
  }
  return result;
}

}  // namespace raceway::control
