#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "tests/hidden_effect/physics.h"

/// Where files and rig differ, by formulas of its own.
namespace hidden_effect {

using Random = std::mt19937_64;

inline double normal(Random& random) { return std::normal_distribution<double>()(random); }

/// What stands otherwise in the files than on the rig.
struct Mistake {
  double viscosity_40 = 0.0, viscosity_100 = 0.0;  ///< of the card [mm2/s]; 0: the oil's
  double rise_seen = 1.0;       ///< share of the film's rise above 24 C that the sensor sees
  double sensor_offset = 0.0;   ///< [K]
  double sensor_scatter = 0.0;  ///< standard deviation from row to row [K]
  bool runs_left_out = false;   ///< no run_id
  bool std_declared = false;    ///< std_Nmm of every row, and it is right
  bool in_fahrenheit = false;   ///< temperatures, in the column of degrees Celsius
  bool in_kilograms = false;    ///< axial loads, in the column of newtons
  bool clock_left_out = false;  ///< no time_s
  double pair_preload = 0.0;    ///< of the pair in O that shares the load [N]; 0: one bearing
  bool preload_grows = false;   ///< the rings keep their distance as the balls press outwards
  double cell_drift = 0.0;      ///< of the true load above that of the cell [1/K above 22 C]
  /// What the bearings that carry the shaft add to the reading, of the rms torque: a constant, and
  /// a part that grows with the square root of the speed up to the highest.
  double support_constant = 0.0, support_viscous = 0.0;
  double creep = 0.0;       ///< of the sensor's zero over a day, anew each day, of the rms torque
  double reset = 0.0;       ///< scatter of the zero that is set before each run, of the rms torque
  double hysteresis = 0.0;  ///< between rising and falling speed, of the rms torque
  /// A second record of the same plan follows, with the oil of another grade; f0 and z are left to
  /// each record.
  bool second_oil = false;
};

struct Reading {
  Point point;
  int run;
  double torque;    ///< without noise [N mm]
  double sigma;     ///< standard deviation of the noise of this row [N mm]
  double measured;  ///< [N mm]
  double seen;      ///< temperature by the sensor [C]
};

/// Torque of all bearings that the sensor feels at the load that they really carry [N mm].
[[nodiscard]] double torque_of_rig(const Bearing& bearing, const BaseLaw& law,
                                   const Mistake& mistake, const Point& point,
                                   std::span<const Hidden> hidden);

/// Root mean square of the torques without noise [N mm].
[[nodiscard]] double rms_torque(std::span<const Reading> rows);

/// Share of a day of measuring that has passed at a time [s].
[[nodiscard]] double share_of_day(double time);

/// Adds what reading and zero of the sensor have beside the torque.
void misread_torques(const Mistake& mistake, std::uint64_t seed, std::vector<Reading>& rows);

/// Fills in the temperatures as the sensor reads them.
void read_temperatures(const Mistake& mistake, bool logger, Random& random,
                       std::vector<Reading>& rows);

}  // namespace hidden_effect
