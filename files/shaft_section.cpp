#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "model/judgement.h"
#include "record/units.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/number_lists.h"
#include "files/detail/shaft_section.h"

namespace raceway::files {
namespace {

using bearing::ArrangementDesign;
using bearing::Layout;
using bearing::Mounting;

/// A set of bearings as the trade names it.
struct TradeName {
  std::string_view name;
  Layout layout;
  int front, rear;  ///< bearings at the tool and behind; 0: the name does not say
};
constexpr std::string_view name(const TradeName& set) { return set.name; }
constexpr std::array trade_names{
    TradeName{"O", Layout::back_to_back, 0, 0},   TradeName{"X", Layout::face_to_face, 0, 0},
    TradeName{"tandem", Layout::tandem, 0, 0},    TradeName{"DB", Layout::back_to_back, 1, 1},
    TradeName{"DF", Layout::face_to_face, 1, 1},  TradeName{"DT", Layout::tandem, 2, 0},
    TradeName{"TBT", Layout::back_to_back, 2, 1}, TradeName{"TFT", Layout::face_to_face, 2, 1},
    TradeName{"TT", Layout::tandem, 3, 0},        TradeName{"QBC", Layout::back_to_back, 2, 2},
    TradeName{"QFC", Layout::face_to_face, 2, 2}, TradeName{"QBT", Layout::back_to_back, 3, 1},
    TradeName{"QFT", Layout::face_to_face, 3, 1}, TradeName{"QT", Layout::tandem, 4, 0}};

const std::string words_of_layout = names_as_words(trade_names);
const ArrangementDesign usual_design;

// Wherever the libraries check as well, these are their ranges.
const Key arrangement_keys[]{
    {"layout", one_of(words_of_layout), is_required,
     "arrangement of the sets on the shaft: O, X, tandem, or a trade name, which also gives the "
     "number of bearings in each set"},
    {"front", whole(1, 20), "from the layout",
     "number of bearings in the set at the tool; required unless the layout gives it"},
    {"rear", whole(0, 20), "from the layout",
     "number of bearings in the rear set (tandem: 0); required unless the layout gives it"},
    {"mounting", one_of("rigid|spring"), "rigid", "preload of the sets: rigid (spacers) or spring"},
    {"spring_rate_N_um", between(0, 1e6, "N/um"), 0.0,
     "rate of the preload spring; 0: constant force"},
    {"preload_N", between(0.001, 1e8, "N"), unset,
     "preload at standstill, sum over the bearings of one set; give one of preload_N, "
     "preload_offset_um and preload_class"},
    {"preload_offset_um", between(0.001, 1000, "um"), unset,
     "gap that is ground into the ring faces and closed by clamping; only for mounting = "
     "\"rigid\""},
    {"preload_class", one_of("light|medium|strong"), unset,
     "preload class from the catalogue; only for mounting = \"rigid\""},
    {"external_load_N", between(-1e8, 1e8, "N"), 0.0,
     "axial load on the shaft, positive towards the tool"},
    {"shaft_stiffness_N_um", between(0.001, 1e9, "N/um"), "rigid",
     "axial stiffness of the shaft between the sets"},
    {"housing_stiffness_N_um", between(0.001, 1e9, "N/um"), "rigid",
     "axial stiffness of the housing between the sets"},
    {"distance_mm", between(0, 1e5, "mm"), 0.0,
     "distance between the middles of the sets, for the thermal expansion"},
    {"shaft_expansion_1e6_K", between(0, 50, "1e-6/K"),
     usual_design.shaft_expansion / per_million_K,
     "linear thermal expansion of the shaft; for a spindle, the default comes from the material of "
     "[shaft]"},
    {"housing_expansion_1e6_K", between(0, 50, "1e-6/K"),
     usual_design.housing_expansion / per_million_K,
     "linear thermal expansion of the housing; for a spindle, the default comes from the material "
     "of [housing]"},
    {"mounting_temperature_C", between(-200, 500, "C"), celsius(usual_design.mounting_temperature),
     "temperature at which the preload was set"},
    {"inner_ring_temperature_C", between(-200, 500, "C"), "mounting temperature",
     "temperature of the inner rings; if no temperature of rings, balls, shaft or housing is "
     "given, no part expands"},
    {"outer_ring_temperature_C", between(-200, 500, "C"), "mounting temperature",
     "temperature of the outer rings"},
    {"ball_temperature_C", between(-200, 500, "C"), "mean of inner and outer ring temperature",
     "temperature of the balls"},
    {"shaft_temperature_C", between(-200, 500, "C"), "inner ring temperature",
     "temperature of the shaft"},
    {"housing_temperature_C", between(-200, 500, "C"), "outer ring temperature",
     "temperature of the housing"},
    {"front_bearing", a_table, "values of [bearing]",
     "table [arrangement.front_bearing]: keys of [bearing] with other values for the set at the "
     "tool; [[arrangement.front_bearing]], once for each bearing, gives each bearing its own "
     "values"},
    {"rear_bearing", a_table, "values of [bearing]",
     "table [arrangement.rear_bearing]: keys of [bearing] with other values for the rear set"},
};
constexpr Key positions_keys[]{
    {"front_position_mm", a_list, unset,
     "distances of the bearing centres of the front set behind the nose face"},
    {"rear_position_mm", a_list, unset,
     "distances of the bearing centres of the rear set behind the nose face"},
};
constexpr Key mounted_bearing_keys[]{
    {"offset_um", between(-1000, 1000, "um"), 0.0,
     "additional axial displacement of one bearing relative to its set. "
     "[arrangement.front_bearing] and [arrangement.rear_bearing] have this key and all keys of "
     "[bearing]"}};

constexpr std::string_view front_position = positions_keys[0].name;
constexpr std::string_view rear_position = positions_keys[1].name;

std::string digits_of(double value) { return fmt::format("{:.10g}", value); }

class ShaftReader {
 public:
  ShaftReader(const Section& section, const ShaftContext& context)
      : s_(section.with({arrangement_keys, positions_keys})), in_(context) {}

