#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bearing/bearing.h"
#include "bearing/operating_point.h"
#include "model/model.h"

/// Compares results with limits of engineering practice, and reports exceeded limits.
/// docs/limits.md lists all limits.
namespace raceway::model {

/// A limit that a result should not exceed. A warning recommends a change of the design or the
/// operating point. A note only informs.
struct Limit {
  std::string_view id;     ///< id in JSON documents
  double value;            ///< limit in `unit`; NaN if the limit depends on the bearing
  std::string_view unit;   ///< unit of the limit in texts and JSON documents
  bool is_warning = true;  ///< true: warning; false: note
};

namespace limits {

/// Largest static equivalent load: the static load rating C0, for a static safety factor of 1
/// [ISO76].
inline constexpr Limit static_load{"static_load", unset, "N", false};
/// Contact pressure that causes a permanent deformation of 1e-4 ball diameters [ISO76].
inline constexpr Limit static_pressure{"static_pressure", 4.2, "GPa", false};
/// Largest Hertz pressure in the contacts of a rotating bearing. Makers of spindle bearings give
/// 2000 MPa as the limit below which their bearings do not fatigue (not checked in a printed
/// source). The pressure at the fatigue load limit of [ISO281, annex B] is 1500 MPa.
inline constexpr Limit running_pressure{"running_pressure", 2.0, "GPa"};
/// Speed limit that the maker's catalogue gives for a single bearing with spring preload. Source:
/// [GMN4000]. With balls of silicon nitride, the limit is 1.25 times the catalogue speed [GMN speed
/// factors].
inline constexpr Limit catalogue_speed{"catalogue_speed", unset, "rpm"};
/// Speed factor n d_m (speed times pitch diameter) of the fastest bearings with steel balls in
/// [GMN4000]. The bearing KH 6014 C with d_m = 90 mm reaches 24 000 rpm with oil-air and 18 000 rpm
/// with grease. Balls of silicon nitride allow 1.25 times this speed factor.
inline constexpr Limit speed_factor{"speed_factor", 2.16e6, "mm/min"};
inline constexpr Limit speed_factor_grease{"speed_factor", 1.62e6, "mm/min"};
inline constexpr double ceramic_speed_factor = 1.25;
/// Largest mean temperature of a ring. Spindle greases and oils are selected for up to about 80 °C
/// at the inner ring. The life of a grease halves for every 15 K above 70 °C (makers' rule, not
/// checked in a printed source).
inline constexpr Limit ring_temperature{"ring_temperature", 80.0, "C"};
/// Largest ratio of the preload in operation to the mounted preload. The preload in operation is
/// the axial force of the less loaded set. Source: preload classes of [GMN4000], in which the
/// strong preload is 6 times the light preload and twice the medium preload. At a ratio of 3, light
/// preload becomes medium preload, and medium preload becomes higher than strong preload.
inline constexpr Limit preload_factor{"preload_factor", 3.0, "times"};
/// Smallest axial load of a rotating bearing: bearing::minimum_load().
inline constexpr Limit minimum_load{"minimum_load", unset, "N", false};
/// Viscosity above which little oil reaches the contacts. An oil at its pour point [ASTM D97] has
/// about 1e5 to 1e6 mm²/s (not checked in a printed source).
inline constexpr Limit oil_stiff{"stiff_oil", 1e5, "mm2/s"};
/// Temperature up to which rings are dimensionally stable and the additives of mineral oil remain
/// effective. Source: bearing rings of the stabilisation class S0 are dimensionally stable up to
/// 150 °C.
inline constexpr Limit oil_hot{"hot_oil", 150.0, "C"};
/// Largest ratio of interference to bore. Source: makers allow up to 1/1000 of the shaft diameter
/// (not checked in a printed source). At 1/1000, the hoop stress of a steel ring is about 0.2 GPa.
inline constexpr Limit interference{"interference", 1e-3, "of the diameter"};
/// Largest slope of the bending line at the nose. At a larger slope, the deflections are no longer
/// proportional to the load. The limit of 10 mrad is also far above the permissible tilt of spindle
/// ball bearings, 0.6 mrad or 2 angular minutes (not checked in a printed source).
inline constexpr Limit nose_slope{"nose_slope", 10.0, "mrad"};
/// Range of speeds, loads and temperatures that the torque table of a model covers. Outside this
/// range, the program uses the torque at the edge of the table.
inline constexpr Limit friction_table{"friction_table", unset, "Nmm"};

}  // namespace limits

/// A limit that a result exceeds.
struct Finding {
  std::string_view limit;  ///< id of the limit that is exceeded
  bool is_warning = true;
  std::string place = {};                 ///< name of the bearing; empty for a rig
  double value = unset, allowed = unset;  ///< result and limit at the worst point, in `unit`
  std::string_view unit = {};
  double speed = unset;    ///< speed at the worst point [rad/s]; NaN: not given
  std::size_t points = 1;  ///< number of operating points beyond the limit
  std::string text = {};   ///< one line of text that describes the finding
};

using Findings = std::vector<Finding>;

/// Makes a finding for a `value` above the limit. `value` has the unit of the limit.
[[nodiscard]] Finding finding(const Limit& limit, double value, std::string text);

[[nodiscard]] std::vector<std::string> warnings_of(const Findings& findings);
[[nodiscard]] std::vector<std::string> notes_of(const Findings& findings);

/// Results of one bearing at one operating point [SI]; NaN for unknown values.
struct JudgedBearing {
  double axial_load = unset, radial_load = unset;
  double minimum_load = unset;  ///< minimum axial load at this speed
  double lost_balls = unset;    ///< number of balls without contact to the inner race
  double inner_pressure = unset, outer_pressure = unset;
  /// Smallest and largest contact angle at the inner ring, of the balls in contact [rad].
  double least_inner_angle = unset, largest_inner_angle = unset;
  double inner_ring_temperature = unset, outer_ring_temperature = unset;
};

/// Compares operating points with the limits. Call look() for each bearing at each operating point.
/// For each exceeded limit, the class stores the number of operating points beyond the limit and
/// the worst of these points. In addition, the class reports balls without contact to the inner
/// race. In an angular-contact bearing, the class also reports balls that run at the bottom of the
/// inner groove or on the side without a shoulder (bearing/seat.h).
class Judge {
 public:
  explicit Judge(const Model& model);

