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
    none,     ///< no candidate explains the misfit
    single,   ///< one candidate explains the misfit
    several,  ///< two or three candidates together explain the misfit
    bent,  ///< one candidate explains the misfit if its law is multiplied by powers of the inputs
    /// The corrections of both exponents of the base law (viscous part and load part) together
    /// explain the misfit. The threshold for this pair is lower than for other pairs.
    base_laws,
    /// One candidate removes at least half of the mean square held-out error beyond the noise, but
    /// the remaining error exceeds the tolerance.
    partly
  };
  Kind kind = Kind::none;
  std::vector<const Explanation*> set{};  ///< fits, best first
  /// Fits with a wrong datum that are as good as the pairs of effects in `set`.
  std::vector<const Explanation*> with_data{};
};

/// Limits and options of a search.
struct SearchLimits {
  double needed_gain = unset;  ///< gain that an accepted candidate must exceed
  int tried = 0;               ///< number of candidates tried, for the multiple-testing correction
  bool pairs = true;
  std::function<void(double share, std::string_view step)> step{};
  std::function<bool()> cancelled{};
};

/// Searches for candidates that explain a misfit. explain() tries, in this order: single
/// candidates, the corrections of both exponents of the base law together, pairs, triples,
/// candidates whose law is multiplied by powers of the inputs. explain_within_tolerance() tries
/// single candidates, then pairs.
class Search {
 public:
  Search(const Evidence& evidence, const Attribution& attribution,
         const std::vector<fit::Blocking>& blockings, SearchLimits limits);

  /// Refits the model with each candidate alone.
  void refit_singles();
  [[nodiscard]] const std::vector<Explanation>& singles() const { return singles_; }
  /// Searches until the residuals are noise. Triples are also tried if the residual with a pair is
  /// only noise.
  [[nodiscard]] Finding explain();
  /// Searches until the held-out error is within the tolerance.
  [[nodiscard]] Finding explain_within_tolerance();

  /// Returns the ids of pairs whose fit leaves only noise, but in which one candidate contributes
  /// too little to be proven. explain() fills this list.
  [[nodiscard]] const std::vector<std::vector<std::string>>& weak_pairs() const {
    return weak_pairs_;
  }
  [[nodiscard]] std::optional<fit::Shape>& shape() { return shape_; }
  /// Returns true if at least one candidate of the fit is a physical effect, not a wrong datum or
  /// an empirical shape.
  [[nodiscard]] bool is_physics(const Explanation& e) const;
  [[nodiscard]] bool is_physics_alone(const Explanation& e) const;
  [[nodiscard]] std::vector<std::string> ids_of(const Explanation& e) const;
  /// Returns true if the RMS residual is larger with the candidates of the fit than without. The
  /// residuals of each channel are divided by its noise, and outliers are left out.
  [[nodiscard]] bool raises_the_error(const Explanation& e) const;
  /// Returns true if the candidates lower the RMS residual, as in raises_the_error(), by at least
  /// the share `share` [1].
  [[nodiscard]] bool lowers_the_error(const Explanation& e, double share) const;
  /// Returns the held-out error in excess of the noise, divided by the tolerance [1]: the largest
  /// ratio of all channels. NaN if no rows can be held out.
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

/// Largest difference in gain between the best set and another set of the verdict.
constexpr double within_reach = 6.0;
constexpr double passed = 0.01;  ///< smallest p-value of residuals that are accepted as noise

}  // namespace raceway::verdict
