#include "io/correction_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "correction/catalogue.h"
#include "correction/numbers.h"
#include "correction/own_effect.h"
#include "io/csv.h"
#include "io/friction_table.h"
#include "io/input_file.h"
#include "record/series_channel.h"

// Last: see io/toml_text.h.
#include "io/column_section.h"
#include "io/correction_trust.h"
#include "io/export_section.h"
#include "io/formula_section.h"
#include "io/model_tables.h"

namespace raceway::io {
namespace {

using correction::DrivenChannel;
using correction::Effect;
using correction::Input;
using correction::Model;
using record::Channel;

constexpr double most = 1e9;  // of any number of a file

/// A table in a list of tables.
Section part_of(const Section& owner, const std::string& name, const toml::node& node) {
  if (!node.is_table())
    throw InputError(fmt::format("{}: {} = {}: must be a table in braces", owner.place(&node), name,
                                 shown(node)),
                     owner.at(name, &node));
  return Section(owner.source(), name, node.as_table());
}

const toml::array* list_of_tables(const Section& s, std::string_view key) {
  const toml::node* const node = s.find(key);
  if (!node) return nullptr;
  if (!node->is_array_of_tables() && !(node->is_array() && node->as_array()->empty()))
    s.fail(key,
           fmt::format("{}: is a list of tables, each written as [[correction.{}]]", key, key));
  return node->as_array();
}

class CorrectionReader {
 public:
  CorrectionReader(ModelTables& tables, CorrectionFile& file)
      : tables_(tables), notes_(file.notes) {}

  Model model(const Section& s) {
    s.allow_only({"name", "displacement", "tolerance_um", "measurement_std_um", "initial_state",
                  "sampling_s", "offset_um", "channel", "kinematic", "effect", "range", "together",
                  "covariance", "residual"});
    Model m;
    m.displacement = displacement(s);
    m.name = s.text("name").value_or(std::string(m.displacement->variable));
    if (const auto t = s.number({"tolerance_um", "um", 0, 1e6})) {
      if (*t == 0.0) s.fail("tolerance_um", "tolerance_um = 0 um: must be above 0");
      m.tolerance = *t * um;
    }
    if (const auto std = s.number({"measurement_std_um", "um", 0, 1e6})) m.measured_std = *std * um;
    m.initial_state = tables_.choice_or(s, "initial_state", {"rest", "free"}, "rest") == "free"
                          ? correction::InitialState::free
                          : correction::InitialState::rest;
    if (const auto dt = s.number({"sampling_s", "s", 1e-6, 1e6})) m.sampling = *dt;
    m.offset = tables_.number_or(s, {"offset_um", "um", -1e6, 1e6}, 0.0) * um;
    if (const toml::array* const list = list_of_tables(s, "channel"))
      for (const toml::node& node : *list)
        m.channels.push_back(channel(part_of(s, "correction.channel", node), m));
    if (s.find("kinematic"))
      m.kinematic = kinematic(part_of(s, "correction.kinematic", *s.find("kinematic")));
    if (const toml::array* const list = list_of_tables(s, "effect"))
      for (const toml::node& node : *list)
        m.effects.push_back(effect(part_of(s, "correction.effect", node), m));
    if (const toml::node* const range = s.find("range"))
      read_range(part_of(s, "correction.range", *range), m);
    read_trust(s, m, notes_);
    return m;
  }

 private:
  const Channel* displacement(const Section& s) const {
    const auto name = s.text("displacement");
    if (!name)
      s.fail_missing({"displacement", "", 0, 0},
                     ", the column that is modelled, such as \"displacement_z_um\"");
    const Channel* const c = record::series_channel(*name);
    if (!c || c->role != record::Role::measured)
      s.fail("displacement",
             fmt::format("displacement = \"{}\": must be a column displacement_NAME_um", *name));
    return c;
  }

