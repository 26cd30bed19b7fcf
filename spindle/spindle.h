#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "effects/spindle_condition.h"
#include "model/model.h"

/// The spindle that calls the bearings: temperatures, expansion, preload and friction together; the
/// beam on its bearings.
namespace raceway::spindle {

struct LoadedShaft;

/// End of a simulation.
enum class Status { not_run, converged, no_equilibrium, thermal_runaway, step_limit };

/// As files write it: "thermal_runaway".
[[nodiscard]] std::string_view name(Status status);
/// For people, a sentence.
[[nodiscard]] std::string_view words(Status status);

/// Conditions that a spindle runs under. NaN: as the model says.
struct Inputs {
  double speed = 0.0;                  ///< [rad/s], >= 0
  double ambient_temperature = unset;  ///< [K]
  double machine_temperature = unset;  ///< [K]
  double coolant_inlet = unset;        ///< [K]
  double motor_heat = unset;           ///< [W]
  double motor_power = unset;          ///< that the motor takes [W]
  double axial_load = 0.0;             ///< at the nose, positive towards the tool [N]
  double radial_load = 0.0;            ///< at the nose, in the direction of y [N]
  /// At the nose in the plane of y, in the sense of a force further in front [N m].
  double moment = 0.0;
  double belt_force = unset;  ///< [N]
  bool coolant_on = true;
  [[nodiscard]] bool operator==(const Inputs&) const = default;
};

/// A row of a speed programme: its inputs hold from the row before it to its time.
struct ProfileRow {
  double time = unset;  ///< [s], rising
  Inputs inputs = {};
};

/// One bearing on the shaft.
struct BearingState {
  double inner_ring_temperature = unset, outer_ring_temperature = unset;  ///< mean of a ring [K]
  double force = unset;                                                   ///< axial [N]
  double radial_force = unset;                                            ///< [N]
  double clearance = unset;  ///< s of a roller bearing, diametral; negative is a preload [m]
  double power = unset;      ///< of its friction [W]
  double power_band = 0.0;   ///< half width of the 95 % band of a friction table in it [W]
};

/// Heat balance [W]; heat that leaves is positive.
struct HeatBalance {
  double friction = 0.0;  ///< of all bearings
  /// Half width of the 95 % band of a friction table, which all bearings of the sets have in
  /// common.
  double friction_band = 0.0;
  double drive = 0.0;  ///< motor, drive, seals
  double coolant = 0.0, air = 0.0, machine = 0.0;
  double stored = 0.0;  ///< per second
};

/// A spindle at one moment.
struct Moment {
  double time = unset;          ///< [s]
  double displacement = unset;  ///< of the nose face against the flange, towards the tool [m]
  double kinematic_displacement = unset;  ///< what the sets alone move by at that speed, cold [m]
  double set_position = unset;            ///< of the front set, from its balance [m]
  double elongation = unset;              ///< of the shaft beyond the housing between the sets [m]
  double front_force = unset, rear_force = unset;  ///< [N]
  HeatBalance heat = {};
  std::vector<double> sources = {};         ///< heat of each of model::Spindle::heat [W]
  std::vector<BearingState> bearings = {};  ///< front set first, roller bearings last
  std::vector<double> sensors = {};         ///< [K], in the order of the model
  /// Temperature of what leaves the channel, T_in + 2 (T_mean - T_in), or stands in it; NaN without
  /// one [K].
  double coolant_outlet = unset;
  [[nodiscard]] double thermal_displacement() const {
    return displacement - kinematic_displacement;
  }
};

/// Temperatures of all cells, with which a simulation can go on.
struct State {
  double time = 0.0;                 ///< [s]
  double structure_time = 0.0;       ///< since the machine began to drift [s]
  std::vector<double> temperatures;  ///< [K]
};

struct Report {
  Status status = Status::not_run;
  int steps = 0, rejected = 0;
  double energy_error = unset;  ///< stored less what came in, of the turnover; worst step [1]
  std::string message = {};     ///< where and why it ended early
  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

/// A run through a speed programme. Where it ended early, `moments` are those before.
struct Run {
  std::vector<Moment> moments = {};    ///< one for each row of the programme
  bool has_end = false;                ///< the last moment is the early end, see add_end()
  std::vector<double> step_ends = {};  ///< of the time steps [s]
  State end = {};
  std::vector<State> kept = {};  ///< those that were asked for and reached
  Report report = {};
  double highest_front_force = 0.0;      ///< over all steps [N]
  double time_of_highest_force = unset;  ///< [s]
};

/// A cell of the axisymmetric mesh, for pictures.
struct FieldCell {
  std::string_view part;                              ///< "shaft", "ring", "housing", "coolant"
  double start = unset, end = unset;                  ///< behind the nose face [m]
  double inner_radius = unset, outer_radius = unset;  ///< [m]
  double temperature = unset;                         ///< [K]
};

/// A seat of a ring, at speed and warm.
struct SeatState {
  double pressure = unset;     ///< [Pa]; 0 where it is loose, NaN where its conductance is given
  double gap = unset;          ///< radial, of a loose one [m]
  double conductance = unset;  ///< of spots that touch and air [W/(m² K)]
};
/// The inner ring on the shaft, the outer one in the housing.
struct SeatsOfBearing {
  SeatState inner, outer;
};

/// A place of the shaft, and how far it has moved along the axis against the flange.
struct ShaftPlace {
  double position = unset;      ///< behind the nose face [m]
  double displacement = unset;  ///< towards the tool [m]
};

/// A spindle made ready to be simulated: cells, conductances, sets as mounted. Not for several
/// threads at once; a copy for each is cheap.
class Simulator {
 public:
  /// With the effects that the model has switched on. Throws std::invalid_argument for a model that
  /// is no spindle, or one that cannot be mounted or meshed: name, value with unit, allowed range.
  explicit Simulator(const model::Model& model);
  /// As above, with this in place of what effects change of the spindle.
  Simulator(const model::Model& model, const effects::SpindleCondition& condition);
  Simulator(const Simulator&);
  Simulator(Simulator&&) noexcept;
  ~Simulator();