  model::Shaft read() {
    read_layout();
    d_.front = read_set("front", *count("front", set_.front));
    const int rear = count("rear", set_.rear).value_or(0);
    const bool tandem = d_.layout == Layout::tandem;
    if (tandem && rear > 0)
      s_.fail("rear",
              fmt::format("rear = {}: must be 0, because a tandem arrangement has no second set",
                          rear));
    if (!tandem && rear == 0)
      s_.fail("rear",
              "rear = 0: must be from 1 to 20, because only a tandem arrangement has no rear set");
    d_.rear = read_set("rear", rear);
    read_mounting();
    read_positions();
    if (!std::isnan(in_.expansions.first))
      std::tie(d_.shaft_expansion, d_.housing_expansion) = in_.expansions;
    read_preload();
    s_.take("shaft_stiffness_N_um", d_.shaft_stiffness, N_per_um);
    s_.take("housing_stiffness_N_um", d_.housing_stiffness, N_per_um);
    const auto temperatures = read_temperatures();
    const double load = number("external_load_N");
    try {
      bearing::Arrangement arrangement(d_);
      require_possible_preload(arrangement);
      return {.arrangement = std::move(arrangement),
              .external_load = load,
              .temperatures = temperatures,
              .own_bearings = s_.find("front_bearing") || s_.find("rear_bearing")};
    } catch (const std::invalid_argument& error) {
      throw text::InputError(fmt::format("{}: [arrangement] {}", s_.place(), error.what()),
                             s_.at());
    }
  }

 private:
  double number(std::string_view key, double fallback) {
    if (const auto value = s_.number(key)) return *value;
    in_.note_default(key, digits_of(fallback));
    return fallback;
  }
  double number(std::string_view key) { return number(key, s_.key(key).fallback.value); }

