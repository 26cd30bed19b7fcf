#include "verdict/unknown_shape.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "fit/subspace.h"
#include "verdict/gate.h"

namespace raceway::verdict {

namespace {

constexpr std::size_t most_starts = 4;

double round_number(double value) {
  const double power_of_ten = std::pow(10.0, std::floor(std::log10(value)));
  return power_of_ten * std::round(value / power_of_ten);
}

/// One input of the formula, over a round reference value.
struct Input {
  std::string word, exponent;
  double reference = 1.0;       // in the unit of the word
  Eigen::VectorXd ratio{};      // by observation
  std::vector<double> plain{};  // exponents that are tried first
  /// Zero at some readings: its exponent is above zero, or it is no part of the formula.
  bool has_zeros = false;
};

constexpr double highest_exponent = 5.0;
double lowest_exponent(const Input& input) { return input.has_zeros ? 0.2 : -4.0; }

/// Those that vary; no power of another can be told.
std::vector<Input> varying_inputs(const fit::Formula& formula, const fit::Observations& observed) {
  constexpr std::array<std::array<double, 5>, 3> tried{
      {{0.0, 0.67, 1.33, 2.0, 3.0}, {-0.5, 0.0, 0.67, 1.33, 2.0}, {-1.0, 0.0, 0.67, 1.5, 3.0}}};
  constexpr std::array<std::size_t, 3> many{5, 4, 4};
  std::vector<Input> inputs;
  for (std::size_t k = 0; k < formula.inputs.size(); ++k) {
    Input input{.word = formula.inputs[k].word, .exponent = formula.inputs[k].exponent};
    input.ratio = observed.at(formula.inputs[k].values);
    const double lowest = input.ratio.minCoeff(), largest = input.ratio.maxCoeff();
    if (!(lowest >= 0.0 && largest > 1.02 * lowest)) continue;
    input.has_zeros = lowest < 1e-3 * largest;
    input.reference = round_number(
        std::exp(input.ratio.array().cwiseMax(input.has_zeros ? 0.1 * largest : 0.0).log().mean()));
    input.ratio /= input.reference;
    if (input.has_zeros) {
      input.plain = {0.0, 0.67, 1.0, 1.5, 2.0};
      inputs.push_back(std::move(input));
      continue;
    }
    const std::size_t set = std::min<std::size_t>(k, 2);
    input.plain.assign(tried[set].begin(),
                       tried[set].begin() + static_cast<std::ptrdiff_t>(many[set]));
    inputs.push_back(std::move(input));
  }
  return inputs;
}

/// The search for the powers.
class ShapeSearch {
 public:
  ShapeSearch(const Evidence& evidence, const fit::Formula& formula)
      : evidence_(evidence),
        problem_(evidence.problem),
        formula_(formula),
        inputs_(varying_inputs(formula, problem_.observed)) {}

  std::optional<fit::Shape> run() {
    find_starts();
    if (starts_.empty()) return std::nullopt;
    leave_out_absent();
    find_starts();
    if (starts_.empty()) return std::nullopt;
    plain_ = fit::response_with(problem_, {});
    plain_.find_affine_form();
    bases_ = static_cast<Eigen::Index>(plain_.parameters.size());
    const fit::ResponseFit fit =
        fit::fit_response(response(), evidence_.whitening, problem_.measured(), points());
    if (!fit.converged) return std::nullopt;
    return shape(fit);
  }

 private:
  struct Start {
    double gain, size;
    Eigen::VectorXd exponents;
  };

  /// What is added to the readings for each unit of its size; nothing but to the first channel.
  [[nodiscard]] Eigen::VectorXd power(const Eigen::VectorXd& exponents) const {
    const fit::Observations& observed = problem_.observed;
    Eigen::ArrayXd product = Eigen::ArrayXd::Ones(observed.size());
    for (std::size_t k = 0; k < inputs_.size(); ++k)
      if (const double e = exponents[static_cast<Eigen::Index>(k)]; e != 0.0)
        product *= inputs_[k].ratio.array().pow(e);
    product.tail(observed.size() - observed.first[1]).setZero();
    return product.matrix();
  }

  /// Every combination of plain exponents, with the size that suits it best.
  void find_starts() {
    std::vector<Eigen::VectorXd> all{
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(inputs_.size()))};
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      std::vector<Eigen::VectorXd> more;
      for (const Eigen::VectorXd& exponents : all)
        for (const double e : inputs_[k].plain) {
          more.push_back(exponents);
          more.back()[static_cast<Eigen::Index>(k)] = e;
        }
      all = std::move(more);
    }
    const fit::ResponseFit& base = evidence_.base;
    for (const Eigen::VectorXd& exponents : all) {
      const Eigen::VectorXd column = evidence_.whitening(power(exponents));
      const Eigen::VectorXd left = fit::project_off(base.tangent, column);
      if (left.norm() < invisible * column.norm()) continue;
      const double size = left.dot(base.residual) / left.squaredNorm();
      starts_.push_back({size * size * left.squaredNorm(), size, exponents});
    }
    std::stable_sort(starts_.begin(), starts_.end(),
                     [](const Start& x, const Start& y) { return x.gain > y.gain; });
  }

