#include "io/model_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

#include "bearing/units.h"
#include "effects/catalogue.h"
#include "effects/formula.h"
#include "io/catalogue_defaults.h"
#include "io/error.h"
#include "io/input_file.h"
#include "io/names.h"
#include "io/shaft_section.h"

// Last: see io/toml_text.h.
#include "io/model_section.h"

namespace raceway::io {
namespace {

using bearing::Material;

// Wherever the libraries check as well, these are their ranges.
constexpr Key ball_count{"ball_count", "", 3, 200};
constexpr Key ball_diameter{"ball_diameter_mm", "mm", 0.1, 300};
constexpr Key pitch_diameter{"pitch_diameter_mm", "mm", 1, 5000};
constexpr Key contact_angle{"contact_angle_deg", "deg", 0, 65};
constexpr Key inner_conformity{"inner_conformity", "", 0.5005, 0.7};
constexpr Key outer_conformity{"outer_conformity", "", 0.5005, 0.7};
constexpr Key static_load_rating{"static_load_rating_N", "N", 1, 1e9};
constexpr Key bore{"bore_mm", "mm", 0, 5000};
constexpr Key outer_diameter{"outer_diameter_mm", "mm", 1, 10000};
constexpr Key radial_clearance{"radial_clearance_um", "um", 0, 10000};
constexpr Key viscosity_40C{"viscosity_40C_mm2_s", "mm2/s", 1, 1e5};
constexpr Key viscosity_100C{"viscosity_100C_mm2_s", "mm2/s", 0.5, 1e5};
constexpr Key inertia{"inertia_kgm2", "kg m2", 1e-9, 1e6};
constexpr Key bearings{"bearings", "", 1, 100};
constexpr Key axial_load{"axial_load_N", "N", 0, 1e8};
constexpr Key radial_load{"radial_load_N", "N", 0, 1e8};
constexpr Key temperature{"temperature_C", "C", -273, 500};
constexpr Key minimum_speed{"minimum_speed_rpm", "rpm", 0, 1e6};
constexpr Key elastic_modulus{"elastic_modulus_GPa", "GPa", 1, 1200};
constexpr Key poisson_ratio{"poisson_ratio", "", 0, 0.49};
constexpr Key density{"density_kg_m3", "kg/m3", 500, 20000};
constexpr Key thermal_expansion{"thermal_expansion_1e6_K", "1e-6/K", 0, 50};

class Reader {
 public:
  Reader(std::string text, const std::string& source)
      : root_(parse_toml(text, source)), text_(std::move(text)), source_(source) {}

  ModelFile read() {
    check_tables();
    read_materials();
    NamedBearing bearing =
        read_bearing(required_section("bearing", "its geometry, or catalogue = \"NAME\""), nullptr);
    from_catalogue_ = bearing.row.has_value();
    friction::Lubricant lubricant = read_lubricant();
    read_friction();
    require_data(bearing.bearing, section("bearing"));
    std::optional<fit::Shaft> shaft = read_arrangement(bearing);
    read_effects(shaft ? &*shaft : nullptr);
    const auto solver = read_solver();
    const fit::Rig rig = read_rig();
    fit::Model model{
        .name = bearing.name,
        .bearing = shaft ? *shaft->arrangement.bearings()[0].bearing : std::move(bearing.bearing),
        .lubricant = lubricant,
        .law = law_,
        .law_values = std::move(law_values_),
        .effects = std::move(effects_),
        .solver = solver,
        .rig = rig,
        .free = {},
        .shaft = std::move(shaft)};
    model.free = read_calibration(model);
    return {.model = std::move(model),
            .source = source_,
            .text = std::move(text_),
            .catalogue = bearing.row ? bearing.row->full_name() : std::string(),
            .defaults = std::move(defaults_)};
  }

 private:
  void check_tables() const {
    const Names known{"bearing", "lubricant", "friction",    "arrangement", "rig",
                      "solver",  "material",  "calibration", "effect"};
    for (const auto& [key, node] : root_) {
      const std::string name(key.str());
      const std::string place = fmt::format("{}:{}", source_, key.source().begin.line);
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        if (!node.is_table() && !node.is_array_of_tables())
          throw InputError(
              fmt::format("{}: {} = {}: stands outside any table; put it below [bearing] or the "
                          "table it belongs "
                          "to",
                          place, name, shown(node)));
        const std::string near = suggestion(name, known);
        throw InputError(fmt::format("{}: [{}]: unknown table{}", place, name,
                                     near.empty() ? "; a model has " + listed(known) : near));
      }
      if (name == "effect") {
        const bool tables =
            node.is_array() && (node.as_array()->empty() || node.is_array_of_tables());
        if (!tables)
          throw InputError(place + ": effects are written as [[effect]] with two brackets");
      } else if (!node.is_table()) {
        throw InputError(fmt::format("{}: {} = {}: must be a table, written as [{}]", place, name,
                                     shown(node), name));
      }
    }
  }

