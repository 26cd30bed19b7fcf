#include "control/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "control/detail/table_fields.h"
#include "control/detail/text.h"
#include "record/series_channel.h"
#include "text/csv.h"
#include "text/error.h"
#include "text/names.h"
#include "text/number_text.h"

namespace raceway::control {
namespace {

struct Row {
  std::string_view of, channel, part, name, value;
  int line = 0;
};

/// "section 2": "section" and 2; 0 where no whole number follows.
std::pair<std::string_view, std::size_t> kind_of(std::string_view part) {
  const std::size_t blank = part.rfind(' ');
  if (blank == part.npos) return {part, 0};
  std::size_t number = 0;
  for (const char c : part.substr(blank + 1)) {
    if (c < '0' || c > '9' || number > 100000) return {part, 0};
    number = 10 * number + static_cast<std::size_t>(c - '0');
  }
  return {part.substr(0, blank), number};
}

/// The numbers in "at 3000 rpm 20 C" or "at 600 s", by their units, with the digits that
/// control_csv() writes: numbers that it would write alike are equal.
std::vector<double> numbers_at(std::string_view name, std::string_view before,
                               const std::vector<std::string_view>& units) {
  std::vector<double> found;
  if (!name.starts_with(before)) return {};
  name.remove_prefix(before.size());
  for (const std::string_view unit : units) {
    const std::size_t end = name.find(unit);
    if (end == name.npos) return {};
    const text::ParsedNumber n = text::parse_number(name.substr(0, end), false);
    if (!n.problem.empty()) return {};
    found.push_back(text::with_15_digits(n.value));
    name.remove_prefix(end + unit.size());
  }
  return name.empty() ? found : std::vector<double>{};
}

class TableReader {
 public:
  TableReader(const text::CsvTable& csv, const std::string& source) : source_(source) {
    for (const std::string& line : csv.comments) {
      if (plan_.source.empty()) plan_.source = source_in_heading(line, "# ");
      if (std::string note = note_in_heading(line, "# "); !note.empty())
        plan_.notes.push_back(std::move(note));
      if (std::string warning = warning_in_heading(line, "# "); !warning.empty())
        plan_.warnings.push_back(std::move(warning));
    }
    for (std::size_t k = 0; k < csv.rows(); ++k)
      rows_.push_back({csv.cell(k, 0), csv.cell(k, 1), csv.cell(k, 2), csv.cell(k, 3),
                       csv.cell(k, 4), csv.line(k)});
  }

  ControlPlan read() {
    // Inputs and displacements first: the other rows name them.
    for (const Row& r : rows_) {
      if (r.part == "input") (void)input(r, true);
      if (r.part == "displacement") (void)axis(r, true);
    }
    if (plan_.axes.empty())
      throw text::InputError(source_ + ": the table has no row for a displacement",
                             {.file = source_});
    std::size_t from = 0;
    for (std::size_t k = 1; k <= rows_.size(); ++k) {
      const bool same = k < rows_.size() && rows_[k].part == rows_[from].part &&
                        (rows_[k].of == rows_[from].of || rows_[k].part == "check" ||
                         rows_[k].part.starts_with("together"));
      if (same) continue;
      read_part({rows_.begin() + static_cast<std::ptrdiff_t>(from),
                 rows_.begin() + static_cast<std::ptrdiff_t>(k)});
      from = k;
    }
    plan_.speed = place_of(plan_, "speed_rpm");
    plan_.coolant = place_of(plan_, "coolant_on");
    check_whole();
    in_order(plan_);
    return std::move(plan_);
  }

 private:
  using Part = std::vector<Row>;

  [[noreturn]] void fail(const Row& r, const std::string& problem) const {
    throw text::InputError(fmt::format("{}:{}: {}, {}, {} = {}: {}", source_, r.line, r.of, r.part,
                                       r.name, r.value, problem),
                           {.file = source_, .line = r.line, .key = std::string(r.name)});
  }
  [[noreturn]] void fail_missing(const Row& r, std::string_view name) const {
    throw text::InputError(
        fmt::format("{}:{}: {}, {}: {} is missing", source_, r.line, r.of, r.part, name),
        {.file = source_, .line = r.line, .key = std::string(name)});
  }