  const Channel* input_column(const Section& s, std::string_view key,
                              const std::string& name) const {
    const Channel* const c = record::series_channel(name);
    if (!c || !c->is_input())
      s.fail(key, fmt::format("{} = \"{}\": must be power_W, speed_rpm, coolant_on, or a column "
                              "NAME_temperature_C, NAME_feed_m_min or NAME_speed_rpm",
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
                              shown(*node)));
    for (const toml::node& one : *node->as_array()) {
      if (!one.is_string())
        s.fail(key, fmt::format("{} = {}: must be columns in quotes", key, shown(*node)));
      list.push_back(input_column(s, key, *one.value<std::string>()));
      if (list.back()->key_unit() != list.front()->key_unit())
        s.fail(key, fmt::format("{}: the mean of {} and {} has no unit", key, list.front()->name,
                                list.back()->name));
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
               "input = \"power_W\": needs friction_table, a CSV with speed_rpm, axial_load_N, "
               "temperature_C and friction_torque_Nmm, as raceway table writes it");
      in.table = std::make_shared<const correction::FrictionTable>(table(s, *file));
      in.axial_load = s.number({"axial_load_N", "N", -1e8, 1e8}).value_or(0.0);
      read_temperature(s, in);
    } else {
      if (!s.find("input"))
        s.fail_missing({"input", "", 0, 0}, ", the column that drives the channel");
      in.columns = columns(s, "input");
      in.name = in.columns.front()->name;
      for (const std::string_view key : {"friction_table", "axial_load_N", "temperature_C"})
        if (s.find(key)) s.fail(key, fmt::format("{}: belongs to input = \"power_W\"", key));
    }
    in.exponent = s.number({"exponent", "1", 0.5, 3.0}).value_or(1.0);
    if (s.find("exponent") && in.unit() != "rpm")
      s.fail("exponent", "exponent: belongs to an input that is a speed");
    if (const auto name = s.text("reference")) {
      in.reference = input_column(s, "reference", *name);
      if (in.is_power() || !record::is_temperature(*in.reference) ||
          !record::is_temperature(*in.columns.front()))
        s.fail("reference", "reference: is a temperature, of an input that is one");
    }
    return in;
  }

  correction::FrictionTable table(const Section& s, const std::string& file) const {
    try {
      NamedFiles& files = tables_.files();
      correction::FrictionTable read =
          parse_friction_table(files.read(file).text, files.shown(file));
      read.file = file;
      return read;
    } catch (const InputError& e) {
      throw InputError(fmt::format("{}: friction_table = \"{}\": {}",
                                   s.place(s.find("friction_table")), file, e.what()),
                       s.at("friction_table"));
    }
  }

  void read_temperature(const Section& s, Input& in) {
    const toml::node* const node = s.find("temperature_C");
    if (node && node->is_string()) {
      in.temperature_column = input_column(s, "temperature_C", *node->value<std::string>());
      if (!record::is_temperature(*in.temperature_column))
        s.fail("temperature_C", "temperature_C: must be a number, or a column NAME_temperature_C");
    } else if (const auto value = s.number({"temperature_C", "C", -273, 500})) {
      in.temperature = kelvin(*value);
    } else if (in.table->temperature.size() > 1) {
      s.fail_missing({"temperature_C", "C", -273, 500},
                     ", at which the friction table is read (a number or a column)");
    } else {
      in.temperature = in.table->temperature.front();
    }
  }

  DrivenChannel channel(const Section& s, const Model& m) {
    DrivenChannel c;
    c.input = input(s);
    const std::string unit(c.input.key_unit());
    const std::string gain = "gain_um_" + unit, feedthrough = "feedthrough_um_" + unit;
    s.allow_only({"name", "input", "reference", "exponent", "friction_table", "axial_load_N",
                  "temperature_C", "sections", feedthrough, "scale", "gain", "time_constant",
                  "numerator", "denominator"});
    c.name = s.text("name").value_or(
        std::string(c.input.is_power() ? "power" : c.input.columns.front()->variable));
    for (const DrivenChannel& other : m.channels)
      if (other.name == c.name)
        s.fail("name", fmt::format("name = \"{}\": two channels have it", c.name));
    if (c.name.find_first_of(".:\" ") != c.name.npos)
      s.fail("name", fmt::format("name = \"{}\": must have no blank, dot, colon or quote", c.name));
    const double factor = um / c.input.factor();
    c.feedthrough =
        s.number({feedthrough, "um/" + std::string(c.input.unit()), -most, most}).value_or(0.0) *
        factor;
    c.scale = s.number({"scale", "1", -1e6, 1e6}).value_or(1.0);
    const int ways = (s.find("sections") ? 1 : 0) +
                     (s.find("gain") || s.find("time_constant") ? 1 : 0) +
                     (s.find("numerator") || s.find("denominator") ? 1 : 0);
    if (ways > 1)
      s.fail(
          "name",
          fmt::format(
              "channel {}: has more than one of sections, gain with time_constant, and numerator "
              "with denominator",
              c.name));
    if (s.find("sections")) read_sections(s, gain, factor, c);
    if (s.find("gain") || s.find("time_constant")) read_element(s, c);
    if (s.find("numerator") || s.find("denominator")) read_printed(s, m, c);
    if (ways == 0 && c.feedthrough == 0.0 && !s.find(feedthrough))
      s.fail("name",
             fmt::format(
                 "channel {}: has no sections: sections = [{{ {} = 5, time_constant_s = 3600 }}]",
                 c.name, gain));
    return c;
  }

