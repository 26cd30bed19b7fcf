#include "tests/correction_study/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "correction/alignment.h"
#include "correction/catalogue.h"
#include "correction/correction_subject.h"
#include "correction/simulation.h"
#include "files/correction_file.h"
#include "files/series_file.h"
#include "fit/isolated_readings.h"
#include "loop/loop.h"

namespace correction_study {
namespace {

namespace correction = raceway::correction;
namespace files = raceway::files;
namespace record = raceway::record;
using Ids = std::vector<std::string>;

constexpr double half_hours = 2.0;  // in an hour

/// "second-time-constant" of "second-time-constant:ambient", in order.
Ids plain(Ids ids) {
  for (std::string& id : ids) id.resize(std::min(id.size(), id.find(':')));
  std::sort(ids.begin(), ids.end());
  return ids;
}

bool accepts(const Case& of, const Ids& set) {
  const Ids names = plain(set);
  if (of.is_pair()) return names == plain(of.hidden);
  return names.size() == 1 &&
         std::find(of.accept.begin(), of.accept.end(), names.front()) != of.accept.end();
}

/// Of the processor, by this thread: others of the machine do not count.
double seconds_of_thread() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

record::Record open(const std::filesystem::path& file, const correction::Model& model) {
  // As the program does it before any question.
  return fit::without_isolated_readings(
             files::read_series(file.string(), {model.displacement}, correction::inputs_of(model)))
      .record;
}

/// The model refitted, with effects where there are any.
correction::Model refitted(const correction::Model& model, const record::Record& train,
                           const Ids& effects) {
  const correction::CorrectionSubject subject(model);
  const std::shared_ptr<const fit::Subject> found =
      effects.empty() ? loop::calibrate(subject, train).subject
                      : loop::add(subject, effects, train).calibration.subject;
  return correction::model_of(*found);
}

/// Told by the record itself: nothing can be switched on.
bool is_fault(const Ids& set) {
  return std::any_of(set.begin(), set.end(), [](const std::string& id) {
    const correction::EffectCard* const card = correction::find_card(id);
    return card && card->evidence;
  });
}

/// On a record that was not fitted, without effects of a reading, one constant removed [um].
double error_on(correction::Model model, const record::Record& test) {
  std::erase_if(model.effects, [](const correction::Effect& e) {
    return correction::find_card(e.id)->of_reading;
  });
  const auto subject = correction::aligned(model, test, correction::Zero::mean);
  const std::vector<double> predicted = fit::predict(*subject, test);
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < test.rows(); ++k) {
    const double error = test.value(*model.displacement, k) - predicted[k];
    if (std::isnan(error)) continue;
    sum += error * error;
    ++count;
  }
  return std::sqrt(sum / count) / raceway::um;
}

/// Errors held out of what was tried: singles, and the sets of the verdict.
void rank(const verdict::Diagnosis& d, Outcome& o) {
  o.base_held_out = d.channels.front().rmse_held_out_before / raceway::um;
  double right = std::numeric_limits<double>::infinity(), wrong = right;
  const auto take = [&](const Ids& set, double error) {
    double& best = accepts(o.of, set) ? right : wrong;
    if (!(error < best)) return;
    best = error;
    if (&best == &wrong) o.best_wrong = fmt::format("{}", fmt::join(set, "+"));
  };
  // A column that is recorded beside follows what it does not cause; no mechanism is ranked by it.
  const auto counts = [&](const verdict::RankedEffect& e) {
    return !e.by_column || accepts(o.of, {e.id});
  };
  for (const verdict::RankedEffect& e : d.effects)
    if (counts(e) && (d.verdict != verdict::Verdict::several_effects || !e.in_verdict))
      take({e.id}, e.rmse_held_out.front() / raceway::um);
  if (d.verdict == verdict::Verdict::several_effects)
    take(d.sets.front(), d.channels.front().rmse_held_out_after / raceway::um);
  if (std::isfinite(right)) o.right_held_out = right;
  if (std::isfinite(wrong)) o.wrong_held_out = wrong;
  o.first_is_right = right <= wrong;
}

std::string lines_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::optional<Case> read_case(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / "truth.json")) return std::nullopt;
  const auto truth = nlohmann::json::parse(lines_of(folder / "truth.json"));
  if (!truth.contains("decidable")) return std::nullopt;
  Case c{.name = folder.filename().string(), .folder = folder};
  c.kind = c.name.substr(0, c.name.rfind('-'));
  c.hidden = truth.at("hidden").get<Ids>();
  c.accept = truth.at("accept").get<Ids>();
  c.verdicts = truth.at("verdicts").get<Ids>();
  const nlohmann::json& decidable = truth.at("decidable");
  c.tolerance = decidable.at("tolerance_um").get<double>();
  c.floor = decidable.at("floor_um").get<double>();
  c.outside = !c.hidden.empty() && c.accept.empty();
  if (decidable.contains("lambda_sep")) {
    c.lambda_sep = decidable.at("lambda_sep").get<double>();
  } else if (decidable.contains("rivals") && !c.outside && !c.hidden.empty()) {
    const double right = decidable.at("right").at("train").get<double>();
    const double half_hour_count = half_hours * truth.at("train").at("hours").get<double>();
    for (const nlohmann::json& rival : decidable.at("rivals")) {
      const double ratio = rival.at("train").get<double>() / right;
      c.lambda_sep = std::fmin(c.lambda_sep, half_hour_count * (ratio * ratio - 1.0));
    }
  }
  return c;
}

