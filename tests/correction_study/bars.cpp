#include "tests/correction_study/bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "record/median.h"

namespace correction_study {
namespace {

constexpr double enough = 20.0;  // lambda_sep from which two are told apart

using Chosen = std::function<bool(const Outcome&)>;

class Counter {
 public:
  explicit Counter(const std::vector<Outcome>& outcomes) : outcomes_(outcomes) {}

  void share(std::string number, std::string what, bool at_least, double must, double good,
             const Chosen& asked, const Chosen& is) {
    int all = 0, yes = 0;
    for (const Outcome& o : outcomes_) {
      if (!o.failure.empty() || !asked(o)) continue;
      ++all;
      yes += is(o) ? 1 : 0;
    }
    const double n = all, p = all > 0 ? yes / n : unset, z = 1.959963984540054;
    const double middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
    const double half =
        z / (1.0 + z * z / n) * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
    list.push_back({std::move(number), std::move(what), at_least, must, good, "%", 100.0 * p,
                    100.0 * std::max(0.0, middle - half), 100.0 * std::min(1.0, middle + half),
                    all});
  }

  /// The median, or the worst.
  void figure(std::string number, std::string what, double must, double good, std::string unit,
              bool worst, const std::function<double(const Outcome&)>& value) {
    std::vector<double> values;
    for (const Outcome& o : outcomes_)
      if (const double v = o.failure.empty() ? value(o) : unset; std::isfinite(v))
        values.push_back(v);
    const double measured = values.empty() ? unset
                            : worst        ? *std::max_element(values.begin(), values.end())
                                           : raceway::record::median(values);
    list.push_back({std::move(number), std::move(what), false, must, good, std::move(unit),
                    measured, unset, unset, static_cast<int>(values.size())});
  }

  std::vector<Bar> list{};

