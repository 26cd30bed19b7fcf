#include "files/correction_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>

#include "correction/catalogue.h"
#include "correction/numbers.h"
#include "correction/own_effect.h"
#include "files/detail/displacement_keys.h"
#include "files/friction_table.h"
#include "files/key_tables.h"
#include "record/series_channel.h"
#include "text/csv.h"
#include "text/input_file.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/column_section.h"
#include "files/detail/correction_prior.h"
#include "files/detail/correction_trust.h"
#include "files/detail/export_section.h"
#include "files/detail/formula_section.h"
#include "files/detail/loop_section.h"
#include "files/detail/marked_values.h"
#include "files/detail/model_tables.h"

namespace raceway::files {
namespace {

constexpr double most = 1e9;  // of any number of a file

constexpr Key correction_keys[]{
    {"displacement", a_text, is_required,
     "column that the correction predicts: displacement_NAME_um, or displacement_NAME_urad for an "
     "angle. The keys of an angle contain urad instead of um: gain_urad_K, offset_urad, "
     "tolerance_urad ..."},
    {"name", a_text, "name of the column", "name in the results"},
    {"tolerance_um", between(0, 1e6, "um"), unset,
     "largest RMS error that you accept on held-out parts of a record, above 0; diagnose needs "
     "this value here, under [loop] or as --tolerance"},
    {"measurement_std_um", between(0, 1e6, "um"), "estimated from neighbouring readings",
     "standard deviation of the noise of one reading"},
    {"initial_state", one_of("rest|free"), "rest",
     "state of the machine at the start of the record; rest: in thermal equilibrium; free: not in "
     "equilibrium, so the program fits the initial states of the lags"},
    {"offset_um", between(-1e6, 1e6, "um"), 0.0, "constant that is added to the prediction"},
    {"sampling_s", between(1e-6, 1e6, "s"), unset,
     "sampling interval for which numerator and denominator are valid; records with another "
     "interval are rejected"},
    {"channel", a_list, unset, "causes of displacement, tables [[correction.channel]]"},
    {"kinematic", a_table, unset,
     "coefficients of the kinematic displacement, table [correction.kinematic]"},
    {"effect", a_list, unset, "effects, tables [[correction.effect]]"},
    {"prior", a_table, unset,
     "\"PARAMETER\" = { value, std }: expected value and standard uncertainty of a parameter "
     "before the next fit, [correction.prior]"},
    {"range", a_table, unset,
     "COLUMN = [lowest, highest]: range of each input in the training data, [correction.range]"},
    {"still_s", a_table, unset,
     "COLUMN = longest time in s without a change of a temperature in the training data, "
     "[correction.still_s]"},
    {"together", a_table, unset,
     "mean, standard deviation and correlation of the inputs in the training data, table "
     "[correction.together]"},
    {"covariance", a_table, unset,
     "covariance of the fitted parameters, table [correction.covariance]"},
    {"residual", a_table, unset,
     "RMS and correlation time of the residual, table [correction.residual]"},
    {"trust", a_table, unset, "error on held-out readings, table [correction.trust]"},
};

constexpr Key correction_channel_keys[]{
    {"name", a_text, "name of the input", "name in the results"},
    {"input", a_text, is_required,
     "input of the channel: a column, a list of columns (the program uses their mean), or "
     "\"power_W\" (torque of a friction table times speed)"},
    {"exponent", between(0.5, 3.0), 1.0,
     "exponent for a speed n as input. The channel then has the input n (n/1000 "
     "rpm)^(exponent - 1)"},
    {"reference", a_text, unset,
     "temperature column. The change of this temperature since the first row of the run is "
     "subtracted from the change of the input"},
    {"sections", a_list, unset, "lags of the channel, each with gain and time constant"},
    {"scale", between(-1e6, 1e6), 1.0,
     "factor on the whole channel, for example to adapt it to another spindle of the same type"},
    {"window", a_table, unset,
     "{ column, points, acts_on }: share of the channel as a function of an axis position"},
    {"friction_table", a_text, unset,
     "for \"power_W\": CSV with speed_rpm, axial_load_N, temperature_C and friction_torque_Nmm, in "
     "the folder of the model"},
    {"axial_load_N", between(-1e8, 1e8, "N"), 0.0,
     "for \"power_W\": axial load at which the friction table is read, a number or a column"},
    {"radial_load_N", between(0, 1e8, "N"),
     "value in the friction table, if the table has only one radial load",
     "for \"power_W\": radial load at which the friction table is read, a number or a column"},
    {"temperature_C", between(-273, 500, "C"),
     "value in the friction table, if the table has only one temperature",
     "for \"power_W\": temperature at which the friction table is read, a number or a column"},
    {"gain", a_table, unset,
     "gain as a function of the input, instead of sections; for \"power_W\" or a column that is "
     "not a temperature, such as a load: { slope_um_W, offset_um }, { factor, exponent } or { "
     "table }"},
    {"time_constant", a_table, unset,
     "time constant as a function of the input, together with gain: { slope_min_W, offset_min }, { "
     "factor, exponent } or { table }"},
    {"numerator", a_list, unset,
     "numerator polynomial in z^-1, instead of sections; in um per unit of the input"},
    {"denominator", a_list, unset, "denominator polynomial in z^-1, instead of sections"},
};
constexpr Key window_keys[]{
    {"column", a_text, is_required,
     "column of the axis position, such as x_position_mm; another input column is also possible"},
    {"points", a_list, is_required,
     "[from, full_from, full_to, to] in the unit of the column: the share is 0 outside from and "
     "to, 1 between full_from and full_to, and linear between. [from, to] has sharp edges; -inf or "
     "inf: no edge on this side"},
    {"acts_on", one_of("displacement|input"), "displacement",
     "quantity that is multiplied by the share: displacement (for a body that acts only inside the "
     "window) or input (for heat that arises only inside the window)"},
};
// Of an input in kelvin; the names of others end in their unit.
constexpr Key feedthrough_keys[]{
    {"feedthrough_um_K", between(-most, most, "um/K"), 0.0,
     "displacement without lag, per unit of the input. The key ends in the unit of this value: "
     "um_K, um_W, um_m_min, um_rpm, um_A, um_mm ..."}};
constexpr Key section_gain_keys[]{
    {"gain_um_K", between(-most, most, "um/K"), is_required,
     "steady displacement per unit of the input. The key ends in the unit of this value: um_K, "
     "um_W, um_m_min, um_rpm, um_A, um_mm ..."}};
constexpr Key section_time_keys[]{
    {"time_constant_s", between(1e-3, most, "s"), is_required, "time constant of the lag"}};
constexpr Key element_gain_keys[]{
    {"slope_um_W", between(-most, most, "um/W"), unset,
     "slope of the gain against the input. The name of the key ends in the unit of the input: "
     "slope_um_W, slope_um_N ..."},
    {"offset_um", between(-most, most, "um"), unset,
     "offset in gain = slope * x + offset; x is the input in its unit, and the slope is the key "
     "slope_um_W or a similar key"},
    {"factor", between(-most, most, "um"), unset,
     "factor in gain = factor * x^exponent; x is the input in its unit"},
    {"exponent", between(-10, 10), unset, "exponent in gain = factor * x^exponent"},
    {"table", a_text, unset,
     "CSV in the folder of the model, with the columns gain_um and power_W (or the input instead "
     "of power_W)"},
};
constexpr Key element_time_keys[]{
    {"slope_min_W", between(-most, most, "min/W"), unset,
     "slope of the time constant against the input. The name of the key ends in the unit of the "
     "input: slope_min_W, slope_min_N ..."},
    {"offset_min", between(-most, most, "min"), unset,
     "offset in time constant = slope * x + offset; x is the input in its unit, and the slope is "
     "the key slope_min_W or a similar key"},
    {"factor", between(-most, most, "min"), unset,
     "factor in time constant = factor * x^exponent; x is the input in its unit"},
    {"exponent", between(-10, 10), unset, "exponent in time constant = factor * x^exponent"},
    {"table", a_text, unset,
     "CSV in the folder of the model, with the columns time_constant_min and power_W (or the input "
     "instead of power_W)"},
};

constexpr Key kinematic_keys[]{
    {"A", between(-most, most, "um"), is_required,
     "coefficient A of the kinematic displacement u = A n^(1 - B exp(-C n)), with u in um and the "
     "speed n in rpm"},
    {"B", between(-1, 2), is_required,
     "coefficient B of the kinematic displacement u = A n^(1 - B exp(-C n)), with u in um and the "
     "speed n in rpm"},
    {"C", between(0, 1, "1/rpm"), is_required,
     "coefficient C of the kinematic displacement u = A n^(1 - B exp(-C n)), with u in um and the "
     "speed n in rpm"},
};

constexpr Key correction_effect_keys[]{
    {"id", a_text, is_required,
     "id of an effect on a displacement over time that raceway effects lists, or a new id for an "
     "effect with a formula. The parameters of the effect are further keys of this table"},
    {"input", a_text, unset, "column, or list of columns, that drives the effect"},
    {"channel", a_text, unset, "name of the channel that the effect changes"},
    {"axis", a_text, unset,
     "machine axis whose movement causes the effect, such as x; the parameter names of the effect "
     "contain this axis"},
    {"window", a_table, unset,
     "{ column, points, acts_on }, only for id = \"input\": window on an axis position, as in a "
     "channel. Inside the window, the effect adds a displacement that follows the input of the "
     "channel"},
};
constexpr Key correction_own_effect_keys[]{
    {"formula", a_text, unset,
     "formula of your own effect, a function of columns and of parameters of the effect; the "
     "displacement is gain_um times the formula, with a lag if time_constant_s is given"},
    {"title", a_text, unset, "title of your own effect in messages"},
    {"gain_um", between(-most, most, "um"), unset,
     "gain of your own effect in um per unit of its formula, required; the value 0 switches the "
     "effect off, and diagnose then tests the effect"},
    {"time_constant_s", between(1, 1e7, "s"), unset,
     "time constant of the lag of your own effect; without it, the effect has no lag"},
};

using correction::DrivenChannel;
using correction::Effect;
using correction::Input;
using correction::Model;
using record::Channel;

/// A table in a list of tables.
Section part_of(const Section& owner, const std::string& name, const toml::node& node,
                Keys keys = {}) {
  if (!node.is_table())
    throw text::InputError(
        fmt::format("{}: {} = {}: must be a table", owner.place(&node), name, text::shown(node)),
        owner.at(name, &node));
  return Section(owner.source(), name, node.as_table(), std::move(keys));
}

const toml::array* list_of_tables(const Section& s, std::string_view key) {
  const toml::node* const node = s.find(key);
  if (!node) return nullptr;
  if (!node->is_array_of_tables() && !(node->is_array() && node->as_array()->empty()))
    s.fail(key, fmt::format("{}: must be a list of tables, each written as [[correction.{}]]", key,
                            key));
  return node->as_array();
}

class CorrectionReader {
 public:
  CorrectionReader(ModelTables& tables, CorrectionFile& file)
      : tables_(tables), notes_(file.notes) {}

