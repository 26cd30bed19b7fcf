#include <tbb/parallel_for.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "algebra/detail/decompositions.h"
#include "tolerance/detail/inquiry.h"
#include "tolerance/thinned_record.h"

// Fits of a diagnosis with single candidates and pairs.
namespace raceway::tolerance {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();
constexpr std::size_t costly_members = 4;  // of pairs: the best singles
constexpr std::size_t most_members = 16;   // of all pairs: beyond that the best singles

}  // namespace

/// Fits with each of some sets of candidates, side by side; in their order.
/// `most`: error in sample up to which parts are held out. `from`, `to`: share of the whole.
std::vector<Tried> Inquiry::fits_with(const std::vector<std::vector<const fit::Candidate*>>& sets,
                                      const ApproximationOptions& with, double most, double from,
                                      double to) const {
  std::vector<Tried> list(sets.size());
  std::mutex telling;
  std::size_t done = 0;
  const auto try_one = [&](std::size_t k) {
    {
      const std::scoped_lock lock(telling);
      step(from + (to - from) * static_cast<double>(done++) / static_cast<double>(sets.size()),
           sets[k].size() > 1 ? "refitting with pairs of effects" : sets[k].front()->id);
    }
    list[k].on = sets[k];
    list[k].fit = approximate_with(base_, recorded_, sets[k], with);
  };
  const auto each = [&](const auto& work) {
    tbb::parallel_for(std::size_t{0}, sets.size(), work, tbb::simple_partitioner());
  };
  each(try_one);
  const double worth_finishing = with.rough ? promising(list) : 0.0;
  each([&](std::size_t k) {
    Approximation& fit = list[k].fit;
    if (fit.fit.misfit <= worth_finishing) fit = finished(fit, recorded_);
    if (fit.fit.values.size() > 0 && fit.rms <= most) hold_out(fit, recorded_);
  });
  return list;
}

/// Misfit up to which a rough fit may yet come near the best.
double Inquiry::promising(const std::vector<Tried>& list) const {
  constexpr double of_best = 4.0, of_base = 0.9;
  double best = base_.fit.misfit;
  for (const Tried& t : list) best = std::fmin(best, t.fit.fit.misfit);
  return std::min(of_best * best, of_base * base_.fit.misfit);
}

void Inquiry::try_singles() {
  std::vector<std::vector<const fit::Candidate*>> sets;
  for (const fit::Candidate& c : candidates_)
    if (is_testable(c.id)) sets.push_back({&c});
  singles_ = fits_with(sets, search(), no_limit, 0.15, 0.5);
  leave_out_what_is_not_felt();
  look_at_record();
  sort(singles_);
  result_.candidates_tried = static_cast<int>(singles_.size()) + options_.tried_before;
}

/// It takes nothing, and over all its range moves no channel by a share of its tolerance.
bool Inquiry::is_felt(const Tried& t) const {
  constexpr double least = 0.1, nothing = 1e-4;
  const Approximation& fit = t.fit;
  if (fit.slope.size() == 0 || fit.rms < (1.0 - nothing) * base_.rms) return true;
  const std::size_t size = base_.names.size() + t.on.front()->size;
  const record::Parameter& p = fit.parameters[size];
  const auto column = fit.slope.col(static_cast<Eigen::Index>(size));
  double square = 0.0;
  for (Eigen::Index i = 0; i < column.size(); ++i)
    square += std::pow(column[i] * recorded_.means.list[static_cast<std::size_t>(i)].weight, 2);
  const double moved = std::sqrt(square / static_cast<double>(column.size()));
  return !(moved * (p.upper - p.lower) < least);
}

void Inquiry::leave_out_what_is_not_felt() {
  for (const Tried& t : singles_)
    if (!is_felt(t))
      result_.not_testable.push_back(
          {t.on.front()->id, "no reading of this record depends on the effect"});
  std::erase_if(singles_, [&](const Tried& t) { return !is_felt(t); });
}

/// What the record cannot feel is not looked for where looking costs much.
bool Inquiry::is_testable(const std::string& id) const {
  return !subject_->is_costly() ||
         std::none_of(result_.not_testable.begin(), result_.not_testable.end(),
                      [&](const verdict::NotTestable& n) { return n.id == id; });
}