  /// Compares one bearing at one operating point with the limits. `place` names the bearing on its
  /// shaft and is empty for a rig.
  void look(const bearing::Bearing& bearing, const std::string& place,
            const bearing::OperatingPoint& point, const JudgedBearing& state);
  /// Compares only speed and lubricant temperature with their limits.
  void look_at_speed(double pitch_diameter, bool ceramic, const std::string& place,
                     const bearing::OperatingPoint& point);
  /// Compares only the ring temperatures with their limit, for a roller bearing of a spindle.
  void look_at_rings(const std::string& place, const bearing::OperatingPoint& point,
                     double inner_ring_temperature, double outer_ring_temperature);
  /// Checks if the operating point of a rotating bearing is outside the range of the friction
  /// table. Does nothing if the friction law is not `table`.
  void look_at_table(const std::string& place, const bearing::OperatingPoint& point,
                     double axial_load, double radial_load);
  /// Compares the preload in operation with the preload `mounted` [N]. The preload in operation is
  /// the smaller axial force of the two sets.
  void look_at_preload(const bearing::OperatingPoint& point, double front_force, double rear_force,
                       double mounted);
  /// Adds the operating points that another object for this model has compared with the limits.
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
  Worst lost_, little_load_, load_, pressure_, bottom_, far_;
  Worst running_, catalogue_, speed_factor_, ring_, preload_, stiff_, hot_, table_;
  double stiff_below_;  ///< temperature at which the oil reaches its viscosity limit [K]
  double mounted_ = unset;
  std::size_t points_ = 0;
  std::size_t turning_ = 0;  ///< number of states of rotating bearings with the law `table`
};

/// Returns true if the density of the balls is below 0.7 times the density of the rings, as for
/// balls of silicon nitride.
[[nodiscard]] bool has_ceramic_balls(const bearing::Bearing& bearing);
/// Returns true if the model has ceramic balls; false for rollers.
[[nodiscard]] bool has_ceramic_balls(const Model& model);

/// Physically possible range of a value, with the reason for its limits.
struct Possible {
  double lower, upper;  ///< [SI]
  std::string why;      ///< reason, worded for the end of a message
};

/// Returns the range of speeds that the rings of a bearing can withstand [rad/s]. In this range,
/// the hoop stress ρ v² of the inner ring is below 2 GPa, the strength of hardened bearing steel. ρ
/// is the density, and v is the circumferential speed of the raceway. Source: thin rotating ring,
/// derived.
[[nodiscard]] Possible possible_speeds(const Model& model);

/// Returns the range of possible oil temperatures [K]. At the lower limit, the oil has a viscosity
/// of 1e7 mm²/s and is practically solid. The upper limit is 800 K.
[[nodiscard]] Possible possible_temperatures(const friction::Lubricant& lubricant);

/// Freezing and boiling temperature of water at atmospheric pressure [K].
inline constexpr double water_freezes = celsius_zero, water_boils = celsius_zero + 100.0;

/// Ratio of interference δ to diameter d at which the hoop stress E δ/d of a steel ring reaches the
/// yield strength of about 1 GPa [1]. E is the elastic modulus.
inline constexpr double ring_yields = 0.005;

/// Maximum Hertz pressure at which the mean pressure, 2/3 of the maximum, equals the hardness of
/// bearing steel, about 7 GPa at 60 HRC [Pa]. No bearing steel withstands this pressure.
inline constexpr double steel_flows = 10.5e9;

/// Slope of a bending line above which linear beam theory is not valid [rad].
inline constexpr double beam_limit = 0.1;

}  // namespace raceway::model
