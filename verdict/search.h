#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

namespace raceway::verdict {

/// The explanation of a misfit that stands, and those within reach of it.
struct Finding {
  enum class Kind {
    none,       ///< nothing explains it
    single,     ///< one candidate
    several,    ///< two or three at once
    bent,       ///< one whose law is bent
    base_laws,  ///< the base law's own corrections together, less than a pair must be
    partly      ///< one that takes most of the misfit, but not enough to meet the tolerance
  };
  Kind kind = Kind::none;
  std::vector<const Explanation*> set{};  ///< the best first
  /// Pairs with wrong data that would do as well as the pairs of effects in the set.
  std::vector<const Explanation*> with_data{};
};

/// Limits and options of a search.
struct SearchLimits {
  double needed_gain = unset;  ///< fall of -2 ln L that admits a candidate
  int tried = 0;               ///< candidates, for the multiplicity
  bool pairs = true;
  std::function<void(double share, std::string_view step)> step{};
  std::function<bool()> cancelled{};
};

/// Looks for an explanation of a misfit: each candidate alone, both corrections of the base law,
/// pairs, triples, bent laws, in this order, until the residuals are noise. With a tolerance, until
/// the held-out error is within it.
class Search {
 public:
  Search(const Evidence& evidence, const Attribution& attribution,
         const std::vector<fit::Blocking>& blockings, SearchLimits limits);

  /// Refits every candidate alone.
  void refit_singles();
  [[nodiscard]] const std::vector<Explanation>& singles() const { return singles_; }
  /// Explains the misfit down to the noise.
  [[nodiscard]] Finding explain();
  /// Brings the held-out error within the tolerance.
  [[nodiscard]] Finding explain_within_tolerance();

  /// Pairs that would do without being shown, and the shape of what is missing: filled in on the
  /// way.
  [[nodiscard]] const std::vector<std::vector<std::string>>& weak_pairs() const {
    return weak_pairs_;
  }
  [[nodiscard]] std::optional<fit::Shape>& shape() { return shape_; }
  /// No wrong datum, and no shape without a law behind it.
  [[nodiscard]] bool is_physics(const Explanation& e) const;
  [[nodiscard]] bool is_physics_alone(const Explanation& e) const;
  [[nodiscard]] std::vector<std::string> ids_of(const Explanation& e) const;
  /// True if the explanation raises the rms residual, weighed by the noise of each channel and
  /// without outliers.
  [[nodiscard]] bool raises_the_error(const Explanation& e) const;
  /// True if it lowers that rms residual by this share at least.
  [[nodiscard]] bool lowers_the_error(const Explanation& e, double share) const;
  /// Held-out error of an explanation as the largest share of a channel's tolerance.
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
  /// Gain needed by the best of `choices` sets: the gain of the best smaller set plus a margin for
  /// chance.
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

constexpr double within_reach = 6.0;  ///< of the best, in -2 ln L
constexpr double passed = 0.01;       ///< of the gate

}  // namespace raceway::verdict
