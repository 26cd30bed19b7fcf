// The covariance of what was fitted, in a model file and back.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "files/model_file.h"
#include "tests/support/message_of.h"

namespace raceway::results {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string rig_text = R"([bearing]
name = "7014"
ball_count = 20
ball_diameter_mm = 11.906
pitch_diameter_mm = 90
contact_angle_deg = 25.0
inner_conformity = 0.52
outer_conformity = 0.52
static_load_rating_N = 43000

[lubricant]
viscosity_40C_mm2_s = 22.0
viscosity_100C_mm2_s = 4.8

[friction]
f0 = 1.5 # guessed
z = 0.001
y = 0.33

[calibration]
free = ["f0", "z", "windage.torque_at_10000_rpm_Nmm"]

[[effect]]
id = "windage"
torque_at_10000_rpm_Nmm = 60.0   # measured
)";

const std::string covariance = R"(
[calibration.covariance]
parameters = ["f0", "torque_at_10000_rpm_Nmm"]
units = ["1", "N mm"]
values = [1.5, 60.0]
std = [0.05, 4]
correlation = [[1], [-0.5, 1]]
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

std::string message(const std::string& from, const std::string& to) {
  return tests::message_of(
      [&] { (void)files::parse_model(replaced(rig_text + covariance, from, to), "m.toml"); });
}

fit::Covariance found() {
  fit::Covariance c{.names = {"f0", "z", "windage.torque_at_10000_rpm_Nmm"},
                    .values = Eigen::Vector3d(1.623456789012345678, 0.00123, 58.25),
                    .matrix = {}};
  const Eigen::Vector3d std(0.0512345, 4.5e-5, 3.75);
  c.matrix = std.asDiagonal() *
             Eigen::Matrix3d{{1.0, -0.875, -0.5}, {-0.875, 1.0, 0.25}, {-0.5, 0.25, 1.0}} *
             std.asDiagonal();
  return c;
}

model::Model fitted() {
  model::Model model = files::parse_model(rig_text, "m.toml").model;
  model.law_values = {1.623456789012345678, 0.00123, 0.33};
  model.effects[0].values = {58.25};
  model.covariance = found();
  return model;
}

void expect_found(const model::Model& model) {
  ASSERT_TRUE(model.covariance.has_value());
  EXPECT_EQ(model.covariance->names, found().names);
  EXPECT_TRUE(model.covariance->values.isApprox(found().values, 1e-14));
  EXPECT_TRUE(model.covariance->matrix.isApprox(found().matrix, 1e-6));
}

TEST(Covariance, IsReadByShortNamesToo) {
  const files::ModelFile file = files::parse_model(rig_text + covariance, "m.toml");
  ASSERT_TRUE(file.model.covariance.has_value());
  EXPECT_EQ(file.model.covariance->names[1], "windage.torque_at_10000_rpm_Nmm");
  EXPECT_DOUBLE_EQ(file.model.covariance->matrix(0, 1), -0.5 * 0.05 * 4.0);
  EXPECT_DOUBLE_EQ(file.model.covariance->matrix(1, 1), 16.0);
  EXPECT_TRUE(file.notes.empty());
}

TEST(Covariance, IsWrittenBehindAllElseAndReadBack) {
  const std::string text = files::with_model(files::parse_model(rig_text, "m.toml"), fitted());
  EXPECT_THAT(text, HasSubstr("f0 = 1.62345678901235 # guessed"));
  EXPECT_THAT(text, HasSubstr("# measured\n\n[calibration.covariance]"));
  EXPECT_THAT(text, HasSubstr("std = [0.0512345, 4.5e-05, 3.75]"));
  EXPECT_THAT(text, HasSubstr("  [-0.875, 1.0],\n"));
  const files::ModelFile back = files::parse_model(text, "m.toml");
  EXPECT_TRUE(back.notes.empty());
  expect_found(back.model);
}