  [[nodiscard]] Section section(std::string_view name) const {
    return Section(source_, std::string(name), root_[name].as_table());
  }
  [[nodiscard]] Section required_section(std::string_view name, std::string_view holds) const {
    Section result = section(name);
    if (!result.given())
      throw InputError(fmt::format("{}: table [{}] is missing; it holds {}", source_, name, holds));
    return result;
  }
  void note_default(std::string_view table, std::string_view key, const std::string& value,
                    std::string_view why = "default") {
    defaults_.push_back(fmt::format("{}.{} = {} ({})", table, key, value, why));
  }
  double number_or(const Section& s, const Key& key, double fallback,
                   std::string_view why = "default") {
    if (const auto value = s.number(key)) return *value;
    note_default(s.name(), key.name, fmt::format("{:.10g}", fallback), why);
    return fallback;
  }
  std::string choice_or(const Section& s, std::string_view key, const Names& allowed,
                        const std::string& fallback) {
    if (auto value = s.choice(key, allowed)) return *value;
    note_default(s.name(), key, fmt::format("\"{}\"", fallback));
    return fallback;
  }

  void read_materials() {
    materials_ = {bearing::steel(), bearing::silicon_nitride()};
    const toml::table* const table = root_["material"].as_table();
    if (!table) return;
    for (const auto& [key, node] : *table) {
      const std::string name(key.str());
      const std::string place = fmt::format("{}:{}", source_, key.source().begin.line);
      if (!node.is_table())
        throw InputError(
            fmt::format("{}: {} = {}: materials are tables, written as [material.NAME]", place,
                        name, shown(node)));
      if (find_material(name))
        throw InputError(
            fmt::format("{}: [material.{}]: this name is built in; take another", place, name));
      const Section s(source_, "material." + name, node.as_table());
      const Names known{"elastic_modulus_GPa", "poisson_ratio", "density_kg_m3",
                        "thermal_expansion_1e6_K"};
      s.allow_only(known);
      const Material material{.name = name,
                              .elastic_modulus = s.required(elastic_modulus) * GPa,
                              .poisson_ratio = s.required(poisson_ratio),
                              .density = s.required(density),
                              .thermal_expansion = s.required(thermal_expansion) * per_million_K};
      try {
        bearing::validate(material);
      } catch (const std::invalid_argument& error) {
        s.fail(error, known);
      }
      materials_.push_back(material);
    }
  }

  [[nodiscard]] const Material* find_material(std::string_view name) const {
    for (const Material& material : materials_)
      if (material.name == name) return &material;
    return nullptr;
  }

