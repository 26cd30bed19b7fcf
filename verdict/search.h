#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// Best explanation of a misfit, and other explanations that are nearly as good.
struct Finding {
  enum class Kind {
    none,     ///< no candidate explains the misfit
    single,   ///< one candidate explains the misfit
    several,  ///< two or three candidates together explain the misfit
    bent,     ///< one candidate explains the misfit if its law is multiplied by powers of inputs
    /// Two corrections of the base law together explain the misfit: one changes an exponent of the
    /// viscous moment, the other an exponent of the load moment. The gain of this pair is too small
    /// for the kind `several`.
    base_laws,
    /// One candidate explains at least half of the misfit, but the remaining held-out error exceeds
    /// the tolerance. The misfit is here the mean square held-out error minus the noise variance.
    partly
  };
  Kind kind = Kind::none;
  std::vector<const Explanation*> set{};  ///< explanations, best first
  /// Pairs, not in `set`, whose gain is also at most `within_reach` below the best gain. In these
  /// pairs, a candidate corrects a datum that may be wrong, such as an entered preload.
  std::vector<const Explanation*> with_data{};
};

/// Limits and options of a search.
struct SearchLimits {
  double needed_gain = unset;  ///< a candidate is accepted only if its gain exceeds this value
  int tried = 0;               ///< number of candidates tried, for the multiple-testing correction
  bool pairs = true;
  std::function<void(double share, std::string_view step)> step{};
  std::function<bool()> cancelled{};
};

/// Searches for candidates that explain a misfit. explain() tries in this order:
///   - single candidates
///   - the corrections of both exponents of the base law together
///   - pairs and triples of candidates
///   - single candidates whose law is multiplied by powers of the inputs
///
/// explain_within_tolerance() tries single candidates, then pairs.
class Search {
 public:
  Search(const Evidence& evidence, const Attribution& attribution,
         const std::vector<fit::Blocking>& blockings, SearchLimits limits);

  /// Refits the model with each candidate alone.
  void refit_singles();
  [[nodiscard]] const std::vector<Explanation>& singles() const { return singles_; }
  /// Searches for candidates that explain the misfit down to the noise. The function tries triples
  /// even if a pair explains the misfit.
  [[nodiscard]] Finding explain();
  /// Searches for candidates that reduce the held-out error to the tolerance.
  [[nodiscard]] Finding explain_within_tolerance();

  /// Returns the ids of pairs that could explain the misfit, but in which the gain of one candidate
  /// is too small as evidence. explain() fills this list.
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
  /// residuals of each channel are divided by the noise of the channel, and outliers are left out.
  [[nodiscard]] bool raises_the_error(const Explanation& e) const;
  /// Returns true if the candidates lower the RMS residual by at least `share`, relative to the RMS
  /// residual without the candidates [1]. The residual is calculated as in raises_the_error().
  [[nodiscard]] bool lowers_the_error(const Explanation& e, double share) const;
  /// Returns the ratio of held-out error to tolerance [1], for the channel with the largest ratio.
  /// The noise is subtracted from the error as in fit::beyond_noise(). The result is NaN if no rows
  /// can be held out.
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
  /// Returns the gain that a larger set must exceed: the gain of the best set in `smaller`, plus a
  /// margin that grows with `choices`, the number of larger sets tried.
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

/// A verdict lists a set of candidates if its gain is at most this value below the gain of the best
/// set.
constexpr double within_reach = 6.0;
constexpr double passed = 0.01;  ///< smallest p-value at which residuals are accepted as noise

}  // namespace raceway::verdict