  /// Looked at before every step: where it is set, simulate() and steady() throw fit::Cancelled.
  /// Copies look at it too. Null: no check.
  void stop_on(const std::atomic<bool>* cancelled);
  /// From `start`, or from the ambient temperature throughout. `step_ends`: the ends of steps of
  /// another run of this programme, taken as they are; fits so see no other steps as parameters
  /// change. `keep`: rising times [s], of each the state at the end of the first step that reaches
  /// it is kept.
  [[nodiscard]] Run simulate(std::span<const ProfileRow> profile, const State* start = nullptr,
                             std::span<const double> step_ends = {},
                             std::span<const double> keep = {});
  /// The state to which these inputs lead.
  [[nodiscard]] Moment steady(const Inputs& inputs, Report& report);
  /// Temperatures of the last call.
  [[nodiscard]] const State& state() const;
  /// The sets at the end of the last call; null in a network.
  [[nodiscard]] const bearing::ArrangementEquilibrium* sets() const;
  /// The sets as mounted; null in a network.
  [[nodiscard]] const bearing::Arrangement* arrangement() const;
  /// The shaft bent there, as the friction of its bearings knows it; null in a network, and where
  /// nothing pushes across a shaft without roller bearings.
  [[nodiscard]] const LoadedShaft* shaft() const;
  /// Conditions of the sets there; null in a network.
  [[nodiscard]] const bearing::ArrangementCondition* sets_condition() const;
  /// Seats at the end of the last call, in the order of Moment::bearings; none in a network.
  [[nodiscard]] std::vector<SeatsOfBearing> seats() const;
  /// The shaft from its nose to its rear end at the end of the last call, which ended in `moment`;
  /// none in a network.
  [[nodiscard]] std::vector<ShaftPlace> along_shaft(const Moment& moment) const;
  [[nodiscard]] std::vector<FieldCell> field(const State& state) const;
  [[nodiscard]] std::size_t cells() const;

 private:
  struct Parts;
  class Passage;
  std::unique_ptr<Parts> parts_;
};

}  // namespace raceway::spindle