  /// Bearings of a set: as the file says, else as the name of the layout does; both may, so that a
  /// set may stand the other way round (1 and 2 of a TBT).
  std::optional<int> count(std::string_view key, int named) {
    const auto value = s_.whole_number(key);
    if (set_.front > 0) {
      const int front = static_cast<int>(s_.number("front").value_or(set_.front));
      const int rear = static_cast<int>(s_.number("rear").value_or(set_.rear));
      if (std::minmax(front, rear) != std::minmax(set_.front, set_.rear))
        s_.fail(key, fmt::format("front = {}, rear = {}: layout = \"{}\" has sets of {} and {} "
                                 "bearings; correct front, rear or layout",
                                 front, rear, set_.name, set_.front, set_.rear));
      if (!value) in_.note_default(key, fmt::format("{}", named));
      return value ? value : std::optional(named);
    }
    if (!value && !(d_.layout == Layout::tandem && key == "rear")) s_.fail_missing(key);
    return value;
  }

  void read_layout() {
    const auto layout = s_.choice("layout");
    if (!layout) s_.fail_missing("layout");
    set_ = *std::find_if(trade_names.begin(), trade_names.end(),
                         [&](const TradeName& t) { return t.name == *layout; });
    d_.layout = set_.layout;
  }

  void read_mounting() {
    const auto given = s_.choice("mounting");
    if (!given) in_.note_default("mounting", "\"rigid\"");
    d_.mounting = given == "spring" ? Mounting::spring : Mounting::rigid;
    if (d_.layout == Layout::tandem && d_.mounting == Mounting::rigid)
      s_.fail("mounting",
              "mounting: a tandem arrangement needs a spring; write mounting = \"spring\"");
    if (d_.mounting == Mounting::spring) {
      d_.spring_rate = number("spring_rate_N_um") * N_per_um;
    } else if (const toml::node* const rate = s_.find("spring_rate_N_um")) {
      s_.fail("spring_rate_N_um",
              fmt::format("spring_rate_N_um = {}: only possible with mounting = \"spring\"",
                          text::shown(*rate)));
    }
  }

  /// [arrangement.front_bearing] for all of a set, [[arrangement.front_bearing]] for each.
  std::vector<bearing::MountedBearing> read_set(const std::string& side, int bearings) {
    const std::string key = side + "_bearing", name = "arrangement." + key;
    const auto share = [](const NamedBearing& b) {
      return std::make_shared<const bearing::Bearing>(b.bearing);
    };
    const auto read = [&](const toml::table* table) {
      const Section section(s_.source(), name, table);
      NamedBearing bearing = in_.read_bearing(section, {mounted_bearing_keys});
      return std::pair(std::move(bearing),
                       section.part({mounted_bearing_keys}).value("offset_um") * um);
    };
    const toml::node* const node = s_.find(key);
    std::vector<bearing::MountedBearing> set;
    if (!node) {
      first_of(side, in_.base);
      set.assign(static_cast<std::size_t>(bearings), {shared_base(share)});
      return set;
    }
    if (const toml::table* const table = node->as_table()) {
      const auto [bearing, shift] = read(table);
      first_of(side, bearing);
      set.assign(static_cast<std::size_t>(bearings), {share(bearing), shift});
      return set;
    }
    if (!node->is_array_of_tables())
      s_.fail(key, fmt::format("{} = {}: must be a table, written as [{}] or [[{}]]", key,
                               text::shown(*node), name, name));
    for (const toml::node& one : *node->as_array()) {
      const auto [bearing, shift] = read(one.as_table());
      if (set.empty()) first_of(side, bearing);
      set.push_back({share(bearing), shift});
    }
    if (set.size() != static_cast<std::size_t>(bearings))
      s_.fail(
          key,
          fmt::format("the model has [[{}]] {} times, but {} = {}; give one table for each bearing",
                      name, set.size(), side, bearings));
    return set;
  }

