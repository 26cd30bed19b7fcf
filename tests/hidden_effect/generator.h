#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/hidden_effect/mistakes.h"

/// Measurements of rigs of which the truth is known: what the user believes, what the rig reads,
/// and what really goes on.
namespace hidden_effect {

enum class Plan {
  factorial,     ///< 6 speeds x 4 loads x 5 temperatures
  run_up,        ///< 10 speeds x 4 loads x 3, the oil warms with speed and load
  sweep,         ///< 24 speeds x 5 at one load and temperature
  replicated,    ///< 5 speeds x 4 loads x 3 temperatures x 2
  run_per_load,  ///< factorial, the rows of one load after the other: a run each
  run_ups,       ///< three runs of 10 rising speeds for each load, in random order
  in_order,      ///< run-up, speeds rising in time within each load, one run
  radial,        ///< 6 speeds x 4 axial loads x 5 radial loads at 40 C
  cycling,       ///< 20 000 rows that cycle through 5 speeds
  stairs,        ///< at each of 4 loads 9 rising speeds, the oil warms with speed; twice
  one_stairs,    ///< the same once
  up_and_down,   ///< at each of 4 loads 9 rising speeds and the same falling
  lab            ///< 6 loads, at each 12 rising speeds in one run; the oil warms with the speed
};

/// The base law of the model that the user has.
enum class Believed {
  as_it_is,  ///< that of the rig, of a formula for the bearing as a whole Palmgren's
  palmgren,
  skf,
  contacts
};

enum class Noise {
  independent,     ///< 2 % of the torque
  run_offsets,     ///< the same, and 2 % common to the ten rows of a run
  autoregressive,  ///< 2 %, correlated 0.8 from row to row
  absolute,        ///< 1 % of the torque and 2 % of its rms
  outliers         ///< 2 %, and 5 % of the rows off by 6 to 15 sigma
};

[[nodiscard]] std::string_view name(Plan plan);
[[nodiscard]] std::string_view name(Noise noise);

/// Bearings of spindles; count, diameters and C0 of makers' catalogues.
[[nodiscard]] std::span<const Machine> machines();

/// How far noise goes beyond a rig that is run well.
struct NoiseDetail {
  double level = 0.02;          ///< of the torque
  double offset = 0.02;         ///< common to a run, of the torque
  double correlation = 0.8;     ///< from row to row
  double outlier_share = 0.05;  ///< of the rows
  bool one_sided = false;       ///< outliers read too much
  /// At the lowest speed of a plan, of the torque, where the level is that at the highest: with a
  /// power of the speed between them, or in a straight line.
  double at_lowest = 0.0;
  bool straight = false;
};

/// A logger that writes rows all the time while the rig stands at each point of the plan.
struct Logger {
  int rows = 0;                ///< of each point; 0: a row for each
  double row_scatter = 0.01;   ///< of the torque, from row to row
  double correlation = 15.0;   ///< time of the same [s]; 0: none
  double point_scatter = 0.0;  ///< of the torque, common to the rows of a point
  double warming = 0.0;        ///< of the oil while the rig stands at a point [K]
};

struct Wish {
  std::string_view id;
  double share = 0.1;  ///< rms of what the effect changes over rms torque of the base law
};

struct Setup {
  const Machine* machine = nullptr;
  Plan plan = Plan::factorial;
  Noise noise = Noise::independent;
  NoiseDetail detail{};
  Logger logger{};
  int rows = 0;  ///< of the plan, chosen at random; 0: all
  Mistake mistake{};
  BaseLaw law{};  ///< with another viscous_exponent and y: a base law that is slightly wrong
  std::vector<Wish> hidden{};
  Believed believed = Believed::as_it_is;
  std::uint64_t seed = 1;
};

struct Rig {
  Setup setup;
  Bearing bearing;
  std::vector<Hidden> hidden;
  std::vector<double> shares;  ///< reached by each hidden effect; below the wish at a limit
  std::vector<Reading> train, test;
  std::size_t second_record = 0;  ///< row of `train` with which it begins; 0: there is one record

  /// Ids by which an answer is right: of the hidden effects, and of those that have their shape.
  [[nodiscard]] std::vector<std::string_view> accepted() const;
  /// The same for one of the hidden effects.
  [[nodiscard]] std::vector<std::string_view> accepted(std::size_t hidden_index) const;
};

/// The seed decides noise, order, jitter of the temperatures and, where both are possible, the sign
/// of an effect. Everything but these follows from the setup.
[[nodiscard]] Rig make_rig(const Setup& setup);

/// The bearing with the oil that it has in the second record.
[[nodiscard]] Bearing bearing_of_second_record(const Setup& setup);

/// More readings of the same rig in runs of ten, independent noise.
[[nodiscard]] std::vector<Reading> measure(const Rig& rig, std::span<const Point> points,
                                           std::uint64_t seed);

/// Of the numbers of a law that the user leaves free, as the rig really has them: f0 and z, or the
/// rolling factor of the contacts.
[[nodiscard]] std::vector<double> free_values(const BaseLaw& law);

[[nodiscard]] std::string model_text(const Rig& rig);
[[nodiscard]] std::string measurement_text(const Rig& rig, std::span<const Reading> readings);
[[nodiscard]] std::string truth_text(const Rig& rig);

}  // namespace hidden_effect