  /// Inputs that have zeros and no part in the best start.
  void leave_out_absent() {
    const Eigen::VectorXd best = starts_.front().exponents;
    for (std::size_t k = inputs_.size(); k-- > 0;)
      if (inputs_[k].has_zeros && best[static_cast<Eigen::Index>(k)] == 0.0)
        inputs_.erase(inputs_.begin() + static_cast<std::ptrdiff_t>(k));
    for (Input& input : inputs_)
      if (input.has_zeros) std::erase(input.plain, 0.0);
    starts_.clear();
  }

  [[nodiscard]] fit::Response response() const {
    fit::Response response;
    response.parameters = plain_.parameters;
    const auto add = [&](std::string name, double start, double lower, double upper, double scale) {
      record::Parameter p{.name = std::move(name), .unit = "1"};
      p.start = start;
      p.lower = lower;
      p.upper = upper;
      p.scale = scale;
      response.parameters.push_back(std::move(p));
    };
    const double size = starts_.front().size, scale = std::max(1e-12, std::abs(size));
    add("c", size, -1e3 * scale, 1e3 * scale, scale);
    for (const Input& input : inputs_)
      add(input.exponent, 0.0, lowest_exponent(input), highest_exponent, 1.0);
    response.readings = [this](const Eigen::VectorXd& x) {
      return Eigen::VectorXd(plain_.at(x.head(bases_)) +
                             x[bases_] * power(x.tail(x.size() - bases_ - 1)));
    };
    return response;
  }

  [[nodiscard]] std::vector<Eigen::VectorXd> points() const {
    std::vector<Eigen::VectorXd> list;
    for (std::size_t s = 0; s < std::min(most_starts, starts_.size()); ++s) {
      Eigen::VectorXd x(bases_ + 1 + starts_[s].exponents.size());
      x << evidence_.base.values, starts_[s].size, starts_[s].exponents;
      list.push_back(std::move(x));
    }
    return list;
  }

  [[nodiscard]] fit::Shape shape(const fit::ResponseFit& fit) const {
    fit::Shape result;
    result.key = formula_.key;
    result.formula = "c";
    const double size = fit.values[bases_];
    record::Parameter c{.name = "c", .unit = formula_.unit};
    c.value = size / formula_.factor;
    c.std = fit.standard_errors[bases_] / formula_.factor;
    result.coefficients.push_back(std::move(c));
    std::string powers;
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      const Input& input = inputs_[k];
      const Eigen::Index at = bases_ + 1 + static_cast<Eigen::Index>(k);
      const bool limit = fit.at_bound[static_cast<std::size_t>(at)];
      result.formula +=
          fmt::format(" * ({} / {:g})^{}", input.word, input.reference, input.exponent);
      record::Parameter exponent{.name = input.exponent, .unit = "1"};
      exponent.lower = lowest_exponent(input);
      exponent.upper = highest_exponent;
      exponent.value = fit.values[at];
      exponent.std = fit.standard_errors[at];
      if (limit)
        exponent.at_bound = exponent.value < 0.0 ? record::Bound::lower : record::Bound::upper;
      result.coefficients.push_back(std::move(exponent));
      powers += fmt::format(" {}^{:.2f}{}", input.word, fit.values[at],
                            limit ? " (limit of the search)" : "");
    }
    Eigen::Index strongest = 0;
    (fit.prediction - plain_.at(fit.values.head(bases_))).cwiseAbs().maxCoeff(&strongest);
    result.statement =
        fmt::format("{}{}, strongest at {}", size < 0.0 ? "-" : "+", powers, words(strongest));
    const fit::ResponseFit& base = evidence_.base;
    const auto freedom = static_cast<double>(problem_.observed.size() - base.tangent.cols());
    result.gain = base.misfit - fit.misfit;
    result.explained_share =
        std::clamp((base.misfit - fit.misfit) / std::max(1.0, base.misfit - freedom), 0.0, 1.0);
    return result;
  }

  /// The point of an observation.
  [[nodiscard]] std::string words(Eigen::Index observation) const {
    const record::Record& record = *problem_.record;
    const std::size_t row = problem_.observed.row[static_cast<std::size_t>(observation)];
    std::vector<fit::Setting> point;
    for (const fit::Axis& axis : problem_.subject->axes(record))
      if (axis.told) point.push_back({axis.channel, record.value(*axis.channel, row)});
    return problem_.subject->words(point);
  }

  const Evidence& evidence_;
  const fit::Problem& problem_;
  const fit::Formula& formula_;
  std::vector<Input> inputs_;
  std::vector<Start> starts_;
  fit::Response plain_;
  Eigen::Index bases_ = 0;
};

}  // namespace

std::optional<fit::Shape> find_unknown_shape(const Evidence& evidence) {
  const std::optional<fit::Formula> formula =
      evidence.problem.subject->formula(*evidence.problem.record);
  // The formula is one of the subject's first channel, which may take no part.
  if (!formula || evidence.problem.observed.place.front() != 0) return std::nullopt;
  return ShapeSearch(evidence, *formula).run();
}

}  // namespace raceway::verdict
