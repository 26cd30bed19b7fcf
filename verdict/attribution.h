#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "verdict/evidence.h"
#include "verdict/gate.h"

namespace raceway::verdict {

/// Fit of the model with one to three candidates (missing effects or wrong data) switched on. All
/// free parameters of the model are refitted.
struct Explanation {
  std::vector<std::size_t> members{};  ///< indices in Problem::candidates, in ascending order
  /// Predicted readings as a function of `parameters`; empty if `elastic`.
  fit::Response response{};
  fit::ResponseFit fit{};
  /// Free parameters of the model, then parameters of the candidates, then free exponents.
  std::vector<record::Parameter> parameters{};
  double gain = unset;  ///< see RankedEffect::gain
  /// True if the fit diverged: a size exceeds 1000 times the largest plausible size.
  bool ran_away = false;
  /// Start values for a full fit, if `fit` is coarse (fit::coarse_fit()); empty after a full fit.
  std::vector<Eigen::VectorXd> starts{};
  Gate recheck{};  ///< test of the residuals of `fit` for a further missing effect
  bool rechecked = false;
  double least_loss = unset;  ///< smallest loss of gain if one of several candidates is left out
  /// True if the candidate changes the readings by its law times fitted powers of the inputs
  /// (Attribution::elastic()).
  bool elastic = false;
  /// Name and exponent of each quantity in Subject::factors(); the exponent is 0 if the quantity
  /// does not vary.
  std::vector<record::NamedValue> exponents{};
  std::size_t free_exponents = 0;  ///< number of fitted exponents
  /// Returns true if an exponent reached its bound.
  [[nodiscard]] bool bent_to_a_bound() const;
};

/// Refits the model with candidates switched on, and tests the residuals.
class Attribution {
 public:
  explicit Attribution(const Evidence& evidence);

  [[nodiscard]] const Gate& gate() const { return gate_; }
  /// Returns the range of a candidate in Gate::scores: index of its first score, and number of its
  /// scores.
  [[nodiscard]] std::pair<Eigen::Index, Eigen::Index> score_range(std::size_t candidate) const;
  /// Returns the length of each column of Gate::projected [1]: the change of all readings by a
  /// candidate of typical size, without the part that the free parameters absorb, as a Euclidean
  /// norm in standard deviations. If the readings allow several noise models, the length is the
  /// smallest of the lengths with these models.
  [[nodiscard]] Eigen::VectorXd least_lengths() const;
  /// Returns the length (see least_lengths()) that an effect needs to be detected in 99 of 100
  /// cases.
  [[nodiscard]] double length_found() const;
  /// Returns the largest Gate::visibility of the columns of a candidate [1].
  [[nodiscard]] double visibility(std::size_t candidate) const;

  /// Refits the model with the candidates `members`. The fit begins at several start values, unless
  /// the readings are linear in all parameters.
  [[nodiscard]] Explanation refit(const std::vector<std::size_t>& members,
                                  const std::vector<Eigen::VectorXd>& extra_starts = {}) const;
  /// Returns fits with each candidate alone, sorted by gain, largest first. Candidates that cannot
  /// be tested, or whose influence the free parameters absorb, are left out.
  [[nodiscard]] std::vector<Explanation> singles() const;
  /// Returns fits with pairs of candidates, sorted by gain, largest first. The function calculates
  /// the gain of every pair in a linearised model, and refits up to 40 pairs close to the best one.
  /// Most fits are coarse; see refine().
  [[nodiscard]] std::vector<Explanation> pairs(const std::vector<Explanation>& singles,
                                               const std::function<bool()>& cancelled) const;
  /// Returns fits with three candidates, sorted by gain, largest first: one of the best pairs and
  /// one more candidate. Triples that contain a candidate for a wrong datum are left out. Most fits
  /// are coarse; see refine().
  [[nodiscard]] std::vector<Explanation> triples(const std::vector<Explanation>& pairs,
                                                 const std::vector<Explanation>& singles,
                                                 const std::function<bool()>& cancelled) const;
  /// Replaces coarse fits by full fits if their gain may be within `reach` of the best gain. The
  /// pairs from which triples() starts also get full fits. The list is then sorted by gain, largest
  /// first.
  void refine(std::vector<Explanation>& list, double reach) const;
  /// Refits one candidate with a modified law: the law times powers of the quantities in
  /// Subject::factors(). The exponents are fitted within +-0.2.
  [[nodiscard]] Explanation elastic(const Explanation& single) const;
  /// Tests the residuals for a further missing effect, and stores the result in
  /// Explanation::recheck.
  void recheck(Explanation& explanation) const;

 private:
  /// Directions in which candidates change the readings, used to rate pairs.
  struct Directions {
    std::vector<std::size_t> owner{};
    std::vector<bool> one_sided{};
    Eigen::MatrixXd columns{};  // whitened, without the part that base parameters absorb
  };
  [[nodiscard]] Directions directions(const std::vector<Explanation>& singles) const;
  using Members = std::pair<std::size_t, std::size_t>;
  /// Returns pairs, each with the negative of its linearised gain. The pair with the largest gain
  /// is first.
  [[nodiscard]] std::vector<std::pair<double, Members>> weigh_pairs(
      const std::vector<Explanation>& singles) const;
  /// Adds the candidate of `single` to `first`. The fit is coarse and starts from the sizes in
  /// `first` and `single`. If the coarse fit is worse than the fit of `first` or of `single`, a
  /// full fit replaces it. The full fit also starts from half of these sizes.
  [[nodiscard]] Explanation refit_together(const Explanation& first,
                                           const Explanation& single) const;
  /// Returns true for a candidate that corrects a datum.
  [[nodiscard]] bool is_datum(std::size_t member) const;
  [[nodiscard]] bool has_datum(const Explanation& e) const;
  /// Returns the parameter values of one candidate.
  [[nodiscard]] Eigen::VectorXd values_of(const Explanation& e, std::size_t member) const;
  /// Computes the gain of a fit. Marks a diverged fit as not converged.
  void judge(Explanation& e) const;
  [[nodiscard]] std::vector<Eigen::VectorXd> starts(std::span<const fit::Screened* const> on,
                                                    const fit::Response& response) const;
  [[nodiscard]] std::vector<const fit::Screened*> screened(
      const std::vector<std::size_t>& members) const;
  /// Tests the residuals of a fit for a missing effect (open_gate()), without the scores of the
  /// candidates in `without`.
  [[nodiscard]] Gate gate_on(const fit::ResponseFit& fit,
                             const std::vector<std::size_t>& without) const;

  const Evidence& evidence_;
  const fit::Problem& problem_;
  const fit::Whitening& whitening_;
  const fit::ResponseFit& base_;
  Eigen::MatrixXd raw_surface_, raw_scores_;  // SI
  Eigen::MatrixXd surface_, scores_;          // whitened
  std::vector<bool> one_sided_;
  std::vector<std::size_t> owner_;  // candidate of each score
  NullDraws draws_;
  Gate gate_;
};

}  // namespace raceway::verdict