  double number(const Row& r, double lowest = -1e30, double highest = 1e30) const {
    if (r.value == "none" && r.name == "limit") return std::numeric_limits<double>::infinity();
    const text::ParsedNumber n = text::parse_number(r.value, false);
    if (!n.problem.empty()) fail(r, std::string(n.problem));
    if (!(n.value >= lowest && n.value <= highest))
      fail(r, fmt::format("must be from {:g} to {:g}", lowest, highest));
    return n.value;
  }

  std::size_t input_named(const Row& r, std::string_view column) const {
    const std::size_t place = place_of(plan_, column);
    if (place == nowhere) fail(r, "the table has no input of this name");
    return place;
  }
  ControlInput& input(const Row& r, bool make = false) {
    if (const std::size_t known = place_of(plan_, r.of); known != nowhere)
      return plan_.inputs[known];
    const record::Channel* const c = record::series_channel(r.of);
    if (!make || !c || !c->is_input()) fail(r, "this column cannot be an input of a correction");
    plan_.inputs.push_back(input_of(*c));
    return plan_.inputs.back();
  }
  ControlAxis& axis(const Row& r, bool make = false) {
    for (ControlAxis& a : plan_.axes)
      if (a.column == r.of) return a;
    const record::Channel* const c = record::series_channel(r.of);
    if (!make || !c || c->role != record::Role::measured)
      fail(r, "this column is not a displacement");
    plan_.axes.push_back({.column = std::string(r.of)});
    plan_.axes.back().angle = record::is_angle(*c);
    return plan_.axes.back();
  }

  /// Whether the row is a number of that part, which is then taken.
  template <typename Of, std::size_t count>
  bool take(const Row& r, Of& part, const std::array<NumberField<Of>, count>& fields) const {
    for (const auto& f : fields) {
      if (f.name != r.name) continue;
      part.*f.number = number(r, f.lowest, f.highest);
      return true;
    }
    return false;
  }
  template <typename Of, std::size_t count>
  bool take(const Row& r, Of& part, const std::array<TextField<Of>, count>& fields) const {
    for (const auto& f : fields) {
      if (f.name != r.name) continue;
      part.*f.text = std::string(r.value);
      const bool one_word = r.value.find(' ') == r.value.npos;
      if (!f.allowed.empty() &&
          (!one_word || f.allowed.find(fmt::format(" {} ", r.value)) == f.allowed.npos))
        fail(r, fmt::format("must be one of:{}", f.allowed.substr(0, f.allowed.size() - 1)));
      return true;
    }
    return false;
  }
  template <typename Of, std::size_t count>
  void require(const Part& part, const Of&,
               const std::array<NumberField<Of>, count>& fields) const {
    for (const auto& f : fields)
      if (f.required &&
          std::none_of(part.begin(), part.end(), [&](const Row& r) { return r.name == f.name; }))
        fail_missing(part.front(), f.name);
  }
  [[noreturn]] void fail_unknown(const Row& r) const {
    fail(r, "unknown name in this part of the table");
  }

