#include "model/band.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "effects/catalogue.h"
#include "model/parameters.h"
#include "model/prediction.h"
#include "tests/support/synthetic.h"

namespace raceway::model {
namespace {

constexpr double two_sided = 1.959963984540054;

/// As if f0 and z of the synthetic rig had been fitted.
Model fitted(double std_f0, double std_z, double correlation) {
  Model model = fit::synthetic_model();
  fit::Covariance c{.names = {"f0", "z"}, .values = Eigen::Vector2d(1.5, 0.001), .matrix = {}};
  const double both = correlation * std_f0 * std_z;
  c.matrix = Eigen::Matrix2d{{std_f0 * std_f0, both}, {both, std_z * std_z}};
  model.covariance = c;
  return model;
}

std::vector<bearing::OperatingPoint> points() {
  std::vector<bearing::OperatingPoint> list;
  for (const double speed : {500.0, 5000.0, 15000.0})
    for (const double load : {100.0, 2000.0})
      list.push_back({.speed = speed * rpm, .axial_load = load, .temperature = kelvin(50)});
  return list;
}

/// Torque and loss at every point, and the heat of one ring.
std::vector<double> outputs(const Model& model) {
  std::vector<double> list;
  for (const bearing::OperatingPoint& p : points()) {
    const FrictionPrediction f = predict_friction(model, p);
    list.push_back(f.torque);
    list.push_back(f.power_loss);
  }
  return list;
}

TEST(Band, IsTheSlopeTimesTheStandardErrorWhereTheTorqueIsLinear) {
  const Model model = fitted(0.05, 0.0, 0.0);
  const std::vector<double> band = Band(model)(outputs);
  Model more = model;
  more.law_values[0] += 1.0;
  const std::vector<double> here = outputs(model), there = outputs(more);
  ASSERT_EQ(band.size(), here.size());
  for (std::size_t i = 0; i < band.size(); ++i)  // M is linear in f0
    EXPECT_NEAR(band[i], two_sided * 0.05 * (there[i] - here[i]), 1e-9 * here[i]);
}

TEST(Band, CountsThatErrorsOfTwoParametersCancel) {
  const Model lone = fitted(0.05, 0.0, 0.0), other = fitted(0.0, 1e-4, 0.0);
  const std::vector<double> a = Band(lone)(outputs), b = Band(other)(outputs);
  for (const double correlation : {-0.9, 0.0, 0.9}) {
    const std::vector<double> both = Band(fitted(0.05, 1e-4, correlation))(outputs);
    for (std::size_t i = 0; i < both.size(); ++i)
      EXPECT_NEAR(both[i], std::sqrt(a[i] * a[i] + b[i] * b[i] + 2.0 * correlation * a[i] * b[i]),
                  1e-9 * (a[i] + b[i]));
  }
}

// Parameters drawn from the covariance, each draw predicted as a model of its own.
TEST(Band, IsTheScatterOfModelsDrawnFromTheCovariance) {
  Model model = fitted(0.05, 4e-5, -0.8);
  model.effects.push_back({.description = effects::find("windage"), .values = {60.0}});
  fit::Covariance& c = *model.covariance;
  c.names.emplace_back("windage.torque_at_10000_rpm_Nmm");
  c.values = Eigen::Vector3d(1.5, 0.001, 60.0);
  const Eigen::Vector3d std(0.05, 4e-5, 5.0);
  const Eigen::Matrix3d correlation{{1.0, -0.8, -0.5}, {-0.8, 1.0, 0.3}, {-0.5, 0.3, 1.0}};
  c.matrix = std.asDiagonal() * correlation * std.asDiagonal();
  const std::vector<double> band = Band(model)(outputs);
  const Eigen::Matrix3d root = Eigen::LLT<Eigen::Matrix3d>(Eigen::Matrix3d(c.matrix)).matrixL();
  const std::vector<record::Parameter> known = parameters(model);
  constexpr int draws = 4000;
  std::mt19937 random(7);
  std::normal_distribution<double> gauss;
  std::vector<double> sum(band.size(), 0.0), square(band.size(), 0.0);
  for (int d = 0; d < draws; ++d) {
    const Eigen::Vector3d values =
        c.values + root * Eigen::Vector3d(gauss(random), gauss(random), gauss(random));
    Model drawn = model;
    for (std::size_t k = 0; k < c.names.size(); ++k)
      set(drawn,
          *std::find_if(known.begin(), known.end(),
                        [&](const auto& p) { return p.name == c.names[k]; }),
          values[static_cast<Eigen::Index>(k)]);
    const std::vector<double> found = outputs(drawn);
    for (std::size_t i = 0; i < found.size(); ++i) {
      sum[i] += found[i];
      square[i] += found[i] * found[i];
    }
  }
  for (std::size_t i = 0; i < band.size(); ++i) {
    const double mean = sum[i] / draws;
    const double scatter = std::sqrt(square[i] / draws - mean * mean);
    // A standard deviation of 4000 draws is known to 1.1 %: four of these.
    EXPECT_NEAR(band[i] / two_sided, scatter, 0.045 * scatter) << i;
  }
}

TEST(Band, IsOneSidedAtABound) {
  Model model = fitted(0.05, 0.0, 0.0);
  model.law_values[0] = 0.1;  // the lower bound of f0
  model.covariance->values[0] = 0.1;
  const std::vector<double> at_bound = Band(model)(outputs);
  const std::vector<double> inside = Band(fitted(0.05, 0.0, 0.0))(outputs);
  for (std::size_t i = 0; i < inside.size(); ++i)
    EXPECT_NEAR(at_bound[i], inside[i], 1e-9 * inside[i]);
}

TEST(Band, HasNoNumberWhereThereIsNoPrediction) {
  const Model model = fitted(0.05, 1e-4, 0.0);
  const std::vector<double> band = Band(model)([](const Model&) {
    return std::vector<double>{unset, 1.0};
  });
  EXPECT_TRUE(std::isnan(band[0]));
  EXPECT_EQ(band[1], 0.0);
}

TEST(Band, NeedsACovarianceOfParametersThatThereAre) {
  EXPECT_THROW(Band{fit::synthetic_model()}, std::invalid_argument);
  Model model = fitted(0.05, 1e-4, 0.0);
  model.covariance->names[1] = "zz";
  EXPECT_THROW(Band{model}, std::invalid_argument);
}

}  // namespace
}  // namespace raceway::model
