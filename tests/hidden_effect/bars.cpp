#include "tests/hidden_effect/bars.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <tuple>

#include "tests/hidden_effect/real_rigs.h"

namespace hidden_effect {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr int proposed_points = 12;

template <typename List, typename Value>
bool contains(const List& list, const Value& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

bool has_name(const std::vector<std::string>& names, const std::vector<std::string_view>& ids) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& n) { return contains(ids, std::string_view(n)); });
}

/// Ids by which the library's catalogue and the generator's agree what is hidden.
std::vector<std::string_view> known_effects() {
  std::vector<std::string_view> ids;
  for (const Effect& e : catalogue_effects())
    if (is_known(e.id)) ids.push_back(e.id);
  return ids;
}

/// Visibility depends on the torque without noise alone; it is found once per kind of rig.
Visibility cached_visibility(const Rig& rig) {
  using Key = std::tuple<const Machine*, Plan, Noise, std::string, bool, bool>;
  static std::map<Key, Visibility> known;
  static std::mutex mutex;
  std::string ids;
  bool negative = false;
  for (const Hidden& h : rig.hidden) {
    ids += std::string(h.effect->id) + ' ';
    negative = negative || h.values.size < 0.0;
  }
  const Key key{rig.setup.machine, rig.setup.plan,        rig.setup.noise, ids,
                negative,          rig.setup.law.contacts};
  {
    const std::scoped_lock lock(mutex);
    if (const auto found = known.find(key); found != known.end()) return found->second;
  }
  // The generator's sign and the jitter of the temperatures vary with the seed; a fixed seed would
  // fix the sign too, so the first rig of the kind stands for all of them.
  const Visibility v = visibility(rig);
  const std::scoped_lock lock(mutex);
  return known.emplace(key, v).first->second;
}

struct Count {
  int yes = 0, all = 0;
  void add(bool hit) {
    yes += hit ? 1 : 0;
    ++all;
  }
};

Bar share(std::string number, std::string what, bool at_least, double must, double good, Count c) {
  const Interval w = wilson(c.yes, c.all);
  return {.number = std::move(number),
          .what = std::move(what),
          .at_least = at_least,
          .must = must,
          .good = good,
          .unit = "%",
          .measured = c.all > 0 ? 100.0 * c.yes / c.all : nan_value,
          .interval = {100.0 * w.lower, 100.0 * w.upper},
          .trials = c.all};
}

Bar figure(std::string number, std::string what, bool at_least, double must, double good,
           std::string unit, double measured, std::size_t trials) {
  return {.number = std::move(number),
          .what = std::move(what),
          .at_least = at_least,
          .must = must,
          .good = good,
          .unit = std::move(unit),
          .measured = measured,
          .interval = {nan_value, nan_value},
          .trials = static_cast<int>(trials)};
}