  void read_part(const Part& part) {
    const Row& first = part.front();
    const auto [kind, count] = kind_of(first.part);
    if (first.part == "control") {
      for (const Row& r : part)
        if (!take(r, plan_.settings, setting_numbers) && !take(r, plan_.settings, setting_texts))
          fail_unknown(r);
      require(part, plan_.settings, setting_numbers);
    } else if (first.part == "input") {
      for (const Row& r : part)
        if (!take(r, input(r), input_numbers) && r.name != "range") fail_unknown(r);
    } else if (first.part == "displacement") {
      read_axis(part);
    } else if (first.part == "check") {
      read_check(part);
    } else if (count == 0) {
      fail(first, "a coefficient table has no part of this name");
    } else if (kind == "together") {
      read_together(part);
    } else if (kind == "section") {
      read_section(part, axis(first));
    } else if (kind == "element") {
      read_element(part, axis(first));
    } else if (kind == "feedthrough") {
      ControlFeedthrough f{.channel = std::string(first.channel)};
      read_driven(part, f, feedthrough_numbers);
      axis(first).feedthroughs.push_back(f);
    } else if (kind == "equation") {
      read_equation(part, axis(first));
    } else if (kind == "kinematic") {
      ControlKinematic law;
      for (const Row& r : part)
        if (!take(r, law, kinematic_numbers)) fail_unknown(r);
      require(part, law, kinematic_numbers);
      axis(first).kinematics.push_back(law);
    } else {
      fail(first, "a coefficient table has no part of this name");
    }
  }

  void read_axis(const Part& part) {
    ControlAxis& a = axis(part.front());
    for (const Row& r : part) {
      if (take(r, a, axis_numbers) || take(r, a, axis_texts)) continue;
      if (r.name != "counts") fail_unknown(r);
      a.counts = number(r, 0, 1) != 0;
    }
    require(part, a, axis_numbers);
    if (std::abs(a.sign) != 1.0) fail(part.front(), "\"sign\" must be 1 or -1");
    // It becomes a name in programs.
    for (const char c : a.output)
      if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
            c == '_' || c == '-'))
        fail(part.front(), "\"output\" must consist of letters, digits, _ and -");
  }

  void read_check(const Part& part) {
    for (const Row& r : part) {
      const std::vector<double> at = numbers_at(r.name, "at ", {" s"});
      if (at.empty()) fail(r, "the name must be a time such as \"at 600 s\"");
      const auto [found, fresh] = check_rows_.emplace(at.front(), plan_.check.rows.size());
      if (fresh)
        plan_.check.rows.push_back({at.front(), std::vector<double>(plan_.inputs.size(), unset),
                                    std::vector<double>(plan_.axes.size(), unset)});
      ControlCheck::Row& row = plan_.check.rows[found->second];
      if (const std::size_t k = place_of(plan_, r.of); k != nowhere)
        row.inputs[k] = number(r);
      else
        row.displacements_um[static_cast<std::size_t>(&axis(r) - plan_.axes.data())] = number(r);
    }
    const auto lacks = [](const std::vector<double>& values) {
      return std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
    };
    for (const ControlCheck::Row& row : plan_.check.rows)
      if (lacks(row.inputs) || lacks(row.displacements_um))
        throw text::InputError(
            fmt::format("{}: check at {:g} s: an input or a displacement is missing", source_,
                        row.time_s),
            {.file = source_, .key = "check"});
  }

  void read_together(const Part& part) {
    ControlTogether t;
    std::vector<std::pair<std::size_t, double>> weights;
    for (const Row& r : part) {
      constexpr std::string_view of_weight = "weight of ";
      if (r.name == "farthest") {
        t.farthest = number(r, 0.0);
      } else if (r.name == "mean") {
        t.inputs.push_back(input_named(r, r.of));
        t.mean.push_back(number(r));
      } else if (r.name.starts_with(of_weight)) {
        const std::size_t next = t.weights.size() + 1;  // of the triangle, row by row
        const std::size_t size = t.inputs.size();
        if (next > size * (size + 1) / 2)
          fail(r, "too many weights for the inputs in the rows above");
        const std::size_t column = next - 1 - (size * (size - 1)) / 2;
        if (size == 0 || column >= size ||
            plan_.inputs[t.inputs[column]].column != r.name.substr(of_weight.size()))
          fail(r,
               "this weight is out of order: a weight before it is missing, or the weights do not "
               "follow the order of the inputs");
        t.weights.push_back(number(r));
      } else {
        fail_unknown(r);
      }
    }
    if (t.weights.size() != t.inputs.size() * (t.inputs.size() + 1) / 2)
      fail_missing(part.front(), "a weight");
    if (std::isnan(t.farthest)) fail_missing(part.front(), "farthest");
    plan_.together.push_back(std::move(t));
  }

