#include "fit/profile_interval.h"

#include <algorithm>
#include <cmath>

namespace raceway::fit {

namespace {

constexpr double close_to_the_end = 1e-4;  // of the distance to an end
constexpr int most_strides = 12;           // until an end is passed
constexpr int first_strides = 5;           // then the bound is tried, if there is one
constexpr int most_halvings = 20;

/// The response with one parameter held at a value.
Response held(const Response& response, std::size_t parameter, double value) {
  const auto at = static_cast<Eigen::Index>(parameter);
  Response reduced;
  reduced.parameters = response.parameters;
  reduced.parameters.erase(reduced.parameters.begin() + at);
  const auto whole = [at, value](const Eigen::VectorXd& x) {
    Eigen::VectorXd all(x.size() + 1);
    all << x.head(at), value, x.tail(x.size() - at);
    return all;
  };
  reduced.readings = [&response, whole](const Eigen::VectorXd& x) { return response.at(whole(x)); };
  if (response.affine) {
    const Eigen::MatrixXd& slope = response.affine->slope;
    Response::Affine form;
    form.constant = response.affine->constant + slope.col(at) * value;
    form.slope.resize(slope.rows(), slope.cols() - 1);
    form.slope << slope.leftCols(at), slope.rightCols(slope.cols() - 1 - at);
    reduced.affine = std::move(form);
  }
  return reduced;
}

/// The root of the rise of χ², over that at the end: 0 at the least, 1 at the end, and nearly
/// straight between them.
class ProfileRoot {
 public:
  ProfileRoot(const Response& response, const ResponseFit& fit, const Whitening& whitening,
              const Eigen::VectorXd& measured, std::size_t parameter, double factor)
      : response_(response),
        fit_(fit),
        whitening_(whitening),
        measured_(measured),
        parameter_(parameter),
        end_(normal_95 * factor),
        others_(fit.values.size() - 1) {
    const auto at = static_cast<Eigen::Index>(parameter);
    others_ << fit.values.head(at), fit.values.tail(others_.size() - at);
    near_ = others_;
  }

  /// Begins again where the fit ended.
  void begin() { near_ = others_; }

  double operator()(double value) {
    ++refits;
    const Response reduced = held(response_, parameter_, value);
    const ResponseFit refit =
        fit_response(reduced, whitening_, measured_, {near_, 0.95 * others_, others_});
    if (!refit.converged) return unset;
    near_ = refit.values;
    return std::sqrt(std::max(0.0, refit.misfit - fit_.misfit)) / end_;
  }

  int refits = 0;

 private:
  const Response& response_;
  const ResponseFit& fit_;
  const Whitening& whitening_;
  const Eigen::VectorXd& measured_;
  std::size_t parameter_;
  double end_;
  Eigen::VectorXd others_, near_;  // of the fit, and of the last refit
};

/// Where the root is 1 between a value where it is less and one where it is more, by the rule of
/// false position that halves what stays twice (Illinois).
double end_between(ProfileRoot& root, double inside, double below, double outside, double above) {
  double less = below - 1.0, more = above - 1.0;
  int last = 0;
  for (int k = 0; k < most_halvings; ++k) {
    const double middle = (inside * more - outside * less) / (more - less);
    const double found = root(middle) - 1.0;
    if (!(std::abs(found) > close_to_the_end)) return std::isnan(found) ? unset : middle;
    const int side = found < 0.0 ? -1 : 1;
    (side < 0 ? inside : outside) = middle;
    (side < 0 ? less : more) = found;
    if (side == last) (side < 0 ? more : less) *= 0.5;
    last = side;
  }
  return unset;
}

struct End {
  double value = unset;
  bool open = false;
};

/// The end on one side of `best`; `step` is where it would be of a linear model.
End end_towards(ProfileRoot& root, double best, double step, double bound) {
  root.begin();
  double inside = best, below = 0.0;
  bool beyond_prediction = false;
  for (int k = 0; k < most_strides; ++k) {
    double outside = inside + step;
    if (k >= first_strides && std::isfinite(bound) && !beyond_prediction) outside = bound;
    const bool last = std::abs(outside - best) >= std::abs(bound - best);
    if (last) outside = bound;
    if (outside == best) return {bound, true};
    const double risen = root(outside);
    if (std::isnan(risen)) {
      beyond_prediction = true;
      step = 0.5 * (outside - inside);
      continue;
    }
    if (std::abs(risen - 1.0) <= close_to_the_end) return {outside, false};
    if (risen > 1.0) return {end_between(root, inside, below, outside, risen), false};
    if (last) return {bound, true};
    // A little further than a straight line would have to go.
    step = (outside - best) * (std::clamp(1.1 / risen, 1.05, 4.0) - 1.0);
    inside = outside;
    below = risen;
  }
  if (beyond_prediction) return {};
  return {bound, true};
}

}  // namespace

ProfileInterval profile_interval(const Response& response, const ResponseFit& fit,
                                 const Whitening& whitening, const Eigen::VectorXd& measured,
                                 std::size_t parameter, double factor) {
  const auto at = static_cast<Eigen::Index>(parameter);
  const Parameter& p = response.parameters[parameter];
  const double best = fit.values[at], std = fit.standard_errors[at];
  const double step = std > 0.0 && std::isfinite(std) ? normal_95 * factor * std : 0.1 * p.scale;
  if (factor == 0.0) return {.lower = best, .upper = best};
  ProfileRoot root(response, fit, whitening, measured, parameter, factor);
  const End lower = end_towards(root, best, -step, p.lower);
  const End upper = end_towards(root, best, step, p.upper);
  return {lower.value, upper.value, lower.open, upper.open, root.refits};
}

}  // namespace raceway::fit
