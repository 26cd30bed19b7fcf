#include "fit/whitening.h"

#include <cmath>
#include <utility>

namespace raceway::fit {

Whitening::Whitening(Eigen::VectorXd std, const RowOrder& order, double correlation,
                     double run_share, double state_share, const Eigen::VectorXd& common,
                     double run_unit)
    : std_(std::move(std)) {
  log_determinant_ = 2.0 * std_.array().log().sum();
  if (correlation <= 0.0 && run_share <= 0.0 && state_share <= 0.0) return;
  const double ar_variance = 1.0 - run_share - state_share;
  // Covariance of the three states: a autoregressive, b of the run, c of the dwell.
  double p_aa = 0.0, p_ab = 0.0, p_bb = 0.0, p_ac = 0.0, p_bc = 0.0, p_cc = 0.0;
  for (std::size_t i = 0; i < order.step.size(); ++i) {
    Step step{};
    step.decay = correlation > 0.0 && std::isfinite(order.step[i])
                     ? std::pow(correlation, order.step[i])
                     : 0.0;
    step.new_run = i == 0 || order.new_run[i];
    step.new_state = i == 0 || order.new_state.empty() || order.new_state[i];
    step.common = common.size() > 0 ? common[static_cast<Eigen::Index>(i)] : 1.0;
    p_aa = step.decay * step.decay * p_aa + (1.0 - step.decay * step.decay) * ar_variance;
    p_ab = step.new_run ? 0.0 : step.decay * p_ab;
    p_bb = step.new_run ? run_share : p_bb;
    p_ac = step.new_state ? 0.0 : step.decay * p_ac;
    p_bc = step.new_run || step.new_state ? 0.0 : p_bc;
    p_cc = step.new_state ? state_share : p_cc;
    if (run_unit > 0.0) step.run = run_unit / std_[static_cast<Eigen::Index>(i)];
    const double h = step.common, r = step.run;
    const double together =
        p_aa + 2.0 * r * p_ab + r * r * p_bb + (2.0 * p_ac + 2.0 * r * p_bc + p_cc);
    const double variance = h * h * together + (1.0 - h * h);
    step.gain_ar = h * (p_aa + r * p_ab + p_ac) / variance;
    step.gain_run = h * (p_ab + r * p_bb + p_bc) / variance;
    step.gain_state = h * (p_ac + r * p_bc + p_cc) / variance;
    step.inverse_std = 1.0 / std::sqrt(variance);
    log_determinant_ += std::log(variance);
    p_aa -= step.gain_ar * step.gain_ar * variance;
    p_ab -= step.gain_ar * step.gain_run * variance;
    p_bb -= step.gain_run * step.gain_run * variance;
    p_ac -= step.gain_ar * step.gain_state * variance;
    p_bc -= step.gain_run * step.gain_state * variance;
    p_cc -= step.gain_state * step.gain_state * variance;
    steps_.push_back(step);
  }
}

Whitening::Whitening(const std::vector<Whitening>& parts) {
  Eigen::Index size = 0;
  bool steps = false;
  for (const Whitening& part : parts) {
    size += part.std_.size();
    steps = steps || !part.steps_.empty();
  }
  std_.resize(size);
  Eigen::Index at = 0;
  for (const Whitening& part : parts) {
    std_.segment(at, part.std_.size()) = part.std_;
    at += part.std_.size();
    log_determinant_ += part.log_determinant_;
    if (!steps) continue;
    // Both states start anew with each part; an independent reading has none.
    std::vector<Step> own = part.steps_;
    if (own.empty())
      own.assign(static_cast<std::size_t>(part.std_.size()),
                 {.decay = 0.0, .new_run = true, .gain_ar = 0.0, .gain_run = 0.0});
    steps_.insert(steps_.end(), own.begin(), own.end());
  }
}

Whitening Whitening::scaled(double factor) const {
  Whitening result = *this;
  result.std_ *= factor;
  result.log_determinant_ += 2.0 * static_cast<double>(std_.size()) * std::log(factor);
  return result;
}

/// So many columns together: one alone waits for the result of each row before the next.
template <std::size_t count>
void Whitening::follow(double* first, Eigen::Index stride) const {
  double ar[count] = {}, run[count] = {}, state[count] = {};
  for (const Step& step : steps_) {
    double* value = first++;
    for (std::size_t c = 0; c < count; ++c, value += stride) {
      ar[c] *= step.decay;
      if (step.new_run) run[c] = 0.0;
      if (step.new_state) state[c] = 0.0;
      const double innovation = *value - step.common * (ar[c] + step.run * run[c] + state[c]);
      ar[c] += step.gain_ar * innovation;
      run[c] += step.gain_run * innovation;
      state[c] += step.gain_state * innovation;
      *value = innovation * step.inverse_std;
    }
  }
}

Eigen::MatrixXd Whitening::operator()(const Eigen::MatrixXd& columns) const {
  Eigen::MatrixXd result = std_.cwiseInverse().asDiagonal() * columns;
  if (steps_.empty()) return result;
  constexpr int together = 4;
  Eigen::Index c = 0;
  for (; c + together <= result.cols(); c += together)
    follow<together>(result.col(c).data(), result.outerStride());
  for (; c < result.cols(); ++c) follow<1>(result.col(c).data(), result.outerStride());
  return result;
}

Eigen::VectorXd Whitening::operator()(const Eigen::VectorXd& column) const {
  return (*this)(Eigen::MatrixXd(column)).col(0);
}

}  // namespace raceway::fit
