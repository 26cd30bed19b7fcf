#pragma once

#include <atomic>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "effects/spindle_condition.h"
#include "model/model.h"

/// Simulates a spindle with its bearings: temperatures, expansion, preload and friction together,
/// and the bending of the shaft.
namespace raceway::spindle {

struct LoadedShaft;

/// Outcome of a simulation.
enum class Status { not_run, converged, no_equilibrium, thermal_runaway, step_limit };

/// Returns the name in files: "thermal_runaway".
[[nodiscard]] std::string_view name(Status status);
/// Returns the status as readable text: "the sets have no equilibrium".
[[nodiscard]] std::string_view words(Status status);

/// Operating conditions of a spindle. NaN means the value of the model, unless stated otherwise.
struct Inputs {
  double speed = 0.0;                  ///< [rad/s], >= 0
  double ambient_temperature = unset;  ///< [K]
  double machine_temperature = unset;  ///< [K]
  double coolant_inlet = unset;        ///< [K]
  double motor_heat = unset;           ///< [W]
  double motor_power = unset;          ///< electrical input of the motor [W]; NaN: not given
  double axial_load = 0.0;             ///< load at the nose, positive towards the tool [N]
  double radial_load = 0.0;            ///< load at the nose in the direction of y [N]
  /// Moment at the nose in the plane of y [N m]. The moment is positive if it turns the shaft like
  /// a positive force in front of the nose.
  double moment = 0.0;
  double belt_force = unset;  ///< [N]
  bool coolant_on = true;
  [[nodiscard]] bool operator==(const Inputs&) const = default;
};

/// A row of a speed programme. The inputs of a row are valid from the time of the previous row to
/// the time of the row.
struct ProfileRow {
  double time = unset;  ///< [s], rising
  Inputs inputs = {};
};

/// State of one bearing on the shaft.
struct BearingState {
  /// mean temperature of the ring [K]
  double inner_ring_temperature = unset, outer_ring_temperature = unset;
  double force = unset;         ///< axial force [N]
  double radial_force = unset;  ///< [N]
  double clearance = unset;     ///< diametral clearance of a roller bearing; negative: preload [m]
  double power = unset;         ///< friction loss of the bearing [W]
  double power_band = 0.0;      ///< half width of the 95 % band from a friction table [W]
};

/// Heat balance [W]. Heat that leaves the spindle is positive.
struct HeatBalance {
  double friction = 0.0;  ///< friction of all bearings
  /// Half width of the 95 % band from a friction table. The errors of all bearings of the sets are
  /// taken as fully correlated.
  double friction_band = 0.0;
  double drive = 0.0;  ///< heat of motor, drive and seals
  double coolant = 0.0, air = 0.0, machine = 0.0;
  double stored = 0.0;  ///< stored heat per second
};

/// State of a coolant circuit.
struct CircuitState {
  double inlet = unset;   ///< [K]
  double outlet = unset;  ///< temperature at the outlet, or of standing coolant [K]
  double heat = 0.0;      ///< heat that the flow removes [W]
};

/// State of a spindle at one moment.
struct Moment {
  double time = unset;          ///< [s]
  double displacement = unset;  ///< displacement of the nose face relative to the flange, positive
                                ///< towards the tool [m]
  double kinematic_displacement = unset;  ///< displacement of the cold sets alone at this speed [m]
  double set_position = unset;  ///< change of the shaft position in the sets since rest [m]
  /// Elongation of the shaft between the sets, relative to the housing [m].
  double elongation = unset;
  double front_force = unset, rear_force = unset;  ///< [N]
  HeatBalance heat = {};
  std::vector<double> sources = {};         ///< heat of each source in model::Spindle::heat [W]
  std::vector<BearingState> bearings = {};  ///< front set first, roller bearings last
  std::vector<double> sensors = {};         ///< [K], in the order of the model
  /// Temperature of the coolant at the outlet, T_in + 2 (T_mean - T_in), or of standing coolant
  /// [K]; NaN without coolant.
  double coolant_outlet = unset;
  std::vector<CircuitState> circuits = {};  ///< in the order of model::Spindle::channels()
  [[nodiscard]] double thermal_displacement() const {
    return displacement - kinematic_displacement;
  }
};

/// Temperatures of all cells, from which a simulation can continue.
struct State {
  double time = 0.0;                 ///< [s]
  double structure_time = 0.0;       ///< time since the machine temperature began to drift [s]
  std::vector<double> temperatures;  ///< [K]
};

struct Report {
  Status status = Status::not_run;
  int steps = 0, rejected = 0;
  /// error of the heat balance in the worst step: stored heat minus supplied heat, relative to the
  /// heat that the spindle receives and gives off [1]
  double energy_error = unset;
  std::string message = {};  ///< reason for an early end
  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

/// Result of a speed programme. After an early end, `moments` contains the rows before the end.
struct Run {
  std::vector<Moment> moments = {};    ///< one for each row of the programme
  bool has_end = false;                ///< true if the last moment is the early end, see add_end()
  std::vector<double> step_ends = {};  ///< ends of the time steps [s]
  State end = {};
  std::vector<State> kept = {};  ///< requested states that were reached
  Report report = {};
  double highest_front_force = 0.0;      ///< largest force of the front set over all steps [N]
  double time_of_highest_force = unset;  ///< [s]
};

/// A cell of the axisymmetric mesh, for plots.
struct FieldCell {
  /// Body of the cell: "shaft", "ring" (a bearing ring or a spacer) or "housing".
  std::string_view part;
  double start = unset, end = unset;                  ///< distance behind the nose face [m]
  double inner_radius = unset, outer_radius = unset;  ///< [m]
  double temperature = unset;                         ///< [K]
};

/// State of the seat of a ring at speed and temperature.
struct SeatState {
  double pressure = unset;     ///< [Pa]; 0 for a loose seat, NaN if its conductance is given
  double gap = unset;          ///< radial gap of a loose seat [m]
  double conductance = unset;  ///< conductance of contact spots and air together [W/(m² K)]
};
/// Seats of the inner ring on the shaft and of the outer ring in the housing.
struct SeatsOfBearing {
  SeatState inner, outer;
};

/// State of a joint or a surface of the spindle; SeatsOfBearing has the seats of the rings.
struct SurfaceState {
  std::string name;
  double area = unset;         ///< [m²]
  double conductance = unset;  ///< heat transfer coefficient, mean over the area [W/(m² K)]
  double pressure = unset;     ///< [Pa]; NaN for a surface, and for a joint with given conductance
  /// Heat that leaves the spindle, crosses the gap to the housing, or flows from a clamped ring to
  /// its neighbour [W]; NaN for shoulders and collars.
  double heat = unset;
};

/// Position on the shaft with its axial displacement relative to the flange.
struct ShaftPlace {
  double position = unset;      ///< distance behind the nose face [m]
  double displacement = unset;  ///< positive towards the tool [m]
};

/// Stress at a radius, positive in tension [Pa].
struct Stress {
  double radius = unset;                               ///< [m]
  double axial = unset, hoop = unset, radial = unset;  ///< [Pa]
  [[nodiscard]] double von_mises() const {
    const double a = axial - hoop, b = hoop - radial, c = radial - axial;
    return std::sqrt(0.5 * (a * a + b * b + c * c));
  }
};

/// Stress of the shaft or of a ring in one column of cells.
struct SectionStress {
  enum class Part { shaft, inner_ring, outer_ring } part = Part::shaft;
  int bearing = -1;  ///< bearing of the ring or of the seat on the shaft; -1: shaft elsewhere
  double start = unset, end = unset;  ///< distance behind the nose face [m]
  std::vector<Stress> at = {};        ///< from the bore to the surface
  /// Returns the stress at the radius of the largest von Mises stress.
  [[nodiscard]] const Stress& largest() const;
};

/// A spindle prepared for simulation: cells, conductances and mounted sets. Several threads must
/// not use one object simultaneously; copies are cheap.
class Simulator {
 public:
  /// Includes the effects that the model has switched on. Throws std::invalid_argument for a model
  /// that is not a spindle or that cannot be mounted or meshed; the message has name, value with
  /// unit and allowed range.
  explicit Simulator(const model::Model& model);
  /// Uses `condition` in place of the effects of the model on the spindle.
  Simulator(const model::Model& model, const effects::SpindleCondition& condition);
  Simulator(const Simulator&);
  Simulator(Simulator&&) noexcept;
  ~Simulator();

