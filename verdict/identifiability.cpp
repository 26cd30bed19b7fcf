#include "verdict/identifiability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "algebra/detail/decompositions.h"
#include "verdict/verdict_text.h"

namespace raceway::verdict {

namespace {

constexpr double dependent = 1e-6;  // share of a unit column that others leave; below, it is theirs

/// Whether a column adds anything to those before it, and to which of them it belongs if not.
struct Dependence {
  bool dependent = false;
  std::vector<Eigen::Index> on;  // empty where the column is zero
};

std::vector<Dependence> column_dependence(const Eigen::MatrixXd& jacobian) {
  std::vector<Dependence> result(static_cast<std::size_t>(jacobian.cols()));
  const double largest = jacobian.colwise().norm().maxCoeff();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < jacobian.cols(); ++k) {
    Dependence& d = result[static_cast<std::size_t>(k)];
    const double norm = jacobian.col(k).norm();
    if (!(norm > 1e-12 * largest)) {
      d.dependent = true;
      continue;
    }
    const Eigen::VectorXd column = jacobian.col(k) / norm;
    if (!kept.empty()) {
      Eigen::MatrixXd before(jacobian.rows(), static_cast<Eigen::Index>(kept.size()));
      for (std::size_t j = 0; j < kept.size(); ++j)
        before.col(static_cast<Eigen::Index>(j)) =
            jacobian.col(kept[j]) / jacobian.col(kept[j]).norm();
      const Eigen::VectorXd share = algebra::least_squares(before, column);
      if ((column - before * share).norm() < dependent) {
        d.dependent = true;
        for (std::size_t j = 0; j < kept.size(); ++j)
          if (std::abs(share[static_cast<Eigen::Index>(j)]) > 1e-3) d.on.push_back(kept[j]);
        continue;
      }
    }
    kept.push_back(k);
  }
  return result;
}

/// Dependence at a point; nothing where it cannot be predicted.
std::optional<std::vector<Dependence>> dependence_at(const fit::Response& response,
                                                     const fit::Whitening& whitening,
                                                     const Eigen::VectorXd& x) {
  const Eigen::MatrixXd slope = response.jacobian(x);
  if (!slope.allFinite()) return std::nullopt;
  Eigen::MatrixXd jacobian = whitening(slope);
  for (Eigen::Index k = 0; k < jacobian.cols(); ++k)
    jacobian.col(k) *= response.parameters[static_cast<std::size_t>(k)].scale;
  return column_dependence(jacobian);
}

/// Standard errors and correlation of the parameters that are free to move at the solution.
class Errors {
 public:
  Errors(const Eigen::MatrixXd& jacobian, double factor, Calibration& result)
      : jacobian_(jacobian), factor_(factor), result_(result) {
    for (std::size_t k = 0, column = 0; k < result.parameters.size(); ++k) {
      if (result.parameters[k].held) continue;
      if (result.parameters[k].at_bound == record::Bound::none) {
        free_.push_back(k);
        columns_.push_back(static_cast<Eigen::Index>(column));
      }
      ++column;
    }
    const auto count = static_cast<Eigen::Index>(result.parameters.size());
    result.correlation = Eigen::MatrixXd::Constant(count, count, unset);
  }

  void estimate() {
    check_bounds();
    if (free_.empty()) return;
    find_covariance();
    for (std::size_t k = 0; k < free_.size(); ++k) set_error(k);
    for (std::size_t a = 0; a < free_.size(); ++a)
      for (std::size_t b = 0; b < free_.size(); ++b) set_correlation(a, b);
  }

 private:
  /// A parameter at its bound has no error. Where nothing depends on it there, or the bound is one
  /// of the computation and not of any machine, it is not the data that want it so far.
  void check_bounds() {
    constexpr double beyond_reason = 1000.0;  // times the start, or of it
    Eigen::Index column = 0;
    for (record::Parameter& p : result_.parameters) {
      if (p.held) continue;
      const double norm = jacobian_.col(column++).norm();
      if (p.at_bound == record::Bound::none) continue;
      const double times = p.value != 0.0 ? std::abs(p.value / p.start) : 1.0;
      if (times > beyond_reason || times * beyond_reason < 1.0 ||
          (!std::isnan(factor_) && factor_ > norm * (p.upper - p.lower)))
        p.identifiable = false;
    }
  }

  void find_covariance() {
    const auto size = static_cast<Eigen::Index>(free_.size());
    Eigen::MatrixXd scaled = jacobian_(Eigen::all, columns_);
    norm_ = scaled.colwise().norm();
    for (Eigen::Index k = 0; k < size; ++k)
      if (norm_[k] > 0.0) scaled.col(k) /= norm_[k];
    const auto [singular, v] = algebra::right_svd(scaled);
    covariance_ = Eigen::MatrixXd::Zero(size, size);
    lost_.assign(free_.size(), false);
    for (Eigen::Index s = 0; s < singular.size(); ++s) {
      if (singular[s] > dependent * singular[0]) {
        covariance_ += v.col(s) * v.col(s).transpose() / (singular[s] * singular[s]);
        continue;
      }
      std::vector<std::string> group;
      for (Eigen::Index k = 0; k < size; ++k) {
        if (std::abs(v(k, s)) < 1e-3) continue;
        lost_[static_cast<std::size_t>(k)] = true;
        group.push_back(parameter(static_cast<std::size_t>(k)).name);
      }
      result_.messages.push_back(record::note::not_identifiable(fmt::format(
          "these data cannot separate {} near the fitted values", joined(group, "and"))));
    }
  }

