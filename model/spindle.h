#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bearing/roller_bearing.h"
#include "friction/state.h"
#include "record/channel.h"
#include "record/expression.h"
#include "record/units.h"

namespace raceway::model {

/// Material of a part.
struct SolidMaterial {
  double conductivity = unset;       ///< [W/(m K)]
  double density = unset;            ///< [kg/m³]
  double heat_capacity = unset;      ///< [J/(kg K)]
  double thermal_expansion = unset;  ///< coefficient of linear expansion [1/K]
  double elastic_modulus = unset;    ///< [Pa]
  double poissons_ratio = unset;     ///< [1]
};

inline constexpr SolidMaterial steel_of_shafts{.conductivity = 42.0,
                                               .density = 7850.0,
                                               .heat_capacity = 460.0,
                                               .thermal_expansion = 11.5 * per_million_K,
                                               .elastic_modulus = 210e9,
                                               .poissons_ratio = 0.3};
inline constexpr SolidMaterial steel_of_rings{.conductivity = 46.0,
                                              .density = 7800.0,
                                              .heat_capacity = 460.0,
                                              .thermal_expansion = 11.5 * per_million_K,
                                              .elastic_modulus = 208e9,
                                              .poissons_ratio = 0.3};
inline constexpr SolidMaterial iron_of_housings{.conductivity = 48.0,
                                                .density = 7250.0,
                                                .heat_capacity = 500.0,
                                                .thermal_expansion = 10.5 * per_million_K,
                                                .elastic_modulus = 120e9,
                                                .poissons_ratio = 0.26};

/// A piece of a shaft or housing between two planes. Pieces are listed from the nose to the rear.
struct Segment {
  double length = unset;    ///< [m]
  double diameter = unset;  ///< outer diameter [m]
  /// Bore [m]; 0: solid part. For a housing, NaN means the outer diameter of the bearings.
  double bore = unset;
  SolidMaterial material = steel_of_shafts;
};

/// A rigid body on the shaft: pulley, rotor, tool.
struct Disk {
  double position = unset;  ///< distance behind the nose face [m]
  double mass = unset;      ///< [kg]
  /// Moment of inertia about a radial axis through the disk [kg m²].
  double diametral_inertia = unset;
  double polar_inertia = unset;  ///< moment of inertia about the shaft axis [kg m²]
};

/// A spring between shaft and housing, for a bearing of which only the stiffness is known.
struct Support {
  double position = unset;          ///< distance behind the nose face [m]
  double radial_stiffness = unset;  ///< [N/m]
  double tilt_stiffness = 0.0;      ///< [N m/rad]
};

struct ShaftBody {
  std::vector<Segment> segments;
  std::vector<Disk> disks = {};
  std::vector<Support> supports = {};
};

/// Screws that press two faces together.
struct ScrewedJoint {
  int screws = 0;
  double screw_force = unset;  ///< clamping force of one screw [N]
  double area = unset;         ///< contact area of the faces [m²]
  /// Returns the mean pressure of the faces [Pa].
  [[nodiscard]] double pressure() const { return screws * screw_force / area; }
};

struct Housing {
  double start = unset;  ///< front face, distance behind the nose face [m]
  /// Segments from the front face. If the bore of a segment is NaN, it equals the outer diameter of
  /// the bearings.
  std::vector<Segment> segments;
  double flange = unset;           ///< middle of the flange, distance behind the nose face [m]
  double flange_length = 20 * mm;  ///< axial length of the flange [m]
  /// Thermal conductance from the flange into the machine [W/K]. If `flange_joint` is given, this
  /// is only the conductance behind the joint.
  double flange_conductance = 4.0;
  std::optional<ScrewedJoint> flange_joint = {};
};

/// Seats of the rings, and contacts at their side faces.
struct Seat {
  /// Diametral interference of the inner ring, as mounted and at standstill [m].
  double inner_interference = 6 * um;
  double outer_clearance = 4 * um;  ///< diametral clearance of the outer ring [m]
  double roughness = 0.8 * um;      ///< roughness Ra of the surfaces [m]
  double slope = 0.15;              ///< mean asperity slope of the surfaces [1]
  double hardness = 3e9;            ///< hardness of the softer surface [Pa]
  /// Conductance of the contact of a ring with a shoulder or another ring [W/(m² K)].
  double shoulder_conductance = 8000.0;
  /// Clamping forces of the inner rings with their spacers, and of the outer rings [N]. If a force
  /// is given, the conductance of the side faces depends on the contact pressure. If the force is
  /// NaN, the side faces have shoulder_conductance, and spacers have no contact resistance.
  double inner_clamping_force = unset, outer_clamping_force = unset;
  /// Conductance from a side face of an outer ring to an adjacent collar of the shaft [W/(m² K)].
  /// The default assumes a contact as at a shoulder. An open air gap of 0.1 mm would conduct 270
  /// W/(m² K).
  double collar_conductance = 8000.0;
  /// Conductance of the outer seats [W/(m² K)]. If given, it replaces the value computed from the
  /// clearance.
  double outer_conductance = unset;
};

enum class Fluid { water, oil };

inline constexpr double l_per_min = 1e-3 / 60;  ///< one litre per minute [m³/s]

/// A cylindrical roller bearing on the shaft in addition to the sets, free to move axially. The
/// friction of the bearing follows Palmgren's formulas.
struct RollerOnShaft {
  std::string name;         ///< NAME in columns such as NAME_clearance_um
  double position = unset;  ///< distance behind the nose face [m]
  /// Bore, outer diameter and width must be given.
  bearing::RollerBearing bearing;
  double f0 = unset, f1 = unset;  ///< factors of Palmgren's formulas [1]
  friction::F1Load counted = friction::F1Load::rollers;
  /// Diametral fits of the seats of this bearing [m]; NaN means the values of Seat.
  double inner_interference = unset, outer_clearance = unset;
  /// Thermal conductance through the lubricant, in addition to the contacts [W/K]; NaN means the
  /// value of the ball bearings.
  double lubricant_conductance = unset;
};

/// A belt that pulls on the shaft.
struct Belt {
  double force = 0.0;       ///< [N]
  double angle = 0.0;       ///< direction of the pull, from +y towards +z [rad]
  double position = unset;  ///< distance behind the nose face [m]
};

/// A helical coolant channel around the housing.
struct Coolant {
  Fluid fluid = Fluid::water;
  double flow = unset;                ///< [m³/s]
  double inlet_temperature = unset;   ///< [K]
  double diameter = unset;            ///< mean diameter of the helix [m]
  double channel_width = unset;       ///< width along the axis [m]
  double channel_depth = unset;       ///< radial depth [m]
  double pitch = unset;               ///< pitch of the turns [m]
  double start = unset, end = unset;  ///< distances behind the nose face [m]
  double stagnant = 25.0;             ///< heat transfer coefficient without flow [W/(m² K)]
  double throttle_diameter = unset;   ///< diameter of an orifice at the outlet [m]; NaN: none
};

/// A further coolant circuit, with a channel around another span of the housing.
struct Circuit {
  std::string name;  ///< NAME in the columns NAME_outlet_temperature_C and heat_to_NAME_W
  Coolant channel;   ///< if its inlet temperature is NaN, the value of the first circuit is used
};

enum class RotatingConvection { becker, kendoush, anderson_saunders };

struct Ambient {
  double temperature = kelvin(20);  ///< ambient temperature [K]
  /// Temperature of the machine at the flange [K]; NaN: ambient temperature.
  double machine_temperature = unset;
  double emissivity = 0.85;        ///< emissivity of the housing [1]
  double convection_factor = 1.0;  ///< factor on free convection of housing and end faces [1]
  RotatingConvection rotating_convection = RotatingConvection::becker;
};

/// A heat source other than bearing friction, and the place that it heats.
struct HeatSource {
  /// Heated place. `shaft` and `housing`: a span of this part. `motor`: shaft and housing between
  /// the sets. `pulley`: the shaft behind the last bearing. `seal`: the shaft between the front
  /// face of the housing and the first bearing. `bearing`: the raceways of one bearing. A given
  /// span replaces the place of `motor`, `pulley` and `seal`.
  enum class Place { shaft, housing, motor, pulley, seal, bearing };
  /// Name of the source: "motor", "drive" or the name of a [[heat]] in the model file.
  std::string name = {};
  /// Heat flow [W]; NaN: computed from the formula.
  double watts = unset;
  /// Formula for the heat flow [W], with the variables in heat_variables.
  std::shared_ptr<const record::Expression> formula = {};
  double factor = 1.0;  ///< factor on the formula [1]
  Place place = Place::shaft;
  std::size_t bearing = 0;  ///< index of the heated bearing, as in rings_of()
  double position = unset;  ///< middle of the span, distance behind the nose face [m]
  double length = unset;    ///< length of the span [m]
  /// Radius of the heated cells [m]; NaN: all cells from the bore to the surface.
  double radius = unset;
  double rotor_diameter = unset;  ///< outer diameter of the motor's rotor [m]
  /// Share of a motor's heat that enters the shaft; the rest enters the housing. For heat at a
  /// bearing: share that enters the inner ring; the rest enters the outer ring [1].
  double rotor_share = 1.0;
};

/// Variables that a heat formula may contain. Each name ends with the unit.
inline const std::vector<std::string> heat_variables{"speed_rpm", "axial_load_N", "radial_load_N",
                                                     "moment_Nm", "belt_force_N", "motor_power_W"};

/// Air gap between shaft and housing.
struct Gap {
  double inner_diameter = unset, outer_diameter = unset;  ///< [m]
  double start = unset, end = unset;                      ///< distances behind the nose face [m]
};

/// Place of a thermometer.
struct ThermometerPlace {
  enum class Part { shaft, ring, housing, coolant };
  std::string name;  ///< NAME in the column NAME_temperature_C
  Part part = Part::housing;
  /// Distance behind the nose face [m]. In the coolant, the position is between start and end of
  /// the channel; NaN means the outlet.
  double position = unset;
  double radius = unset;  ///< distance from the shaft axis [m]
};

/// Thermal network of bodies and conductances that replaces the geometry, for experts and tests.
struct Network {
  struct Node {
    std::string name;
    double capacity = unset;     ///< heat capacity [J/K]; 0 or NaN if `temperature` is given
    double temperature = unset;  ///< fixed temperature [K]
    double heat = 0.0;           ///< heat flow into the body [W]
  };
  struct Link {
    std::size_t from = 0, to = 0;  ///< indices in `nodes`
    double conductance = unset;    ///< [W/K]
  };
  std::vector<Node> nodes;
  std::vector<Link> links;
};

enum class Cells { coarse, medium, fine };

/// All parts of a spindle except the ball bearings, their lubricant and arrangement. Positions are
/// distances behind the nose face. Displacements are movements of the nose relative to the
/// flange, positive towards the tool.
struct Spindle {
  std::string name = {};
  /// True if the friction is computed from the bearing forces of the warm spindle; false if it is
  /// computed from the bearing forces of the cold spindle at the same speed.
  bool preload_feedback = true;
  std::vector<double> front_positions = {}, rear_positions = {};    ///< centres of the bearings [m]
  double bearing_width = unset;                                     ///< width of one bearing [m]
  double inner_ring_shoulder = unset, outer_ring_shoulder = unset;  ///< shoulder diameters [m]
  /// Conductance of one bearing through oil film, lubricant and rolling balls, in addition to the
  /// contacts [W/K].
  double lubricant_conductance = unset;
  /// Share of a bearing's friction power that heats its inner ring [1]. If the value is NaN,
  /// split_heat() computes the share.
  double inner_heat_share = unset;
  ShaftBody shaft = {};
  std::vector<RollerOnShaft> rollers = {};
  Housing housing = {};
  Seat seat = {};
  std::optional<Coolant> coolant = {};  ///< first circuit
  std::vector<Circuit> circuits = {};   ///< further circuits; only allowed with `coolant`
  Ambient ambient = {};
  std::optional<HeatSource> motor = {};
  std::optional<HeatSource> drive = {};
  std::vector<HeatSource> heat = {};  ///< further heat sources
  std::optional<Belt> belt = {};
  std::optional<Gap> gap = {};
  std::vector<ThermometerPlace> sensors = {};
  std::optional<Network> network = {};  ///< thermal network that replaces the geometry
  Cells cells = Cells::medium;
  double step = unset;  ///< longest adaptive time step [s]; NaN: 600 s
  /// Residuals of temperatures [K] and of displacements [m] up to these values are attributed to
  /// simplifications of the model.
  double model_floor_temperature = 0.5, model_floor_displacement = 1 * um;

  /// Returns the channels of all circuits, `coolant` first.
  [[nodiscard]] std::vector<Coolant> channels() const {
    std::vector<Coolant> list;
    if (coolant) list.push_back(*coolant);
    for (const Circuit& c : circuits) list.push_back(c.channel);
    return list;
  }
};

}  // namespace raceway::model
