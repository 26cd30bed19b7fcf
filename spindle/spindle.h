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

/// Simulates a spindle with its bearings. The simulation couples temperatures, thermal expansion,
/// preload, friction and shaft bending.
namespace raceway::spindle {

struct LoadedShaft;

/// Outcome of a simulation.
enum class Status { not_run, converged, no_equilibrium, thermal_runaway, step_limit };

/// Returns the name of the status in result files, such as "thermal_runaway".
[[nodiscard]] std::string_view name(Status status);
/// Returns the status in words, such as "the bearing sets have no equilibrium".
[[nodiscard]] std::string_view words(Status status);

/// Operating conditions of a spindle. If a temperature, the motor heat or the belt force is NaN,
/// the simulation uses the value in the model. Speed and loads at the nose must not be NaN.
struct Inputs {
  double speed = 0.0;                  ///< [rad/s], >= 0
  double ambient_temperature = unset;  ///< [K]
  double machine_temperature = unset;  ///< temperature of the machine at the flange [K]
  /// Inlet temperature of the first coolant circuit, and of circuits without an inlet temperature
  /// in the model [K].
  double coolant_inlet = unset;
  double motor_heat = unset;   ///< heat that the motor releases in the spindle [W]
  double motor_power = unset;  ///< electrical power of the motor [W]; NaN if unknown
  double axial_load = 0.0;     ///< load at the nose, positive towards the tool [N]
  double radial_load = 0.0;    ///< load at the nose in the direction of y [N]
  /// Moment at the nose [N m]. A positive moment bends the shaft in the same plane and direction as
  /// a positive radial force in front of the nose.
  double moment = 0.0;
  double belt_force = unset;  ///< force of the belt on the shaft [N]
  bool coolant_on = true;
  [[nodiscard]] bool operator==(const Inputs&) const = default;
};

/// Row of a speed programme. The inputs of a row apply from the time of the previous row to the
/// time of this row.
struct ProfileRow {
  double time = unset;  ///< time [s]; increases from row to row
  Inputs inputs = {};
};

/// Temperatures, forces, clearance and friction of one bearing on the shaft.
struct BearingState {
  /// Mean temperature of the ring [K].
  double inner_ring_temperature = unset, outer_ring_temperature = unset;
  double force = unset;         ///< axial force [N]
  double radial_force = unset;  ///< [N]
  /// Diametral clearance [m]; NaN for ball bearings. A negative value means preload.
  double clearance = unset;
  double power = unset;  ///< friction loss of the bearing [W]
  /// Half width of the 95 % error band of `power` [W]; 0 unless the bearing uses the friction law
  /// `table` with an error band.
  double power_band = 0.0;
};

/// Heat balance of the spindle [W]. Heat to coolant, air and machine is positive if it leaves the
/// spindle.
struct HeatBalance {
  double friction = 0.0;  ///< friction of all bearings
  /// Half width of the 95 % error band of `friction`; 0 unless the bearings use the friction law
  /// `table` with an error band. The friction errors of all bearings are assumed to be fully
  /// correlated.
  double friction_band = 0.0;
  double drive = 0.0;  ///< heat of all sources except bearing friction
  double coolant = 0.0, air = 0.0, machine = 0.0;
  double stored = 0.0;  ///< heat flow that is stored in the spindle
};

/// Temperatures and heat flow of a coolant circuit.
struct CircuitState {
  double inlet = unset;   ///< [K]
  double outlet = unset;  ///< outlet temperature [K]; without flow: mean coolant temperature
  double heat = 0.0;      ///< heat that the coolant flow removes [W]
};

/// Displacements, forces, heat flows and temperatures of a spindle at one time.
struct Moment {
  double time = unset;  ///< [s]
  /// Displacement of the nose face relative to the flange, positive towards the tool [m].
  double displacement = unset;
  /// Displacement [m] that the shaft would have with cold bearing sets at this speed and axial
  /// load, relative to cold standstill.
  double kinematic_displacement = unset;
  /// Axial displacement of the shaft in its bearing sets, relative to cold standstill [m].
  double set_position = unset;
  /// Thermal elongation of the shaft minus the elongation of the housing between the centres of the
  /// two bearing sets [m].
  double elongation = unset;
  double front_force = unset, rear_force = unset;  ///< axial force of each bearing set [N]
  HeatBalance heat = {};
  std::vector<double> sources = {};         ///< heat of each source in model::Spindle::heat [W]
  std::vector<BearingState> bearings = {};  ///< in the order front set, rear set, roller bearings
  /// Sensor temperatures in the order of the model [K]. For a thermal network, the list contains
  /// the temperatures of all bodies.
  std::vector<double> sensors = {};
  /// Outlet temperature of the first coolant circuit, T_in + 2 (T_mean - T_in) [K]. T_in is the
  /// inlet temperature and T_mean the mean temperature of the coolant. Without flow, the value is
  /// T_mean. Without a coolant circuit, the value is NaN.
  double coolant_outlet = unset;
  std::vector<CircuitState> circuits = {};  ///< circuits in the order of model::Spindle::channels()
  [[nodiscard]] double thermal_displacement() const {
    return displacement - kinematic_displacement;
  }
};

/// Temperatures of all cells, from which a simulation can continue.
struct State {
  double time = 0.0;  ///< [s]
  /// Simulated time since the start from ambient temperature [s]. The temperature of the machine
  /// drifts slowly with this time. After Simulator::steady(), the value is 1e9 s, so that the drift
  /// has ended.
  double structure_time = 0.0;
  std::vector<double> temperatures;  ///< [K]
};

struct Report {
  Status status = Status::not_run;
  int steps = 0, rejected = 0;
  /// Error of the heat balance [1]. simulate() reports the largest error of all time steps. The
  /// error of a step is |stored heat - supplied heat|/H. H is the heat into the spindle plus the
  /// heat out of the spindle, but at least 100 J. steady() reports |stored heat| divided by the
  /// total heat of bearing friction and all other sources.
  double energy_error = unset;
  std::string message = {};  ///< reason if the simulation did not converge
  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

/// Result of a simulated speed programme. If the simulation stops early, `moments` contains only
/// the rows before the stop. If `has_end` is true, an additional last entry of `moments` contains
/// the results at the time of the stop.
struct Run {
  std::vector<Moment> moments = {};    ///< results at the rows of the programme
  bool has_end = false;                ///< true if `moments` has an entry for an early stop
  std::vector<double> step_ends = {};  ///< end time of each time step [s]
  State end = {};
  /// States at the times `keep` of simulate(): for each time, the state at the end of the time step
  /// that reaches this time. If the simulation stops early, times after the stop have no state.
  std::vector<State> kept = {};
  Report report = {};
  /// Largest axial force of the front set in any row or at the end of any time step [N].
  double highest_front_force = 0.0;
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

/// Contact of a ring with its seat at speed and temperature.
struct SeatState {
  /// Contact pressure [Pa]; 0 for a loose seat, NaN if the model gives the conductance.
  double pressure = unset;
  double gap = unset;          ///< radial gap of a loose seat [m]; 0 for a tight seat
  double conductance = unset;  ///< conductance of contact spots and air together [W/(m² K)]
};
/// Seats of the inner ring on the shaft and of the outer ring in the housing.
struct SeatsOfBearing {
  SeatState inner, outer;
};

/// Heat transfer at a joint or a surface of the spindle, except the seats of the bearing rings (see
/// SeatsOfBearing).
struct SurfaceState {
  std::string name;
  double area = unset;         ///< [m²]
  double conductance = unset;  ///< heat transfer coefficient, mean over the area [W/(m² K)]
  /// Contact pressure of a clamped ring face or of a screwed flange joint [Pa]; otherwise NaN.
  double pressure = unset;
  /// Heat flow [W]. At a surface and at the flange, heat that leaves the spindle is positive. In
  /// the air gap, heat from shaft to housing is positive. At a clamped face of a ring, heat that
  /// leaves the ring is positive. At shoulders and collars, the heat flow is not computed (NaN).
  double heat = unset;
};

/// Position on the shaft with its axial displacement relative to the flange.
struct ShaftPlace {
  double position = unset;      ///< distance behind the nose face [m]
  double displacement = unset;  ///< positive towards the tool [m]
};

/// Stresses at one radius, positive in tension [Pa].
struct Stress {
  double radius = unset;                               ///< [m]
  double axial = unset, hoop = unset, radial = unset;  ///< [Pa]
  [[nodiscard]] double von_mises() const {
    const double a = axial - hoop, b = hoop - radial, c = radial - axial;
    return std::sqrt(0.5 * (a * a + b * b + c * c));
  }
};

/// Stresses of the shaft or of a ring over the radius, in one axial slice of the mesh.
struct SectionStress {
  enum class Part { shaft, inner_ring, outer_ring } part = Part::shaft;
  /// Index of the bearing of this ring or shaft seat; -1 for the shaft outside the seats.
  int bearing = -1;
  double start = unset, end = unset;  ///< distance behind the nose face [m]
  std::vector<Stress> at = {};        ///< stresses from the bore to the outer surface
  /// Returns the stresses at the radius at which the von Mises stress is largest.
  [[nodiscard]] const Stress& largest() const;
};

/// Spindle prepared for simulation, with its cells, thermal conductances and mounted bearing sets.
/// A thermal network is a spindle model of thermal bodies without bearings. Several threads must
/// not use one object simultaneously; give each thread a copy.
class Simulator {
 public:
  /// Creates a simulator with the effects that are switched on in the model. Throws
  /// std::invalid_argument if the model is not a spindle, or if the parts of the spindle cannot be
  /// mounted or meshed.
  explicit Simulator(const model::Model& model);
  /// Creates a simulator in which `condition` replaces the spindle effects that are switched on in
  /// the model.
  Simulator(const model::Model& model, const effects::SpindleCondition& condition);
  Simulator(const Simulator&);
  Simulator(Simulator&&) noexcept;
  ~Simulator();

