#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// Best explanation of a misfit, and the explanations close to it.
struct Finding {
  enum class Kind {
    none,       ///< no candidate explains the misfit
    single,     ///< one candidate explains the misfit
    several,    ///< two or three candidates together
    bent,       ///< one candidate whose law is multiplied by powers of the inputs
    base_laws,  ///< both corrections of the base law together; their threshold is lower than for
                ///< other pairs
    partly      ///< one candidate explains most of the misfit but misses the tolerance
  };
  Kind kind = Kind::none;
  std::vector<const Explanation*> set{};  ///< explanations, best first
  /// Pairs that contain a wrong datum and fit as well as the pairs of effects in the set.
  std::vector<const Explanation*> with_data{};
};

/// Limits and options of a search.
struct SearchLimits {
  double needed_gain = unset;  ///< fall of -2 ln L that an explanation must exceed
  int tried = 0;               ///< number of candidates tried, for the multiple-testing correction
  bool pairs = true;
  std::function<void(double share, std::string_view step)> step{};
  std::function<bool()> cancelled{};
};

/// Searches for an explanation of a misfit: single candidates, both corrections of the base law,
/// pairs, triples and laws multiplied by powers, in this order, until the residuals are noise. If
/// there is a tolerance, the search ends when the held-out error is within the tolerance.
class Search {
 public:
  Search(const Evidence& evidence, const Attribution& attribution,
         const std::vector<fit::Blocking>& blockings, SearchLimits limits);

  /// Refits every candidate separately.
  void refit_singles();
  [[nodiscard]] const std::vector<Explanation>& singles() const { return singles_; }
  /// Searches until the remaining misfit is noise.
  [[nodiscard]] Finding explain();
  /// Searches until the held-out error is within the tolerance.
  [[nodiscard]] Finding explain_within_tolerance();

  /// Returns pairs of effects that fit well, although neither effect of a pair is proven. explain()
  /// and explain_within_tolerance() fill this list and shape().
  [[nodiscard]] const std::vector<std::vector<std::string>>& weak_pairs() const {
    return weak_pairs_;
  }
  [[nodiscard]] std::optional<fit::Shape>& shape() { return shape_; }
  /// Returns true if at least one member of the explanation is a physical effect, not a wrong datum
  /// or an empirical shape.
  [[nodiscard]] bool is_physics(const Explanation& e) const;
  [[nodiscard]] bool is_physics_alone(const Explanation& e) const;
  [[nodiscard]] std::vector<std::string> ids_of(const Explanation& e) const;
  /// Returns true if the explanation raises the rms residual. Each channel is weighted by its
  /// noise, and outliers are left out.
  [[nodiscard]] bool raises_the_error(const Explanation& e) const;
  /// Returns true if the explanation lowers the rms residual of raises_the_error() by at least
  /// `share`.
  [[nodiscard]] bool lowers_the_error(const Explanation& e, double share) const;
  /// Returns the held-out error in excess of the noise, divided by the tolerance, for the channel
  /// with the largest ratio [1].
  [[nodiscard]] double share_of_tolerance(const fit::Response& response,
                                          const fit::ResponseFit& fit) const;

 private:
  using Ranked = std::vector<Explanation>;
  [[nodiscard]] bool is_base_law(const Explanation& single) const;
  [[nodiscard]] std::vector<const Explanation*> within_reach_of_best(const Ranked& list,
                                                                     double needed) const;
  void drop_implausible(Ranked& list) const;
  [[nodiscard]] bool any_passes(Ranked& list, const std::vector<const Explanation*>& set) const;
  [[nodiscard]] std::optional<Finding> one_candidate();
  [[nodiscard]] std::optional<Finding> both_base_laws();
  [[nodiscard]] std::optional<Finding> two_candidates();
  [[nodiscard]] std::optional<Finding> three_candidates();
  [[nodiscard]] double least_loss_of(const Explanation& triple);
  /// Returns the gain that the best of `choices` sets must reach: the gain of the best smaller set
  /// plus a margin for chance.
  [[nodiscard]] double gain_beyond(const Ranked& smaller, int choices) const;
  [[nodiscard]] Finding bent_law();
  void add_bent_physics(std::vector<const Explanation*>& set);
  [[nodiscard]] bool bent_too_far(const Explanation& bent) const;
  [[nodiscard]] std::vector<const Explanation*> good_enough(const Ranked& list, double most) const;

  const Evidence& evidence_;
  const fit::Problem& problem_;
  const Attribution& attribution_;
  const std::vector<fit::Blocking>& blockings_;
  SearchLimits limits_;
  Ranked singles_, pairs_, triples_, bent_, base_laws_;
  std::vector<std::vector<std::string>> weak_pairs_;
  std::optional<fit::Shape> shape_;
};

constexpr double within_reach = 6.0;  ///< largest difference of -2 ln L from the best set
constexpr double passed = 0.01;       ///< smallest p-value at which residuals count as noise

}  // namespace raceway::verdict