  /// A table of a bearing; where there is a `base`, the keys that are left out are its own.
  NamedBearing read_bearing(const Section& s, const NamedBearing* base, const Names& further = {}) {
    Names known{"name",
                "catalogue",
                "ball_count",
                "ball_diameter_mm",
                "pitch_diameter_mm",
                "contact_angle_deg",
                "inner_conformity",
                "outer_conformity",
                "static_load_rating_N",
                "ball_material",
                "ring_material",
                "bore_mm",
                "outer_diameter_mm",
                "radial_clearance_um"};
    known.insert(known.end(), further.begin(), further.end());
    s.allow_only(known);
    std::string bearing_name;
    std::optional<CatalogueBearing> row;
    bearing::BearingGeometry g;
    if (base) {
      g = base->bearing.geometry();
      row = base->row;
      bearing_name = base->name;
    }
    const auto catalogue = s.text("catalogue");
    if (catalogue) {
      const auto rows = read_catalogues();
      try {
        row = find_bearing(rows, *catalogue);
      } catch (const InputError& error) {
        s.fail("catalogue", error.what());
      }
      g = row->geometry;
      bearing_name = row->full_name();
      // Makers rate bearings with ceramic balls lower.
      const auto balls = s.text("ball_material");
      if ((balls  ? *balls
           : base ? base->bearing.balls().name
                  : "") == "silicon-nitride" &&
          !std::isnan(row->static_load_rating_silicon_nitride))
        g.static_load_rating = row->static_load_rating_silicon_nitride;
    }
    const auto take = [&](const Key& key, double unit, double& value) {
      if (const auto given = s.number(key))
        value = *given * unit;
      else if (std::isnan(value))
        s.fail_missing(key);
    };
    if (const auto balls = s.whole_number(ball_count))
      g.ball_count = *balls;
    else if (g.ball_count == 0)
      s.fail_missing(ball_count);
    take(ball_diameter, mm, g.ball_diameter);
    take(pitch_diameter, mm, g.pitch_diameter);
    take(contact_angle, degree, g.contact_angle);
    for (const Key& key : {inner_conformity, outer_conformity})
      if (catalogue && !s.find(key.name))
        note_default(s.name(), key.name, fmt::format("{}", g.inner_conformity));
    take(inner_conformity, 1.0, g.inner_conformity);
    take(outer_conformity, 1.0, g.outer_conformity);
    if (const auto given = s.number(static_load_rating)) g.static_load_rating = *given;
    if (const auto given = s.number(radial_clearance)) g.radial_clearance = *given * um;
    // A bore from the catalogue is no more that of a bearing with another pitch circle.
    if (s.find(ball_diameter.name) || s.find(pitch_diameter.name))
      g.bore = g.outer_diameter = unset;
    if (const auto given = s.number(bore)) g.bore = *given * mm;
    if (const auto given = s.number(outer_diameter)) g.outer_diameter = *given * mm;
    const bool no_bore = std::isnan(g.bore), no_outer_diameter = std::isnan(g.outer_diameter);
    try {
      g = bearing::validated(g);
    } catch (const std::invalid_argument& error) {
      s.fail(error, known);
    }
    if (no_bore)
      note_default(s.name(), "bore_mm", fmt::format("{:.6g}", g.bore / mm),
                   "default: pitch diameter - 1.5 ball diameters");
    if (no_outer_diameter)
      note_default(s.name(), "outer_diameter_mm", fmt::format("{:.6g}", g.outer_diameter / mm),
                   "default: pitch diameter + 1.5 ball diameters");

    Names materials;
    for (const Material& material : materials_) materials.push_back(material.name);
    const auto material = [&](const char* key, const Material* inherited) {
      if (inherited && !s.find(key)) return *inherited;
      return *find_material(choice_or(s, key, materials, "steel"));
    };
    const Material balls = material("ball_material", base ? &base->bearing.balls() : nullptr);
    const Material rings = material("ring_material", base ? &base->bearing.rings() : nullptr);
    if (auto given = s.text("name")) bearing_name = *given;
    if (bearing_name.empty()) {
      bearing_name = std::filesystem::path(source_).stem().string();
      note_default("bearing", "name", fmt::format("\"{}\"", bearing_name));
    }
    return {bearing::Bearing(g, balls, rings), bearing_name, row};
  }

  [[nodiscard]] friction::Lubricant read_lubricant() const {
    const Section s = required_section("lubricant", "viscosity_40C_mm2_s and viscosity_100C_mm2_s");
    const Names known{"viscosity_40C_mm2_s", "viscosity_100C_mm2_s"};
    s.allow_only(known);
    try {
      return {s.required(viscosity_40C) * mm2_per_s, s.required(viscosity_100C) * mm2_per_s};
    } catch (const std::invalid_argument& error) {
      // "viscosity_40C" and "viscosity_100C" are the libraries' names of the two keys.
      s.fail(error, known);
    }
  }

