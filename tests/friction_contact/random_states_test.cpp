// What the law of contacts promises for whatever bearing, oil and load: ten thousand random states.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/friction_contact/running_state.h"

namespace raceway::friction::contact {
namespace {

/// What a state's contacts make, and the extremes among them.
struct Contacts {
  BearingFriction friction;
  double torque = unset;         ///< [N m]
  double largest_loading = 0.0;  ///< L of thermal_loading(), which turns films and rolling
  double apart = 0.0;            ///< largest difference of a ball's contact angles [rad]
  bool dissipates = true;        ///< powers are numbers and none is below zero
};

Contacts contacts_of(const RunningState& s, const bearing::BearingEquilibrium& balance,
                     const OilState& oil) {
  Contacts all;
  const auto look = [&](std::size_t k, bearing::Race race, const ContactFriction& c, double) {
    const bearing::BallEquilibrium& ball = balance.balls.distinct()[k];
    const BallMotion m =
        ball_motion(s.bearing.geometry(), ball, bearing::RaceControl::outer, s.point.speed);
    const double u = (race == bearing::Race::inner ? m.inner : m.outer).surface_speed;
    all.largest_loading =
        std::fmax(all.largest_loading,
                  thermal_loading(oil.viscosity, oil.viscosity_slope, u, oil.conductivity));
    all.apart = std::fmax(all.apart, std::abs(ball.inner_contact_angle - ball.outer_contact_angle));
    for (const double power : {c.sliding, c.rolling, c.hysteresis})
      all.dissipates = all.dissipates && std::isfinite(power) && power >= 0.0;
    all.dissipates = all.dissipates && c.power() > 0.0;
  };
  all.friction = bearing_friction(s.bearing, balance, bearing::RaceControl::outer, s.point.speed,
                                  oil, s.law, look);
  all.torque = all.friction.moment();
  return all;
}

Contacts contacts_of(const RunningState& s) { return contacts_of(s, s.balance(), s.oil_there()); }

/// Optimised builds go through all states, others through every twentieth of these, as
/// tests/bearing/robustness_test.cpp.
#ifdef NDEBUG
constexpr std::uint64_t state_step = 1;
#else
constexpr std::uint64_t state_step = 20;
#endif
constexpr std::uint64_t states_of_a_test = 2500;

class RandomStates : public testing::TestWithParam<std::uint64_t> {
 protected:
  /// Of those that have a balance.
  template <typename Look>
  void for_each_state(const Look& look) const {
    const std::uint64_t first = GetParam() * states_of_a_test;
    std::uint64_t balanced = 0;
    for (std::uint64_t i = first; i < first + states_of_a_test; i += state_step) {
      const RunningState s = running_state(i);
      const bearing::BearingEquilibrium balance = s.balance();
      if (!balance.report.converged()) continue;
      ++balanced;
      look(i, s, balance);
    }
    EXPECT_GT(100 * balanced * state_step, 98 * states_of_a_test);
  }
};

TEST_P(RandomStates, TakePowerInEveryPart) {
  for_each_state([](std::uint64_t i, const RunningState& s, const auto& balance) {
    const Contacts here = contacts_of(s, balance, s.oil_there());
    EXPECT_TRUE(here.friction.converged) << "state " << i;
    EXPECT_TRUE(here.dissipates) << "state " << i;
    EXPECT_TRUE(std::isfinite(here.torque) && here.torque > 0.0) << "state " << i;
  });
}

/// d ln M of a step to either side of a state, over its share of that state (temperature: of 40 K).
struct Tangents {
  double behind, ahead;
};

template <typename Move>
Tangents tangents(const RunningState& s, double torque, const Move& move) {
  constexpr double step = 1e-5;
  RunningState up = s, down = s;
  move(up.point, 1.0 + step);
  move(down.point, 1.0 - step);
  return {.behind = std::log(torque / contacts_of(down).torque) / step,
          .ahead = std::log(contacts_of(up).torque / torque) / step};
}

// A jump of 5e-8 of the torque would be seen, and a bend of its slope by half a per cent. Where the
// inner race lets go of balls the slope over speed grows to 15. Bends that the formulas have, as
// the film at inlet_over_b = m*, are not met by steps as small as these.
TEST_P(RandomStates, AreSmoothInSpeedLoadAndTemperature) {
  const auto expect_one_tangent = [](const Tangents& t, const std::string& where) {
    EXPECT_NEAR(t.behind, t.ahead, 0.005 * (1.0 + std::abs(t.ahead))) << where;
  };
  for_each_state([&](std::uint64_t i, const RunningState& s, const auto& balance) {
    const double torque = contacts_of(s, balance, s.oil_there()).torque;
    const std::string where = "state " + std::to_string(i) + " over ";
    expect_one_tangent(tangents(s, torque, [](auto& p, double f) { p.speed *= f; }),
                       where + "speed");
    expect_one_tangent(tangents(s, torque,
                                [](auto& p, double f) {
                                  p.axial_load *= f;
                                  p.radial_load *= f;
                                }),
                       where + "load");
    expect_one_tangent(
        tangents(s, torque, [](auto& p, double f) { p.temperature += 40.0 * (f - 1.0); }),
        where + "temperature");
  });
}

/// The oil so many times as thick at its temperature: its pressure-viscosity coefficient follows,
/// its slope over temperature stays.
OilState thickened(const RunningState& s, double times) {
  OilState oil = s.oil_there();
  oil.kinematic_viscosity *= times;
  oil.viscosity *= times;
  oil.pressure_viscosity = pressure_viscosity(s.oil.type, oil.kinematic_viscosity);
  return oil;
}

// Full film: Λ > 3 at every contact. Not for the whole range, by the formulas themselves: the
// force of rolling goes with η^0.64 and the share that inlet heat leaves of it, 1/(1 + 0.29
// L^0.78), at last with η^-0.78, so that above L of some 33 the torque of a limited inlet falls
// again; and K_rs, exp(-K_rs ν n ...), takes the more the thicker the oil is, so it is left out
// here.
TEST_P(RandomStates, OnAFullFilmTakeMoreOfThickerOilUntilItsInletsAreHot) {
  int on_full_film = 0, hot = 0, turned = 0;
  for_each_state([&](std::uint64_t i, RunningState s, const auto& balance) {
    s.law.replenishment = 0.0;
    const Contacts thick = contacts_of(s, balance, thickened(s, 1.001));
    const Contacts thin = contacts_of(s, balance, thickened(s, 1.0 / 1.001));
    if (!(thin.friction.smallest_film_ratio > 3.0)) return;
    if (thick.largest_loading < 30.0) {
      ++on_full_film;
      EXPECT_GT(thick.torque, thin.torque) << "state " << i;
    } else if (thin.largest_loading > 60.0) {
      ++hot;
      turned += thick.torque < thin.torque;
    }
  });
  const auto of_all = [](int n) { return static_cast<std::uint64_t>(n) * state_step; };
  EXPECT_GT(of_all(on_full_film), states_of_a_test / 10);
  RecordProperty("on_full_film", on_full_film);
  RecordProperty("hot", hot);
  RecordProperty("turned", turned);
}

// The film goes with u^0.68 and the share that inlet heat leaves of it, 1/(1 + 0.1 L^0.64), with
// L ~ u²: it turns at L of some 44, or earlier where centrifugal force loads the outer race. Balls
// that climb the inner race at speed (contact angles more than 5 deg apart) move otherwise: u
// falls.
TEST_P(RandomStates, HaveAFilmThatGrowsWithSpeedUntilItsInletsAreHot) {
  int cool = 0, hot = 0;
  for_each_state([&](std::uint64_t i, const RunningState& s, const auto& balance) {
    const Contacts here = contacts_of(s, balance, s.oil_there());
    if (here.apart > 5.0 * degree) return;
    RunningState faster = s;
    faster.point.speed *= 1.001;
    const double more = contacts_of(faster).friction.smallest_film;
    if (here.largest_loading < 20.0) {
      ++cool;
      EXPECT_GT(more, here.friction.smallest_film) << "state " << i;
    } else if (here.largest_loading > 60.0) {
      ++hot;
      EXPECT_LT(more, here.friction.smallest_film) << "state " << i;
    }
  });
  EXPECT_GT(static_cast<std::uint64_t>(cool) * state_step, states_of_a_test / 2);
  RecordProperty("cool", cool);
  RecordProperty("hot", hot);
}

INSTANTIATE_TEST_SUITE_P(Contacts, RandomStates,
                         testing::Range(std::uint64_t{0}, std::uint64_t{4}));

// Found by these states: a ball thrown so far outwards that it turns backwards on the inner race
// had a hysteresis that drove.
TEST(RandomState, OfABallBeyondARightAngleOnItsRaceTakesPower) {
  const bearing::Bearing b({.ball_count = 17,
                            .ball_diameter = 5.556 * mm,
                            .pitch_diameter = 36.5 * mm,
                            .contact_angle = 55.4 * degree,
                            .inner_conformity = 0.521,
                            .outer_conformity = 0.5356},
                           bearing::steel(), bearing::steel());
  const RaceFriction race =
      race_friction(b, bearing::Race::inner, running_state(0).oil_there(), {}, 500.0);
  const ContactMotion forwards{.surface_speed = 0.2, .rolling = 300.0, .spin = 900.0};
  const ContactMotion backwards{.surface_speed = -0.2, .rolling = -300.0, .spin = 900.0};
  const ContactFriction f = race.contact(0.4, forwards), back = race.contact(0.4, backwards);
  EXPECT_GT(f.hysteresis, 0.0);
  EXPECT_DOUBLE_EQ(back.hysteresis, f.hysteresis);
  EXPECT_DOUBLE_EQ(back.rolling, f.rolling);
  EXPECT_DOUBLE_EQ(back.film.minimum, f.film.minimum);
  EXPECT_NEAR(back.sliding, f.sliding, 1e-6 * f.sliding);
}

}  // namespace
}  // namespace raceway::friction::contact