  template <typename Share>
  std::shared_ptr<const bearing::Bearing> shared_base(const Share& share) {
    if (!base_) base_ = share(in_.base);
    return base_;
  }

  /// Where the bearings' centres stand, from which the distance of the sets follows.
  void read_positions() {
    const bool front = s_.find(front_position), rear = s_.find(rear_position);
    if (!front && !rear) return;
    const std::string_view missing = front ? rear_position : front_position;
    if (!front || (!rear && !d_.rear.empty()))
      throw text::InputError(
          fmt::format("{}: [arrangement] {} is missing; it is required, because {} is given",
                      s_.place(), missing, front ? front_position : rear_position),
          s_.at(missing));
    const auto middle = [&](std::string_view key, std::size_t count) {
      double sum = 0.0;
      for (const double position : numbers(s_, key, *s_.find(key), count)) sum += position;
      return sum / static_cast<double>(count);
    };
    const double at_front = middle(front_position, d_.front.size());
    if (d_.rear.empty()) return;
    const double apart = middle(rear_position, d_.rear.size()) - at_front;
    if (!(apart > 0.0))
      s_.fail(rear_position,
              fmt::format("{} = {}: the middle of the rear set must be further from the nose than "
                          "the middle of the front set ({})",
                          rear_position, text::shown(*s_.find(rear_position)), front_position));
    constexpr double rounding_mm = 1e-6;
    if (const auto given = s_.number("distance_mm");
        given && std::abs(*given - apart) > rounding_mm)
      s_.fail("distance_mm", fmt::format("distance_mm = {0:.10g} mm: the distance calculated from "
                                         "{2} and {3} is {1:.10g} mm; correct or remove this key",
                                         *given, apart, front_position, rear_position));
    positions_give_distance_ = true;
    d_.distance = apart * mm;
  }

  /// Keeps the first bearing of a side, whose printed preload stands for it.
  void first_of(const std::string& side, const NamedBearing& bearing) {
    (side == "front" ? first_front_ : first_rear_) = bearing;
  }

  void read_preload() {
    Names given;
    for (const char* key : {"preload_N", "preload_offset_um", "preload_class"})
      if (s_.find(key)) given.emplace_back(key);
    if (given.size() != 1)
      throw text::InputError(
          fmt::format("{}: [arrangement] {}: give exactly one of preload_N, preload_offset_um and "
                      "preload_class",
                      s_.place(),
                      given.empty() ? "preload is missing" : text::listed(given) + " are given"),
          s_.at(given.empty() ? "preload_N" : given.front()));
    if (d_.mounting == Mounting::spring && given[0] != "preload_N")
      s_.fail(given[0], fmt::format("{}: a spring needs a force; give preload_N", given[0]));
    if (given[0] == "preload_N") {
      d_.preload = bearing::PreloadForce{*s_.number("preload_N")};
    } else if (given[0] == "preload_offset_um") {
      d_.preload = bearing::PreloadOffset{*s_.number("preload_offset_um") * um};
    } else {
      const std::string word = *s_.choice("preload_class");
      d_.preload = bearing::matched_preload(first_front_->bearing, class_force(*first_front_, word),
                                            first_rear_->bearing, class_force(*first_rear_, word));
    }
  }

  /// Refuses a preload that presses the balls harder than any steel is.
  void require_possible_preload(const bearing::Arrangement& arrangement) const {
    const bearing::ArrangementEquilibrium rest = solve_arrangement(arrangement, {});
    double most = 0.0;
    for (const bearing::BearingInSet& b : rest.bearings)
      most = std::max({most, b.inner_pressure, b.outer_pressure});
    if (!(most > model::steel_flows)) return;
    for (const char* key : {"preload_N", "preload_offset_um", "preload_class"})
      if (const toml::node* const node = s_.find(key))
        s_.fail(key, fmt::format(
                         "{} = {}: the contact pressure as mounted is {:.3g} GPa (preload {:.4g} "
                         "N): it must be below {:.3g} GPa, at which the hardest steel yields",
                         key, text::shown(*node), most / GPa, arrangement.preload(),
                         model::steel_flows / GPa));
  }