  /// Sets a flag that is checked before every step: when it becomes true, simulate() and steady()
  /// throw fit::Cancelled. Copies of this object also check the flag. Null switches the check off.
  void stop_on(const std::atomic<bool>* cancelled);
  /// Simulates from `start` or, without it, from the ambient temperature in all cells. `step_ends`
  /// gives the ends of all steps, from another run of this programme. With it, step sizes do not
  /// change with the parameters of a fit. `keep` lists increasing times [s]. For each time, the
  /// result has the state at the end of the first step that reaches the time.
  [[nodiscard]] Run simulate(std::span<const ProfileRow> profile, const State* start = nullptr,
                             std::span<const double> step_ends = {},
                             std::span<const double> keep = {});
  /// Finds the steady state for these inputs.
  [[nodiscard]] Moment steady(const Inputs& inputs, Report& report);
  /// Returns the temperatures of the last call.
  [[nodiscard]] const State& state() const;
  /// Returns the equilibrium of the sets at the end of the last call; null for a network.
  [[nodiscard]] const bearing::ArrangementEquilibrium* sets() const;
  /// Returns the sets as mounted; null for a network.
  [[nodiscard]] const bearing::Arrangement* arrangement() const;
  /// Returns the bent shaft of the last call. The bearing friction is computed with this shaft. The
  /// result is null for a network, and for a shaft without radial loads and roller bearings.
  [[nodiscard]] const LoadedShaft* shaft() const;
  /// Returns the conditions of the sets in the last call; null for a network.
  [[nodiscard]] const bearing::ArrangementCondition* sets_condition() const;
  /// Returns the seats at the end of the last call, in the order of Moment::bearings; empty for a
  /// network.
  [[nodiscard]] std::vector<SeatsOfBearing> seats() const;
  /// Returns joints and surfaces at the end of the last call; empty for a network.
  [[nodiscard]] std::vector<SurfaceState> surfaces() const;
  /// Returns the displacement along the shaft, from nose to rear end, at the end of the last call.
  /// `moment` must be the result of that call. The list is empty for a network.
  [[nodiscard]] std::vector<ShaftPlace> along_shaft(const Moment& moment) const;
  /// Returns the stresses of shaft and rings at the end of the last call, which must have had this
  /// speed. The list is empty for a network.
  [[nodiscard]] std::vector<SectionStress> stresses(double speed) const;
  [[nodiscard]] std::vector<FieldCell> field(const State& state) const;
  [[nodiscard]] std::size_t cells() const;

 private:
  struct Parts;
  class Passage;
  std::unique_ptr<Parts> parts_;
};

}  // namespace raceway::spindle