/// Faults that the record shows of itself: the model alone, on what it would be without.
void Inquiry::look_at_record() {
  const auto asked = [&](const std::string& id) {
    const std::vector<std::string>& only = options_.candidates;
    return only.empty() || std::find(only.begin(), only.end(), id) != only.end();
  };
  faults_ = fitted(base_)->faults(record_);
  const bool something_is_left = worst_held_out(base_) > 1.0;
  for (const fit::Fault& e : faults_) {
    if (!asked(e.id) || (!e.certain && !something_is_left)) continue;
    const Recorded without = recorded(*subject_, for_search(e.without), usual_width(record_));
    Tried t{.shown = &e};
    t.fit = approximate(subject_, without, subject_->free(), search());
    if (t.fit.fit.values.size() == 0) continue;
    hold_out(t.fit, without);
    singles_.push_back(std::move(t));
  }
}

void Inquiry::sort(std::vector<Tried>& list) {
  std::erase_if(list, [](const Tried& t) { return !std::isfinite(t.error()); });
  std::stable_sort(list.begin(), list.end(),
                   [](const Tried& a, const Tried& b) { return a.error() < b.error(); });
}

std::vector<std::vector<const fit::Candidate*>> Inquiry::all_pairs() const {
  std::vector<const fit::Candidate*> members;
  for (const Tried& t : singles_)
    if (!t.on.empty() && members.size() < most_members) members.push_back(t.on.front());
  std::sort(members.begin(), members.end());
  std::vector<std::vector<const fit::Candidate*>> sets;
  for (std::size_t i = 0; i < members.size(); ++i)
    for (std::size_t j = i + 1; j < members.size(); ++j)
      if (!members[i]->by_column || !members[j]->by_column)
        sets.push_back({members[i], members[j]});
  return sets;
}

/// Those of the best few, and the best with what takes most of what it leaves, by derivatives.
std::vector<std::vector<const fit::Candidate*>> Inquiry::promising_pairs() const {
  if (singles_.front().on.empty()) return {};
  std::vector<const fit::Candidate*> members;
  for (const Tried& t : singles_)
    if (!t.on.empty() && members.size() < costly_members) members.push_back(t.on.front());
  std::vector<std::vector<const fit::Candidate*>> sets;
  for (std::size_t i = 0; i < members.size(); ++i)
    for (std::size_t j = i + 1; j < members.size(); ++j) sets.push_back({members[i], members[j]});
  for (const fit::Candidate* partner : partners_of(singles_.front())) {
    const bool is_new = std::find(members.begin(), members.end(), partner) == members.end();
    if (is_new) sets.push_back({members.front(), partner});
  }
  return sets;
}

/// Candidates by how far the misfit of `best` would fall with them, the most first; a few.
std::vector<const fit::Candidate*> Inquiry::partners_of(const Tried& best) const {
  const std::vector<fit::Means::Mean>& means = recorded_.means.list;
  Eigen::VectorXd weight(recorded_.means.size());
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    weight[i] = means[static_cast<std::size_t>(i)].weight;
  const Eigen::MatrixXd own = weight.asDiagonal() * best.fit.slope;
  const algebra::PivotedQr qr(own);
  const auto without_own = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
    return v - own * qr.solve(v);
  };
  const Eigen::VectorXd left = without_own(weight.cwiseProduct(best.fit.fit.residual));
  std::vector<std::pair<double, const fit::Candidate*>> falls;
  for (const Tried& t : singles_) {
    if (t.on.empty() || t.on.front() == best.on.front()) continue;
    const auto size = static_cast<Eigen::Index>(base_.names.size() + t.on.front()->size);
    const Eigen::VectorXd column =
        without_own(weight.cwiseProduct(Eigen::VectorXd(t.fit.slope.col(size))));
    const double square = column.squaredNorm();
    if (square > 0.0) falls.emplace_back(std::pow(column.dot(left), 2) / square, t.on.front());
  }
  std::stable_sort(falls.begin(), falls.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const fit::Candidate*> list;
  for (std::size_t k = 0; k < std::min(costly_members, falls.size()); ++k)
    list.push_back(falls[k].second);
  return list;
}

/// Pairs that meet the tolerance on the rows that they were fitted to: others cannot on those
/// that they did not see.
void Inquiry::try_pairs() {
  if (singles_.empty()) return;
  const double most = std::min(1.0, singles_.front().error() / comes_near);
  const std::vector<std::vector<const fit::Candidate*>> sets =
      subject_->is_costly() ? promising_pairs() : all_pairs();
  ApproximationOptions from = search();
  from.random_starts = 8;
  from.polished = 2;
  pairs_ = fits_with(sets, from, most, 0.5, 0.9);
  sort(pairs_);
}

}  // namespace raceway::tolerance