  /// Torques of a table by temperature, radial load, axial load and speed: the order of a plan.
  using Torques = std::map<std::vector<double>, double>;

  /// Place of a torque among them; empty for another name. 0 for a load that no input has.
  static std::vector<double> torque_point(std::string_view name, const ControlDrive& d) {
    std::vector<std::string_view> units{" rpm "};
    if (d.axial_load != nowhere) units.emplace_back(" N axial ");
    if (d.radial_load != nowhere) units.emplace_back(" N radial ");
    units.emplace_back(" C");
    const std::vector<double> at = numbers_at(name, "torque at ", units);
    if (at.empty()) return {};
    const double axial = d.axial_load == nowhere ? 0.0 : at[1];
    return {at.back(), d.radial_load == nowhere ? 0.0 : at[at.size() - 2], axial, at.front()};
  }

  /// A part that something drives: its own numbers, and those of the drive.
  template <typename Of, std::size_t count>
  Part read_driven(const Part& part, Of& of, const std::array<NumberField<Of>, count>& fields) {
    Part others;
    ControlDrive d;
    ControlTable t;
    Torques torques;
    std::string_view u;
    for (const Row& r : part) {
      if (take(r, of, fields) || take(r, d, drive_numbers)) continue;
      if (r.name == "u") {
        u = r.value;
        const auto* const kind = std::find(drive_kinds.begin(), drive_kinds.end(), u);
        if (kind == drive_kinds.end()) fail(r, "\"u\" must be rise, size, power or motor");
        d.kind = static_cast<ControlDrive::Kind>(kind - drive_kinds.begin());
      } else if (r.name == "input") {
        d.inputs.push_back(input_named(r, r.value));
      } else if (r.name == "reference") {
        d.reference = input_named(r, r.value);
      } else if (r.name == "axial_load_input") {
        d.axial_load = input_named(r, r.value);
      } else if (r.name == "radial_load_input") {
        d.radial_load = input_named(r, r.value);
      } else if (r.name == "temperature") {
        d.temperature = input_named(r, r.value);
      } else if (r.name == "window") {
        d.window = input_named(r, r.value);
      } else if (r.name == "window_acts_on") {
        if (r.value != "input" && r.value != "displacement")
          fail(r, "window_acts_on must be input or displacement");
        d.window_of_drive = r.value == "input";
      } else if (r.name == "friction_table") {
        t.file = std::string(r.value);
      } else if (r.name == "axial_load") {
        t.axial_load_N = {number(r)};
      } else if (const auto at = torque_point(r.name, d); !at.empty()) {
        torques[at] = number(r);
      } else {
        others.push_back(r);
      }
    }
    const Row& first = part.front();
    if (u.empty()) fail_missing(first, "u");
    require(part, of, fields);
    complete(first, d, t, torques);
    of.drive = plan_.drives.size();
    plan_.drives.push_back(std::move(d));
    return others;
  }

