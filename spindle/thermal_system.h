#pragma once

#include <memory>
#include <span>
#include <vector>

#include "effects/spindle_condition.h"
#include "spindle/bearing_conduction.h"
#include "spindle/heat_paths.h"
#include "spindle/layout.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Heat that leaves each cell radially, through its inner and its outer face [W].
struct CylinderHeat {
  Vector inner, outer;
};

/// Cells of a spindle with all heat paths except the paths through the bearings. BearingCoupling
/// computes friction and heat conduction of the bearings.
///
/// Heat transfer coefficients, and pressures and conductances of the ring seats, depend on the
/// temperatures that are passed to update(). These quantities are constant within a time step.
class ThermalSystem {
 public:
  /// Group of heat paths with the same conductance per area.
  struct Group {
    std::size_t first = 0;  ///< index of the first path in HeatPaths::links or HeatPaths::outlets
    Joints joints;
    double area = 0.0;  ///< [m²]
    double film = 0.0;  ///< heat transfer coefficient, mean over the area [W/(m² K)]
  };
  ThermalSystem(const model::Model& model, const effects::SpindleCondition& condition,
                model::Cells cells);

  [[nodiscard]] const HeatPaths& paths() const { return paths_; }
  [[nodiscard]] const Layout& layout() const { return layout_; }
  /// Coolant circuit with its node and heat paths.
  struct Circuit {
    model::Coolant channel;
    int node = -1;  ///< index of the node at the mean coolant temperature
    Group walls = {};
    std::size_t flow = 0;  ///< index of the coolant flow in HeatPaths::outlets
  };
  [[nodiscard]] const std::vector<Circuit>& circuits() const { return circuits_; }
  /// Returns the inlet temperature of a circuit for these inputs [K].
  [[nodiscard]] double inlet(const Circuit& circuit, const Inputs& inputs) const;

  /// Updates heat transfer coefficients, and pressures and conductances of the ring seats, for
  /// these cell temperatures [K] and inputs.
  void update(const Vector& temperatures, const Inputs& inputs);
  /// Sets the temperatures of the surroundings (Reservoir) and the heat of all sources for these
  /// inputs. `machine_rise` [K] is added to the machine temperature in the inputs.
  void set_inputs(const Inputs& inputs, double machine_rise);
  /// Returns the heat of all sources except bearing friction [W].
  [[nodiscard]] double driven_heat() const { return driven_heat_; }
  /// Returns the heat of each source in the list model::Spindle::heat [W].
  [[nodiscard]] const std::vector<double>& source_heat() const { return source_heat_; }
  [[nodiscard]] double ambient(const Inputs& inputs) const;
  /// Returns the ring seats after the last update(), in the order of Layout::bearings.
  [[nodiscard]] const std::vector<SeatsOfBearing>& seats() const { return seats_; }
  /// Returns the state of all joints and surfaces except the seats of the rings, after the last
  /// update().
  [[nodiscard]] std::vector<SurfaceState> surfaces(const Vector& temperatures) const;
  /// Returns the heat that leaves each cell radially, without the heat at raceways, at coolant
  /// walls and at the outer surface of the housing.
  [[nodiscard]] CylinderHeat through_cylinders(const Vector& temperatures) const;

 private:
  Group add_links(const Joints& joints);
  Group add_outlets(const Joints& joints, Reservoir reservoir);
  void set_links(Group& group, double film);
  void set_outlets(Group& group, double film);
  [[nodiscard]] double heat_through(const Group& group, const Vector& temperatures,
                                    bool outlets) const;
  void add_fixed();
  void add_clamped_faces();
  void add_sleeve(const effects::SpindleCondition& condition);
  void update_seats(const Vector& temperatures, double speed);
  void update_room(const Vector& temperatures, double speed);
  void update_coolant(const Vector& temperatures, const Inputs& inputs);
  /// Weights of the cells that a source heats. The fraction `share` of the heat of the source
  /// enters the cells in `first`, and the rest enters the cells in `second`.
  struct HeatedCells {
    Shares first, second;
    double share = 1.0;
  };
  [[nodiscard]] HeatedCells cells_of(const model::HeatSource& source) const;
  void place_heat();
  [[nodiscard]] double flange_conductance() const;
  [[nodiscard]] double contact_conductance(double pressure, double gap, double first_conductivity,
                                           double second_conductivity) const;
  [[nodiscard]] double joint_conductance() const;
  void add_source(const HeatedCells& cells, double heat);

  model::Spindle spindle_;
  effects::SpindleCondition condition_;
  Layout layout_;
  HeatPaths paths_;
  std::vector<Group> inner_seats_, outer_seats_;
  std::vector<SeatsOfBearing> seats_;
  Group shoulders_, collars_, flange_;
  std::vector<Group> faces_;
  Group housing_, ends_, nose_, rear_, gap_;
  std::vector<Circuit> circuits_;
  double nose_diameter_ = unset, rear_diameter_ = unset;
  HeatedCells motor_, drive_, seal_, front_bearings_, rear_bearings_;
  std::vector<HeatedCells> sources_;
  double driven_heat_ = 0.0;
  std::vector<double> source_heat_;
};

/// Returns the weighted mean of cell temperatures [K]; `shares` contains the weights.
[[nodiscard]] double mean(const Shares& shares, const Vector& temperatures);

}  // namespace raceway::spindle
