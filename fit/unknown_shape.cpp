#include "fit/unknown_shape.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "fit/screening.h"

namespace raceway::fit {

namespace {

/// One input of the formula, over a round reference value.
struct Input {
  const char* word;       // in the formula
  const char* exponent;   // its name
  double reference;       // in the unit of the word
  Eigen::VectorXd ratio;  // by row
  bool varies;
};

double round_number(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  return decade * std::round(value / decade);
}

}  // namespace

std::optional<Shape> find_unknown_shape(const Problem& problem, const NoiseModel& noise,
                                        const ResponseFit& base) {
  if (problem.data.quantity != Quantity::friction_torque) return std::nullopt;
  const auto rows = problem.measured.size();
  std::array<Input, 3> inputs{{{"speed_rpm", "a", 1.0, Eigen::VectorXd(rows), false},
                               {"axial_load_N", "b", 1.0, Eigen::VectorXd(rows), false},
                               {"viscosity_mm2_s", "d", 1.0, Eigen::VectorXd(rows), false}}};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const bearing::OperatingPoint& p = problem.data.rows[static_cast<std::size_t>(i)].point;
    inputs[0].ratio[i] = p.speed / rpm;
    inputs[1].ratio[i] = p.axial_load;
    inputs[2].ratio[i] = problem.model.lubricant.kinematic_viscosity(p.temperature) / mm2_per_s;
  }
  for (Input& input : inputs) {
    const double largest = input.ratio.maxCoeff();
    input.varies = input.ratio.minCoeff() > 0.0 && largest > 1.02 * input.ratio.minCoeff();
    if (!input.varies) continue;
    input.reference = round_number(std::exp(input.ratio.array().log().mean()));
    input.ratio /= input.reference;
  }
  const auto power = [&](const Eigen::Vector3d& exponents) {
    Eigen::ArrayXd product = Eigen::ArrayXd::Ones(rows);
    for (Eigen::Index k = 0; k < 3; ++k)
      if (inputs[static_cast<std::size_t>(k)].varies && exponents[k] != 0.0)
        product *= inputs[static_cast<std::size_t>(k)].ratio.array().pow(exponents[k]);
    return Eigen::VectorXd(product.matrix());
  };
  // Every combination of plain exponents, with the size that suits it best.
  struct Start {
    double gain, size;
    Eigen::Vector3d exponents;
  };
  std::vector<Start> starts;
  for (const double a : {0.0, 0.67, 1.33, 2.0, 3.0})
    for (const double b : {-0.5, 0.0, 0.67, 1.33})
      for (const double d : {-1.0, 0.0, 0.67, 1.5}) {
        if ((a != 0.0 && !inputs[0].varies) || (b != 0.0 && !inputs[1].varies) ||
            (d != 0.0 && !inputs[2].varies))
          continue;
        const Eigen::Vector3d exponents(a, b, d);
        const Eigen::VectorXd column = noise.whitening(power(exponents));
        const Eigen::VectorXd left = project_off(base.tangent, column);
        if (left.norm() < invisible * column.norm()) continue;
        const double size = left.dot(base.residual) / left.squaredNorm();
        starts.push_back({size * size * left.squaredNorm(), size, exponents});
      }
  if (starts.empty()) return std::nullopt;
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& x, const Start& y) { return x.gain > y.gain; });

  const Response plain = [&] {
    Response r = response_with(problem, {});
    r.find_affine_form();
    return r;
  }();
  Response response;
  response.parameters = plain.parameters;
  const double scale = std::max(1e-12, std::abs(starts.front().size));
  response.parameters.push_back({.name = "c",
                                 .unit = "N mm",
                                 .start = starts.front().size,
                                 .lower = -1e3 * scale,
                                 .upper = 1e3 * scale,
                                 .scale = scale});
  std::vector<Eigen::Index> moving;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Input& input = inputs[static_cast<std::size_t>(k)];
    if (!input.varies) continue;
    moving.push_back(k);
    response.parameters.push_back(
        {.name = input.exponent, .unit = "1", .start = 0.0, .lower = -4.0, .upper = 5.0});
  }
  const auto bases = static_cast<Eigen::Index>(plain.parameters.size());
  response.readings = [&](const Eigen::VectorXd& x) {
    Eigen::Vector3d exponents = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < moving.size(); ++k)
      exponents[moving[k]] = x[bases + 1 + static_cast<Eigen::Index>(k)];
    return Eigen::VectorXd(plain.at(x.head(bases)) + x[bases] * power(exponents));
  };
  std::vector<Eigen::VectorXd> points;
  for (std::size_t s = 0; s < std::min<std::size_t>(4, starts.size()); ++s) {
    Eigen::VectorXd x = response.start();
    x.head(bases) = base.values;
    x[bases] = starts[s].size;
    for (std::size_t k = 0; k < moving.size(); ++k)
      x[bases + 1 + static_cast<Eigen::Index>(k)] = starts[s].exponents[moving[k]];
    points.push_back(x);
  }
  const ResponseFit fit = fit_response(response, noise.whitening, problem.measured, points);
  if (!fit.converged) return std::nullopt;

  Shape shape;
  shape.formula = "c";
  const double size = fit.values[bases];
  shape.coefficients.push_back({.name = "c",
                                .unit = "N mm",
                                .value = size / N_mm,
                                .std = fit.standard_errors[bases] / N_mm});
  std::string powers;
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const Input& input = inputs[static_cast<std::size_t>(moving[k])];
    const Eigen::Index at = bases + 1 + static_cast<Eigen::Index>(k);
    shape.formula += fmt::format(" * ({} / {:g})^{}", input.word, input.reference, input.exponent);
    shape.coefficients.push_back({.name = input.exponent,
                                  .unit = "1",
                                  .value = fit.values[at],
                                  .std = fit.standard_errors[at],
                                  .at_bound = fit.at_bound[static_cast<std::size_t>(at)]});
    powers += fmt::format(" {}^{:.2f}{}", input.word, fit.values[at],
                          shape.coefficients.back().at_bound ? " (limit of the search)" : "");
  }
  // A rig of several bearings reads them all; a formula is of one.
  shape.coefficients.front().value /= problem.model.rig.bearings;
  shape.coefficients.front().std /= problem.model.rig.bearings;
  Eigen::Index strongest = 0;
  (fit.prediction - plain.at(fit.values.head(bases))).cwiseAbs().maxCoeff(&strongest);
  const bearing::OperatingPoint& where =
      problem.data.rows[static_cast<std::size_t>(strongest)].point;
  shape.statement =
      fmt::format("{}{}, strongest at {:.0f} rpm, {:.0f} N, {:.0f} C", size < 0.0 ? "-" : "+",
                  powers, where.speed / rpm, where.axial_load, where.temperature - kelvin(0));
  const double freedom = static_cast<double>(rows - base.tangent.cols());
  shape.gain = base.misfit - fit.misfit;
  shape.explained_share =
      std::clamp((base.misfit - fit.misfit) / std::max(1.0, base.misfit - freedom), 0.0, 1.0);
  return shape;
}

}  // namespace raceway::fit