double mean(const std::vector<double>& values) {
  if (values.empty()) return nan_value;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double median(std::vector<double> values) {
  if (values.empty()) return nan_value;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Count count(const std::vector<Outcome>& outcomes, const std::function<bool(const Outcome&)>& which,
            const std::function<bool(const Outcome&)>& hit) {
  Count c;
  for (const Outcome& o : outcomes)
    if (which(o)) c.add(hit(o));
  return c;
}

std::uint64_t seed_of(std::size_t block, std::size_t item, int seed) {
  return 1000003ULL * (block + 1) + 7919ULL * item + static_cast<std::uint64_t>(seed);
}

/// An effect of the catalogue, as large as the diagnosis of a rig without it says that it would
/// have been found. Not an exponent: its share depends on where it is without effect.
Wish as_stated(Setup setup, int turn) {
  const std::vector<std::string_view> known = known_effects();
  const Rig rig = make_rig(setup);
  const std::vector<std::pair<std::string, double>> shares = ask(rig, rig.train).stated;
  for (std::size_t k = 0; k < known.size(); ++k) {
    const std::string_view id = known[(static_cast<std::size_t>(turn) + k) % known.size()];
    for (const auto& [name, share] : shares)
      if (name == id && share < 0.3 && !id.ends_with("exponent") &&
          effect(id).shape_lower == effect(id).shape_upper)
        return {.id = id, .share = share};
  }
  return {.id = known.front()};
}

/// Power laws c n^a F^b nu^c of the outside list, for the exponents of `shape`.
const std::map<std::string_view, std::array<double, 3>>& power_laws() {
  static const std::map<std::string_view, std::array<double, 3>> laws{
      {"power-law-slow", {0.5, 0.5, 0.0}},
      {"power-law-product", {1.0, 1.0, 0.0}},
      {"power-law-cold", {0.8, 0.7, 0.8}}};
  return laws;
}

}  // namespace

bool Outcome::is(std::initializer_list<std::string_view> verdicts) const {
  return contains(verdicts, std::string_view(answer.verdict));
}

bool Outcome::names_a_right() const {
  return std::any_of(accepted.begin(), accepted.end(),
                     [&](const auto& ids) { return has_name(answer.names, ids); });
}

bool Outcome::names_data() const {
  return std::any_of(answer.names.begin(), answer.names.end(), is_datum);
}

bool Outcome::names_every_hidden() const {
  return !accepted.empty() && std::all_of(accepted.begin(), accepted.end(), [&](const auto& ids) {
    return has_name(answer.names, ids);
  });
}

bool Outcome::names_only_right() const {
  return !answer.names.empty() &&
         std::all_of(answer.names.begin(), answer.names.end(), [&](const std::string& name) {
           return std::any_of(accepted.begin(), accepted.end(), [&](const auto& ids) {
             return contains(ids, std::string_view(name));
           });
         });
}

bool Outcome::acts_like_right_shape() const {
  return is({"effect-like"}) && !answer.names.empty() && is_empirical(answer.names.front()) &&
         std::any_of(accepted.begin(), accepted.end(), [&](const auto& ids) {
           return contains(ids, std::string_view(answer.names.front()));
         });
}

bool Outcome::exact() const {
  if (acts_like_right_shape()) return accepted.size() == 1;
  if (accepted.size() == 1) return is({"effect", "ambiguous"}) && names_only_right();
  return is({"several-effects"}) && names_every_hidden() && names_only_right();
}

bool Outcome::in_set() const {
  if (acts_like_right_shape()) return accepted.size() == 1;
  if (accepted.size() == 1) return is({"effect", "ambiguous"}) && names_a_right();
  return is({"several-effects"}) && names_every_hidden();
}

bool Outcome::wrong() const {
  return is({"effect", "ambiguous", "several-effects"}) && !names_a_right();
}

bool Outcome::right_first() const {
  return std::any_of(accepted.begin(), accepted.end(), [&](const auto& ids) {
    return contains(ids, std::string_view(answer.first));
  });
}

bool Outcome::includes_truth() const {
  if (trial.setup.hidden.empty() && accepted.empty()) return !alarm();
  if (outside) return is({"not-in-catalogue", "effect-like"});
  return in_set();
}

bool Outcome::names_wrong() const {
  return (is({"effect"}) && !names_a_right()) || (is({"several-effects"}) && !names_every_hidden());
}

bool Outcome::only_truth() const {
  if (trial.setup.hidden.empty() && accepted.empty()) return !alarm();
  if (outside) return is({"not-in-catalogue"});
  return exact();
}

const std::vector<Block>& blocks() {
  static const std::vector<Block> all{
      {"null", "nothing hidden, independent noise, every plan but the sweep"},
      {"noise", "nothing hidden, each kind of structured noise"},
      {"base", "exponents 0.70 and 0.30 in the base law, nothing else"},
      {"factorial", "each effect of the catalogue, factorial plan"},
      {"run-up", "each effect of the catalogue, run-up plan; ambiguous ones measured further"},
      {"sweep", "each effect of the catalogue, speed sweep"},
      {"replicated", "each effect of the catalogue, replicated factorial"},
      {"forms", "the same mechanisms in other forms, factorial plan"},
      {"outside", "effects that no catalogue has, factorial plan"},
      {"two", "two effects at once, factorial and run-up plan"},
      {"invariance", "the same rig with rows, candidates, parameters in another order"},
      {"time", "how long a verdict takes, one rig after the other on one core"},
      {"blind", "a third each: nothing, one of the catalogue, outside or two; any plan and noise"},
      {"real", "plans, noise and mistakes of real laboratories"},
      // At the end, so that the others keep their seeds.
      {"contact", "truth by a law of the contacts: nothing hidden, each effect that it lacks"},
  };
  return all;
}

std::vector<Trial> trials(std::string_view block, int seeds, int first, std::string_view only) {
  std::vector<Trial> out;
  std::size_t block_index = 0;
  while (block_index < blocks().size() && blocks()[block_index].id != block) ++block_index;
  std::size_t item = 0;
  const auto add = [&](Plan plan, Noise noise, std::vector<Wish> hidden, BaseLaw law = {}) {
    for (int i = first; i < first + seeds; ++i)
      out.push_back(
          {.block = blocks()[block_index].id,
           .setup = {
               .machine = &machines()[(item + static_cast<std::size_t>(i)) % machines().size()],
               .plan = plan,
               .noise = noise,
               .law = law,
               .hidden = hidden,
               .seed = seed_of(block_index, item, i)}});
    ++item;
  };
  const Noise independent = Noise::independent;
  const auto each = [&](auto effects, Plan plan) {
    for (const Effect& e : effects)
      if (e.family.empty() || is_known(e.family)) add(plan, independent, {{e.id, 0.1}});
  };
  if (block == "null") {
    // As many rigs as a block of effects has.
    for (int repeat = 0; repeat < 4; ++repeat)
      for (const Plan plan : {Plan::factorial, Plan::run_up, Plan::replicated})
        add(plan, independent, {});
  } else if (block == "noise") {
    for (const Noise noise :
         {Noise::run_offsets, Noise::autoregressive, Noise::absolute, Noise::outliers})
      for (int repeat = 0; repeat < 4; ++repeat) add(Plan::factorial, noise, {});
  } else if (block == "base") {
    BaseLaw law;
    law.viscous_exponent = 0.70;
    law.y = 0.30;
    // f0 such that the torque stays what it was in the middle.
    law.f0 *= std::pow(1e5, 2.0 / 3.0 - 0.70);
    for (int repeat = 0; repeat < 4; ++repeat) add(Plan::factorial, independent, {}, law);
  } else if (block == "factorial") {
    each(catalogue_effects(), Plan::factorial);
  } else if (block == "run-up") {
    each(catalogue_effects(), Plan::run_up);
  } else if (block == "sweep") {
    each(catalogue_effects(), Plan::sweep);
  } else if (block == "replicated") {
    each(catalogue_effects(), Plan::replicated);
  } else if (block == "forms") {
    each(other_forms(), Plan::factorial);
  } else if (block == "outside") {
    each(outside_effects(), Plan::factorial);
  } else if (block == "two") {
    const std::vector<std::pair<std::string_view, std::string_view>> pairs{
        {"seal-friction", "lubricant-drag"},
        {"spin-friction", "inlet-shear-heating"},
        {"load-offset", "lubricant-drag"},
        {"thermal-preload", "mixed-lubrication"},
        {"seal-friction", "film-self-heating"},
        {"gyroscopic-slip", "churning"},
        {"torque-temperature-drift", "centrifugal-ring-growth"}};
    for (const Plan plan : {Plan::factorial, Plan::run_up})
      for (const auto& [a, b] : pairs)
        if (is_known(a) && is_known(b)) add(plan, independent, {{a, 0.12}, {b, 0.12}});
  } else if (block == "invariance") {
    for (const std::string_view id : {"spin-friction", "inlet-shear-heating", "seal-friction"})
      if (is_known(id)) add(Plan::factorial, independent, {{id, 0.1}});
    add(Plan::factorial, independent, {});
    add(Plan::run_up, independent, {{"cage-resonance", 0.1}});
  } else if (block == "time") {
    for (const std::string_view id : {"lubricant-drag", "inlet-shear-heating"})
      if (is_known(id)) add(Plan::factorial, independent, {{id, 0.1}});
    add(Plan::factorial, independent, {{"speed-ripple", 0.1}});
  } else if (block == "contact") {
    BaseLaw law;
    law.contacts = true;
    law.rolling_factor = 0.8;
    for (int repeat = 0; repeat < 5; ++repeat)
      for (const Plan plan : {Plan::factorial, Plan::run_up}) add(plan, independent, {}, law);
    for (const Effect& e : catalogue_effects())
      if (joins_contacts(e.id)) add(Plan::factorial, independent, {{e.id, 0.1}}, law);
  } else if (block == "real") {
    for (const RealRig& rig : real_rigs()) {
      const bool wanted = rig.id.find(only) != rig.id.npos;
      for (int i = first * rig.per_seed; wanted && i < (first + seeds) * rig.per_seed; ++i) {
        Trial trial{.block = blocks()[block_index].id, .setup = rig.setup, .kind = rig.id};
        // The card that is wrong is one of the first oil.
        const std::size_t choice = rig.setup.mistake.viscosity_40 > 0.0 ? 2 : machines().size();
        trial.setup.machine = &machines()[(item + static_cast<std::size_t>(i)) % choice];
        trial.setup.seed = seed_of(block_index, item, i);
        if (rig.as_stated) trial.setup.hidden = {as_stated(trial.setup, i)};
        out.push_back(std::move(trial));
      }
      ++item;
    }
  } else if (block == "blind") {
    const std::vector<std::string_view> known = known_effects();
    constexpr Plan plans[] = {Plan::factorial, Plan::run_up, Plan::replicated};
    constexpr Noise noises[] = {Noise::independent, Noise::run_offsets, Noise::independent,
                                Noise::outliers, Noise::absolute};
    for (int i = first * 3; i < (first + seeds) * 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      Setup s{.machine = &machines()[(k / 3) % machines().size()],
              .plan = plans[(k / 3) % 3],
              .noise = noises[(k / 2) % 5],
              .law = {},
              .hidden = {},
              .seed = seed_of(block_index, 0, i)};
      if (k % 3 == 1 && !known.empty()) {
        s.hidden = {{known[(k * 7 / 3) % known.size()], 0.12}};
      } else if (k % 3 == 2 && (k / 3) % 2 == 0) {
        const auto outside = outside_effects();
        s.hidden = {{outside[(k / 6) % outside.size()].id, 0.12}};
      } else if (k % 3 == 2 && is_known("seal-friction") && is_known("lubricant-drag")) {
        s.plan = Plan::factorial;
        s.hidden = {{"seal-friction", 0.12}, {"lubricant-drag", 0.12}};
      }
      out.push_back({.block = blocks()[block_index].id, .setup = s});
    }
  }
  return out;
}

Outcome judge(const Trial& trial) {
  const Rig rig = make_rig(trial.setup);
  Outcome o{.trial = trial,
            .answer = ask(rig, rig.train),
            .accepted = {},
            .visibility = {},
            .improvement = {},
            .after_proposed = {},
            .after_same = {},
            .changed_by = {}};
  for (std::size_t i = 0; i < rig.hidden.size(); ++i) {
    const Effect& e = *rig.hidden[i].effect;
    o.outside = o.outside || e.kind == Kind::outside;
    o.too_small = o.too_small || rig.shares[i] < 0.5 * trial.setup.hidden[i].share;
    if (!e.family.empty()) o.accepted.push_back(rig.accepted(i));
  }
  if (!trial.kind.empty())
    if (const auto right = real_rig(trial.kind).accepted; !right.empty())
      o.accepted = {{right.begin(), right.end()}};
  if (rig.hidden.size() == 1)
    for (std::size_t k = 0; k < o.answer.names.size(); ++k)
      if (o.answer.names[k] == rig.hidden.front().effect->id) {
        const double size = rig.hidden.front().values.size;
        o.size_held = size >= o.answer.intervals[k].lower && size <= o.answer.intervals[k].upper;
      }
  // Of the contacts it would take longer than all else.
  if (rig.hidden.size() == 1 && trial.kind.empty() && trial.block != "contact")
    o.visibility = cached_visibility(rig);
  if (trial.oracle) o.oracle = ask_oracle(rig, rig.train);
  if ((trial.block == "factorial" || trial.block == "contact") && o.exact() &&
      !o.accepted.empty()) {
    const std::string leading[] = {o.answer.names.front()};
    o.improvement = improve(rig, leading);
  }
  if (trial.block == "run-up" && o.is({"ambiguous"}) && o.in_set() && !o.exact()) {
    // The proposed points against as many repetitions spread over the plan.
    std::vector<Point> proposed, same;
    for (std::size_t i = 0; i < proposed_points; ++i) {
      if (!o.answer.suggested.empty())
        proposed.push_back(o.answer.suggested[i % o.answer.suggested.size()]);
      same.push_back(rig.train[i * rig.train.size() / proposed_points].point);
    }
    const auto again = [&](const std::vector<Point>& points, bool& right, bool& wrong) {
      std::vector<Reading> rows = rig.train;
      for (const Reading& r : measure(rig, points, trial.setup.seed + 77)) rows.push_back(r);
      if (trial.oracle && &points == &proposed) o.oracle_after_proposed = ask_oracle(rig, rows);
      Outcome next = o;
      next.answer = ask(rig, rows);
      right = next.exact();
      wrong = next.wrong();
      return next.answer.verdict + " " + next.answer.sentence;
    };
    bool ignored = false;
    if (!proposed.empty())
      o.after_proposed = again(proposed, o.right_after_proposed, o.wrong_after_proposed);
    else
      o.after_proposed = "nothing proposed";
    o.after_same = again(same, o.right_after_same, ignored);
  }
  if (trial.block == "invariance") {
    const auto differs = [&](const Presentation& p) {
      const Answer other = ask(rig, rig.train, p);
      return other.verdict != o.answer.verdict || other.names != o.answer.names;
    };
    if (differs({.reversed_rows = true})) o.changed_by += "order of rows, ";
    if (differs({.reversed_catalogue = true})) o.changed_by += "order of candidates, ";
    if (differs({.other_start = true})) o.changed_by += "start values, ";
  }
  return o;
}

std::vector<Outcome> judge_all(const std::vector<Trial>& trials,
                               const std::function<void(std::size_t)>& progress) {
  std::vector<Outcome> outcomes(trials.size());
  std::size_t done = 0;
  std::mutex mutex;
  const auto work = [&](std::size_t i) {
    outcomes[i] = judge(trials[i]);
    const std::scoped_lock lock(mutex);
    progress(++done);
  };
  const auto timed = [&](std::size_t i) { return trials[i].block == "time"; };
  // Processor time is that of the program: nothing else may run meanwhile.
  tbb::task_arena(1).execute([&] {
    for (std::size_t i = 0; i < trials.size(); ++i)
      if (timed(i)) work(i);
  });
  tbb::parallel_for(std::size_t{0}, trials.size(), [&](std::size_t i) {
    if (!timed(i)) tbb::this_task_arena::isolate([&] { work(i); });
  });
  return outcomes;
}

Interval wilson(int successes, int trials) {
  if (trials == 0) return {nan_value, nan_value};
  const double n = trials, p = successes / n, z = 1.959963984540054, z2 = z * z;
  const double middle = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half = z / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n));
  // At both ends the bound is exact, which rounding would miss.
  return {successes == 0 ? 0.0 : middle - half, successes == trials ? 1.0 : middle + half};
}