  Model model(const Section& table) {
    displacement_ = record::series_channel(table.text_or_empty("displacement"));
    const Section s = table.with({keys(correction_keys)});
    Model m;
    m.displacement = displacement(s);
    m.name = s.text("name").value_or(std::string(m.displacement->variable));
    const std::string tolerance = own("tolerance_um");
    if (const auto t = s.number(tolerance)) {
      if (*t == 0.0) s.fail(tolerance, own("tolerance_um = 0 um: must be above 0"));
      m.tolerance = *t * um;
    }
    s.take(own("measurement_std_um"), m.measured_std, um);
    m.initial_state = tables_.choice(s, "initial_state") == "free" ? correction::InitialState::free
                                                                   : correction::InitialState::rest;
    s.take("sampling_s", m.sampling);
    m.offset = tables_.number(s, own("offset_um")) * um;
    if (const toml::array* const list = list_of_tables(s, "channel"))
      for (const toml::node& node : *list)
        m.channels.push_back(channel(part_of(s, "correction.channel", node), m));
    if (s.find("kinematic"))
      m.kinematic = kinematic(
          part_of(s, "correction.kinematic", *s.find("kinematic"), {keys(kinematic_keys)}));
    if (const toml::array* const list = list_of_tables(s, "effect"))
      for (const toml::node& node : *list)
        m.effects.push_back(effect(part_of(s, "correction.effect", node), m));
    read_priors(s, m);
    if (const toml::node* const range = s.find("range"))
      read_range(part_of(s, "correction.range", *range), m);
    if (const toml::node* const still = s.find("still_s"))
      read_still(part_of(s, "correction.still_s", *still), m);
    std::vector<std::string> on_trust;
    read_trust(s, m, on_trust);
    append(notes_, notes_of(record::note::odd_value, std::move(on_trust), {.key = "correction"}));
    return m;
  }

