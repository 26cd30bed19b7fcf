#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/band.h"
#include "model/parameters.h"
#include "shaft/shaft_prediction.h"
#include "tests/support/shafts.h"

namespace raceway::shaft {
namespace {

std::vector<double> positions(const model::Model& model) {
  std::vector<ShaftPoint> points;
  for (const double speed : {2000.0, 8000.0, 16000.0}) points.push_back({.speed = speed * rpm});
  std::vector<double> list;
  for (const ShaftPrediction& p : predict_shaft(model, points)) list.push_back(p.displacement);
  return list;
}

// The preload acts on the position through the balance of the sets, and not linearly.
TEST(DisplacementBand, IsTheScatterOfShaftsDrawnFromTheCovarianceOfTheirPreload) {
  model::Model model = fit::two_against_one();
  constexpr double preload = 600.0, std = 25.0;
  model.covariance = fit::Covariance{.names = {"preload_N"},
                                     .values = Eigen::VectorXd::Constant(1, preload),
                                     .matrix = Eigen::MatrixXd::Constant(1, 1, std * std)};
  const std::vector<double> band = model::Band(model)(positions);
  const auto known = model::parameters(model);
  const auto place =
      std::find_if(known.begin(), known.end(), [](const auto& p) { return p.name == "preload_N"; });
  constexpr int draws = 1500;
  std::mt19937 random(11);
  std::normal_distribution<double> gauss(preload, std);
  std::vector<double> sum(band.size(), 0.0), square(band.size(), 0.0);
  for (int d = 0; d < draws; ++d) {
    model::Model drawn = model;
    model::set(drawn, *place, gauss(random));
    const std::vector<double> found = positions(drawn);
    for (std::size_t i = 0; i < found.size(); ++i) {
      sum[i] += found[i];
      square[i] += found[i] * found[i];
    }
  }
  for (std::size_t i = 0; i < band.size(); ++i) {
    const double mean = sum[i] / draws;
    const double scatter = std::sqrt(square[i] / draws - mean * mean);
    EXPECT_GT(band[i], 0.0);
    EXPECT_NEAR(band[i] / 1.96, scatter, 0.075 * scatter) << i;  // four times 1.8 %
  }
}

}  // namespace
}  // namespace raceway::shaft