  void read_sections(const Section& s, const std::string& gain, double factor, DrivenChannel& c) {
    const toml::node& node = *s.find("sections");
    if (!node.is_array())
      s.fail("sections",
             fmt::format("sections = {}: must be a list, as [{{ {} = 5, time_constant_s = 3600 }}]",
                         shown(node), gain));
    for (const toml::node& one : *node.as_array()) {
      const Section of = part_of(s, "sections", one);
      of.allow_only({gain, "time_constant_s"});
      c.sections.push_back(
          {of.required({gain, "um/" + std::string(c.input.unit()), -most, most}) * factor,
           of.required({"time_constant_s", "s", 1e-3, most})});
    }
  }

  correction::Characteristic characteristic(const Section& s, const std::string& key,
                                            const std::string& unit_key, double unit) const {
    const toml::node* const node = s.find(key);
    if (!node)
      s.fail("name", fmt::format("gain and time_constant stand together: {} is missing", key));
    const Section of = part_of(s, key, *node);
    const std::string slope = fmt::format("slope_{}_W", unit_key), offset = "offset_" + unit_key;
    of.allow_only({slope, offset, "factor", "exponent", "table"});
    if (of.find("table")) {
      const auto file = of.text("table");
      try {
        NamedFiles& files = tables_.files();
        return correction::Characteristic(
            parse_characteristic(files.read(*file).text, files.shown(*file), key));
      } catch (const std::exception& e) {
        of.fail("table", fmt::format("table = \"{}\": {}", *file, e.what()));
      }
    }
    if (of.find("factor") || of.find("exponent"))
      return correction::Characteristic(
          correction::Characteristic::Power{of.required({"factor", unit_key, -most, most}) * unit,
                                            of.required({"exponent", "1", -10, 10})});
    return correction::Characteristic(
        correction::Characteristic::Line{of.required({slope, unit_key + "/W", -most, most}) * unit,
                                         of.required({offset, unit_key, -most, most}) * unit});
  }

  void read_element(const Section& s, DrivenChannel& c) {
    if (!c.input.is_power())
      s.fail("gain", "gain and time_constant that go with the power need input = \"power_W\"");
    constexpr double minute = 60.0;
    c.element = correction::DelayElement{characteristic(s, "gain", "um", um),
                                         characteristic(s, "time_constant", "min", minute)};
    notes_.push_back(
        fmt::format("channel {}: at a power of 0 its gain is 0, with the time constant of that "
                    "power: the paper "
                    "that it comes from is silent about standstill",
                    c.name));
  }

  std::vector<double> coefficients(const Section& s, std::string_view key) const {
    const toml::node* const node = s.find(key);
    if (!node)
      s.fail("name", fmt::format("numerator and denominator stand together: {} is missing", key));
    std::vector<double> list;
    const toml::array* const array = node->as_array();
    if (!array || array->empty())
      s.fail(key, fmt::format("{} = {}: must be a list of numbers", key, shown(*node)));
    for (const toml::node& one : *array) {
      const auto value = one.value<double>();
      if (!value || !std::isfinite(*value))
        s.fail(key, fmt::format("{} = {}: must be a list of numbers", key, shown(*node)));
      list.push_back(*value);
    }
    return list;
  }

