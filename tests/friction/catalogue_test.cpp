#include "effects/catalogue.h"

#include <set>

#include "tests/friction/sample.h"

namespace raceway {
namespace {

using bearing::RaceControl;

/// Runs a check on every effect of the list, as a type.
template <typename Check>
void for_each_effect(const Check& check) {
  [&]<typename... E>(const std::tuple<E...>*) {
    (..., [&] {
      SCOPED_TRACE(std::string(E::id));
      check.template operator()<E>();
    }());
  }(static_cast<const effects::Catalogue*>(nullptr));
}

std::vector<double> initial_values(const effects::Description& d) {
  std::vector<double> values;
  for (const auto& p : d.parameters) values.push_back(p.initial);
  return values;
}

TEST(Catalogue, IsComplete) {
  ASSERT_EQ(effects::catalogue().size(), std::tuple_size_v<effects::Catalogue>);
  std::set<std::string_view> ids;
  for (const auto& d : effects::catalogue()) {
    SCOPED_TRACE(std::string(d.id));
    EXPECT_TRUE(ids.insert(d.id).second);
    EXPECT_EQ(effects::find(d.id), &d);
    for (const auto text : {d.id, d.title, d.mechanism, d.formula, d.source})
      EXPECT_FALSE(text.empty());
    EXPECT_EQ(d.title.find('\n'), std::string_view::npos);
    EXPECT_FALSE(d.parameters.empty());
    for (const auto& p : d.parameters) {
      EXPECT_FALSE(p.name.empty());
      EXPECT_FALSE(p.unit.empty());
      EXPECT_LE(p.lower, p.initial);
      EXPECT_LE(p.initial, p.upper);
    }
  }
  EXPECT_EQ(effects::find("no-such-effect"), nullptr);
}

TEST(Catalogue, MomentsAreFiniteDissipativeAndZeroAtTheirNeutralValue) {
  const auto bearing = tests::spindle_bearing();
  for (const double speed : {0.0, 3000 * rpm, 12000 * rpm})
    for (const double radial : {0.0, 150.0}) {
      const bearing::OperatingPoint point{.speed = speed, .axial_load = 600, .radial_load = radial};
      const auto e = solve_bearing_equilibrium(bearing, point);
      ASSERT_TRUE(e.report.converged());
      const auto s = tests::state_of(bearing, e, point, RaceControl::outer);
      for (const auto& d : effects::catalogue()) {
        SCOPED_TRACE(std::string(d.id));
        auto values = initial_values(d);
        const double m = d.moment(s, values);
        EXPECT_TRUE(std::isfinite(m));
        EXPECT_GE(m * speed, 0.0);
        values[0] = 0.0;
        EXPECT_EQ(d.moment(s, values), 0.0);
      }
    }
}

TEST(Catalogue, EffectsThatNeedAnEquilibriumHaveNoNumberWithoutOne) {
  const auto bearing = tests::spindle_bearing();
  friction::BearingState<double> s;
  s.bearing = &bearing;
  s.speed = 100;
  for (const auto& d : effects::catalogue())
    if (d.needs_equilibrium) {
      EXPECT_TRUE(std::isnan(d.moment(s, initial_values(d)))) << d.id;
    }
}

TEST(Catalogue, DerivativesByParametersAreThoseOfTheFormula) {
  const auto bearing = tests::spindle_bearing();
  const bearing::OperatingPoint point{.speed = 9000 * rpm, .axial_load = 800, .radial_load = 120};
  const auto e = solve_bearing_equilibrium(bearing, point);
  const auto s = tests::state_of(bearing, e, point, RaceControl::outer);
  for_each_effect([&]<typename E>() {
    constexpr int count = static_cast<int>(E::parameters.size());
    using Jet = ceres::Jet<double, count>;
    friction::BearingState<Jet> t;
    t.bearing = s.bearing;
    t.equilibrium = s.equilibrium;
    t.race_control = s.race_control;
    t.speed = Jet(s.speed);
    t.axial_load = Jet(s.axial_load);
    t.radial_load = Jet(s.radial_load);
    t.temperature = Jet(s.temperature);
    t.kinematic_viscosity = Jet(s.kinematic_viscosity);
    std::array<double, E::parameters.size()> values;
    std::array<Jet, E::parameters.size()> jets;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = E::parameters[i].initial;
      jets[i] = Jet(values[i], static_cast<int>(i));
    }
    const Jet m = E::template moment<Jet>(t, jets);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double step = 1e-5 * std::max(std::abs(values[i]), 1e-3);
      auto up = values, down = values;
      up[i] += step;
      down[i] -= step;
      const double difference =
          (E::template moment<double>(s, up) - E::template moment<double>(s, down)) / (2.0 * step);
      tests::expect_relative(m.v[static_cast<int>(i)], difference, 1e-7);
    }
  });
}

}  // namespace
}  // namespace raceway
