#include <gmock/gmock.h>

#include <limits>

#include "correction/numbers.h"
#include "correction/simulation.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

using testing::Contains;
using testing::Pointee;

constexpr double endless_mm = std::numeric_limits<double>::infinity();

Window at_x(std::array<double, 4> points_mm, bool of_input = false) {
  Window w{.column = record::series_channel("x_position_mm"), .of_input = of_input};
  for (std::size_t k = 0; k < 4; ++k) w.points[k] = w.column->to_SI(points_mm[k]);
  return w;
}

/// A screw that a motor warms, and an axis that goes to and fro.
MadeRecord of_screw() {
  MadeRecord made(36000, 30);
  made.with("x_drive_W", [](double t) { return t < 18000 ? 300.0 : 40.0; })
      .with("x_position_mm", [](double t) { return 250.0 + 250.0 * std::sin(t / 700.0); });
  return made;
}

Model with_window(const std::optional<Window>& window) {
  Model m{.name = "x", .displacement = record::series_channel("displacement_x_um")};
  m.channels.push_back({.name = "screw",
                        .input = {.name = "x_drive_W",
                                  .columns = {record::series_channel("x_drive_W")},
                                  .window = window},
                        .sections = {{0.1e-6, 3000}}});
  return m;
}

std::vector<double> displacement_of(const Model& model, const MadeRecord& made) {
  std::vector<double> y(made.time.size());
  simulate(model, Series(made.record), y);
  return y;
}

TEST(Window, IsZeroOutsideOneInsideAndStraightBetween) {
  const Window w = at_x({100, 200, 300, 500});
  const double mm = 1e-3;
  for (const auto& [x, share] : {std::pair{99.9, 0.0},
                                 {100.0, 0.0},
                                 {150.0, 0.5},
                                 {200.0, 1.0},
                                 {300.0, 1.0},
                                 {450.0, 0.25},
                                 {500.0, 0.0},
                                 {501.0, 0.0}})
    EXPECT_NEAR(w(x * mm), share, 1e-12) << x;
  const Window sharp = at_x({100, 100, 300, 300});
  EXPECT_EQ(sharp(0.1), 1.0);
  EXPECT_EQ(sharp(0.3), 1.0);
  EXPECT_EQ(sharp(0.3001), 0.0);
  const Window from_zero = at_x({0, 500, endless_mm, endless_mm});
  EXPECT_NEAR(from_zero(0.125), 0.25, 1e-12);
  EXPECT_EQ(from_zero(9.0), 1.0);
}

TEST(Window, OfTheDisplacementShowsTheWarmBodyWhereTheAxisStands) {
  const MadeRecord made = of_screw();
  const Window w = at_x({0, 500, endless_mm, endless_mm});
  const std::vector<double> all = displacement_of(with_window({}), made),
                            y = displacement_of(with_window(w), made);
  const auto x = made.record.values(*w.column);
  for (std::size_t k = 0; k < y.size(); ++k) EXPECT_NEAR(y[k], all[k] * x[k] / 0.5, 1e-15) << k;
}

TEST(Window, OfTheInputWarmsTheBodyWhileTheAxisIsThere) {
  MadeRecord made = of_screw();
  const Window w = at_x({300, 300, 500, 500}, true);
  const std::vector<double> y = displacement_of(with_window(w), made);
  made.with("x_drive_W", [](double t) {
    return 250.0 + 250.0 * std::sin(t / 700.0) >= 300.0 ? (t < 18000 ? 300.0 : 40.0) : 0.0;
  });
  const std::vector<double> product = displacement_of(with_window({}), made);
  EXPECT_EQ(y, product);
  EXPECT_GT(*std::max_element(y.begin(), y.end()), 5e-6);
}

TEST(Window, NeedsItsColumn) {
  EXPECT_THAT(inputs_of(with_window(at_x({0, 1, 2, 3}))),
              Contains(Pointee(testing::Field(&Channel::name, "x_position_mm"))));
}

/// Loads and positions stand with their sign, speeds and feeds without.
TEST(RecordedColumns, ActAsTheyStand) {
  MadeRecord made(600, 60);
  made.with("axial_load_N", [](double t) { return t < 300 ? -500.0 : 200.0; })
      .with("x_feed_m_min", [](double) { return -12.0; });
  const Series series(made.record);
  const auto of = [&](const char* name) {
    return *series.input({.name = name, .columns = {record::series_channel(name)}});
  };
  EXPECT_NEAR(of("axial_load_N").front(), -500.0, 1e-9);
  EXPECT_NEAR(of("axial_load_N").back(), 200.0, 1e-9);
  EXPECT_NEAR(of("x_feed_m_min").back(), 0.2, 1e-12);
}

TEST(RecordedColumns, HaveTheUnitsOfTheirNames) {
  for (const auto& [name, variable, unit, one] :
       {std::tuple{"spindle_power_W", "spindle_power", "W", 1.0},
        {"axial_load_N", "axial_load", "N", 1.0},
        {"drive_torque_Nm", "drive_torque", "N m", 1.0},
        {"motor_current_A", "motor_current", "A", 1.0},
        {"z_position_mm", "z_position", "mm", 1e-3},
        {"coolant_flow_l_min", "coolant_flow", "l/min", 1.0 / 60000},
        {"oil_pressure_bar", "oil_pressure", "bar", 1e5},
        {"load_percent", "load", "%", 0.01}}) {
    const Channel* const c = record::series_channel(name);
    ASSERT_NE(c, nullptr) << name;
    EXPECT_EQ(c->variable, variable);
    EXPECT_EQ(c->unit, unit);
    EXPECT_NEAR(c->to_SI(1.0), one, 1e-15);
    EXPECT_TRUE(c->is_input());
  }
  // A length that is no position, and a letter that may be the name of a sensor.
  for (const char* name : {"probe_mm", "sensor_A", "_W"})
    EXPECT_EQ(record::series_channel(name), nullptr) << name;
}

}  // namespace
}  // namespace raceway::correction