  void read_printed(const Section& s, const Model& m, DrivenChannel& c) {
    if (std::isnan(m.sampling))
      s.fail(
          "numerator",
          "numerator: coefficients hold for one sampling time: [correction] sampling_s is missing");
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
    s.allow_only({"A", "B", "C"});
    return {s.required({"A", "um", -most, most}), s.required({"B", "1", -1, 2}),
            s.required({"C", "1/rpm", 0, 1})};
  }

  Effect effect(const Section& s, const Model& m) {
    const auto id = s.text("id");
    Names known;
    for (const correction::EffectCard& card : correction::catalogue()) known.emplace_back(card.id);
    if (!id) s.fail_missing({"id", "", 0, 0}, ", the name of an effect of raceway effects");
    const correction::EffectKind* const found = correction::find_kind(*id);
    if (s.find("formula")) {
      if (found)
        s.fail(
            "formula",
            fmt::format("formula: {} is an effect of the catalogue; give yours another id", *id));
      return own_effect(s, *id, m);
    }
    if (!found || found->card().evidence)
      s.fail("id", fmt::format("id = \"{}\": no effect on a displacement over time{}; one of your "
                               "own has a formula",
                               *id, suggestion(*id, known)));
    Effect e{.id = *id};
    e.columns = columns(s, "input");
    e.where = s.text("channel").value_or(s.text("axis").value_or(""));
    if (s.find("channel") && !correction::find_channel(m, e.where))
      s.fail("channel", fmt::format("channel = \"{}\": the model has no such channel", e.where));
    if (found->card().needs_input && e.columns.empty())
      s.fail_missing({"input", "", 0, 0}, ", the column that drives the effect");
    Names keys{"id", "input", "channel", "axis"};
    const std::span<const record::NumberCard> numbers = found->numbers(e);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const std::string key = found->key(e, k, m);
      if (found->may_end_before(k) && !s.find(key)) break;
      keys.push_back(key);
      e.values.push_back(
          s.required({key, correction::unit_of(e, k, m), std::max(-most, numbers[k].lower),
                      std::min(most, numbers[k].upper)}));
    }
    s.allow_only(keys);
    return e;
  }

