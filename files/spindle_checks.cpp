#include <algorithm>
#include <cmath>
#include <limits>

#include "model/judgement.h"
#include "model/rings.h"
#include "record/units.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/spindle_parts.h"

namespace raceway::files {
namespace {

using model::Segment;
using model::ThermometerPlace;

constexpr double rounding = 1e-9;        ///< of positions that are sums [m]
constexpr double other_size = 0.5 * mm;  ///< from here on a seat is not of that bearing [m]
constexpr double highest_contact_pressure = 0.02;  ///< of a rough contact, in its hardness [1]

/// Segments behind each other.
struct Stack {
  double start = 0.0;  ///< [m]
  const std::vector<Segment>& segments;

  [[nodiscard]] double end() const {
    double at = start;
    for (const Segment& s : segments) at += s.length;
    return at;
  }
  [[nodiscard]] bool holds(double from, double to) const {
    return from >= start - rounding && to <= end() + rounding;
  }
  /// The segment on the rear or front side of a plane; null outside.
  [[nodiscard]] const Segment* beyond(double plane, bool rear) const {
    return at(plane + (rear ? 2.0 : -2.0) * rounding);
  }
  /// The segment at a position, the one before it where two meet; null outside.
  [[nodiscard]] const Segment* at(double position) const {
    double from = start;
    for (const Segment& s : segments) {
      if (position >= from - rounding && position <= from + s.length + rounding) return &s;
      from += s.length;
    }
    return nullptr;
  }
};

std::string in_mm(double length) { return fmt::format("{:.10g} mm", length / mm); }

class SpindleCheck {
 public:
  SpindleCheck(const ModelTables& tables, const model::Spindle& spindle, const model::Shaft& shaft,
               Names& notes)
      : tables_(tables),
        spindle_(spindle),
        sets_(shaft.arrangement),
        notes_(notes),
        shaft_{.segments = spindle.shaft.segments},
        housing_{.start = spindle.housing.start, .segments = spindle.housing.segments},
        rings_(model::rings_of(spindle, shaft.arrangement)) {}

  void run() {
    check_order();
    check_fits();
    for (std::size_t k = 0; k < rings_.size(); ++k) {
      check_inner_seat(k);
      check_outer_seat(k);
    }
    check_flange();
    check_flange_joint();
    check_clamping();
    check_coolant();
    check_what_the_shaft_carries();
    check_gap();
    const auto sensors = sensor_sections(tables_);
    for (std::size_t k = 0; k < sensors.size(); ++k) check_sensor(sensors[k], spindle_.sensors[k]);
  }

 private:
  [[nodiscard]] double position(std::size_t bearing) const { return rings_[bearing].position; }
  /// "front_position_mm = 60 mm", and where that number stands.
  [[noreturn]] void fail_bearing(std::size_t bearing, const std::string& why) const {
    const std::size_t front = spindle_.front_positions.size();
    if (const std::size_t sets = sets_.bearings().size(); bearing >= sets)
      tables_in(tables_.section("shaft"), "roller_bearing")[bearing - sets].fail(
          "position_mm", fmt::format("position_mm = {}: {}", in_mm(position(bearing)), why));
    const char* const key = bearing < front ? "front_position_mm" : "rear_position_mm";
    const Section s = tables_.section("arrangement");
    const toml::node* const list = s.find(key);
    const toml::node* const node =
        list && list->is_array()
            ? list->as_array()->get(bearing < front ? bearing : bearing - front)
            : list;
    throw text::InputError(
        fmt::format("{}: {} = {}: {}", s.place(node), key, in_mm(position(bearing)), why),
        s.at(key, node));
  }
  [[noreturn]] void fail(std::string_view table, std::string_view key, double length,
                         const std::string& why) const {
    tables_.section(table).fail(key, fmt::format("{} = {}: {}", key, in_mm(length), why));
  }
  [[nodiscard]] std::string shaft_reach() const {
    return fmt::format("the shaft reaches from 0 to {}", in_mm(shaft_.end()));
  }
  [[nodiscard]] std::string housing_reach() const {
    return fmt::format("the housing reaches from {} to {}", in_mm(housing_.start),
                       in_mm(housing_.end()));
  }

