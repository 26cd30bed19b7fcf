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
  double thermal_expansion = unset;  ///< linear [1/K]
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

/// A piece of a shaft or a housing between two planes, from the nose to the rear.
struct Segment {
  double length = unset;    ///< [m]
  double diameter = unset;  ///< outer [m]
  double bore = unset;      ///< [m]; 0 for a solid one. Of a housing: NaN follows the bearings
  SolidMaterial material = steel_of_shafts;
};

/// A stiff body on the shaft: pulley, rotor, tool.
struct Disk {
  double position = unset;           ///< behind the nose face [m]
  double mass = unset;               ///< [kg]
  double diametral_inertia = unset;  ///< about a radial axis through it [kg m²]
  double polar_inertia = unset;      ///< about the shaft [kg m²]
};

/// A spring from shaft to housing: a bearing of which only the stiffness is known.
struct Support {
  double position = unset;          ///< behind the nose face [m]
  double radial_stiffness = unset;  ///< [N/m]
  double tilt_stiffness = 0.0;      ///< [N m/rad]
};

struct ShaftBody {
  std::vector<Segment> segments;
  std::vector<Disk> disks = {};
  std::vector<Support> supports = {};
};

struct Housing {
  double start = unset;  ///< front face, behind the nose face [m]
  /// From the front face on; bored to the outer diameter of the bearings where they leave it open.
  std::vector<Segment> segments;
  double flange = unset;            ///< centre of where it is bolted to the machine [m]
  double flange_length = 20 * mm;   ///< [m]
  double flange_conductance = 4.0;  ///< into the machine [W/K]
};

/// Seats of the rings, and what they touch sideways.
struct Seat {
  double inner_interference = 6 * um;    ///< diametral, as mounted and still [m]
  double outer_clearance = 4 * um;       ///< diametral [m]
  double roughness = 0.8 * um;           ///< Ra [m]
  double slope = 0.15;                   ///< mean, of the surfaces [1]
  double hardness = 3e9;                 ///< of the softer one [Pa]
  double shoulder_conductance = 8000.0;  ///< ring against shoulder or next ring [W/(m² K)]
  /// Conductance of a face of an outer ring that a collar of the shaft runs against [W/(m² K)]. As
  /// a shoulder, an assumption: over an open gap of 0.1 mm air conducts 270.
  double collar_conductance = 8000.0;
  double outer_conductance = unset;  ///< of the outer seats, whatever the rest says [W/(m² K)]
};

enum class Fluid { water, oil };

/// A cylindrical roller bearing on the shaft in addition to the sets, free along the axis. Its
/// friction follows Palmgren.
struct RollerOnShaft {
  std::string name;         ///< gives the columns NAME_clearance_um and so on
  double position = unset;  ///< behind the nose face [m]
  /// With bore, outer diameter and width.
  bearing::RollerBearing bearing;
  double f0 = unset, f1 = unset;  ///< [1]
  friction::F1Load counted = friction::F1Load::rollers;
  /// Fits of its own seats, diametral [m]; NaN: as Seat has them.
  double inner_interference = unset, outer_clearance = unset;
  /// Beside the contacts [W/K]; NaN: as of the ball bearings.
  double lubricant_conductance = unset;
};

/// A belt that pulls at the shaft.
struct Belt {
  double force = 0.0;       ///< [N]
  double angle = 0.0;       ///< of its pull, from +y towards +z [rad]
  double position = unset;  ///< behind the nose face [m]
};

/// A helical channel around the housing.
struct Coolant {
  Fluid fluid = Fluid::water;
  double flow = unset;                ///< [m³/s]
  double inlet_temperature = unset;   ///< [K]
  double diameter = unset;            ///< mean, of the helix [m]
  double channel_width = unset;       ///< along the axis [m]
  double channel_depth = unset;       ///< radial [m]
  double pitch = unset;               ///< of the turns [m]
  double start = unset, end = unset;  ///< behind the nose face [m]
  double stagnant = 25.0;             ///< film of the standing fluid [W/(m² K)]
  double throttle_diameter = unset;   ///< of an orifice at the outlet [m]; NaN: none
};

enum class RotatingConvection { becker, kendoush, anderson_saunders };

struct Ambient {
  double temperature = kelvin(20);     ///< [K]
  double machine_temperature = unset;  ///< at the flange [K]; NaN: the ambient's
  double emissivity = 0.85;            ///< of the housing [1]
  double convection_factor = 1.0;      ///< on free convection of the housing [1]
  RotatingConvection rotating_convection = RotatingConvection::becker;
};

