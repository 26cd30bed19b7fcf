#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bearing/bearing.h"
#include "bearing/operating_point.h"
#include "model/model.h"

/// The one place that judges answers: limits of engineering practice with their sources, and the
/// answers that pass them. docs/limits.md lists all limits.
namespace raceway::model {

/// A limit that an answer should not pass. A warning says that the design or the question should
/// change, a note that the reader should know.
struct Limit {
  std::string_view id;     ///< in JSON documents
  double value;            ///< in `unit`; NaN where it depends on the bearing
  std::string_view unit;   ///< as people read it
  bool is_warning = true;  ///< else a note
};

namespace limits {

/// Static equivalent load over C0. Source: [ISO76], static safety of 1.
inline constexpr Limit static_load{"static_load", unset, "N", false};
/// Pressure that leaves dents. Source: [ISO76], a permanent deformation of 1e-4 ball diameters.
inline constexpr Limit static_pressure{"static_pressure", 4.2, "GPa", false};
/// Pressure of a contact that is rolled over. Makers of spindle bearings give 2000 MPa as the
/// pressure below which their bearings do not tire (from memory, print not seen); [ISO281, annex B]
/// counts from 1500 MPa.
inline constexpr Limit running_pressure{"running_pressure", 2.0, "GPa"};
/// Speed that the catalogue prints, of one bearing on a spring. Source: [GMN4000]; balls of silicon
/// nitride reach 1.25 times as much [GMN speed factors].
inline constexpr Limit catalogue_speed{"catalogue_speed", unset, "rpm"};
/// n d_m of the fastest bearings with steel balls in [GMN4000], KH 6014 C: 24 000 rpm with oil-air
/// and 18 000 rpm with grease on 90 mm; 1.25 times as much with balls of silicon nitride.
inline constexpr Limit speed_factor{"speed_factor", 2.16e6, "mm/min"};
inline constexpr Limit speed_factor_grease{"speed_factor", 1.62e6, "mm/min"};
inline constexpr double ceramic_speed_factor = 1.25;
/// Mean temperature of a ring. Greases and oils of spindles are chosen for up to about 80 °C at the
/// inner ring, and the life of a grease halves every 15 K above 70 °C (makers' rule, from memory).
inline constexpr Limit ring_temperature{"ring_temperature", 80.0, "C"};
/// Force between the sets over that as mounted. Source: the classes of [GMN4000]: the strong
/// preload is 6 times the light one and twice the medium one, so that at 3 times a spindle that was
/// mounted light runs at medium, and one mounted medium beyond every class.
inline constexpr Limit preload_factor{"preload_factor", 3.0, "times"};
/// Viscosity above which an oil hardly reaches the contacts. An oil at its pour point has about
/// 1e5 to 1e6 mm²/s [ASTM D97, from memory].
inline constexpr Limit oil_stiff{"stiff_oil", 1e5, "mm2/s"};
/// Temperature to which rings keep their size, and mineral oil its additives. Source: dimensional
/// stability S0 of bearing rings, 150 °C.
inline constexpr Limit oil_hot{"hot_oil", 150.0, "C"};
/// Interference over bore. Source: makers allow up to 1/1000 of the shaft diameter (from memory);
/// at 0.6/1000 the hoop stress of a ring reaches 127 MPa.
inline constexpr Limit interference{"interference", 1e-3, "of the diameter"};
/// Slope of the bending line, up to which a linear beam and linear seats hold. Ball bearings of
/// spindles stand misalignments of about 0.6 mrad (2 angular minutes, from memory).
inline constexpr Limit nose_slope{"nose_slope", 10.0, "mrad"};
/// Range of the friction table of a model, beyond which its edge holds.
inline constexpr Limit friction_table{"friction_table", unset, "Nmm"};

}  // namespace limits

/// A limit that an answer passes.
struct Finding {
  std::string_view limit;  ///< Limit::id
  bool is_warning = true;
  std::string place = {};                 ///< of a bearing on its shaft; empty for one on a rig
  double value = unset, allowed = unset;  ///< in `unit`, at the worst point
  std::string_view unit = {};
  double speed = unset;    ///< at the worst point [rad/s]; NaN as mounted
  std::size_t points = 1;  ///< beyond the limit
  std::string text = {};   ///< a line for people
};

using Findings = std::vector<Finding>;

/// A finding of one answer by itself, its text behind the place.
[[nodiscard]] Finding finding(const Limit& limit, double value, std::string text);

[[nodiscard]] std::vector<std::string> warnings_of(const Findings& findings);
[[nodiscard]] std::vector<std::string> notes_of(const Findings& findings);

/// One bearing at one point [SI]; NaN where a number is not known.
struct JudgedBearing {
  double axial_load = unset, radial_load = unset;
  double lost_balls = unset;
  double inner_pressure = unset, outer_pressure = unset;
  double least_inner_angle = unset, largest_inner_angle = unset;  ///< of the balls that touch
  double inner_ring_temperature = unset, outer_ring_temperature = unset;
};

/// Looks at points one by one and finds where balls have lost the inner race or do not lie against
/// the shoulders of an angular-contact bearing (bearing/seat.h), and where limits are passed: how
/// many points, and the worst.
class Judge {
 public:
  explicit Judge(const Model& model);