  void read_friction() {
    const Section s = from_catalogue_
                          ? section("friction")
                          : required_section("friction", "the base law and its factors");
    using friction::FrictionLaw;
    const Names laws{std::string(friction::name(FrictionLaw::palmgren)),
                     std::string(friction::name(FrictionLaw::skf))};
    law_ = choice_or(s, "law", laws, laws[0]) == laws[0] ? FrictionLaw::palmgren : FrictionLaw::skf;
    Names known{"law"};
    for (const friction::Parameter& p : friction::parameters(law_)) known.emplace_back(p.name);
    const FrictionLaw other =
        law_ == FrictionLaw::palmgren ? FrictionLaw::skf : FrictionLaw::palmgren;
    for (const friction::Parameter& p : friction::parameters(other))
      if (const toml::node* const node = s.find(p.name))
        s.fail(p.name,
               fmt::format("{} = {}: belongs to law = \"{}\", but the law is \"{}\"", p.name,
                           shown(*node), friction::name(other), friction::name(law_)));
    s.allow_only(known);
    for (const friction::Parameter& p : friction::parameters(law_)) {
      const Key key{p.name, p.unit == "1" ? "" : p.unit, p.lower, p.upper};
      // The factors of the SKF law are published constants; those of Palmgren depend on the
      // bearing, and only a catalogue's user may leave them out.
      if (law_ == FrictionLaw::palmgren && !from_catalogue_) {
        law_values_.push_back(s.required(key));
        continue;
      }
      const double fallback = p.name == "f0"  ? catalogue_f0
                              : p.name == "z" ? catalogue_z
                              : p.name == "y" ? catalogue_y
                                              : p.initial;
      law_values_.push_back(number_or(s, key, fallback));
    }
  }

  /// Reads [arrangement], where there is one.
  std::optional<fit::Shaft> read_arrangement(const NamedBearing& base) {
    const Section s = section("arrangement");
    if (!s.given()) return std::nullopt;
    const ShaftContext context{
        .base = base,
        .read_bearing =
            [&](const Section& table, const Names& further) {
              NamedBearing one = read_bearing(table, &base, further);
              require_data(one.bearing, table);
              return one;
            },
        .note_default = [&](std::string_view key,
                            const std::string& value) { note_default("arrangement", key, value); }};
    return read_shaft(s, context);
  }

  void require_data(const bearing::Bearing& bearing, const Section& s) const {
    if (law_ == friction::FrictionLaw::palmgren &&
        std::isnan(bearing.geometry().static_load_rating))
      s.fail_missing(static_load_rating, ", which the friction law palmgren needs");
    try {
      friction::require_data(law_, bearing);
    } catch (const std::invalid_argument& error) {
      s.fail(error, {"static_load_rating_N", "contact_angle_deg"});
    }
  }

  void read_effects(const fit::Shaft* shaft) {
    const effects::Subject subject = shaft ? effects::Subject::shaft : effects::Subject::bearing;
    const toml::array* const list = root_["effect"].as_array();
    if (!list) return;
    Names ids;
    for (const effects::Description& d : effects::catalogue(subject))
      if (d.belongs_to(subject)) ids.emplace_back(d.id);
    for (const toml::node& node : *list) {
      const Section s(source_, "effect", node.as_table());
      const auto id = s.text("id");
      if (!id)
        throw InputError(
            fmt::format("{}: [[effect]] has no id; the catalogue has {}", s.place(), listed(ids)));
      const effects::Description* const found = effects::find(*id, subject);
      if (found && !found->belongs_to(subject))
        s.fail("id", fmt::format("id = \"{}\": acts {}", *id,
                                 subject == effects::Subject::shaft
                                     ? "on a bearing on a rig, but this model is of a shaft, with "
                                       "an [arrangement]"
                                     : "on the displacement of a shaft, but this model has no "
                                       "[arrangement]"));
      if (!found && !s.find("torque_Nmm")) {
        const std::string near = suggestion(*id, ids);
        s.fail("id", fmt::format(
                         "id = \"{}\": unknown effect{}; one of your own has a formula, torque_Nmm",
                         *id, near.empty() ? "; the catalogue has " + listed(ids) : near));
      }
      if (found && shaft && shaft->arrangement.design().rear.empty())
        for (const effects::Need need : found->needs)
          if (need == effects::Need::opposed_sets)
            s.fail("id", fmt::format("id = \"{}\": needs {}", *id, effects::text(need)));
      for (const effects::Effect& before : effects_)
        if (before.description->id == *id)
          s.fail("id", fmt::format("id = \"{}\": this effect is listed twice", *id));
      effects_.push_back(found ? read_effect(s, *found) : read_user_made(s, *id));
    }
  }

