#include "friction/contact/many_contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "friction/contact/contact_law.h"
#include "tests/friction_contact/running_state.h"

namespace raceway::friction::contact {
namespace {

#ifdef NDEBUG
constexpr std::uint64_t bearings = 400;
#else
constexpr std::uint64_t bearings = 40;
#endif
constexpr std::size_t states_each = 11;  // not a multiple of what goes side by side

/// One bearing with its oil at several speeds, loads and temperatures; the last state stands still.
struct ManyStates {
  RunningState one;
  ContactData data;
  std::vector<double> values{1.0, 1.0, 0.1, 0.06, 0.0, 0.001};
  std::vector<bearing::OperatingPoint> points;
  std::vector<bearing::BearingEquilibrium> balances;
  std::vector<BearingState<double>> states;

  explicit ManyStates(std::uint64_t index) : one(running_state(index)) {
    data.oil = one.oil;
    data.supply = one.law.supply;
    data.inlet_over_b = one.law.inlet_over_b;
    data.race_roughness = one.law.composite_roughness;
    data.ball_roughness = 0.0;
    values[4] = one.law.replenishment;
    for (std::size_t n = 0; n < states_each; ++n) {
      const auto x = static_cast<double>(n);
      bearing::OperatingPoint p = one.point;
      p.speed *= 1.0 - x / (states_each - 1.0);
      p.axial_load *= 1.0 + 0.1 * x;
      p.temperature += x;
      points.push_back(p);
      balances.push_back(solve_bearing_equilibrium(one.bearing, p));
    }
    for (std::size_t n = 0; n < states_each; ++n)
      states.push_back(
          {.bearing = &one.bearing,
           .equilibrium = &balances[n],
           .lubricant = &one.lubricant,
           .contact = &data,
           .speed = points[n].speed,
           .axial_load = points[n].axial_load,
           .radial_load = points[n].radial_load,
           .temperature = points[n].temperature,
           .kinematic_viscosity = one.lubricant.kinematic_viscosity(points[n].temperature)});
  }
};

void expect_same(double many, double one, double tolerance, const std::string& where) {
  if (std::isnan(one)) {
    EXPECT_TRUE(std::isnan(many)) << where;
    return;
  }
  EXPECT_NEAR(many, one, tolerance * std::abs(one)) << where;
}

TEST(ManyContacts, AreThoseOfOneStateAtATime) {
  for (std::uint64_t index = 0; index < bearings; ++index) {
    const ManyStates m(index);
    for (const bearing::InstructionSet set :
         {bearing::InstructionSet::sse2, bearing::InstructionSet::avx2,
          bearing::InstructionSet::avx512}) {
      if (!bearing::available(set)) continue;
      std::vector<ContactResult> many(states_each);
      contact_results(m.states, m.values, many, set);
      for (std::size_t n = 0; n < states_each; ++n) {
        const ContactResult one = contact_result(m.states[n], m.values);
        const ContactResult& r = many[n];
        const std::string where = "bearing " + std::to_string(index) + ", state " +
                                  std::to_string(n) + ", " + std::string(name(set));
        EXPECT_EQ(r.friction.converged, one.friction.converged) << where;
        for (const bool outer : {false, true}) {
          const auto &a = outer ? r.friction.outer : r.friction.inner,
                     &b = outer ? one.friction.outer : one.friction.inner;
          expect_same(a.rolling, b.rolling, 1e-11, where + " rolling");
          expect_same(a.hysteresis, b.hysteresis, 1e-11, where + " hysteresis");
          expect_same(a.sliding, b.sliding, 3e-4, where + " sliding");
        }
        expect_same(r.friction.smallest_film, one.friction.smallest_film, 1e-11, where + " film");
        expect_same(r.friction.smallest_film_ratio, one.friction.smallest_film_ratio, 1e-11,
                    where + " ratio");
        expect_same(r.drag, one.drag, 1e-13, where + " drag");
        expect_same(r.mean_slip, one.mean_slip, 5e-4, where + " slip");
        expect_same(r.holding_coefficient, one.holding_coefficient, 1e-13, where + " holding");
        expect_same(r.holding_over_traction, one.holding_over_traction, 2e-2,
                    where + " over traction");
      }
    }
  }
}

TEST(ManyContacts, OfAStateDoNotDependOnTheOthers) {
  for (const std::uint64_t index : {3, 17, 101}) {
    const ManyStates m(index);
    std::vector<ContactResult> all(states_each);
    contact_results(m.states, m.values, all);
    for (std::size_t n = 0; n < states_each; ++n) {
      ContactResult alone;
      contact_results({&m.states[n], 1}, m.values, {&alone, 1});
      if (std::isnan(all[n].moment())) continue;
      EXPECT_EQ(all[n].moment(), alone.moment()) << index << " " << n;
      EXPECT_EQ(all[n].mean_slip, alone.mean_slip) << index << " " << n;
    }
  }
}

TEST(ManyContacts, OfAnotherBearingAmongThemAreItsOwn) {
  ManyStates m(5);
  const ManyStates other(6);
  m.states[4] = other.states[4];
  std::vector<ContactResult> all(states_each);
  contact_results(m.states, m.values, all);
  EXPECT_EQ(all[4].moment(), contact_result(other.states[4], m.values).moment());
}

TEST(ManyContacts, WithBalanceFillTheColumnsThatAreAskedFor) {
  const ManyStates m(8);
  std::vector<double> torque(states_each), rolling(states_each), sliding(states_each),
      hysteresis(states_each), drag(states_each), inner(states_each), outer(states_each),
      film(states_each), inner_load(states_each);
  const FrictionOfMany asked{.bearing = &m.one.bearing,
                             .lubricant = &m.one.lubricant,
                             .data = &m.data,
                             .values = m.values};
  friction_of_many(asked, m.points,
                   {.torque = torque,
                    .rolling = rolling,
                    .sliding = sliding,
                    .hysteresis = hysteresis,
                    .drag = drag,
                    .inner_heat = inner,
                    .outer_heat = outer,
                    .smallest_film = film,
                    .inner_equivalent_load = inner_load});
  for (std::size_t n = 0; n < states_each; ++n) {
    const ContactResult one = contact_result(m.states[n], m.values);
    expect_same(torque[n], one.moment(), 1e-4, "torque");
    expect_same(rolling[n] + sliding[n] + hysteresis[n] + drag[n], torque[n], 1e-12, "parts");
    expect_same(inner[n] + outer[n], torque[n] * m.points[n].speed, 1e-12, "heat");
    expect_same(film[n], one.friction.smallest_film, 1e-9, "film");
    double cubes = 0.0;
    for (std::size_t k = 0; k < m.balances[n].balls.size(); ++k)
      cubes += std::pow(m.balances[n].balls[k].inner_load, 3.0);
    expect_same(inner_load[n], std::cbrt(cubes / static_cast<double>(m.balances[n].balls.size())),
                1e-9, "load");
  }
  std::vector<double> few(2);
  EXPECT_THROW(friction_of_many(asked, m.points, {.torque = few}), std::invalid_argument);
}

}  // namespace
}  // namespace raceway::friction::contact