 private:
  /// Keys, names and units of the displacement that is read, see keys_of().
  [[nodiscard]] std::span<const Key> keys(std::span<const Key> of_length) const {
    return keys_of(displacement_, of_length);
  }
  [[nodiscard]] std::string own(std::string_view of_length) const {
    return displacement_ ? record::in_unit_of(*displacement_, of_length) : std::string(of_length);
  }

  const Channel* displacement(const Section& s) const {
    const auto name = s.text("displacement");
    if (!name)
      s.fail_missing("displacement",
                     ", the column that the correction predicts, such as \"displacement_z_um\"");
    const Channel* const c = record::series_channel(*name);
    if (!c || c->role != record::Role::measured)
      s.fail("displacement",
             fmt::format("displacement = \"{}\": must be a column displacement_NAME_um or "
                         "displacement_NAME_urad",
                         *name));
    return c;
  }

  const Channel* input_column(const Section& s, std::string_view key,
                              const std::string& name) const {
    const Channel* const c = record::series_channel(name);
    if (!c || !c->is_input())
      s.fail(key, fmt::format("{} = \"{}\": must be power_W, speed_rpm, coolant_on, or a column "
                              "NAME_temperature_C, NAME_feed_m_min, NAME_speed_rpm, "
                              "NAME_position_mm, NAME_current_A, NAME_voltage_V, or NAME with unit "
                              "W, N, Nm, l_min, bar or percent, such as spindle_power_W",
                              key, name));
    return c;
  }

