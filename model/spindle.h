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

/// A piece of a shaft or housing with constant diameters. Segments are listed from the nose to the
/// rear.
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

/// A spring between shaft and housing, for a bearing whose stiffness is known and whose geometry is
/// unknown.
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
  double start = unset;  ///< position of the front face: distance behind the nose face [m]
  /// Segments of the housing, from the front face to the rear. If the bore of a segment is NaN, the
  /// bore equals the outer diameter of the bearings.
  std::vector<Segment> segments;
  /// Position of the middle of the flange: distance behind the nose face [m].
  double flange = unset;
  double flange_length = 20 * mm;  ///< axial length of the flange [m]
  /// Thermal conductance from the flange into the machine [W/K]. If `flange_joint` is given, the
  /// value does not include the joint.
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
  /// Axial clamping forces of the inner rings with their spacers, and of the outer rings [N]. The
  /// contact pressure of the side faces follows from the force, and the conductance of the side
  /// faces from the pressure. If a force is NaN, the side faces have `shoulder_conductance`, and
  /// spacers have no contact resistance.
  double inner_clamping_force = unset, outer_clamping_force = unset;
  /// Conductance from a side face of an outer ring to an adjacent collar of the shaft [W/(m² K)].
  /// The default assumes that ring and collar touch, as at a shoulder. For an air gap of 0.1 mm,
  /// the conductance is 270 W/(m² K).
  double collar_conductance = 8000.0;
  /// Conductance of the seats of the outer rings [W/(m² K)]; NaN: computed from the clearance.
  double outer_conductance = unset;
};

enum class Fluid { water, oil };

inline constexpr double l_per_min = 1e-3 / 60;  ///< one litre per minute [m³/s]

/// A cylindrical roller bearing on the shaft, in addition to the sets of ball bearings. The roller
/// bearing carries no axial load. Its friction follows Palmgren's formulas.
struct RollerOnShaft {
  /// Name of the bearing; replaces NAME in columns such as NAME_clearance_um.
  std::string name;
  double position = unset;  ///< distance behind the nose face [m]
  /// Bore, outer diameter and width must be given.
  bearing::RollerBearing bearing;
  double f0 = unset, f1 = unset;  ///< factors of Palmgren's formulas [1]
  /// Load that enters Palmgren's formula for the load moment.
  friction::F1Load counted = friction::F1Load::rollers;
  /// Diametral interference and clearance of the seats of this bearing [m]; NaN: the values in Seat
  /// are used.
  double inner_interference = unset, outer_clearance = unset;
  /// Thermal conductance of this bearing through the lubricant [W/K]; NaN:
  /// Spindle::lubricant_conductance is used. The conductance of the dry contacts is added.
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

/// A further coolant circuit with its own channel in the housing.
struct Circuit {
  /// Name of the circuit; replaces NAME in the columns NAME_outlet_temperature_C and
  /// heat_to_NAME_W.
  std::string name;
  /// Coolant channel. If the inlet temperature of this channel is NaN, the coolant enters with the
  /// inlet temperature of the first circuit.
  Coolant channel;
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

/// A heat source other than bearing friction.
struct HeatSource {
  /// Heated place. `shaft` and `housing` mean a span of this part along the axis, given by
  /// `position` and `length`. `motor` is shaft and housing between the bearing sets, `pulley` is
  /// the shaft behind the last bearing, and `seal` is the shaft between the front face of the
  /// housing and the first bearing. If `position` and `length` are given for `motor`, `pulley` or
  /// `seal`, the heat enters the span that they define. `bearing` means the raceways of one
  /// bearing.
  enum class Place { shaft, housing, motor, pulley, seal, bearing };
  /// Name of the source: "motor", "drive" or the name of a [[heat]] in the model file.
  std::string name = {};
  /// Heat flow [W]; NaN: computed from the formula.
  double watts = unset;
  /// Formula for the heat flow [W], with the variables in heat_variables.
  std::shared_ptr<const record::Expression> formula = {};
  double factor = 1.0;  ///< factor on the formula [1]
  Place place = Place::shaft;
  /// Index of the heated bearing: front set, rear set, roller bearings, see rings_of().
  std::size_t bearing = 0;
  /// Position of the middle of the heated span: distance behind the nose face [m].
  double position = unset;
  double length = unset;  ///< length of the heated span [m]
  /// Radius of the heated cells of the mesh [m]; NaN: all cells from the bore to the surface.
  double radius = unset;
  double rotor_diameter = unset;  ///< outer diameter of the motor's rotor [m]
  /// Share of a motor's heat that enters the shaft [1]; the rest enters the housing. For a heat
  /// source at a bearing: share that enters the inner ring; the rest enters the outer ring.
  double rotor_share = 1.0;
};

/// Variables that the formula of a heat source may contain. Each name ends with its unit.
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
  std::string name;  ///< name of the thermometer; replaces NAME in the column NAME_temperature_C
  Part part = Part::housing;
  /// Distance behind the nose face [m]. In the coolant, the position is between start and end of
  /// the channel; NaN means the outlet.
  double position = unset;
  double radius = unset;  ///< distance from the shaft axis [m]
};

/// Thermal network of bodies and conductances, in place of the geometry of the spindle; for experts
/// and tests.
struct Network {
  struct Node {
    std::string name;
    double capacity = unset;     ///< heat capacity [J/K]; 0 or NaN if `temperature` is given
    double temperature = unset;  ///< fixed temperature [K]; NaN: computed
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
/// distances behind the nose face. A displacement is the movement of the nose relative to the
/// flange, positive towards the tool.
struct Spindle {
  std::string name = {};
  /// True if the bearing forces of the warm spindle determine the friction; false if the bearing
  /// forces of the cold spindle at this speed determine the friction.
  bool preload_feedback = true;
  std::vector<double> front_positions = {}, rear_positions = {};    ///< centres of the bearings [m]
  double bearing_width = unset;                                     ///< width of one bearing [m]
  double inner_ring_shoulder = unset, outer_ring_shoulder = unset;  ///< shoulder diameters [m]
  /// Thermal conductance of one bearing in operation through oil film, lubricant and rolling balls
  /// [W/K]. This value excludes the dry contacts of the balls, whose conductance the program adds.
  double lubricant_conductance = unset;
  /// Share of a bearing's friction power that heats its inner ring [1]. If the value is NaN,
  /// split_heat() computes the share.
  double inner_heat_share = unset;
  ShaftBody shaft = {};
  std::vector<RollerOnShaft> rollers = {};
  Housing housing = {};
  Seat seat = {};
  std::optional<Coolant> coolant = {};  ///< first coolant circuit
  std::vector<Circuit> circuits = {};   ///< further coolant circuits; only with `coolant`
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
  /// Assumed standard deviations of the model error, for temperatures [K] and displacements [m]. A
  /// fit adds the variance of the model error to the variance of the noise.
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