  /// A formula of columns, with a gain, and a time constant where it lags.
  Effect own_effect(const Section& s, const std::string& id, const Model& m) const {
    if (id.empty() || id.find_first_of(" .:\t\n,;\"'") != id.npos ||
        std::string_view("=+-@").find(id.front()) != std::string_view::npos)
      s.fail("id", fmt::format("id = {}: must be a name without blanks, dots, colons, commas, "
                               "semicolons and quotes, and not begin with =, +, - or @",
                               io::quoted(id)));
    for (const Effect& before : m.effects)
      if (before.id == id) s.fail("id", fmt::format("id = \"{}\": two effects have it", id));
    correction::OwnEffect::Given given{.id = id,
                                       .title = s.text("title").value_or(""),
                                       .formula = s.text("formula").value_or(""),
                                       .lags = s.find("time_constant_s") != nullptr};
    const Names keys{"id", "title", "formula", "gain_um", "time_constant_s"};
    for (const auto& [key, node] : *s.table()) {
      const std::string name(key.str());
      if (std::find(keys.begin(), keys.end(), name) != keys.end()) continue;
      if (correction::column_of_formula(name))
        s.fail(name, fmt::format("{}: a column has this name; take another", name));
      const FormulaNumber n = read_formula_number(s, id, name, node, keys);
      given.parameters.push_back({n.name, n.unit, n.value, n.lower, n.upper, n.in_braces});
    }
    Effect e{.id = id};
    e.values.push_back(s.required({"gain_um", "um", -most, most}));
    if (given.lags) e.values.push_back(s.required({"time_constant_s", "s", 1.0, 1e7}));
    Names known{"speed_rpm",      "NAME_temperature_C", "NAME_feed_m_min",
                "NAME_speed_rpm", "coolant_on",         "time_s"};
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
      s.fail("formula", fmt::format("formula = \"{}\": has no column of a record in it, such as "
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
        s.fail(name, fmt::format("{} = {}: must be [lowest, highest]", name, shown(node)));
      const double low = *pair->get(0)->value<double>(), high = *pair->get(1)->value<double>();
      if (!(low <= high))
        s.fail(name, fmt::format("{} = {}: the lowest is above the highest", name, shown(node)));
      if (name.ends_with(of_power)) {
        const std::string channel = name.substr(0, name.size() - of_power.size());
        const DrivenChannel* const c = correction::find_channel(m, channel);
        if (channel.empty() || !c || !c->input.is_power())
          s.fail(name, fmt::format("{}: the model has no channel {} that the power drives", name,
                                   channel));
        m.range.push_back({.name = channel, .lower = low, .upper = high});
        continue;
      }
      const Channel* const c = input_column(s, name, name);
      m.range.push_back(
          {.column = c, .name = name, .lower = c->to_SI(low), .upper = c->to_SI(high)});
    }
  }

  ModelTables& tables_;
  std::vector<std::string>& notes_;
};

void check_tables(const ModelTables& tables) {
  const Names known{"correction", "calibration", "loop",          "columns", "bearing",
                    "lubricant",  "friction",    "arrangement",   "rig",     "solver",
                    "material",   "effect",      "torque_sensor", "export"};
  for (const auto& [key, node] : tables.root())
    if (std::find(known.begin(), known.end(), key.str()) == known.end())
      throw InputError(fmt::format("{}: {}: unknown table{}", tables.place(key), key.str(),
                                   suggestion(key.str(), known)),
                       tables.at(key));
}

Names read_free(const ModelTables& tables, const Model& model) {
  const Section s = tables.section("calibration");
  const toml::node* const node = s.find("free");
  Names free;
  if (!node) return free;
  if (!node->is_array()) s.fail("free", "free: must be a list of names or groups");
  for (const toml::node& one : *node->as_array()) {
    if (!one.is_string()) s.fail("free", "free: must be names in quotes");
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
  const Section s = tables.section("loop");
  const auto value = s.number({"tolerance_um", "um", 0, 1e6});
  if (!value) return;
  if (!std::isnan(model.tolerance))
    s.fail("tolerance_um", "tolerance_um: stands under [correction] as well; keep one of them");
  model.tolerance = *value * um;
}

}  // namespace

CorrectionFile parse_correction(std::string text, const std::string& source,
                                std::vector<NamedFile> held) {
  ModelTables tables(text, source, std::move(held));
  check_tables(tables);
  CorrectionFile file;
  file.source = source;
  CorrectionReader reader(tables, file);
  const toml::node* const node = tables.root().get("correction");
  if (!node)
    throw InputError(fmt::format("{}: table [correction] is missing", source),
                     {.file = source, .key = "correction"});
  const Section root(source, "correction", node->as_table());
  if (node->is_array_of_tables()) {
    for (const toml::node& one : *node->as_array())
      file.models.push_back(reader.model(Section(source, "correction", one.as_table())));
  } else if (node->is_table()) {
    file.models.push_back(reader.model(root));
  } else {
    throw InputError(
        fmt::format("{}: correction = {}: must be a table, [correction]", source, shown(*node)),
        {.file = source, .key = "correction"});
  }
  for (std::size_t k = 0; k < file.models.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j)
      if (file.models[j].displacement == file.models[k].displacement)
        throw InputError(fmt::format("{}: two tables [[correction]] model {}", source,
                                     file.models[k].displacement->name),
                         {.file = source, .key = "displacement"});
    file.models[k].free = read_free(tables, file.models[k]);
    read_tolerance(tables, file.models[k]);
  }
  file.columns = read_columns(tables);
  file.control = read_export(tables, file.models);
  file.defaults = tables.defaults();
  file.files = tables.files().list();
  file.text = std::move(text);
  return file;
}

CorrectionFile read_correction(const std::string& path) {
  bool marked = false;
  std::string text = read_text(path, &marked);
  CorrectionFile file = parse_correction(std::move(text), input_name(path));
  if (marked) file.text.insert(0, utf8_mark);
  return file;
}

}  // namespace raceway::io