std::vector<Carried> carried(const std::vector<Outcome>& judged) {
  std::vector<Carried> table;
  struct Said {
    bool right, wrong;
  };
  const auto add = [&](const std::string& kind, const char* what, Said diagnosis, Said oracle) {
    auto entry = std::find_if(table.begin(), table.end(),
                              [&](const Carried& c) { return c.kind == kind && c.what == what; });
    if (entry == table.end()) entry = table.insert(entry, {.kind = kind, .what = what});
    entry->diagnosis += diagnosis.right ? 1 : 0;
    entry->oracle += oracle.right ? 1 : 0;
    entry->both += diagnosis.right && oracle.right ? 1 : 0;
    entry->diagnosis_wrong += diagnosis.wrong ? 1 : 0;
    entry->oracle_wrong += oracle.wrong ? 1 : 0;
    ++entry->cases;
  };
  for (const Outcome& o : judged) {
    if (o.too_small || !o.oracle) continue;
    std::string kind(o.trial.kind.empty() ? o.trial.block : o.trial.kind);
    if (o.trial.block == "two") kind += ", " + std::string(name(o.trial.setup.plan));
    const OracleAnswer& oracle = *o.oracle;
    const bool wrong = o.names_wrong(), misnames = oracle.misnames();
    if (!oracle.something) {
      add(kind, "nothing missing", {!o.alarm(), wrong}, {!oracle.detects(), misnames});
      if (oracle.learned_detection) {
        const bool quiet = *oracle.learned_detection <= oracle.learned_from;
        add(kind, "the same, scatter of zeros unknown", {!o.alarm(), wrong}, {quiet, !quiet});
      }
      continue;
    }
    add(kind, "something missing", {o.alarm(), wrong}, {oracle.detects(), misnames});
    if (oracle.learned_detection)
      add(kind, "any candidate, run offsets unknown", {o.alarm(), wrong},
          {*oracle.learned_detection > oracle.learned_from, misnames});
    // The verdict may be the one with another base law.
    const bool with_other_law =
        std::any_of(o.accepted.begin(), o.accepted.end(),
                    [&](const auto& ids) { return has_name(o.answer.names_given_it, ids); });
    add(kind, "truth in the verdict", {o.includes_truth() || with_other_law, wrong},
        {oracle.includes(), misnames});
    add(kind, "only the truth", {o.only_truth(), wrong}, {oracle.decides(), misnames});
    if (oracle.entry_lead)
      add(kind, "right entry ranks first", {o.right_first(), wrong},
          {*oracle.entry_lead > 0.0, *oracle.entry_lead < -within_reach});
    if (oracle.misfit_excess) {
      const bool beyond = *oracle.misfit_excess > 0.0;
      add(kind, "no entry fits, formula unknown", {o.only_truth(), wrong}, {beyond, !beyond});
      if (o.visibility.separation >= 50.0)
        add(kind, "the same, lambda_sep >= 50", {o.only_truth(), wrong}, {beyond, !beyond});
    }
    if (o.trial.setup.hidden.size() == 2)
      add(kind, "only the truth, each loses 60", {o.only_truth(), wrong},
          {oracle.decides() && oracle.least_loss >= 60.0, misnames});
    if (o.oracle_after_proposed)
      add(kind, "only the truth, 12 proposed points",
          {o.right_after_proposed, o.wrong_after_proposed},
          {o.oracle_after_proposed->decides(), o.oracle_after_proposed->misnames()});
  }
  return table;
}