 private:
  const std::vector<Outcome>& outcomes_;
};

bool hides_known(const Outcome& o) { return !o.of.is_clean() && !o.of.outside; }
bool is_of_reading(const Outcome& o) {
  return o.of.kind == "offset-jump" || o.of.kind == "slow-drift" ||
         o.of.kind == "sensor-quantisation" || o.of.kind == "exchanged-columns" ||
         o.of.kind == "loose-sensor";
}

}  // namespace

std::vector<Bar> bars(const std::vector<Outcome>& outcomes) {
  Counter count(outcomes);
  const auto clean = [](const Outcome& o) { return o.of.is_clean(); };
  const auto outside = [](const Outcome& o) { return o.of.outside; };
  const auto any = [](const Outcome&) { return true; };
  const auto right = [](const Outcome& o) { return o.right(); };
  const auto wrong = [](const Outcome& o) { return o.wrong(); };
  const auto over_floor = [](const Outcome& o) {
    return hides_known(o) && o.right() ? o.added_test / o.of.floor : unset;
  };
  count.share("4", "nothing missing: false alarm", false, 5, 2, clean,
              [](const Outcome& o) { return !o.right(); });
  count.share("5", "one effect or two: right verdict", true, 75, 85, hides_known, right);
  count.share(
      "5", "one effect", true, 75, 85,
      [](const Outcome& o) { return hides_known(o) && !o.of.is_pair(); }, right);
  count.share(
      "5", "two effects", true, 75, 85, [](const Outcome& o) { return o.of.is_pair(); }, right);
  count.share("6", "wrong name or pair", false, 4, 0, any, wrong);
  count.share("7", "outside the catalogue: said so", true, 85, 95, outside, right);
  count.figure("8", "test error after add over floor, median", 1.15, 1.02, "", false, over_floor);
  count.figure("8", "the same, worst", 1.5, 1.2, "", true, over_floor);
  count.figure("9", "test error after add over refitted base, median", 0.25, 0.2, "", false,
               [](const Outcome& o) {
                 return hides_known(o) && o.right() && !is_of_reading(o)
                            ? o.added_test / o.base_test
                            : unset;
               });
  count.share("10", "nothing missing: test error within tolerance", true, 100, 100, clean,
              [](const Outcome& o) { return o.base_test <= o.of.tolerance; });
  count.share(
      "11", "lambda_sep >= 20: right one first", true, 95, 100,
      [](const Outcome& o) {
        return hides_known(o) && !o.of.is_pair() && o.of.lambda_sep >= enough &&
               std::isfinite(o.right_held_out);
      },
      [](const Outcome& o) { return o.first_is_right; });
  count.share(
      "12", "asked again after add: nothing missing", true, 90, 100,
      [](const Outcome& o) { return o.asked_again; }, [](const Outcome& o) { return o.content; });
  count.figure("13", "time of a verdict, single effects, median", 10, 0.5, "s", false,
               [](const Outcome& o) { return o.seconds; });
  count.figure("13", "time of a verdict with pairs, median", 60, 3, "s", false,
               [](const Outcome& o) { return o.pairs_seconds; });
  return count.list;
}

std::string table(const std::vector<Bar>& bars) {
  std::string text = fmt::format("{:<4} {:<50} {:>8} {:>8} {:>9}  {:<16} {:>5}\n", "bar", "",
                                 "must", "good", "now", "95 % interval", "cases");
  for (const Bar& b : bars) {
    const char* const sign = b.at_least ? ">=" : "<=";
    const bool share = b.unit == "%";
    text += fmt::format(
        "{:<4} {:<50} {:>8} {:>8} {:>9}  {:<16} {:>5} {}\n", b.number, b.what,
        fmt::format("{} {:g}", sign, b.must), fmt::format("{} {:g}", sign, b.good),
        share ? fmt::format("{:.1f}", b.measured)
              : fmt::format("{:.2f}{}{}", b.measured, b.unit.empty() ? "" : " ", b.unit),
        share && b.cases > 0 ? fmt::format("{:.1f} to {:.1f}", b.lower, b.upper) : "", b.cases,
        b.cases == 0  ? ""
        : b.missed()  ? "!"
        : b.is_good() ? "+"
                      : "");
  }
  return text;
}

std::string line(const Outcome& o) {
  if (!o.failure.empty()) return fmt::format("{:<40} failed: {}", o.of.name, o.failure);
  std::vector<std::string> sets;
  for (const std::vector<std::string>& set : o.sets)
    sets.push_back(fmt::format("{}", fmt::join(set, "+")));
  return fmt::format(
      "{:<40} {:<7} {:<16} tol {:.1f} held out: base {:.2f} right {:.2f} wrong {:.2f} ({}); test: "
      "base {:.2f} added {:.2f} floor {:.2f}; {}{:.1f} s, with pairs {:.1f} s [{}]",
      o.of.name,
      o.right()   ? "right"
      : o.wrong() ? "WRONG"
                  : "missed",
      verdict::name(o.verdict), o.of.tolerance, o.base_held_out, o.right_held_out, o.wrong_held_out,
      o.best_wrong, o.base_test, o.added_test, o.of.floor,
      o.asked_again ? o.content ? "content; " : "NOT content; " : "", o.seconds, o.pairs_seconds,
      fmt::join(sets, " | "));
}

std::string confusion(const std::vector<Outcome>& outcomes) {
  struct Row {
    int all = 0, right = 0, wrong = 0, failed = 0;
    std::map<std::string, int> verdicts{};
  };
  std::map<std::string, Row> rows;
  std::vector<std::string> order;
  for (const Outcome& o : outcomes) {
    if (!rows.contains(o.of.kind)) order.push_back(o.of.kind);
    Row& row = rows[o.of.kind];
    ++row.all;
    if (!o.failure.empty()) {
      ++row.failed;
      continue;
    }
    row.right += o.right() ? 1 : 0;
    row.wrong += o.wrong() ? 1 : 0;
    std::string verdict(verdict::name(o.verdict));
    if (o.wrong()) verdict += fmt::format(" ({})", fmt::join(o.sets.front(), "+"));
    ++row.verdicts[verdict];
  }
  std::string text =
      fmt::format("{:<38} {:>5} {:>5} {:>5}  {}\n", "class", "cases", "right", "wrong", "verdicts");
  for (const std::string& kind : order) {
    const Row& row = rows[kind];
    std::vector<std::string> verdicts;
    for (const auto& [verdict, times] : row.verdicts)
      verdicts.push_back(fmt::format("{} {}", times, verdict));
    if (row.failed > 0) verdicts.push_back(fmt::format("{} failed", row.failed));
    text += fmt::format("{:<38} {:>5} {:>5} {:>5}  {}\n", kind, row.all, row.right, row.wrong,
                        fmt::join(verdicts, ", "));
  }
  return text;
}

}  // namespace correction_study