  void check_order() const {
    for (std::size_t k = 1; k < sets_.bearings().size(); ++k)
      if (position(k) - position(k - 1) < rings_[k].width - rounding)
        fail_bearing(
            k,
            fmt::format("the bearing is {} behind the previous bearing, but the ring width is {}: "
                        "give the centres from the nose to the rear, at least one width apart",
                        in_mm(position(k) - position(k - 1)), in_mm(rings_[k].width)));
    for (std::size_t k = sets_.bearings().size(); k < rings_.size(); ++k)
      for (std::size_t other = 0; other < k; ++other)
        if (rings_[k].front() < rings_[other].rear() - rounding &&
            rings_[other].front() < rings_[k].rear() - rounding)
          fail_bearing(k, fmt::format("with width_mm = {}, the bearing overlaps the bearing at {}",
                                      in_mm(rings_[k].width), in_mm(position(other))));
  }

  /// An interference that no ring survives.
  void check_fits() const {
    const auto look = [&](const Section& s, const char* key, double interference, double sign,
                          double diameter, const char* of) {
      const double most = model::ring_yields * diameter;
      if (interference > most)
        s.fail(key, fmt::format("{} = {:.6g} um: must be {} {:.4g} um on the {} of {}, because the "
                                "ring yields beyond this value",
                                key, sign * interference / um, sign > 0.0 ? "at most" : "at least",
                                sign * most / um, of, in_mm(diameter)));
    };
    const std::vector<Section> rollers = tables_in(tables_.section("shaft"), "roller_bearing");
    const std::size_t first = rings_.size() - rollers.size();
    for (std::size_t k = 0; k < rings_.size(); ++k) {
      // The seats of all bearings of the sets are alike.
      if (k > 0 && k < first) continue;
      const Section s = k < first ? tables_.section("seat") : rollers[k - first];
      look(s, s.find("drive_up_mm") ? "drive_up_mm" : "inner_interference_um",
           rings_[k].inner_interference, 1.0, rings_[k].bore, "bore");
      look(s, "outer_clearance_um", -rings_[k].outer_clearance, -1.0, rings_[k].outer_diameter,
           "outer diameter");
    }
  }

  /// A rotor wider than the housing around it.
  void check_rotor() const {
    if (!spindle_.motor || std::isnan(spindle_.motor->rotor_diameter)) return;
    const model::HeatSource& rotor = *spindle_.motor;
    const double half = std::isnan(rotor.length) ? 0.0 : 0.5 * rotor.length;
    for (double from = housing_.start; const Segment& s : housing_.segments) {
      const double to = from + s.length;
      const bool over =
          rotor.position + half > from + rounding && rotor.position - half < to - rounding;
      from = to;
      const double wall = std::isnan(s.bore) ? s.diameter : s.bore;
      if (over && rotor.rotor_diameter >= wall)
        fail("motor", "rotor_diameter_mm", rotor.rotor_diameter,
             fmt::format("must be below {}, the {} of the housing around the rotor", in_mm(wall),
                         std::isnan(s.bore) ? "outer diameter" : "bore"));
    }
  }

  void check_inner_seat(std::size_t k) const {
    const double at = position(k), bore = rings_[k].bore;
    if (!shaft_.holds(rings_[k].front(), rings_[k].rear()))
      fail_bearing(k, fmt::format("the bearing, {} wide, does not lie entirely on the shaft: {}",
                                  in_mm(rings_[k].width), shaft_reach()));
    const double inset = 0.99 * (0.5 * rings_[k].width);
    for (const double place : {at, at - inset, at + inset}) {
      const double diameter = shaft_.at(place)->diameter;
      if (diameter > bore + other_size || (place == at && diameter < bore - other_size))
        fail_bearing(k, fmt::format("the shaft has diameter_mm = {} at {}, but the bearing has "
                                    "bore_mm = {}",
                                    in_mm(diameter), in_mm(place), in_mm(bore)));
      if (diameter < bore - other_size)
        notes_.push_back(
            fmt::format("a part of the shaft under the bearing at {} has diameter_mm = {}: the "
                        "ring does not touch this part",
                        in_mm(at), in_mm(diameter)));
    }
  }

  void check_outer_seat(std::size_t k) const {
    const double at = position(k), outer = rings_[k].outer_diameter;
    if (!housing_.holds(rings_[k].front(), rings_[k].rear()))
      fail_bearing(k, fmt::format("the bearing, {} wide, does not lie entirely in the housing: {}",
                                  in_mm(rings_[k].width), housing_reach()));
    const Segment& around = *housing_.at(at);
    if (around.diameter <= outer)
      fail_bearing(k, fmt::format("at this position, the housing has outer_diameter_mm = {} and "
                                  "the bearing has {}, so the housing has no wall",
                                  in_mm(around.diameter), in_mm(outer)));
    // Where a piece leaves it open, it is bored to the bearings of the sets.
    const double bore = std::isnan(around.bore) ? rings_.front().outer_diameter : around.bore;
    if (std::abs(bore - outer) > other_size)
      fail_bearing(k, fmt::format("at this position, the housing has bore_mm = {}, but the bearing "
                                  "has outer_diameter_mm = {}",
                                  in_mm(bore), in_mm(outer)));
  }

