#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "verdict/evidence.h"
#include "verdict/gate.h"

namespace raceway::verdict {

/// The model with one to three candidates, refitted with all base parameters free.
struct Explanation {
  std::vector<std::size_t> members{};  ///< indices into Problem::candidates, rising
  fit::Response response{};            ///< empty where the law is bent
  fit::ResponseFit fit{};
  std::vector<record::Parameter> parameters{};  ///< base, then the parameters of the members
  double gain = unset;  ///< fall of -2 ln L against the base, less ln N for each shape that is free
  bool ran_away = false;  ///< not converged, as its size left all bounds of belief
  /// Starts of the whole fit where this one is coarse; empty where it is whole.
  std::vector<Eigen::VectorXd> starts{};
  Gate recheck{};  ///< of the residuals, against the rest of the catalogue
  bool rechecked = false;
  double least_loss = unset;  ///< rise of -2 ln L when the least of several members is dropped
  bool elastic = false;       ///< with exponents that bend the law
  /// Exponents of every factor of the subject, by its name; 0 where it does not vary.
  std::vector<record::NamedValue> exponents{};
  std::size_t free_exponents = 0;  ///< number of those that were free
  /// True if an exponent ended at the limit to which the law may be bent.
  [[nodiscard]] bool bent_to_a_bound() const;
};

/// All that is needed to hold an extended model against the data, and the fits made so far.
class Attribution {
 public:
  explicit Attribution(const Evidence& evidence);

  [[nodiscard]] const Gate& gate() const { return gate_; }
  /// Column of the gate's scores at which a candidate's begin, and how many it has.
  [[nodiscard]] std::pair<Eigen::Index, Eigen::Index> score_range(std::size_t candidate) const;
  /// Length of each score off the base, the least under all shapes of the noise that the readings
  /// allow [1].
  [[nodiscard]] Eigen::VectorXd least_lengths() const;
  /// Length that a score must have to alarm the gate in 99 of 100 cases.
  [[nodiscard]] double length_found() const;
  /// Largest visibility of its scores.
  [[nodiscard]] double visibility(std::size_t candidate) const;

  /// Refits one candidate or more from two or more starts.
  [[nodiscard]] Explanation refit(const std::vector<std::size_t>& members,
                                  const std::vector<Eigen::VectorXd>& extra_starts = {}) const;
  /// Every testable, visible candidate alone; best first.
  [[nodiscard]] std::vector<Explanation> singles() const;
  /// Pairs that may beat the best single, refitted; best first. All are weighed linearised, those
  /// within reach of the best are refitted, most of them coarsely: see refine().
  [[nodiscard]] std::vector<Explanation> pairs(const std::vector<Explanation>& singles,
                                               const std::function<bool()>& cancelled) const;
  /// Triples that may beat the best pair, from the best pairs and one candidate more, refitted as
  /// pairs are; best first.
  [[nodiscard]] std::vector<Explanation> triples(const std::vector<Explanation>& pairs,
                                                 const std::vector<Explanation>& singles,
                                                 const std::function<bool()>& cancelled) const;
  /// Makes the coarse fits whole that may come within `reach` of the gain of the best, and the fits
  /// of pairs that triples() goes on from; best first.
  void refine(std::vector<Explanation>& list, double reach) const;
  /// The law of one candidate bent by powers of the subject's factors within +-0.2.
  [[nodiscard]] Explanation elastic(const Explanation& single) const;
  /// The gate again on an extended model.
  void recheck(Explanation& explanation) const;

 private:
  /// Directions in which candidates change the readings, as pairs are weighed.
  struct Directions {
    std::vector<std::size_t> owner{};
    std::vector<bool> one_sided{};
    Eigen::MatrixXd columns{};  // whitened, off the base
  };
  [[nodiscard]] Directions directions(const std::vector<Explanation>& singles) const;
  using Members = std::pair<std::size_t, std::size_t>;
  /// Linearised gains of pairs, negative, the best first.
  [[nodiscard]] std::vector<std::pair<double, Members>> weigh_pairs(
      const std::vector<Explanation>& singles) const;
  /// One more candidate, the sizes of all started whole and halved; a coarse fit unless that is
  /// worse than either of them.
  [[nodiscard]] Explanation refit_together(const Explanation& first,
                                           const Explanation& single) const;
  /// True for a datum that may be wrong.
  [[nodiscard]] bool is_datum(std::size_t member) const;
  [[nodiscard]] bool has_datum(const Explanation& e) const;
  /// Values of the parameters of a member.
  [[nodiscard]] Eigen::VectorXd values_of(const Explanation& e, std::size_t member) const;
  /// Gain of a fit, or why there is none.
  void judge(Explanation& e) const;
  [[nodiscard]] std::vector<Eigen::VectorXd> starts(std::span<const fit::Screened* const> on,
                                                    const fit::Response& response) const;
  [[nodiscard]] std::vector<const fit::Screened*> screened(
      const std::vector<std::size_t>& members) const;
  /// The gate on a fit, without the scores of these candidates.
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