/// A recorded body is no effect of the catalogue. It is no wrong name either where it predicts
/// well.
bool Outcome::follows_a_body() const {
  constexpr double of_the_floor = 1.5;
  return of.outside && verdict == verdict::Verdict::effect && sets.size() == 1 &&
         sets.front().size() == 1 && sets.front().front() == "input" &&
         added_test <= of_the_floor * of.floor;
}

bool Outcome::right() const {
  if (follows_a_body()) return true;
  if (std::find(of.verdicts.begin(), of.verdicts.end(), verdict::name(verdict)) ==
      of.verdicts.end())
    return false;
  return of.is_clean() || of.outside ||
         std::any_of(sets.begin(), sets.end(), [&](const Ids& s) { return accepts(of, s); });
}

bool Outcome::wrong() const {
  if (sets.empty() || follows_a_body()) return false;
  if (of.outside) return verdict != verdict::Verdict::effect_like;
  // Of two that are hidden, one that acts like most of it is no lie.
  if (of.is_pair() && verdict == verdict::Verdict::effect_like)
    return std::find(of.hidden.begin(), of.hidden.end(), sets.front().front()) == of.hidden.end();
  return std::none_of(sets.begin(), sets.end(), [&](const Ids& s) { return accepts(of, s); });
}

Outcome judge(const Case& of) {
  Outcome o{.of = of};
  try {
    const bool own = std::filesystem::exists(of.folder / "model.toml");
    const std::filesystem::path file = of.folder / (own ? "model.toml" : "correction.toml");
    const correction::Model model = files::read_correction(file.string()).models.front();
    const record::Record train = open(of.folder / "train.csv", model);
    const record::Record test = open(of.folder / "test.csv", model);
    verdict::DiagnoseOptions options;
    const double begin = seconds_of_thread();
    options.progress = [&](double, std::string_view step) {
      if (std::isnan(o.seconds) && step.find("pairs") != std::string_view::npos)
        o.seconds = seconds_of_thread() - begin;
    };
    const verdict::Diagnosis d =
        loop::diagnose(correction::CorrectionSubject(model), train, options);
    (std::isnan(o.seconds) ? o.seconds : o.pairs_seconds) = seconds_of_thread() - begin;
    o.verdict = d.verdict;
    o.sentence = d.sentence;
    for (const Ids& set : d.sets) o.sets.push_back(plain(set));
    rank(d, o);
    o.base_test = error_on(refitted(model, train, {}), test);
    if (d.sets.empty() || d.verdict == verdict::Verdict::effect_like || is_fault(d.sets.front()))
      return o;
    const correction::Model added = refitted(model, train, d.sets.front());
    o.added_test = error_on(added, test);
    o.asked_again = true;
    o.content = loop::diagnose(correction::CorrectionSubject(added), train, {}).verdict ==
                verdict::Verdict::nothing_missing;
  } catch (const std::exception& e) {
    o.failure = e.what();
  }
  return o;
}

std::vector<Outcome> judge_all(const std::vector<Case>& cases, unsigned threads,
                               const std::function<void(const Outcome&)>& done) {
  std::vector<Outcome> outcomes(cases.size());
  std::atomic<std::size_t> next = 0;
  std::mutex telling;
  const auto work = [&] {
    for (std::size_t k = next++; k < cases.size(); k = next++) {
      outcomes[k] = judge(cases[k]);
      const std::scoped_lock lock(telling);
      done(outcomes[k]);
    }
  };
  std::vector<std::thread> workers;
  for (unsigned k = 0; k < threads; ++k) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
  return outcomes;
}

}  // namespace correction_study