  /// `place` names the bearing on its shaft, empty for one on a rig; `point` is the one asked.
  void look(const bearing::Bearing& bearing, const std::string& place,
            const bearing::OperatingPoint& point, const JudgedBearing& state);
  /// Speed and lubricant of a bearing of which nothing else is looked at.
  void look_at_speed(double pitch_diameter, bool ceramic, const std::string& place,
                     const bearing::OperatingPoint& point);
  /// Looks at a bearing that turns beyond the friction table of its law, if the model has one.
  void look_at_table(const std::string& place, const bearing::OperatingPoint& point,
                     double axial_load, double radial_load);
  /// Forces of both sets compared with the mounted force [N].
  void look_at_preload(const bearing::OperatingPoint& point, double front_force, double rear_force,
                       double mounted);
  /// Looks at all that another judge of this model has seen.
  void add(const Judge& other);
  [[nodiscard]] Findings findings() const;

 private:
  struct Worst {
    std::size_t points = 0;
    double value = 0.0, limit = 0.0;
    bearing::OperatingPoint point = {};
    std::string place = {};
    void look(double value, double limit, const std::string& place,
              const bearing::OperatingPoint& point);
    void add(const Worst& other);
  };
  [[nodiscard]] std::string where(const Worst& worst) const;
  [[nodiscard]] std::string before(const Worst& worst) const;
  [[nodiscard]] Finding finding_of(const Limit& limit, const Worst& worst, double unit,
                                   std::string text, double offset = 0.0) const;
  void add_notes(Findings& findings) const;
  void add_speeds(Findings& findings) const;
  void add_heat(Findings& findings) const;

  const Model* model_;
  Worst lost_, load_, pressure_, bottom_, far_;
  Worst running_, catalogue_, speed_factor_, ring_, preload_, stiff_, hot_, table_;
  double stiff_below_;  ///< temperature at which the oil has its limit [K]
  double mounted_ = unset;
  std::size_t points_ = 0;
  std::size_t turning_ = 0;  ///< states of bearings that turn, under the law `table`
};

/// True for balls that are much lighter than the rings, as silicon nitride is.
[[nodiscard]] bool has_ceramic_balls(const bearing::Bearing& bearing);
/// True for such balls in the bearing of a model; false for rollers.
[[nodiscard]] bool has_ceramic_balls(const Model& model);

/// The range in which a number can be, and the reason for its ends.
struct Possible {
  double lower, upper;  ///< [SI]
  std::string why;      ///< ends a sentence
};

/// Speeds that a bearing's rings survive [rad/s]: the hoop stress ρ v² of the inner ring at its
/// raceway stays below 2 GPa, the strength of hardened bearing steel. Source: a thin turning ring,
/// derived.
[[nodiscard]] Possible possible_speeds(const Model& model);

/// Temperatures at which an oil is a liquid [K]: its viscosity stays below 1e7 mm²/s, thick as
/// pitch, where no oil flows into a contact.
[[nodiscard]] Possible possible_temperatures(const friction::Lubricant& lubricant);

/// Temperatures at which water is a liquid at the pressure of the air [K].
inline constexpr double water_freezes = celsius_zero, water_boils = celsius_zero + 100.0;

/// Interference over diameter at which the hoop stress E δ/d of a steel ring reaches its yield
/// strength, about 1 GPa [1].
inline constexpr double ring_yields = 0.005;

/// Hertz pressure that no bearing steel holds: the mean pressure, 2/3 of it, equals its hardness,
/// 60 HRC or about 7 GPa [Pa].
inline constexpr double steel_flows = 10.5e9;

/// Slope of a bending line beyond which no linear beam has a meaning [rad].
inline constexpr double beam_limit = 0.1;

}  // namespace raceway::model