  void check_flange() const {
    const model::Housing& h = spindle_.housing;
    if (!housing_.holds(h.flange - 0.5 * h.flange_length, h.flange + 0.5 * h.flange_length))
      fail("housing", "flange_mm", h.flange,
           fmt::format(
               "with flange_length_mm = {}, the flange does not lie entirely on the housing: {}",
               in_mm(h.flange_length), housing_reach()));
  }

  /// The formula of a rough contact ends at this share of the hardness.
  void check_flange_joint() const {
    if (!spindle_.housing.flange_joint) return;
    const model::ScrewedJoint& joint = *spindle_.housing.flange_joint;
    require_contact_pressure(tables_.section("housing"), "flange_screw_force_N", joint.screw_force,
                             joint.pressure(), fmt::format("each of {} screws", joint.screws));
  }

  void require_contact_pressure(const Section& s, std::string_view key, double force,
                                double pressure, const std::string& of_what) const {
    const double highest = highest_contact_pressure * spindle_.seat.hardness;
    if (pressure > highest)
      s.fail(key, fmt::format("{} = {:.10g} N: this force on {} causes a contact pressure of "
                              "{:.4g} MPa. With hardness_GPa = {:.4g}, the formula for the contact "
                              "conductance is valid only up to {:.4g} MPa; reduce the force",
                              key, force, of_what, pressure / MPa, spindle_.seat.hardness / GPa,
                              highest / MPa));
  }

  /// Contact area of the side face of an inner ring [m²]; 0 if nothing stands against it.
  [[nodiscard]] double inner_face(std::size_t k, bool rear) const {
    const model::Rings& r = rings_[k];
    const Segment* const beyond = shaft_.beyond(rear ? r.rear() : r.front(), rear);
    double reach = beyond ? beyond->diameter : 0.0;
    for (std::size_t other = 0; other < rings_.size(); ++other)
      if (stand_together(k, other, rear) || share_spacer(k, other, rear))
        reach = std::max(reach, rings_[other].inner_shoulder);
    return ring_area(r.bore, std::min(reach, r.inner_shoulder));
  }

  /// Contact area of the side face of an outer ring [m²]; 0 if nothing stands against it.
  [[nodiscard]] double outer_face(std::size_t k, bool rear) const {
    const model::Rings& r = rings_[k];
    const Segment* const beyond = housing_.beyond(rear ? r.rear() : r.front(), rear);
    double bore = r.outer_diameter;
    if (beyond) bore = std::isnan(beyond->bore) ? rings_.front().outer_diameter : beyond->bore;
    for (std::size_t other = 0; other < rings_.size(); ++other)
      if (stand_together(k, other, rear)) bore = std::min(bore, rings_[other].outer_shoulder);
    return ring_area(std::max(bore, r.outer_shoulder), r.outer_diameter);
  }

  static double ring_area(double inner, double outer) {
    return outer > inner + rounding ? 0.25 * pi * (outer * outer - inner * inner) : 0.0;
  }
  [[nodiscard]] bool stand_together(std::size_t k, std::size_t other, bool rear) const {
    const double face = rear ? rings_[k].rear() : rings_[k].front();
    return std::abs((rear ? rings_[other].front() : rings_[other].rear()) - face) < rounding;
  }
  /// Sleeves keep the inner rings of one set apart, where the shaft leaves room for them.
  [[nodiscard]] bool share_spacer(std::size_t k, std::size_t other, bool rear) const {
    const std::size_t front = spindle_.front_positions.size(), sets = sets_.bearings().size();
    if (k >= sets || other >= sets || (k < front) != (other < front)) return false;
    if (rear ? other != k + 1 : other + 1 != k) return false;
    const Segment* const between = shaft_.at(0.5 * (position(k) + position(other)));
    return between && between->diameter <= rings_[k].bore + rounding;
  }