  std::vector<const Channel*> columns(const Section& s, std::string_view key) const {
    const toml::node* const node = s.find(key);
    std::vector<const Channel*> list;
    if (!node) return list;
    if (node->is_string()) return {input_column(s, key, *node->value<std::string>())};
    if (!node->is_array() || node->as_array()->empty())
      s.fail(key, fmt::format("{} = {}: must be a column in quotes, or a list of columns", key,
                              text::shown(*node)));
    for (const toml::node& one : *node->as_array()) {
      if (!one.is_string())
        s.fail(key, fmt::format("{} = {}: each column of the list must be in quotes", key,
                                text::shown(*node)));
      list.push_back(input_column(s, key, *one.value<std::string>()));
      if (list.back()->key_unit() != list.front()->key_unit())
        s.fail(key, fmt::format(
                        "{}: {} and {} have different units, so the program cannot take their mean",
                        key, list.front()->name, list.back()->name));
    }
    return list;
  }

  Input input(const Section& s) {
    Input in;
    if (s.text_or_empty("input") == "power_W") {
      in.name = "power_W";
      const auto file = s.text("friction_table");
      if (!file)
        s.fail("input",
               "input = \"power_W\": friction_table is missing. This key names a CSV with "
               "speed_rpm, axial_load_N, temperature_C and friction_torque_Nmm, which raceway "
               "table can write. For a recorded power, use its column, such as spindle_power_W");
      in.table = std::make_shared<const correction::FrictionTable>(table(s, *file));
      const correction::FrictionTable& t = *in.table;
      in.axial_load = coordinate(s, record::axial_load, t.axial_load, 0.0);
      in.radial_load = coordinate(s, record::radial_load, t.radial_load);
      in.temperature = coordinate(s, record::temperature, t.temperature);
      require_radial_load(s, in);
    } else {
      if (!s.find("input")) s.fail_missing("input", ", the column that drives the channel");
      in.columns = columns(s, "input");
      in.name = in.columns.front()->name;
      for (const std::string_view key :
           {"friction_table", "axial_load_N", "radial_load_N", "temperature_C"})
        if (s.find(key))
          s.fail(key, fmt::format("{}: only possible with input = \"power_W\"", key));
    }
    if (const toml::node* const node = s.find("window"))
      in.window = window(part_of(s, "correction.channel.window", *node, {window_keys}));
    in.exponent = s.value("exponent");
    if (s.find("exponent") && in.unit() != "rpm")
      s.fail("exponent", "exponent: only possible if the input is a speed");
    if (const auto name = s.text("reference")) {
      in.reference = input_column(s, "reference", *name);
      if (in.is_power() || !record::is_temperature(*in.reference) ||
          !record::is_temperature(*in.columns.front()))
        s.fail("reference", "reference: the reference and the input must both be temperatures");
    }
    return in;
  }

  correction::Window window(const Section& s) {
    const auto column = s.text("column");
    if (!column)
      s.fail_missing("column", ", the column of the position, such as \"x_position_mm\"");
    correction::Window w{.column = input_column(s, "column", *column)};
    const toml::node* const node = s.find("points");
    if (!node) s.fail_missing("points", ", [from, full_from, full_to, to]");
    std::vector<double> points;
    if (const toml::array* const list = node->as_array())
      for (const toml::node& one : *list)
        if (const auto value = one.value<double>(); value && one.is_number())
          points.push_back(*value);
    if (points.size() == 2) points = {points[0], points[0], points[1], points[1]};
    if (points.size() != 4 || !std::is_sorted(points.begin(), points.end()) || !node->is_array() ||
        std::any_of(points.begin(), points.end(), [](double p) { return std::isnan(p); }))
      s.fail("points", fmt::format("points = {}: must be [from, full_from, full_to, to] or [from, "
                                   "to], in ascending order",
                                   text::shown(*node)));
    for (std::size_t k = 0; k < 4; ++k) w.points[k] = w.column->to_SI(points[k]);
    w.of_input = tables_.choice(s, "acts_on") == "input";
    return w;
  }

  correction::FrictionTable table(const Section& s, const std::string& file) const {
    try {
      NamedFiles& files = tables_.files();
      correction::FrictionTable read =
          of_correction(parse_friction_table(files.read(file).text, files.shown(file)));
      read.file = file;
      return read;
    } catch (const text::InputError& e) {
      throw text::InputError(fmt::format("{}: friction_table = \"{}\": {}",
                                         s.place(s.find("friction_table")), file, e.what()),
                             s.at("friction_table"));
    }
  }