bool Bar::missed() const { return at_least ? measured < must : measured > must; }
bool Bar::is_good() const { return at_least ? measured >= good : measured <= good; }

std::vector<Bar> bars(const std::vector<Outcome>& judged) {
  std::vector<Outcome> outcomes;
  for (const Outcome& o : judged)
    if (!o.too_small) outcomes.push_back(o);
  using O = const Outcome&;
  const auto block = [](std::string_view id) { return [id](O o) { return o.trial.block == id; }; };
  const auto noise = [](Noise kind) {
    return [kind](O o) { return o.trial.block == "noise" && o.trial.setup.noise == kind; };
  };
  // Plans on which each effect of the catalogue was hidden alone.
  const auto plans = [](O o) {
    return contains(
        std::initializer_list<std::string_view>{"factorial", "run-up", "sweep", "replicated"},
        o.trial.block);
  };
  const auto exact = [](O o) { return o.exact(); };
  const auto in_set = [](O o) { return o.in_set(); };
  const auto wrong = [](O o) { return o.wrong(); };
  const auto alarm = [](O o) { return o.alarm(); };
  const auto first = [](O o) { return o.right_first(); };

  std::vector<Bar> out;
  out.push_back(share("1", "false alarm, independent noise", false, 2, 1,
                      count(outcomes, block("null"), alarm)));
  for (const Noise kind :
       {Noise::run_offsets, Noise::autoregressive, Noise::absolute, Noise::outliers})
    out.push_back(share("2", "false alarm, " + std::string(name(kind)), false, 5, 3,
                        count(outcomes, noise(kind), alarm)));
  out.push_back(
      share("3", "factorial: exact", true, 88, 93, count(outcomes, block("factorial"), exact)));
  out.push_back(share("4", "factorial: truth in the verdict", true, 94, 97,
                      count(outcomes, block("factorial"), in_set)));
  for (const std::string_view plan : {"factorial", "run-up", "sweep", "replicated"})
    out.push_back(share("5", std::string(plan) + ": wrong", false, 2, 1,
                        count(outcomes, block(plan), wrong)));
  out.push_back(share("6", "run-up: exact", true, 70, 78, count(outcomes, block("run-up"), exact)));
  out.push_back(share("6", "run-up: truth in the verdict", true, 92, 96,
                      count(outcomes, block("run-up"), in_set)));
  out.push_back(share(
      "7", "lambda_sep >= 20: right one first", true, 97, 99,
      count(
          outcomes, [&](O o) { return plans(o) && o.visibility.separation >= 20.0; }, first)));
  out.push_back(
      share("7", "lambda_det >= 25: detected", true, 98, 99,
            count(
                outcomes, [&](O o) { return plans(o) && o.visibility.detection >= 25.0; }, alarm)));

  // 8: right first, as lambda to each rival predicts it, in classes of the least lambda.
  {
    constexpr double edges[] = {0.0, 2.0, 8.0, 20.0, 50.0, 1e300};
    double worst = nan_value;
    int all = 0;
    for (std::size_t k = 0; k + 1 < std::size(edges); ++k) {
      double predicted = 0.0;
      Count c;
      for (const Outcome& o : outcomes) {
        if (!plans(o) || !o.alarm() || o.visibility.separation < edges[k] ||
            o.visibility.separation >= edges[k + 1])
          continue;
        predicted += o.visibility.right_first;
        c.add(o.right_first());
      }
      if (c.all < 20) continue;
      const double gap = 100.0 * std::abs(predicted - c.yes) / c.all;
      worst = std::isnan(worst) ? gap : std::max(worst, gap);
      all += c.all;
    }
    out.push_back(figure("8", "right first against law of lambda_sep, worst class", false, 10, 5,
                         "points", worst, static_cast<std::size_t>(all)));
  }

  const auto followed = [](O o) { return !o.after_proposed.empty(); };
  out.push_back(share("9", "ambiguous, then 12 proposed points: decided right", true, 88, 94,
                      count(outcomes, followed, [](O o) { return o.right_after_proposed; })));
  out.push_back(share("9", "the same with 12 repeated points (for comparison)", true, 0, 0,
                      count(outcomes, followed, [](O o) { return o.right_after_same; })));
  out.push_back(share("9", "ambiguous, then 12 proposed points: wrong", false, 2, 0,
                      count(outcomes, followed, [](O o) { return o.wrong_after_proposed; })));

  const auto unknown = [](O o) { return o.is({"not-in-catalogue"}); };
  const auto outside_apart = [](O o) {
    return o.trial.block == "outside" && o.visibility.separation >= 50.0;
  };
  out.push_back(share("10", "outside, lambda_sep >= 50: not in catalogue", true, 97, 99,
                      count(outcomes, outside_apart, unknown)));
  out.push_back(
      share("10", "the same or effect-like", true, 97, 99, count(outcomes, outside_apart, [](O o) {
              return o.is({"not-in-catalogue", "effect-like"});
            })));
  out.push_back(share("11", "outside: wrong single name", false, 15, 8,
                      count(outcomes, block("outside"), [](O o) { return o.is({"effect"}); })));
  out.push_back(share("12", "other forms: right family first", true, 95, 98,
                      count(outcomes, block("forms"), first)));
  out.push_back(
      share("12", "other forms: wrong", false, 2, 1, count(outcomes, block("forms"), wrong)));
  out.push_back(share("13", "other forms: right family in the verdict", true, 90, 95,
                      count(outcomes, block("forms"), [](O o) {
                        return o.is({"effect", "ambiguous", "effect-like"}) && o.names_a_right();
                      })));
  const auto two = [](Plan plan) {
    return [plan](O o) { return o.trial.block == "two" && o.trial.setup.plan == plan; };
  };
  out.push_back(share("14", "two effects, factorial: exact", true, 88, 92,
                      count(outcomes, two(Plan::factorial), exact)));
  out.push_back(share("14", "two effects, run-up: exact or in the set", true, 95, 99,
                      count(outcomes, two(Plan::run_up), in_set)));
  out.push_back(
      share("14b", "outside: false pairs", false, 10, 5,
            count(outcomes, block("outside"), [](O o) { return o.is({"several-effects"}); })));

  {
    std::vector<double> validation, in_sample, seconds, pair_seconds;
    std::map<std::string_view, std::vector<std::vector<double>>> off_by;  // by effect and number
    for (const Outcome& o : outcomes) {
      if (o.trial.block == "time" && o.answer.verdict != "failed") {
        const bool pairs = o.is({"several-effects", "not-in-catalogue", "effect-like"});
        (pairs ? pair_seconds : seconds).push_back(o.answer.seconds);
      }
      if (!o.improvement.converged || o.trial.block != "factorial") continue;
      validation.push_back(100.0 * o.improvement.validation);
      in_sample.push_back(o.improvement.in_sample);
      const std::string_view id = o.trial.setup.hidden.front().id;
      const std::vector<double> truth = free_values(o.trial.setup.law);
      auto& off_of = off_by[id];
      off_of.resize(truth.size());
      for (std::size_t k = 0; k < truth.size(); ++k)
        off_of[k].push_back(o.improvement.free[k] / truth[k] - 1.0);
    }
    out.push_back(figure("15", "validation error after adding, mean", false, 0.5, 0.3, "%",
                         mean(validation), validation.size()));
    out.push_back(figure("15", "error in sample over noise floor, mean", false, 1.05, 1.02, "",
                         mean(in_sample), in_sample.size()));
    // The exponents share their size with f0 and z by definition of their reference point.
    std::vector<double> bias;
    for (const auto& [id, numbers] : off_by) {
      if (id == "viscous-exponent" || id == "load-exponent") continue;
      double most = 0.0;
      for (const std::vector<double>& values : numbers)
        most = std::max(most, std::abs(mean(values)));
      bias.push_back(100.0 * most);
    }
    out.push_back(figure("16", "bias of f0 and z after adding, median of effects", false, 1, 0.3,
                         "%", median(bias), bias.size()));
    out.push_back(figure("16", "the same, worst effect (for the record)", false, 1e300, 3, "%",
                         bias.empty() ? nan_value : *std::max_element(bias.begin(), bias.end()),
                         bias.size()));
    std::vector<double> off;
    for (const Outcome& o : outcomes) {
      if (!o.is({"not-in-catalogue"}) || o.trial.setup.hidden.size() != 1) continue;
      const auto law = power_laws().find(o.trial.setup.hidden.front().id);
      if (law == power_laws().end() || o.answer.exponents.size() != 3) continue;
      for (std::size_t k = 0; k < 3; ++k)
        off.push_back(std::abs(o.answer.exponents[k] - law->second[k]));
    }
    out.push_back(figure("17", "exponents of an unknown power law, median error", false, 0.25, 0.1,
                         "", median(off), off.size()));
    out.push_back(figure("18", "time of a verdict, single effects, median", false, 0.2, 0.02, "s",
                         median(seconds), seconds.size()));
    out.push_back(figure("18", "time of a verdict with all pairs, median", false, 2, 0.3, "s",
                         median(pair_seconds), pair_seconds.size()));
  }
  out.push_back(
      share("19", "identical verdict: order of rows, candidates, parameters", true, 100, 100,
            count(outcomes, block("invariance"), [](O o) { return o.changed_by.empty(); })));
  out.push_back(share("20", "blind: right class of verdict", true, 80, 90,
                      count(outcomes, block("blind"), [](O o) {
                        if (o.trial.setup.hidden.empty()) return !o.alarm();
                        if (o.outside) return o.is({"not-in-catalogue", "effect-like"});
                        if (o.accepted.size() > 1) return o.is({"several-effects"});
                        return o.is({"effect", "ambiguous", "effect-like"});
                      })));
  out.push_back(share("20", "blind: wrong single name where lambda_sep >= 50", false, 0, 0,
                      count(
                          outcomes,
                          [](O o) {
                            return o.trial.block == "blind" && o.trial.setup.hidden.size() == 1 &&
                                   o.visibility.separation >= 50.0;
                          },
                          [](O o) { return o.is({"effect"}) && !o.names_a_right(); })));
  out.push_back(share(
      "21", "right cards: wrong data in the verdict", false, 5, 1,
      count(
          outcomes, [](O o) { return o.trial.kind.empty(); }, [](O o) { return o.names_data(); })));
  out.push_back(
      share("22", "right law: another one is said to explain the data", false, 2, 0,
            count(
                outcomes,
                [](O o) { return o.trial.kind.empty() && o.trial.block != "base" && !o.outside; },
                [](O o) { return !o.answer.other_law.empty(); })));
  const auto contact = [](bool hidden) {
    return [hidden](O o) {
      return o.trial.block == "contact" && o.trial.setup.hidden.empty() != hidden;
    };
  };
  out.push_back(
      share("c1", "contact law: false alarm", false, 3, 2, count(outcomes, contact(false), alarm)));
  out.push_back(
      share("c2", "contact law: wrong", false, 5, 2, count(outcomes, contact(true), wrong)));
  out.push_back(share("c3", "contact law: truth in the verdict", true, 90, 95,
                      count(outcomes, contact(true), in_set)));
  out.push_back(
      share("c3", "contact law: exact", true, 80, 90, count(outcomes, contact(true), exact)));
  {
    std::vector<double> validation, off;
    for (const Outcome& o : outcomes) {
      if (o.trial.block != "contact" || !o.improvement.converged) continue;
      validation.push_back(100.0 * o.improvement.validation);
      off.push_back(100.0 *
                    std::abs(o.improvement.free[0] / free_values(o.trial.setup.law).front() - 1.0));
    }
    out.push_back(figure("c4", "contact law: validation error after adding, mean", false, 1, 0.5,
                         "%", mean(validation), validation.size()));
    out.push_back(figure("c4", "contact law: error of the rolling factor, median", false, 2, 1, "%",
                         median(off), off.size()));
  }
  for (const RealRig& rig : real_rigs())
    for (const Demand& d : rig.demands)
      out.push_back(share(
          "r", std::string(rig.id) + ": " + std::string(d.what), d.at_least, d.must, d.good,
          count(
              outcomes, [&](O o) { return o.trial.kind == rig.id && (!d.among || d.among(o)); },
              d.hit)));
  out.push_back(share("f7", "base 0.70/0.30: a base exponent in the verdict", true, 95, 98,
                      count(outcomes, block("base"), [](O o) {
                        return contains(o.answer.names, "viscous-exponent") ||
                               contains(o.answer.names, "load-exponent");
                      })));
  return out;
}

}  // namespace hidden_effect