  /// Faces of rings under their clamping force: at least one, and none beyond the formula.
  void check_clamping() const {
    const auto look = [&](std::string_view key, double force, auto area_of, const char* rings) {
      if (std::isnan(force)) return;
      const Section s = tables_.section("seat");
      double smallest = std::numeric_limits<double>::infinity();
      std::size_t where = 0;
      for (std::size_t k = 0; k < rings_.size(); ++k)
        for (const bool rear : {false, true})
          if (const double area = area_of(k, rear); area > 0.0 && area < smallest) {
            smallest = area;
            where = k;
          }
      if (std::isinf(smallest))
        s.fail(key,
               fmt::format(
                   "{} = {:.10g} N: the clamping force acts on no face, because neither a shoulder "
                   "nor another ring touches the {}; correct the geometry or remove this key",
                   key, force, rings));
      require_contact_pressure(
          s, key, force, force / smallest,
          fmt::format("the smallest ring face ({:.4g} mm2, at the bearing at {})",
                      smallest / (mm * mm), in_mm(position(where))));
    };
    look(
        "inner_clamping_force_N", spindle_.seat.inner_clamping_force,
        [&](std::size_t k, bool rear) { return inner_face(k, rear); }, "inner rings");
    look(
        "outer_clamping_force_N", spindle_.seat.outer_clamping_force,
        [&](std::size_t k, bool rear) { return outer_face(k, rear); }, "outer rings");
  }

  /// Bore of the housing at a position; where it is open, that of the bearings.
  [[nodiscard]] double bore_at(double place) const {
    const Segment* const s = housing_.at(place);
    return std::isnan(s->bore) ? rings_.front().outer_diameter : s->bore;
  }

  void check_coolant() const {
    if (!spindle_.coolant) return;
    check_channel(tables_.section("coolant"), *spindle_.coolant);
    const std::vector<Section> sections = circuit_sections(tables_);
    const std::vector<model::Coolant> channels = spindle_.channels();
    for (std::size_t k = 0; k < sections.size(); ++k) {
      const model::Coolant& c = channels[k + 1];
      check_channel(sections[k], c);
      for (std::size_t j = 0; j <= k; ++j)
        if (std::min(c.end, channels[j].end) > std::max(c.start, channels[j].start) + rounding)
          sections[k].fail(
              "start_mm",
              fmt::format("start_mm = {}, end_mm = {}: circuit {} reaches from {} to {}; circuits "
                          "must not overlap",
                          in_mm(c.start), in_mm(c.end),
                          j == 0 ? "[coolant]" : '"' + spindle_.circuits[j - 1].name + '"',
                          in_mm(channels[j].start), in_mm(channels[j].end)));
    }
  }

  void check_channel(const Section& table, const model::Coolant& c) const {
    const auto outside = [&](const char* key, double length, const std::string& why) {
      table.fail(key, fmt::format("{} = {}: {}", key, in_mm(length), why));
    };
    for (const auto& [key, at] : {std::pair{"start_mm", c.start}, {"end_mm", c.end}})
      if (!housing_.holds(at, at)) outside(key, at, housing_reach());
    for (double from = housing_.start; const Segment& s : housing_.segments) {
      const double to = from + s.length, middle = 0.5 * (from + to);
      from = to;
      if (to <= c.start + rounding || to - s.length >= c.end - rounding) continue;
      const double bore = bore_at(middle), inner = c.diameter - c.channel_depth,
                   outer = c.diameter + c.channel_depth;
      if (inner <= bore || outer >= s.diameter)
        outside("diameter_mm", c.diameter,
                fmt::format("with channel_depth_mm = {} the channel reaches from {} to {} in "
                            "diameter, partly outside the wall of the housing, which reaches from "
                            "{} to {}",
                            in_mm(c.channel_depth), in_mm(inner), in_mm(outer), in_mm(bore),
                            in_mm(s.diameter)));
    }
  }

  void check_source(std::string_view table, const std::optional<model::HeatSource>& source) const {
    if (!source || std::isnan(source->position)) return;
    const double half = std::isnan(source->length) ? 0.0 : 0.5 * source->length;
    if (!shaft_.holds(source->position - half, source->position + half))
      fail(
          table, "position_mm", source->position,
          fmt::format("with a length of {}, the heated part does not lie entirely on the shaft: {}",
                      in_mm(2.0 * half), shaft_reach()));
  }

  void check_heated(const Section& s, const model::HeatSource& source) const {
    if (std::isnan(source.position)) return;
    const bool on_housing = source.place == model::HeatSource::Place::housing;
    const Stack& body = on_housing ? housing_ : shaft_;
    if (!body.holds(source.position - 0.5 * source.length, source.position + 0.5 * source.length))
      s.fail("position_mm", fmt::format("position_mm = {}: with length_mm = {}, the heated part "
                                        "does not lie entirely on the {}: {}",
                                        in_mm(source.position), in_mm(source.length),
                                        on_housing ? "housing" : "shaft",
                                        on_housing ? housing_reach() : shaft_reach()));
    if (std::isnan(source.radius)) return;
    const Segment& at = *body.at(source.position);
    const double from = on_housing ? bore_at(source.position) : at.bore;
    require_radius(s, source.radius, 0.5 * from, 0.5 * at.diameter,
                   on_housing ? "the housing" : "the shaft");
  }