  /// A number or a column at which a friction table is read on `axis`; without either `otherwise`,
  /// or the only value of the axis.
  correction::TableCoordinate coordinate(const Section& s, const Channel& of,
                                         const std::vector<double>& axis,
                                         double otherwise = unset) const {
    const toml::node* const node = s.find(of.name);
    if (node && node->is_string()) {
      const Channel* const c = input_column(s, of.name, *node->value<std::string>());
      if (c->unit != of.unit)
        s.fail(of.name,
               fmt::format("{}: must be a number, or a column {}", of.name,
                           record::is_temperature(of) ? "NAME_temperature_C" : "that ends in _N"));
      if (axis.size() < 2)
        s.fail(of.name, fmt::format("{} = \"{}\": the friction table has only one value of this "
                                    "quantity, so the column would have no effect; give a number",
                                    of.name, c->name));
      return {.column = c};
    }
    if (const auto value = s.number(of.name)) return {.value = of.to_SI(*value)};
    if (!std::isnan(otherwise)) return {.value = otherwise};
    if (axis.size() > 1)
      s.fail_missing(of.name, ", at which the friction table is read: give a number or a column");
    return {.value = axis.front()};
  }

  /// A radial load that is a number lies within its table.
  void require_radial_load(const Section& s, const Input& in) const {
    const double asked = in.radial_load.value;
    const std::vector<double>& loads = in.table->radial_load;
    if (in.radial_load.column || (asked >= loads.front() && asked <= loads.back())) return;
    std::vector<std::string> known;
    for (const double load : loads) known.push_back(fmt::format("{:g}", load));
    s.fail("radial_load_N",
           fmt::format("radial_load_N = {:g} N is outside the range of the friction table {} "
                       "(radial load{}: {} N)",
                       asked, in.table->file, known.size() == 1 ? "" : "s", text::listed(known)));
  }

  DrivenChannel channel(const Section& table, const Model& m) {
    DrivenChannel c;
    c.input = input(table.part({correction_channel_keys}));
    const std::string unit(c.input.key_unit()),
        per_input = own("um/" + std::string(c.input.unit()));
    const std::string gain = own("gain_um_" + unit), feedthrough = own("feedthrough_um_" + unit);
    const std::array at_once{feedthrough_keys[0].as(feedthrough, per_input)};
    const Section s = table.with({correction_channel_keys, at_once});
    c.name = s.text("name").value_or(
        std::string(c.input.is_power() ? "power" : c.input.columns.front()->variable));
    for (const DrivenChannel& other : m.channels)
      if (other.name == c.name)
        s.fail("name",
               fmt::format("name = \"{}\": two channels have this name; rename one", c.name));
    if (c.name.find_first_of(".:\" ") != c.name.npos)
      s.fail("name",
             fmt::format("name = \"{}\": must not contain blanks, dots, colons or quotes", c.name));
    const double factor = um / c.input.factor();
    c.feedthrough = s.value(feedthrough) * factor;
    c.scale = s.value("scale");
    const int ways = (s.find("sections") ? 1 : 0) +
                     (s.find("gain") || s.find("time_constant") ? 1 : 0) +
                     (s.find("numerator") || s.find("denominator") ? 1 : 0);
    if (ways > 1)
      s.fail("name", fmt::format("channel {}: give only one of these: sections, gain with "
                                 "time_constant, or numerator with denominator",
                                 c.name));
    if (s.find("sections")) read_sections(s, section_gain_keys[0].as(gain, per_input), factor, c);
    if (s.find("gain") || s.find("time_constant")) read_element(s, c);
    if (s.find("numerator") || s.find("denominator")) read_printed(s, m, c);
    if (ways == 0 && c.feedthrough == 0.0 && !s.find(feedthrough))
      s.fail("name", fmt::format("channel {}: sections are missing, for example sections = [{{ {} "
                                 "= 5, time_constant_s = 3600 }}]",
                                 c.name, gain));
    return c;
  }

  void read_sections(const Section& s, const Key& gain, double factor, DrivenChannel& c) {
    const toml::node& node = *s.find("sections");
    if (!node.is_array())
      s.fail("sections",
             fmt::format(
                 "sections = {}: must be a list such as [{{ {} = 5, time_constant_s = 3600 }}]",
                 text::shown(node), gain.name));
    for (const toml::node& one : *node.as_array()) {
      const std::array gains{gain};
      const Section of = part_of(s, "sections", one, {gains, section_time_keys});
      c.sections.push_back({of.required(gain.name) * factor, of.required("time_constant_s")});
    }
  }

  correction::Characteristic characteristic(const Section& s, const Input& input,
                                            const std::string& key, std::span<const Key> of_power,
                                            double unit) const {
    const std::string stem = key == "gain" ? own("um") : "min";
    const std::string slope = fmt::format("slope_{}_{}", stem, input.key_unit());
    const std::span<const Key> of_length = keys(of_power);
    std::vector<Key> own_keys(of_length.begin(), of_length.end());
    own_keys[0] = own_keys[0].as(slope, fmt::format("{}/{}", stem, input.unit()));
    const toml::node* const node = s.find(key);
    if (!node)
      s.fail("name",
             fmt::format("gain and time_constant are only possible together: {} is missing", key));
    const Section of = part_of(s, key, *node, {std::span<const Key>(own_keys)});
    if (of.find("table")) {
      const auto file = of.text("table");
      try {
        NamedFiles& files = tables_.files();
        return correction::Characteristic(parse_characteristic(
            files.read(*file).text, files.shown(*file), key,
            {.column = input.name,
             .variable = input.is_power() ? std::string("power")
                                          : std::string(input.columns.front()->variable),
             .unit = input.factor()}));
      } catch (const std::exception& e) {
        of.fail("table", fmt::format("table = \"{}\": {}", *file, e.what()));
      }
    }
    if (of.find("factor") || of.find("exponent"))
      return correction::Characteristic(
          correction::Characteristic::Power{of.required("factor") * unit, of.required("exponent")});
    // Slope and offset, whose names have the unit.
    return correction::Characteristic(correction::Characteristic::Line{
        of.required(own_keys[0].name) * unit, of.required(own_keys[1].name) * unit});
  }