/// Heat that is none of the bearings' own, and where it arises.
struct HeatSource {
  /// shaft, housing: a span of it. motor: shaft and housing between the sets. pulley: the shaft
  /// behind the last bearing. seal: the shaft between the housing's front face and the first
  /// bearing. bearing: the raceways of one. Of motor, pulley and seal a span may say otherwise.
  enum class Place { shaft, housing, motor, pulley, seal, bearing };
  std::string name = {};                                   ///< "motor", "drive" or its own
  double watts = unset;                                    ///< [W]; NaN: by the formula
  std::shared_ptr<const record::Expression> formula = {};  ///< [W], of heat_variables
  double factor = 1.0;                                     ///< on the formula [1]
  Place place = Place::shaft;
  std::size_t bearing = 0;        ///< in the order of rings_of()
  double position = unset;        ///< middle of the span, behind the nose face [m]
  double length = unset;          ///< of the span [m]
  double radius = unset;          ///< of cells of shaft or housing; NaN: from bore to surface [m]
  double rotor_diameter = unset;  ///< [m]
  /// Share of a motor's heat into the shaft, the rest into the housing; of the heat at a bearing
  /// into the inner ring, the rest into the outer one [1].
  double rotor_share = 1.0;
};

/// Variables of a formula of heat, in units of the files.
inline const std::vector<std::string> heat_variables{"speed_rpm", "axial_load_N", "radial_load_N",
                                                     "moment_Nm", "belt_force_N", "motor_power_W"};

/// Air between shaft and housing.
struct Gap {
  double inner_diameter = unset, outer_diameter = unset;  ///< [m]
  double start = unset, end = unset;                      ///< behind the nose face [m]
};

/// Place of a thermometer.
struct ThermometerPlace {
  enum class Part { shaft, ring, housing, coolant };
  std::string name;  ///< gives the column NAME_temperature_C
  Part part = Part::housing;
  /// Behind the nose face [m]. Coolant flows from the start of its channel to the end; NaN: outlet.
  double position = unset;
  double radius = unset;  ///< [m]
};

/// Bodies and conductances in place of a geometry, for experts and tests.
struct Network {
  struct Node {
    std::string name;
    double capacity = unset;     ///< [J/K]; 0 or NaN where `temperature` is given
    double temperature = unset;  ///< held at this [K]
    double heat = 0.0;           ///< [W]
  };
  struct Link {
    std::size_t from = 0, to = 0;  ///< places in `nodes`
    double conductance = unset;    ///< [W/K]
  };
  std::vector<Node> nodes;
  std::vector<Link> links;
};

enum class Cells { coarse, medium, fine };

/// All of a spindle that is not its bearings, their lubricant and their arrangement. Positions are
/// behind the nose face, displacements of the nose against the flange, positive towards the tool.
struct Spindle {
  std::string name = {};
  /// Friction by the forces of the warm set, or else of the cold set at that speed.
  bool preload_feedback = true;
  std::vector<double> front_positions = {}, rear_positions = {};  ///< of the bearings' centres [m]
  double bearing_width = unset;                                   ///< [m]
  double inner_ring_shoulder = unset, outer_ring_shoulder = unset;  ///< diameters [m]
  /// Conductance of oil film, lubricant and balls that carry heat, in addition to the contacts, of
  /// one bearing [W/K].
  double lubricant_conductance = unset;
  /// Share of a bearing's friction power that arises at its inner ring; NaN: split_heat().
  double inner_heat_share = unset;
  ShaftBody shaft = {};
  std::vector<RollerOnShaft> rollers = {};
  Housing housing = {};
  Seat seat = {};
  std::optional<Coolant> coolant = {};
  Ambient ambient = {};
  std::optional<HeatSource> motor = {};
  std::optional<HeatSource> drive = {};
  std::vector<HeatSource> heat = {};  ///< further sources
  std::optional<Belt> belt = {};
  std::optional<Gap> gap = {};
  std::vector<ThermometerPlace> sensors = {};
  std::optional<Network> network = {};  ///< then there is no geometry
  Cells cells = Cells::medium;
  double step = unset;  ///< longest time step [s]; NaN: adaptive
  /// Up to these what the model leaves is its own coarseness: [K], [m].
  double model_floor_temperature = 0.5, model_floor_displacement = 1 * um;
};

}  // namespace raceway::model