  void complete(const Row& first, ControlDrive& d, ControlTable& t, const Torques& torques) {
    using Kind = ControlDrive::Kind;
    if ((d.kind == Kind::rise || d.kind == Kind::size) && d.inputs.empty())
      fail_missing(first, "input");
    if (d.kind == Kind::motor && std::isnan(d.decay_rpm)) fail_missing(first, "decay_speed");
    if ((d.kind == Kind::power || d.kind == Kind::motor) && place_of(plan_, "speed_rpm") == nowhere)
      fail(first, "this part depends on the speed, but the table has no input speed_rpm");
    const bool rises = d.window_from <= d.window_full_from &&
                       d.window_full_from <= d.window_full_to && d.window_full_to <= d.window_to;
    if (d.window != nowhere && !rises)
      fail(
          first,
          "window_from, window_full_from, window_full_to and window_to must be in ascending order");
    if (d.kind == Kind::rise) d.unit = "K";
    if (d.kind == Kind::size) d.unit = plan_.inputs[d.inputs.front()].unit;
    if (d.kind == Kind::motor) d.unit = "1";
    if (d.kind != Kind::power) return;
    d.unit = "W";
    if (d.temperature == nowhere && std::isnan(d.temperature_C))
      fail_missing(first, "temperature or temperature_value");
    std::array<std::set<double>, 4> axes;
    for (const auto& [at, torque] : torques) {
      for (std::size_t k = 0; k < axes.size(); ++k) axes[k].insert(at[k]);
      t.torque_Nmm.push_back(torque);
    }
    std::size_t points = 1;
    for (const auto& axis : axes) points *= axis.size();
    if (torques.empty() || t.torque_Nmm.size() != points)
      fail(first,
           "the friction table needs a torque at each combination of speed, load and temperature");
    const auto list = [](const std::set<double>& axis) {
      return std::vector<double>(axis.begin(), axis.end());
    };
    t.temperature_C = list(axes[0]);
    t.radial_load_N = list(axes[1]);
    if (d.axial_load != nowhere || t.axial_load_N.empty()) t.axial_load_N = list(axes[2]);
    t.speed_rpm = list(axes[3]);
    if (d.temperature == nowhere && t.temperature_C.size() > 1)
      fail(first,
           "the friction table has several temperatures, so this part needs a row \"temperature\" "
           "that names an input");
    d.table = plan_.tables.size();
    plan_.tables.push_back(std::move(t));
  }

  void read_section(const Part& part, ControlAxis& a) {
    ControlSection s{.channel = std::string(part.front().channel)};
    for (const Row& r : read_driven(part, s, section_numbers)) {
      if (r.name != "course") fail_unknown(r);
      if (r.value != "straight" && r.value != "held")
        fail(r,
             "\"course\" of a section must be straight (linear between samples) or "
             "held (constant between samples)");
      s.straight = r.value == "straight";
    }
    a.sections.push_back(std::move(s));
  }

  void read_element(const Part& part, ControlAxis& a) {
    ControlElement e{.channel = std::string(part.front().channel)};
    const Part others = read_driven(part, e, element_numbers);
    const ControlDrive& d = plan_.drives.back();
    if (d.kind != ControlDrive::Kind::power && d.kind != ControlDrive::Kind::size)
      fail(part.front(),
           "a delay element needs a power or a load as input: \"u\" must be power or size");
    e.gain_um = curve(part.front(), others, "gain", d.unit);
    e.time_constant_s = curve(part.front(), others, "time_constant", d.unit);
    for (const Row& r : others)
      if (!r.name.starts_with("gain ") && !r.name.starts_with("time_constant ")) fail_unknown(r);
    a.elements.push_back(std::move(e));
  }

  void read_equation(const Part& part, ControlAxis& a) {
    ControlEquation e{.channel = std::string(part.front().channel)};
    e.denominator = {1.0};
    for (const Row& r : read_driven(part, e, equation_numbers)) {
      const auto [name, place] = kind_of(r.name);
      std::vector<double>* const list = name == "numerator"     ? &e.numerator
                                        : name == "denominator" ? &e.denominator
                                                                : nullptr;
      if (!list) fail_unknown(r);
      if (place != list->size())
        fail(r, "the coefficients of a polynomial must be in ascending order, without gaps");
      list->push_back(number(r));
    }
    if (e.numerator.size() != e.denominator.size())
      fail(part.front(),
           "\"numerator\" and \"denominator\" must have the same number of coefficients");
    a.equations.push_back(std::move(e));
  }