  [[nodiscard]] double class_force(const NamedBearing& b, const std::string& word) const {
    const auto fail = [&](const std::string& why) {
      s_.fail("preload_class", fmt::format("preload_class = \"{}\": {}", word, why));
    };
    if (!b.row)
      fail(b.name + " is not in the catalogue, so it has no preload class; give preload_N");
    const PairPreload& pair = word == "light"    ? b.row->light
                              : word == "medium" ? b.row->medium
                                                 : b.row->strong;
    if (std::isnan(pair.force))
      fail("the catalogue has no preload of this class for " + b.name + "; give preload_N");
    return pair.force;
  }

  std::optional<bearing::SetTemperatures> read_temperatures() {
    const auto kelvin_of = [&](std::string_view key) {
      const auto value = s_.number(key);
      return value ? kelvin(*value) : unset;
    };
    bearing::SetTemperatures t{.inner_ring = kelvin_of("inner_ring_temperature_C"),
                               .outer_ring = kelvin_of("outer_ring_temperature_C"),
                               .balls = kelvin_of("ball_temperature_C"),
                               .shaft = kelvin_of("shaft_temperature_C"),
                               .housing = kelvin_of("housing_temperature_C")};
    bool any = false;
    for (const double value : {t.inner_ring, t.outer_ring, t.balls, t.shaft, t.housing})
      any = any || !std::isnan(value);
    if (!any) {
      // Only a shaft that is warm needs these; they may stand there already.
      if (const auto value = s_.number("distance_mm"); value && !positions_give_distance_)
        d_.distance = *value * mm;
      s_.take("shaft_expansion_1e6_K", d_.shaft_expansion, per_million_K);
      s_.take("housing_expansion_1e6_K", d_.housing_expansion, per_million_K);
      if (const auto value = s_.number("mounting_temperature_C"))
        d_.mounting_temperature = kelvin(*value);
      return std::nullopt;
    }
    if (!positions_give_distance_) d_.distance = number("distance_mm") * mm;
    d_.shaft_expansion =
        number("shaft_expansion_1e6_K", d_.shaft_expansion / per_million_K) * per_million_K;
    d_.housing_expansion =
        number("housing_expansion_1e6_K", d_.housing_expansion / per_million_K) * per_million_K;
    d_.mounting_temperature = kelvin(number("mounting_temperature_C"));
    const auto fill = [&](double& value, std::string_view key, double fallback) {
      if (!std::isnan(value)) return;
      value = fallback;
      in_.note_default(key, digits_of(celsius(value)));
    };
    fill(t.inner_ring, "inner_ring_temperature_C", d_.mounting_temperature);
    fill(t.outer_ring, "outer_ring_temperature_C", d_.mounting_temperature);
    fill(t.balls, "ball_temperature_C", 0.5 * (t.inner_ring + t.outer_ring));
    fill(t.shaft, "shaft_temperature_C", t.inner_ring);
    fill(t.housing, "housing_temperature_C", t.outer_ring);
    return t;
  }

  const Section s_;
  const ShaftContext& in_;
  ArrangementDesign d_;
  bool positions_give_distance_ = false;
  TradeName set_ = trade_names.front();
  std::shared_ptr<const bearing::Bearing> base_;
  std::optional<NamedBearing> first_front_, first_rear_;
};

}  // namespace

std::vector<KeyTable> arrangement_tables() {
  return {{"arrangement", arrangement_keys},
          {"arrangement", positions_keys, "spindle"},
          {"arrangement.front_bearing", mounted_bearing_keys}};
}

model::Shaft read_shaft(const Section& section, const ShaftContext& context) {
  return ShaftReader(section, context).read();
}

}  // namespace raceway::files
