#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "verdict/evidence.h"
#include "verdict/gate.h"

namespace raceway::verdict {

/// The base model extended by one to three candidates, with all base parameters refitted.
struct Explanation {
  std::vector<std::size_t> members{};  ///< indices into Problem::candidates, rising
  fit::Response response{};            ///< response of the extended model; empty if `elastic`
  fit::ResponseFit fit{};
  /// Base parameters, then the parameters of the candidates.
  std::vector<record::Parameter> parameters{};
  double gain = unset;    ///< as RankedEffect::gain, relative to the base model
  bool ran_away = false;  ///< true if the fit diverged and the size is outside its plausible bounds
  /// Start values of the full fit if this fit is coarse; empty after a full fit.
  std::vector<Eigen::VectorXd> starts{};
  Gate recheck{};  ///< gate on the residuals, with the other effects of the catalogue
  bool rechecked = false;
  double least_loss = unset;  ///< rise of -2 ln L if the weakest of several candidates is removed
  /// True if fitted powers of the factors multiply the change of the readings by the candidate.
  bool elastic = false;
  /// Exponent of each factor (Subject::factors()), by name; 0 for a factor that does not vary.
  std::vector<record::NamedValue> exponents{};
  std::size_t free_exponents = 0;  ///< number of free exponents
  /// Returns true if an exponent reached its bound.
  [[nodiscard]] bool bent_to_a_bound() const;
};

/// Extends the base model by candidates, and refits the extended model.
class Attribution {
 public:
  explicit Attribution(const Evidence& evidence);

  [[nodiscard]] const Gate& gate() const { return gate_; }
  /// Returns the first column and the number of columns of a candidate among the scores of the
  /// gate.
  [[nodiscard]] std::pair<Eigen::Index, Eigen::Index> score_range(std::size_t candidate) const;
  /// Returns the length of each score after the base parameters are projected off [1]: the smallest
  /// length over all noise shapes that the readings allow.
  [[nodiscard]] Eigen::VectorXd least_lengths() const;
  /// Returns the length at which the gate detects a score in 99 of 100 cases.
  [[nodiscard]] double length_found() const;
  /// Returns the largest visibility of the candidate's scores.
  [[nodiscard]] double visibility(std::size_t candidate) const;

  /// Refits one or several candidates, from several starts unless the model is linear in all
  /// parameters.
  [[nodiscard]] Explanation refit(const std::vector<std::size_t>& members,
                                  const std::vector<Eigen::VectorXd>& extra_starts = {}) const;
  /// Returns a refitted explanation for each testable and visible candidate; best first.
  [[nodiscard]] std::vector<Explanation> singles() const;
  /// Returns refitted pairs that may have a larger gain than the best single candidate; best first.
  /// All pairs are rated by their linearised gain. Pairs close to the best one are refitted, most
  /// of them only coarsely: see refine().
  [[nodiscard]] std::vector<Explanation> pairs(const std::vector<Explanation>& singles,
                                               const std::function<bool()>& cancelled) const;
  /// Returns triples that may have a larger gain than the best pair; best first. A triple is one of
  /// the best pairs with one more candidate. Triples are refitted like pairs.
  [[nodiscard]] std::vector<Explanation> triples(const std::vector<Explanation>& pairs,
                                                 const std::vector<Explanation>& singles,
                                                 const std::function<bool()>& cancelled) const;
  /// Repeats coarse fits as full fits if their gain may be within `reach` of the best gain. The
  /// pairs from which triples() starts are also repeated. The list is then sorted, best first.
  void refine(std::vector<Explanation>& list, double reach) const;
  /// Bends the law of one candidate: multiplies the law by powers of Subject::factors(), with
  /// exponents within +-0.2.
  [[nodiscard]] Explanation elastic(const Explanation& single) const;
  /// Applies the gate to an extended model.
  void recheck(Explanation& explanation) const;

 private:
  /// Directions in which candidates change the readings, used to rate pairs.
  struct Directions {
    std::vector<std::size_t> owner{};
    std::vector<bool> one_sided{};
    Eigen::MatrixXd columns{};  // whitened, base parameters projected off
  };
  [[nodiscard]] Directions directions(const std::vector<Explanation>& singles) const;
  using Members = std::pair<std::size_t, std::size_t>;
  /// Returns the negative linearised gains of pairs, best first.
  [[nodiscard]] std::vector<std::pair<double, Members>> weigh_pairs(
      const std::vector<Explanation>& singles) const;
  /// Adds one candidate to an explanation. The fit is coarse and starts from the given sizes. If
  /// the coarse fit is worse than the better given fit, a full fit replaces it. The full fit also
  /// starts from half the sizes.
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
  /// Applies the gate to a fit, without the scores of the listed candidates.
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