  effects::Effect read_effect(const Section& s, const effects::Description& description) {
    // A text is a formula; a number is the parameter that torque-offset calls so.
    if (const toml::node* const formula = s.find("torque_Nmm"); formula && formula->is_string())
      s.fail("torque_Nmm",
             fmt::format("torque_Nmm: {} is an effect of the catalogue; give yours another id",
                         description.id));
    Names known{"id"};
    for (const effects::Parameter& p : description.parameters) known.emplace_back(p.name);
    s.allow_only(known);
    effects::Effect effect;
    effect.description = &description;
    for (const effects::Parameter& p : description.parameters) {
      const Key key{p.name, p.unit == "1" ? "" : p.unit, p.lower, p.upper};
      if (const auto value = s.number(key)) {
        effect.values.push_back(*value);
      } else {
        effect.values.push_back(p.initial);
        note_default(fmt::format("effect[{}]", effects_.size()), p.name,
                     fmt::format("{:.10g}", p.initial),
                     fmt::format("default of {}", description.id));
      }
    }
    return effect;
  }

  /// An effect of the user's own: a formula and its parameters,
  /// `c = { value = 0.0, unit = "N mm", lower = 0.0 }` or short `c = 0.0`.
  [[nodiscard]] effects::Effect read_user_made(const Section& s, const std::string& id) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    effects::UserMadeEffect effect{.id = id,
                                   .title = s.text("title").value_or(""),
                                   .torque_Nmm = *s.text("torque_Nmm"),
                                   .parameters = {}};
    if (id.empty() || id.find_first_of(" .\t\n") != id.npos)
      s.fail("id", fmt::format("id = \"{}\": must be a name without blanks and dots", id));
    for (const auto& [key, node] : *s.table()) {
      const std::string name(key.str());
      if (name == "id" || name == "title" || name == "torque_Nmm") continue;
      const auto is = [&](const effects::Formula::Variable& v) { return v.name == name; };
      const auto variables = effects::Formula::variables();
      if (std::any_of(variables.begin(), variables.end(), is))
        s.fail(name, fmt::format("{}: a variable has this name; take another", name));
      if (!valid_name(name))
        s.fail(name, fmt::format("{}: must be letters, digits and _, not a digit first", name));
      effects::UserMadeEffect::Number number{.name = name, .unit = "1"};
      const Key any{name, "", -infinity, infinity};
      if (!node.is_table()) {
        number.value = *s.number(any);
      } else {
        const Section t(source_, fmt::format("effect {}, {}", id, name), node.as_table());
        t.allow_only({"value", "unit", "lower", "upper"});
        number.unit = t.text("unit").value_or("1");
        if (const auto lower = t.number({"lower", number.unit, -infinity, infinity}))
          number.lower = *lower;
        if (const auto upper = t.number({"upper", number.unit, -infinity, infinity}))
          number.upper = *upper;
        const double from = std::isnan(number.lower) ? -infinity : number.lower;
        const double to = std::isnan(number.upper) ? infinity : number.upper;
        if (!(from < to))
          t.fail("upper", fmt::format("{}: upper = {} must be above lower = {}", name, to, from));
        number.value = t.required({"value", number.unit, from, to});
      }
      effect.parameters.push_back(std::move(number));
    }
    try {
      return effects::make_effect(effect);
    } catch (const effects::FormulaError& error) {
      wrong_formula(s, effect, error);
    }
  }

  /// A name that muParser takes for a variable.
  [[nodiscard]] static bool valid_name(std::string_view name) {
    const auto letter = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    return !name.empty() && letter(name[0]) && std::all_of(name.begin(), name.end(), [&](char c) {
      return letter(c) || (c >= '0' && c <= '9');
    });
  }

  /// File, line and column of what is wrong, and the formula with a mark under it.
  [[noreturn]] void wrong_formula(const Section& s, const effects::UserMadeEffect& effect,
                                  const effects::FormulaError& error) const {
    std::string hint;
    if (!error.unknown_name.empty()) {
      Names known;
      for (const auto& v : effects::Formula::variables()) known.emplace_back(v.name);
      for (const auto& p : effect.parameters) known.push_back(p.name);
      hint = suggestion(error.unknown_name, known);
      if (hint.empty()) hint = "; a formula knows " + listed(known);
    }
    const toml::source_position at = s.find("torque_Nmm")->source().begin;
    // Exact for a formula in plain quotes, which has no escapes.
    throw InputError(fmt::format("{}:{}:{}: effect {}: torque_Nmm: {}{}\n  {}\n  {:>{}}", source_,
                                 at.line, at.column + 1 + error.position, effect.id, error.what(),
                                 hint, effect.torque_Nmm, "^", error.position + 1));
  }