TEST(Covariance, TakesThePlaceOfTheOneBefore) {
  for (const std::string& before :
       {rig_text + covariance, rig_text + covariance + "\n[rig]\nbearings = 2\n",
        replaced(rig_text, "[[effect]]", covariance.substr(1) + "\n[[effect]]")}) {
    const files::ModelFile file = files::parse_model(before, "m.toml");
    const std::string text = files::with_model(file, fitted());
    EXPECT_EQ(text.find("[calibration.covariance]"), text.rfind("[calibration.covariance]"));
    const files::ModelFile back = files::parse_model(text, "m.toml");
    expect_found(back.model);
    // Written again it does not grow.
    EXPECT_EQ(files::with_model(back, back.model), text);
    // A model without one has none.
    model::Model without = fitted();
    without.covariance.reset();
    EXPECT_THAT(files::with_model(file, without), Not(HasSubstr("covariance")));
  }
}

TEST(Covariance, KeepsCrlf) {
  std::string text = rig_text;
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 2)
    text.insert(at, 1, '\r');
  const std::string written = files::with_model(files::parse_model(text, "m.toml"), fitted());
  for (std::size_t at = 0; (at = written.find('\n', at)) != written.npos; ++at)
    ASSERT_EQ(written[at - 1], '\r');
  const files::ModelFile back = files::parse_model(written, "m.toml");
  expect_found(back.model);
  EXPECT_EQ(files::with_model(back, back.model), written);
}

TEST(Covariance, IsOfNoUseForOtherValues) {
  const files::ModelFile file =
      files::parse_model(replaced(rig_text + covariance, "f0 = 1.5", "f0 = 1.7"), "m.toml");
  EXPECT_FALSE(file.model.covariance.has_value());
  ASSERT_EQ(file.notes.size(), 1U);
  EXPECT_THAT(
      file.notes[0].text,
      HasSubstr(
          "the model has f0 = 1.7, but [calibration.covariance] was calculated for f0 = 1.5"));
}

TEST(Covariance, IsRefusedWithLineAndKey) {
  EXPECT_THAT(message("\"f0\", \"torque_", "\"f00\", \"torque_"),
              HasSubstr("m.toml:28: parameters = \"f00\": no such parameter; did you mean f0?"));
  EXPECT_THAT(message("\"1\", \"N mm\"", "\"1\", \"N\""),
              HasSubstr("m.toml:29: units = \"N\": the unit of windage.torque_at_10000_rpm_Nmm "
                        "must be \"N mm\""));
  EXPECT_THAT(message("values = [1.5, 60.0]", "values = [1.5]"),
              HasSubstr("m.toml:30: values = [...]: must be a list of length 2"));
  EXPECT_THAT(message("[0.05, 4]", "[0.05, -4]"), HasSubstr("m.toml:31: std"));
  EXPECT_THAT(message("[0.05, 4]", "[0.05, nan]"), HasSubstr("must be a number"));
  EXPECT_THAT(message("-0.5, 1]", "-1.5, 1]"), HasSubstr("m.toml:32: correlation = -1.5"));
  EXPECT_THAT(message("-0.5, 1]", "-0.5, 2]"), HasSubstr("each row must end with 1"));
  EXPECT_THAT(message("std = [0.05, 4]\n", ""), HasSubstr("std is missing"));
  EXPECT_THAT(message("std =", "sdt ="), HasSubstr("unknown key"));
}

TEST(Covariance, IsRefusedWhereNoParametersCanBeCorrelatedLikeThat) {
  std::string text = rig_text + covariance;
  text = replaced(text, "[\"f0\", \"torque", "[\"z\", \"f0\", \"torque");
  text = replaced(text, "[\"1\", \"N mm", "[\"1\", \"1\", \"N mm");
  text = replaced(text, "[1.5, 60", "[0.001, 1.5, 60");
  text = replaced(text, "[0.05, 4]", "[1e-4, 0.05, 4]");
  text = replaced(text, "[[1], [-0.5, 1]]", "[[1], [0.9, 1], [-0.9, 0.9, 1]]");
  EXPECT_THAT(tests::message_of([&] { (void)files::parse_model(text, "m.toml"); }),
              HasSubstr("m.toml:32: correlation: the matrix is not positive semidefinite"));
}

}  // namespace
}  // namespace raceway::results