  void set_error(std::size_t k) {
    record::Parameter& p = parameter(k);
    const auto at = static_cast<Eigen::Index>(k);
    if (lost_[k] || !(norm_[at] > 0.0)) p.identifiable = false;
    if (!p.identifiable) return;
    p.std = factor_ * std::sqrt(covariance_(at, at)) / norm_[at];
    if (!(p.std > p.upper - p.lower)) return;
    result_.messages.push_back(record::note::not_identifiable(
        fmt::format("these data do not determine {}: the standard error would be {}, which is "
                    "larger than the distance between the bounds of this parameter",
                    p.name, with_unit(p.std, p.unit, 5)),
        {.key = p.name}));
    p.identifiable = false;
    p.std = unset;
  }

  void set_correlation(std::size_t a, std::size_t b) {
    const record::Parameter &first = parameter(a), &second = parameter(b);
    if (!first.identifiable || !second.identifiable || std::isnan(factor_)) return;
    const auto i = static_cast<Eigen::Index>(a), j = static_cast<Eigen::Index>(b);
    const double c = covariance_(i, j) / std::sqrt(covariance_(i, i) * covariance_(j, j));
    result_.correlation(static_cast<Eigen::Index>(free_[a]), static_cast<Eigen::Index>(free_[b])) =
        a == b ? 1.0 : c;
    if (a < b && std::abs(c) > 0.99)
      result_.messages.push_back(record::note::not_identifiable(
          fmt::format("{} and {} have a correlation of {:.4f}: these data determine a combination "
                      "of them far better than each of them",
                      first.name, second.name, c)));
  }

  record::Parameter& parameter(std::size_t k) { return result_.parameters[free_[k]]; }

  const Eigen::MatrixXd& jacobian_;
  double factor_;
  Calibration& result_;
  std::vector<std::size_t> free_;      // parameters
  std::vector<Eigen::Index> columns_;  // of the Jacobian, which held ones have none in
  Eigen::VectorXd norm_;
  Eigen::MatrixXd covariance_;
  std::vector<bool> lost_;
};

}  // namespace

void hold_dependent(const fit::Response& response, const fit::Whitening& whitening,
                    const std::function<std::string(const std::string& parameter)>& lacks,
                    Calibration& result) {
  // A second point, because a parameter may be without effect at its start only (the shape of an
  // effect whose size starts at zero).
  const Eigen::VectorXd start = response.start();
  Eigen::VectorXd moved = start;
  for (Eigen::Index k = 0; k < start.size(); ++k) {
    const record::Parameter& p = response.parameters[static_cast<std::size_t>(k)];
    const double step = (0.1 + 0.03 * static_cast<double>(k)) * p.scale;
    moved[k] = start[k] + step <= p.upper ? start[k] + step : std::max(start[k] - step, p.lower);
  }
  const auto here = dependence_at(response, whitening, start);
  const auto there = dependence_at(response, whitening, moved);
  if (!here || !there) return;
  for (std::size_t k = 0; k < here->size(); ++k) {
    if (!(*here)[k].dependent || !(*there)[k].dependent) continue;
    record::Parameter& p = result.parameters[k];
    p.held = true;
    p.identifiable = false;
    std::vector<std::string> group;
    for (const Eigen::Index j : (*there)[k].on) {
      record::Parameter& other = result.parameters[static_cast<std::size_t>(j)];
      other.identifiable = false;
      group.push_back(other.name);
    }
    if (group.empty()) {
      const std::string needed = lacks(p.name);
      result.messages.push_back(record::note::not_identifiable(
          needed.empty() ? fmt::format("the readings do not depend on {}, which stays at {}",
                                       p.name, with_unit(p.value, p.unit, 5))
                         : not_identifiable(p, needed),
          {.key = p.name}));
      continue;
    }
    group.push_back(p.name);
    result.messages.push_back(record::note::not_identifiable(
        fmt::format(
            "these data cannot separate {}: {} is kept at {}, and the other {} no standard error",
            joined(group, "and"), p.name, with_unit(p.value, p.unit, 5),
            group.size() == 2 ? "value has" : "values have"),
        {.key = p.name}));
  }
}

std::string not_identifiable(const record::Parameter& held, const std::string& needed) {
  return fmt::format("these data do not determine {0}, which stays at {1}; {0} needs {2}",
                     held.name, with_unit(held.value, held.unit, 5), needed);
}

void estimate_errors(const Eigen::MatrixXd& jacobian, double factor, Calibration& result) {
  Errors(jacobian, factor, result).estimate();
}

}  // namespace raceway::verdict