  bearing::EquilibriumOptions read_solver() {
    const Section s = section("solver");
    s.allow_only({"race_control", "tilt"});
    bearing::EquilibriumOptions options;
    options.race_control = choice_or(s, "race_control", {"outer", "inner"}, "outer") == "outer"
                               ? bearing::RaceControl::outer
                               : bearing::RaceControl::inner;
    options.tilt = choice_or(s, "tilt", {"locked", "free"}, "locked") == "locked"
                       ? bearing::Tilt::locked
                       : bearing::Tilt::free;
    return options;
  }

  fit::Rig read_rig() {
    const Section s = section("rig");
    s.allow_only({"inertia_kgm2", "bearings", "axial_load_N", "radial_load_N", "temperature_C",
                  "minimum_speed_rpm"});
    fit::Rig rig;
    if (const auto value = s.number(inertia)) rig.inertia = *value;
    if (const auto value = s.number(axial_load)) rig.axial_load = *value;
    if (const auto value = s.whole_number(bearings))
      rig.bearings = *value;
    else
      note_default("rig", bearings.name, fmt::format("{}", rig.bearings));
    rig.radial_load = number_or(s, radial_load, rig.radial_load);
    rig.temperature = kelvin(number_or(s, temperature, celsius(rig.temperature)));
    rig.minimum_speed = number_or(s, minimum_speed, rig.minimum_speed / rpm) * rpm;
    return rig;
  }

  Names read_calibration(const fit::Model& model) {
    const Section s = section("calibration");
    s.allow_only({"free"});
    // An effect's parameter is known by "id.name", and by its name alone where no other has it.
    std::multimap<std::string, std::string> full_names;
    for (const friction::Parameter& p : friction::parameters(model.law))
      full_names.emplace(p.name, p.name);
    for (const effects::Effect& e : model.effects)
      for (const effects::Parameter& p : e.description->parameters) {
        const std::string full = fmt::format("{}.{}", e.description->id, p.name);
        full_names.emplace(p.name, full);
        full_names.emplace(full, full);
      }
    for (const fit::ShaftParameter& p : fit::shaft_parameters(model))
      full_names.emplace(p.name, p.name);
    Names known;
    for (const auto& [name, full] : full_names) known.push_back(name);
    const toml::node* const node = s.find("free");
    if (!node) {
      Names names = fit::default_free(model);
      std::string text;
      for (const std::string& name : names)
        text += fmt::format("{}\"{}\"", text.empty() ? "" : ", ", name);
      note_default("calibration", "free", "[" + text + "]");
      return names;
    }
    const auto wrong = [&](const toml::node& at, const std::string& problem) {
      throw InputError(fmt::format("{}: free = {}: {}", s.place(&at), shown(at), problem));
    };
    if (!node->is_array() || node->as_array()->empty())
      wrong(*node, "must be a list of one name or more, as in [\"f0\", \"z\"]");
    Names names;
    for (const toml::node& entry : *node->as_array()) {
      const auto name = entry.is_string() ? entry.value<std::string>() : std::nullopt;
      if (!name) wrong(entry, "must be the name of a parameter in quotes");
      const auto [first, last] = full_names.equal_range(*name);
      if (first == last) {
        const std::string near = suggestion(*name, known);
        wrong(entry,
              "no such parameter" + (near.empty() ? "; this model has " + listed(known) : near));
      }
      if (std::next(first) != last)
        wrong(entry, "several effects have it; write effect-id." + *name);
      if (std::find(names.begin(), names.end(), first->second) != names.end())
        wrong(entry, "stands twice");
      names.push_back(first->second);
    }
    return names;
  }

  toml::table root_;
  std::string text_, source_;
  bool from_catalogue_ = false;
  std::vector<Material> materials_;
  friction::FrictionLaw law_ = friction::FrictionLaw::palmgren;
  std::vector<double> law_values_;
  std::vector<effects::Effect> effects_;
  Names defaults_;
};

}  // namespace

ModelFile parse_model(std::string text, const std::string& source) {
  return Reader(std::move(text), source).read();
}

ModelFile read_model(const std::string& path) {
  bool marked = false;
  std::string text = read_text(path, &marked);
  ModelFile file = parse_model(std::move(text), path);
  if (marked) file.text.insert(0, utf8_mark);
  return file;
}

}  // namespace raceway::io