  void read_element(const Section& s, DrivenChannel& c) {
    if (c.input.course() == record::Course::straight)
      s.fail("gain",
             "gain and time_constant are not possible for a temperature: use sections; gain and "
             "time_constant need input = \"power_W\" or a column such as a load");
    constexpr double minute = 60.0;
    c.element = correction::DelayElement{
        characteristic(s, c.input, "gain", element_gain_keys, um),
        characteristic(s, c.input, "time_constant", element_time_keys, minute),
        !c.input.is_power() && !record::acts_by_amount(*c.input.columns.front())};
    notes_.push_back(record::note::assumed(
        fmt::format(
            "channel {}: at {} of 0, the gain is 0{}, and the value of `gain` is ignored; the time "
            "constant is the value of `time_constant` at this {}",
            c.name, c.input.is_power() ? "a power" : "an input",
            c.input.is_power() ? " because a spindle at standstill produces no heat" : "",
            c.input.is_power() ? "power" : "input"),
        {.key = c.name}));
  }

  std::vector<double> coefficients(const Section& s, std::string_view key) const {
    const toml::node* const node = s.find(key);
    if (!node)
      s.fail(
          "name",
          fmt::format("numerator and denominator are only possible together: {} is missing", key));
    std::vector<double> list;
    const toml::array* const array = node->as_array();
    if (!array || array->empty())
      s.fail(key, fmt::format("{} = {}: must be a list of numbers", key, text::shown(*node)));
    for (const toml::node& one : *array) {
      const auto value = one.value<double>();
      if (!value || !std::isfinite(*value))
        s.fail(key, fmt::format("{} = {}: must be a list of numbers", key, text::shown(*node)));
      list.push_back(*value);
    }
    return list;
  }

  void read_printed(const Section& s, const Model& m, DrivenChannel& c) {
    if (std::isnan(m.sampling))
      s.fail("numerator",
             "numerator: the coefficients are valid for one sampling interval only, but sampling_s "
             "is missing under [correction]");
    correction::TransferFunction printed{coefficients(s, "numerator"),
                                         coefficients(s, "denominator"), m.sampling};
    for (double& a : printed.numerator) a *= um / c.input.factor();
    try {
      (void)correction::reduced(printed);
    } catch (const std::invalid_argument& e) {
      s.fail("denominator", fmt::format("channel {}: {}", c.name, e.what()));
    }
    c.printed = std::move(printed);
  }

  correction::Kinematic kinematic(const Section& s) const {
    return {s.required("A"), s.required("B"), s.required("C")};
  }

  Effect effect(const Section& table, const Model& m) {
    const Section s = table.part({correction_effect_keys, keys(correction_own_effect_keys)});
    const auto id = s.text("id");
    Names known;
    for (const correction::EffectCard& card : correction::catalogue()) known.emplace_back(card.id);
    if (!id) s.fail_missing("id", ", the id of an effect; raceway effects lists all ids");
    const correction::EffectKind* const found = correction::find_kind(*id);
    if (s.find("formula")) {
      if (found)
        s.fail(
            "formula",
            fmt::format(
                "formula: {} is the id of an effect in the catalogue; give your effect another id",
                *id));
      return own_effect(s, *id, m);
    }
    if (!found || found->card().evidence)
      s.fail("id", fmt::format("id = \"{}\": unknown effect on a displacement over time{}; for an "
                               "effect of your own, give a formula",
                               *id, text::suggestion(*id, known)));
    Effect e{.id = *id};
    e.columns = columns(s, "input");
    e.where = s.text("channel").value_or(s.text("axis").value_or(""));
    if (s.find("channel") && !correction::find_channel(m, e.where))
      s.fail("channel",
             fmt::format("channel = \"{}\": the model has no channel of this name", e.where));
    if (const toml::node* const node = s.find("window")) {
      if (!found->card().by_window)
        s.fail("window",
               fmt::format("window: not possible with id = \"{}\", only with id = \"input\"", *id));
      if (!e.columns.empty())
        s.fail("window",
               "window: an effect with a window acts on the input of a channel; give channel = "
               "\"NAME\" instead of input");
      e.window = window(part_of(s, "correction.effect.window", *node, {window_keys}));
    }
    if (found->card().needs_input && e.columns.empty() && !e.window)
      s.fail_missing("input", ", the column that drives the effect");
    const std::span<const record::NumberCard> numbers = found->numbers(e);
    std::deque<std::string> texts;  // of the keys
    std::vector<Key> of_numbers;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const std::string& name = texts.emplace_back(correction::key_of(e, k, m));
      if (found->may_end_before(k) && !s.find(name)) break;
      const Form form = between(std::max(-most, numbers[k].lower), std::min(most, numbers[k].upper),
                                texts.emplace_back(correction::unit_of(e, k, m)));
      of_numbers.push_back({name, form, is_required, found->card().title});
      e.values.push_back(*s.number(of_numbers.back()));
    }
    (void)table.with({correction_effect_keys, of_numbers});  // no others
    return e;
  }

