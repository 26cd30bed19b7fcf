#pragma once

#include "friction/contact/balanced_equilibrium.h"
#include "tests/friction_contact/contact_cases.h"
#include "tests/friction_contact/reference_bearing.h"

namespace raceway::friction::contact {

/// A bearing of a case with its oil, whose balls no race holds.
struct BalancedRun {
  bearing::Bearing bearing;
  bearing::OperatingPoint point;
  OilState oil;
  ContactLaw law;

  explicit BalancedRun(const nlohmann::json& in)
      : bearing(reference_bearing(in.at("geometry"), in.at("ball") == "nitride"
                                                         ? bearing::silicon_nitride()
                                                         : bearing::steel())),
        point{.speed = in.at("rpm").get<double>() * rpm,
              .axial_load = in.at("Fa"),
              .radial_load = in.value("Fr", 0.0)} {
    set_oil(in.at("nu40"), in.at("nu100"), in.at("T_C"), in.at("lubricant").get<std::string>());
    law.boundary_friction = in.at("mu_b");
    law.composite_roughness = in.at("composite_roughness_um").get<double>() * um;
  }

  void set_oil(double nu40, double nu100, double celsius, const std::string& type = "mineral") {
    oil = oil_state(Lubricant(nu40 * mm2_per_s, nu100 * mm2_per_s), {.type = *find_oil_type(type)},
                    kelvin(celsius));
  }
  [[nodiscard]] BalancedEquilibrium solve() const {
    return solve_balanced_equilibrium(bearing, point, oil, law);
  }
  [[nodiscard]] BearingFriction friction(const BalancedEquilibrium& e) const {
    return balanced_friction(bearing, e.equilibrium, point.speed, oil, law);
  }
  [[nodiscard]] BearingFriction friction_under(bearing::RaceControl control) const {
    const auto e = solve_bearing_equilibrium(bearing, point, {.race_control = control});
    return bearing_friction(bearing, e, control, point.speed, oil, law);
  }
};

/// The steel 7014 of the reference under 500 N at this speed.
inline BalancedRun steel_7014(double speed_rpm) {
  nlohmann::json in = contact_cases("balanced_steel").front().at("inputs");
  in["rpm"] = speed_rpm;
  in["Fa"] = 500.0;
  return BalancedRun(in);
}

}  // namespace raceway::friction::contact
