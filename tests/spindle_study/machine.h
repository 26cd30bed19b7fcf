#pragma once

#include <string>
#include <vector>

#include "tests/spindle_study/films.h"

namespace spindle_study {

struct ShaftPiece {
  double length = nan, diameter = nan;  ///< [m]
};

/// Where a temperature is measured. Positions are behind the nose face.
struct Thermometer {
  enum class Part { shaft, ring, housing };
  std::string name;
  Part part = Part::housing;
  double position = nan, radius = nan;  ///< [m]
};

struct Helix {
  double flow = nan;   ///< [m³/s]
  double inlet = nan;  ///< [K]
  double diameter = nan, width = nan, depth = nan, pitch = nan, start = nan, end = nan;  ///< [m]
  double standing = 25.0;  ///< film of water at rest [W/(m² K)]
};

/// A spindle on two back-to-back sets. SI.
struct Spindle {
  BearingData bearing;
  double bearing_bore = nan, bearing_outer = nan, bearing_width = nan;  ///< [m]
  double inner_shoulder = nan, outer_shoulder = nan;                    ///< diameters [m]
  double lubricant_conductance = 1.5;                                   ///< of one bearing [W/K]
  std::vector<double> front, rear;                                      ///< centres [m]
  double preload = nan;                                                 ///< [N]
  Oil oil{20.0, 4.4};
  double f0 = nan, z = 0.0007, y = 0.33;
  bool preload_feedback =
      true;                 ///< friction by the forces of the warm set, or those of the cold one
  double shaft_bore = nan;  ///< [m]
  std::vector<ShaftPiece> shaft;
  double housing_start = nan, housing_length = nan, housing_diameter = nan;  ///< [m]
  double flange = nan, flange_length = 0.02;                                 ///< [m]
  double flange_conductance = 4.0;                                           ///< [W/K]
  double interference = 6e-6, clearance = 4e-6, roughness = 0.8e-6;          ///< [m]
  double slope = 0.15, hardness = 3e9;                                       ///< [1], [Pa]
  double shoulder_conductance = 8000.0;  ///< of a ring's face to its shoulder [W/(m² K)]
  double collar_conductance = 6000.0;    ///< of an outer ring's face to a collar of the shaft
  bool cooled = true;
  Helix helix;
  double emissivity = 0.85;
  std::vector<Thermometer> thermometers;

  [[nodiscard]] std::size_t bearings() const { return front.size() + rear.size(); }
  [[nodiscard]] double shaft_length() const {
    double sum = 0.0;
    for (const ShaftPiece& p : shaft) sum += p.length;
    return sum;
  }
};

/// What the spindle does that its model does not know: factors and sources.
struct Hidden {
  double sleeve = 0.0;  ///< from the housing between the sets to the inlet's water or air [W/K]
  double sleeve_radius = nan;  ///< [m]
  double outer_seat = 1.0, convection = 1.0, bearing_conductance = 1.0, flange = 1.0;
  double motor = 0.0, drive = 0.0, seal = 0.0;  ///< at 10 000 rpm, linear in speed [W]
  double structure_rise = 0.0;                  ///< of the machine at the flange [K]
  double structure_time = 3600.0;               ///< time constant of that rise [s]
  double churning = 0.0;  ///< moment of each bearing at 10 000 rpm, with the square [N m]
  double stray = 0.0;     ///< into the rear of the housing, by nothing that is recorded [W]
  double stray_from = 0.0, stray_to = 0.0;  ///< [s]
};

/// What holds from the row before to this one.
struct Inputs {
  double time = nan;   ///< end [s]
  double speed = 0.0;  ///< [rad/s]
  double ambient = 293.15;
  bool coolant_on = true;
};

}  // namespace spindle_study