  void check_what_the_shaft_carries() const {
    const Section s = tables_.section("shaft");
    const auto require = [&](std::string_view list, std::size_t k, double at) {
      if (!shaft_.holds(at, at))
        tables_in(s, list)[k].fail(
            "position_mm", fmt::format("position_mm = {}: this position is outside; {}", in_mm(at),
                                       shaft_reach()));
    };
    const model::ShaftBody& body = spindle_.shaft;
    for (std::size_t k = 0; k < body.supports.size(); ++k)
      require("support", k, body.supports[k].position);
    for (std::size_t k = 0; k < body.disks.size(); ++k) require("disk", k, body.disks[k].position);
    check_source("motor", spindle_.motor);
    check_rotor();
    check_source("drive", spindle_.drive);
    const auto heated = heat_sections(tables_);
    for (std::size_t k = 0; k < heated.size(); ++k) check_heated(heated[k], spindle_.heat[k]);
  }

  void check_gap() const {
    if (!spindle_.gap) return;
    for (const auto& [key, at] :
         {std::pair{"start_mm", spindle_.gap->start}, {"end_mm", spindle_.gap->end}})
      if (!std::isnan(at) && (!shaft_.holds(at, at) || !housing_.holds(at, at)))
        fail("gap", key, at, fmt::format("{}, {}", shaft_reach(), housing_reach()));
  }

  static void require_radius(const Section& s, double radius, double from, double to,
                             std::string_view what) {
    if (radius < from - rounding || radius > to + rounding)
      s.fail("radius_mm",
             fmt::format(
                 "radius_mm = {}: at this position, the radius must be inside {}, from {} to {}",
                 in_mm(radius), what, in_mm(from), in_mm(to)));
  }

  void check_sensor(const Section& s, const ThermometerPlace& place) const {
    const auto outside = [&](const std::string& why) {
      s.fail("position_mm", fmt::format("position_mm = {}: this position is outside; {}",
                                        in_mm(place.position), why));
    };
    switch (place.part) {
      case ThermometerPlace::Part::shaft: {
        const Segment* const at = shaft_.at(place.position);
        if (!at) outside(shaft_reach());
        require_radius(s, place.radius, 0.5 * at->bore, 0.5 * at->diameter, "the shaft");
        return;
      }
      case ThermometerPlace::Part::housing: {
        const Segment* const at = housing_.at(place.position);
        if (!at) outside(housing_reach());
        require_radius(s, place.radius, 0.5 * bore_at(place.position), 0.5 * at->diameter,
                       "the housing");
        return;
      }
      case ThermometerPlace::Part::ring:
        check_ring_sensor(s, place);
        return;
      case ThermometerPlace::Part::coolant:
        if (!spindle_.coolant) s.fail("part", "part = \"coolant\": the model has no [coolant]");
        if (std::isnan(place.position)) return;
        std::string reach;
        for (const model::Coolant& c : spindle_.channels()) {
          if (place.position >= c.start - rounding && place.position <= c.end + rounding) return;
          reach += fmt::format("{} {} to {}",
                               reach.empty() ? "the channel reaches from" : ", another from",
                               in_mm(c.start), in_mm(c.end));
        }
        outside(reach);
    }
  }

  void check_ring_sensor(const Section& s, const ThermometerPlace& place) const {
    for (const model::Rings& r : rings_) {
      if (std::abs(place.position - r.position) > 0.5 * r.width + rounding) continue;
      const bool inner = place.radius < 0.25 * (r.inner_shoulder + r.outer_shoulder);
      require_radius(s, place.radius, 0.5 * (inner ? r.bore : r.outer_shoulder),
                     0.5 * (inner ? r.inner_shoulder : r.outer_diameter),
                     inner ? "the inner ring" : "the outer ring");
      return;
    }
    s.fail("position_mm", fmt::format("position_mm = {}: there is no bearing at this position",
                                      in_mm(place.position)));
  }

  const ModelTables& tables_;
  const model::Spindle& spindle_;
  const bearing::Arrangement& sets_;
  Names& notes_;
  Stack shaft_, housing_;
  std::vector<model::Rings> rings_;
};

}  // namespace

void check_spindle(const ModelTables& tables, const model::Spindle& spindle,
                   const model::Shaft& shaft, Names& notes) {
  SpindleCheck(tables, spindle, shaft, notes).run();
}

}  // namespace raceway::files
