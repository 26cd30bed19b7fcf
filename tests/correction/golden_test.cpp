// Rows of data/reference/correction_reference.json that stand beside those of single laws.
#include <gmock/gmock.h>

#include <set>
#include <string>

#include "correction/friction_table.h"
#include "correction/series.h"
#include "tests/correction/made_record.h"
#include "tests/correction/reference.h"
#include "tests/places.h"

namespace raceway::correction {
namespace {

TEST(Golden, PowerIsTorqueTimesAngularSpeed) {
  const auto known = reference("S0_power");
  const double torque = known["torque_Nm"], speed = known["speed_rpm"];
  auto table = std::make_shared<FrictionTable>();
  table->speed = {0.0, 2.0 * speed * rpm};
  table->axial_load = {500.0};
  table->temperature = {kelvin(40)};
  table->torque = {torque, torque};
  const Input power{.name = "power_W",
                    .table = table,
                    .axial_load = {500.0},
                    .radial_load = {0.0},
                    .temperature = {kelvin(40)}};
  MadeRecord made(100, 10);
  made.with("speed_rpm", [&](double) { return speed; });
  const Series series(made.record);
  for (const double p : *series.input(power))
    EXPECT_NEAR(p / known["power_W"].get<double>(), 1.0, 1e-10);
}

/// A row that is new in the file has no test yet.
TEST(Golden, EveryRowIsHeldByATest) {
  const std::set<std::string> held{
      // transfer_function_test.cpp
      "tf_S2_SP1", "tf_S2_amb", "tf_S2_SP2", "tf_S3_Z_amb", "tf_S3_Z_X", "tf_S3_Z_Y", "tf_S3_Z_Z",
      "why_not_polynomials",
      // metrics_test.cpp
      "fit_known_answer", "metrics_small", "S2_table5_correction", "S0_reduction",
      // delay_element_test.cpp
      "S0_K_T", "S0_state_form_varying", "S0_kinematic",
      // lag_test.cpp
      "foh_tau900_dt10", "foh_tau5400_dt60", "foh_uneven", "delta_form_float32",
      // regression_test.cpp
      "mlr_small", "gain_model",
      // here, and tests/cli/correction_golden_test.cpp
      "S0_power", "identify_exact-01", "identify_exact-02"};
  std::set<std::string> rows;
  const nlohmann::json all = nlohmann::json::parse(
      std::ifstream(tests::source_dir() + "/data/reference/correction_reference.json"));
  for (const auto& [name, _] : all.items()) rows.insert(name);
  EXPECT_EQ(rows, held);
}

}  // namespace
}  // namespace raceway::correction
