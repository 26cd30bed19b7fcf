#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "verdict/evidence.h"
#include "verdict/gate.h"

namespace raceway::verdict {

/// Fit of the model with one to three added candidates. A candidate is an effect that may be
/// missing, or a datum that may be wrong. The fit also changes all free parameters of the model.
struct Explanation {
  std::vector<std::size_t> members{};  ///< indices in Problem::candidates, in ascending order
  /// Predicted readings as a function of `parameters`; empty if `elastic` is true.
  fit::Response response{};
  fit::ResponseFit fit{};
  /// Parameters in this order: free parameters of the model, parameters of the candidates, fitted
  /// exponents.
  std::vector<record::Parameter> parameters{};
  double gain = unset;  ///< gain of the candidates (RankedEffect::gain) [1]
  /// True if the fit diverged: the size of a candidate exceeds 1000 times its largest plausible
  /// size.
  bool ran_away = false;
  /// Start values for a full fit, if `fit` is coarse (fit::coarse_fit()); empty after a full fit.
  std::vector<Eigen::VectorXd> starts{};
  Gate recheck{};  ///< test of the residuals of `fit` for a further missing effect
  bool rechecked = false;
  /// Decrease of the gain when the least important candidate is left out [1]. NaN for a single
  /// candidate, or if this decrease was not calculated.
  double least_loss = unset;
  /// True if the formula of the candidate is multiplied by fitted powers of the inputs
  /// (Attribution::elastic()).
  bool elastic = false;
  /// Fitted exponent of each quantity in Subject::factors(). The exponent is 0 if the quantity does
  /// not vary.
  std::vector<record::NamedValue> exponents{};
  std::size_t free_exponents = 0;  ///< number of fitted exponents
  /// Returns true if an exponent reached its bound.
  [[nodiscard]] bool bent_to_a_bound() const;
};

/// Refits the model with added candidates, and tests the residuals for a missing effect.
class Attribution {
 public:
  explicit Attribution(const Evidence& evidence);

  [[nodiscard]] const Gate& gate() const { return gate_; }
  /// Returns the range of a candidate in Gate::scores: index of its first score, and number of its
  /// scores.
  [[nodiscard]] std::pair<Eigen::Index, Eigen::Index> score_range(std::size_t candidate) const;
  /// Returns the Euclidean norm of each column of Gate::projected [1]. If several noise models
  /// agree with the readings, the function computes the norm of a column with each of them and
  /// returns the smallest norm.
  [[nodiscard]] Eigen::VectorXd least_lengths() const;
  /// Returns the norm that a column of Gate::projected must have so that the test detects its
  /// effect in 99 of 100 cases [1].
  [[nodiscard]] double length_found() const;
  /// Returns the largest value in Gate::visibility that belongs to a candidate [1].
  [[nodiscard]] double visibility(std::size_t candidate) const;

  /// Refits the model with the candidates whose indices are `members`. The fit begins at several
  /// start values, unless the readings are linear in all parameters.
  [[nodiscard]] Explanation refit(const std::vector<std::size_t>& members,
                                  const std::vector<Eigen::VectorXd>& extra_starts = {}) const;
  /// Returns one fit for each candidate alone, sorted by gain, largest first. The list does not
  /// contain candidates that cannot be tested, or whose influence the free parameters compensate.
  [[nodiscard]] std::vector<Explanation> singles() const;
  /// Returns fits with pairs of candidates, sorted by gain, largest first. The function calculates
  /// the gain of every pair in a linearised model, and refits up to 40 pairs close to the best one.
  /// Most fits are coarse; see refine().
  [[nodiscard]] std::vector<Explanation> pairs(const std::vector<Explanation>& singles,
                                               const std::function<bool()>& cancelled) const;
  /// Returns fits with three candidates, sorted by gain, largest first. Each triple consists of one
  /// of the eight best pairs and one more candidate. No triple contains a candidate for a wrong
  /// datum. Most fits are coarse; see refine().
  [[nodiscard]] std::vector<Explanation> triples(const std::vector<Explanation>& pairs,
                                                 const std::vector<Explanation>& singles,
                                                 const std::function<bool()>& cancelled) const;
  /// Replaces a coarse fit in `list` by a full fit if the gain of the full fit may be within
  /// `reach` of the best gain. The pairs from which triples() starts also get full fits. The
  /// function removes fits that do not converge, and sorts the list by gain, largest first.
  void refine(std::vector<Explanation>& list, double reach) const;
  /// Refits the model with one candidate whose formula is multiplied by powers of the quantities in
  /// Subject::factors(). The fitted exponents lie between -0.2 and 0.2.
  [[nodiscard]] Explanation elastic(const Explanation& single) const;
  /// Tests the residuals for a further missing effect, and stores the result in
  /// Explanation::recheck.
  void recheck(Explanation& explanation) const;

 private:
  /// Changes of the readings that the candidates cause. weigh_pairs() uses these changes to
  /// estimate the gains of pairs.
  struct Directions {
    std::vector<std::size_t> owner{};
    std::vector<bool> one_sided{};
    Eigen::MatrixXd columns{};  // whitened, without the part that base parameters absorb
  };
  [[nodiscard]] Directions directions(const std::vector<Explanation>& singles) const;
  using Members = std::pair<std::size_t, std::size_t>;
  /// Returns pairs of candidates, each with its negative linearised gain, largest gain first.
  [[nodiscard]] std::vector<std::pair<double, Members>> weigh_pairs(
      const std::vector<Explanation>& singles) const;
  /// Refits the model with the candidates of `first` and the candidate of `single`. The fit is
  /// coarse. If it is worse than the fit of `first` or of `single`, a full fit replaces it.
  [[nodiscard]] Explanation refit_together(const Explanation& first,
                                           const Explanation& single) const;
  [[nodiscard]] bool is_datum(std::size_t member) const;
  [[nodiscard]] bool has_datum(const Explanation& e) const;
  [[nodiscard]] Eigen::VectorXd values_of(const Explanation& e, std::size_t member) const;
  /// Computes the gain of a fit. If the fit diverged, marks it as not converged.
  void judge(Explanation& e) const;
  [[nodiscard]] std::vector<Eigen::VectorXd> starts(std::span<const fit::Screened* const> on,
                                                    const fit::Response& response) const;
  [[nodiscard]] std::vector<const fit::Screened*> screened(
      const std::vector<std::size_t>& members) const;
  /// Tests the residuals of a fit for a missing effect (open_gate()). The test does not include the
  /// candidates whose indices are in `without`.
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