  /// Sets a flag that cancels the work. simulate() checks the flag before every time step, and
  /// steady() checks it at the start. Both functions throw fit::Cancelled if the flag is true.
  /// Copies of this object use the same flag. A null pointer switches the check off.
  void stop_on(const std::atomic<bool>* cancelled);
  /// Simulates a speed programme from the state `start`. If `start` is null, all cells start at the
  /// ambient temperature. `step_ends` may contain the step ends of an earlier run of this programme
  /// [s], so that all simulations of a fit use the same time steps. If `step_ends` is empty, the
  /// simulator chooses the step sizes. `keep` lists increasing times [s]. For each time in `keep`,
  /// Run::kept contains the state at the end of the first step that reaches the time. Throws
  /// std::invalid_argument if `start` belongs to another mesh.
  [[nodiscard]] Run simulate(std::span<const ProfileRow> profile, const State* start = nullptr,
                             std::span<const double> step_ends = {},
                             std::span<const double> keep = {});
  /// Finds the steady state for these inputs. If the search fails, `report` gives the reason, and
  /// displacements and forces are NaN.
  [[nodiscard]] Moment steady(const Inputs& inputs, Report& report);
  /// Returns the temperatures of all cells at the end of the last call of simulate() or steady().
  /// In the comments below, "the last call" means the last call of simulate() or steady().
  [[nodiscard]] const State& state() const;
  /// Returns the equilibrium of the bearing sets at the end of the last call; null for a thermal
  /// network.
  [[nodiscard]] const bearing::ArrangementEquilibrium* sets() const;
  /// Returns the bearing sets as mounted; null for a thermal network.
  [[nodiscard]] const bearing::Arrangement* arrangement() const;
  /// Returns the equilibrium of the bent shaft from the last call, with the bearing loads that
  /// determine the bearing friction. The result is null for a thermal network. It is also null if
  /// the shaft has no radial load, no moment and no roller bearing.
  [[nodiscard]] const LoadedShaft* shaft() const;
  /// Returns the operating condition of the bearing sets at the end of the last call: speed, axial
  /// load, growth of the rings, and elongation between the sets; null for a thermal network.
  [[nodiscard]] const bearing::ArrangementCondition* sets_condition() const;
  /// Returns the seats of all bearings at the end of the last call, in the order of
  /// Moment::bearings; empty for a thermal network.
  [[nodiscard]] std::vector<SeatsOfBearing> seats() const;
  /// Returns all joints and surfaces except the ring seats at the end of the last call; empty for a
  /// thermal network.
  [[nodiscard]] std::vector<SurfaceState> surfaces() const;
  /// Returns the axial displacement along the shaft, from the nose to the rear end. `moment` must
  /// be the Moment at the end of the last call. The list is empty for a thermal network.
  [[nodiscard]] std::vector<ShaftPlace> along_shaft(const Moment& moment) const;
  /// Returns the stresses of shaft and rings at the end of the last call. `speed` must be the speed
  /// in the last call [rad/s]. The list is empty for a thermal network.
  [[nodiscard]] std::vector<SectionStress> stresses(double speed) const;
  [[nodiscard]] std::vector<FieldCell> field(const State& state) const;
  [[nodiscard]] std::size_t cells() const;

 private:
  struct Parts;
  class Passage;
  std::unique_ptr<Parts> parts_;
};

}  // namespace raceway::spindle