  ControlCurve curve(const Row& first, const Part& part, std::string_view name,
                     std::string_view unit) const {
    ControlCurve c;
    const std::string end = " " + std::string(unit);
    bool line = false, law = false;
    int numbers = 0;
    for (const Row& r : part) {
      if (!r.name.starts_with(name) || r.name.size() <= name.size() || r.name[name.size()] != ' ')
        continue;
      const std::string_view what = r.name.substr(name.size() + 1);
      if (const auto at = numbers_at(what, "at ", {end}); !at.empty()) {
        if (!c.input.empty() && at.front() <= c.input.back())
          fail(r, "the input values of a curve must increase from row to row");
        c.input.push_back(at.front());
        c.value.push_back(number(r));
        continue;
      }
      ++numbers;
      line = line || what == "slope" || what == "value_at_0";
      law = law || what == "factor" || what == "exponent";
      if (what == "slope" || what == "factor")
        c.factor = number(r);
      else if (what == "value_at_0" || what == "exponent")
        c.other = number(r);
      else
        fail_unknown(r);
    }
    const bool table = !c.value.empty();
    if ((line ? 1 : 0) + (law ? 1 : 0) + (table ? 1 : 0) != 1 || (!table && numbers != 2))
      fail(first,
           fmt::format(
               "{0} must be a line (rows {0} slope and {0} value_at_0), a power law (rows {0} "
               "factor and {0} exponent) or a table (rows {0} at ...)",
               name));
    c.kind = table ? ControlCurve::Kind::table
             : law ? ControlCurve::Kind::power_law
                   : ControlCurve::Kind::line;
    return c;
  }

  void check_whole() const {
    for (const ControlAxis& a : plan_.axes) {
      const bool by_speed =
          !a.kinematics.empty() || std::any_of(a.sections.begin(), a.sections.end(),
                                               [](const auto& s) { return s.speed_factor != 0.0; });
      const bool by_coolant = std::any_of(a.sections.begin(), a.sections.end(), [](const auto& s) {
        return s.off_gain != 1.0 || s.off_time_constant != 1.0;
      });
      for (const auto& [needs, place, column] :
           {std::tuple{by_speed, plan_.speed, "speed_rpm"},
            std::tuple{by_coolant, plan_.coolant, "coolant_on"}})
        if (needs && place == nowhere)
          throw text::InputError(
              fmt::format("{}: {} depends on {}, but the table has no such input", source_,
                          a.column, column),
              {.file = source_, .key = column});
    }
    for (const ControlAxis& a : plan_.axes)
      for (const ControlEquation& e : a.equations)
        if (e.sampling_s != sampling_of(plan_))
          throw text::InputError(fmt::format("{}: {}: all difference equations need the same "
                                             "sampling interval, but the table has {} s and {} s",
                                             source_, a.column, sampling_of(plan_), e.sampling_s),
                                 {.file = source_, .key = "sampling"});
    for (const ControlInput& in : plan_.inputs)
      if (!(in.lowest <= in.highest) && !(std::isnan(in.lowest) && std::isnan(in.highest)))
        throw text::InputError(fmt::format("{}: {}, input: lowest = {} and highest = {}: give both "
                                           "or neither, and lowest must not exceed highest",
                                           source_, in.column, in.lowest, in.highest),
                               {.file = source_, .key = in.column});
  }

  std::string source_;
  std::vector<Row> rows_;
  ControlPlan plan_;
  std::map<double, std::size_t> check_rows_;  // by their time [s]
};

}  // namespace

bool is_control_table(std::string_view text) { return text.starts_with(table_mark); }

ControlPlan read_control_table(std::string text, const std::string& source) {
  const text::CsvTable csv = text::parse_csv(std::move(text), source);
  std::string header;
  for (const std::string& name : csv.header) header += (header.empty() ? "" : ",") + name;
  if (header != table_header)
    throw text::InputError(
        fmt::format("{}:{}: the columns must be {}", source, csv.header_line, table_header),
        csv.header_place());
  return TableReader(csv, source).read();
}

}  // namespace raceway::control