  /// A formula of columns, with a gain, and a time constant where it lags.
  Effect own_effect(const Section& s, const std::string& id, const Model& m) const {
    if (id.empty() || id.find_first_of(" .:\t\n,;\"'") != id.npos ||
        std::string_view("=+-@").find(id.front()) != std::string_view::npos)
      s.fail("id", fmt::format("id = {}: must be a name without blanks, dots, colons, commas, "
                               "semicolons and quotes, and must not begin with =, +, - or @",
                               text::quoted(id)));
    for (const Effect& before : m.effects)
      if (before.id == id)
        s.fail("id", fmt::format("id = \"{}\": two effects have this id; rename one", id));
    correction::OwnEffect::Given given{.id = id,
                                       .title = s.text("title").value_or(""),
                                       .formula = s.text("formula").value_or(""),
                                       .lags = s.find("time_constant_s") != nullptr};
    Names taken{"id"};
    for (const Key& key : keys(correction_own_effect_keys)) taken.emplace_back(key.name);
    for (const auto& [key, node] : *s.table()) {
      const std::string name(key.str());
      if (std::find(taken.begin(), taken.end(), name) != taken.end()) continue;
      if (correction::column_of_formula(name))
        s.fail(name, fmt::format("{}: a column has this name; choose another name", name));
      const FormulaNumber n = read_formula_number(s, id, name, node, taken);
      given.parameters.push_back({n.name, n.unit, n.value, n.lower, n.upper, n.in_braces});
    }
    Effect e{.id = id};
    e.values.push_back(s.required(own("gain_um")));
    if (given.lags) e.values.push_back(s.required("time_constant_s"));
    Names known{"speed_rpm",        "NAME_temperature_C", "NAME_feed_m_min", "NAME_speed_rpm",
                "NAME_position_mm", "coolant_on",         "time_s"};
    for (const correction::OwnEffect::Number& n : given.parameters) {
      e.values.push_back(n.value);
      known.push_back(n.name);
    }
    try {
      e.own = std::make_shared<const correction::OwnEffect>(given);
    } catch (const record::FormulaError& error) {
      fail_formula(s, "formula", id, given.formula, error, known);
    }
    if (e.own->columns().empty())
      s.fail("formula", fmt::format("formula = \"{}\": must contain a column of a record, such as "
                                    "speed_rpm or front_temperature_C",
                                    given.formula));
    e.off = e.values.front() == 0.0;
    return e;
  }

  void read_range(const Section& s, Model& m) const {
    constexpr std::string_view of_power = " power_W";
    for (const auto& [key, node] : *s.table()) {
      const std::string name(key.str());
      const toml::array* const pair = node.as_array();
      if (!pair || pair->size() != 2 || !pair->get(0)->is_number() || !pair->get(1)->is_number())
        s.fail(name, fmt::format("{} = {}: must be [lowest, highest]", name, text::shown(node)));
      const double low = *pair->get(0)->value<double>(), high = *pair->get(1)->value<double>();
      if (!(low <= high))
        s.fail(name, fmt::format("{} = {}: the lowest value must not be above the highest", name,
                                 text::shown(node)));
      if (name.ends_with(of_power)) {
        const std::string channel = name.substr(0, name.size() - of_power.size());
        const DrivenChannel* const c = correction::find_channel(m, channel);
        if (channel.empty() || !c || !c->input.is_power())
          s.fail(name, fmt::format("{}: the model has no channel {} with input = \"power_W\"", name,
                                   channel));
        m.range.push_back({.name = channel, .lower = low, .upper = high});
        continue;
      }
      const Channel* const c = input_column(s, name, name);
      m.range.push_back(
          {.column = c, .name = name, .lower = c->to_SI(low), .upper = c->to_SI(high)});
    }
  }

  void read_still(const Section& s, Model& m) const {
    for (const auto& [key, node] : *s.table()) {
      const std::string name(key.str());
      const auto range = std::find_if(m.range.begin(), m.range.end(), [&](const auto& r) {
        return r.column && r.name == name && record::is_temperature(*r.column);
      });
      if (range == m.range.end())
        s.fail(name, fmt::format("{}: [correction.range] has no temperature of this name", name));
      range->still = *s.number(Key{name, between(0, 1e12, "s"), unset, {}});
    }
  }

  ModelTables& tables_;
  std::vector<record::Note>& notes_;
  const Channel* displacement_ = nullptr;  ///< of the model that is read
};

void check_correction_tables(const ModelTables& tables) {
  const Names known{"correction", "calibration", "loop",          "columns", "bearing",
                    "lubricant",  "friction",    "arrangement",   "rig",     "solver",
                    "material",   "effect",      "torque_sensor", "export",  "transducers"};
  for (const auto& [key, node] : tables.root())
    if (std::find(known.begin(), known.end(), key.str()) == known.end())
      throw text::InputError(fmt::format("{}: {}: unknown table{}", tables.place(key), key.str(),
                                         text::suggestion(key.str(), known)),
                             tables.at(key));
}

Names read_free(const ModelTables& tables, const Model& model) {
  const Section s = calibration_section(tables);
  const toml::node* const node = s.find("free");
  Names free;
  if (!node) return free;
  if (!node->is_array())
    s.fail("free", "free: must be a list of parameters or groups of parameters");
  for (const toml::node& one : *node->as_array()) {
    if (!one.is_string()) s.fail("free", "free: each name in the list must be in quotes");
    const std::string name = *one.value<std::string>();
    // Beside a [bearing] the list is of both, and f0 is for the other commands.
    if (tables.root().contains("bearing") && name.find('.') == name.npos &&
        !correction::is_group(name))
      continue;
    free.push_back(name);
  }
  Model with = model;
  with.free = free;
  try {
    (void)correction::free_names(with);
  } catch (const std::invalid_argument& e) {
    s.fail("free", fmt::format("free: {}", e.what()));
  }
  return free;
}

void read_tolerance(const ModelTables& tables, Model& model) {
  const Section s = loop_section(tables);
  const std::string key = correction::in_unit_of(model, "tolerance_um");
  const auto value = s.number(key);
  if (!value) return;
  if (!std::isnan(model.tolerance))
    s.fail(key, key + ": is also given under [correction]; keep one of them");
  model.tolerance = *value * um;
}

}  // namespace

std::vector<KeyTable> correction_tables() {
  return {{"correction", correction_keys},
          {"correction.channel", correction_channel_keys},
          {"correction.channel", feedthrough_keys},
          {"correction.channel.window", window_keys},
          {"correction.channel.sections", section_gain_keys},
          {"correction.channel.sections", section_time_keys},
          {"correction.channel.gain", element_gain_keys},
          {"correction.channel.time_constant", element_time_keys},
          {"correction.kinematic", kinematic_keys},
          {"correction.effect", correction_effect_keys},
          {"correction.effect", correction_own_effect_keys},
          {"correction.effect.window", window_keys}};
}

CorrectionFile parse_correction(std::string text, const std::string& source,
                                std::vector<NamedFile> held) {
  ModelTables tables(text, source, std::move(held));
  check_correction_tables(tables);
  CorrectionFile file;
  file.source = source;
  CorrectionReader reader(tables, file);
  const toml::node* const node = tables.root().get("correction");
  if (!node)
    throw text::InputError(fmt::format("{}: table [correction] is missing", source),
                           {.file = source, .key = "correction"});
  const Section root(source, "correction", node->as_table());
  if (node->is_array_of_tables()) {
    for (const toml::node& one : *node->as_array())
      file.models.push_back(reader.model(Section(source, "correction", one.as_table())));
  } else if (node->is_table()) {
    file.models.push_back(reader.model(root));
  } else {
    throw text::InputError(fmt::format("{}: correction = {}: must be a table, [correction]", source,
                                       text::shown(*node)),
                           {.file = source, .key = "correction"});
  }
  for (std::size_t k = 0; k < file.models.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j)
      if (file.models[j].displacement == file.models[k].displacement)
        throw text::InputError(fmt::format("{}: two tables [[correction]] predict {}; remove one",
                                           source, file.models[k].displacement->name),
                               {.file = source, .key = "displacement"});
    file.models[k].free = read_free(tables, file.models[k]);
    read_tolerance(tables, file.models[k]);
  }
  file.columns = read_columns(tables);
  file.control = read_export(tables, file.models);
  file.defaults = marked_values(tables.root(), text);
  file.defaults.insert(file.defaults.end(), tables.defaults().begin(), tables.defaults().end());
  file.files = tables.files().list();
  file.text = std::move(text);
  return file;
}

CorrectionFile read_correction(const std::string& path) {
  bool marked = false;
  std::string text = text::read_text(path, &marked);
  CorrectionFile file = parse_correction(std::move(text), text::input_name(path));
  if (marked) file.text.insert(0, text::utf8_mark);
  return file;
}

}  // namespace raceway::files
