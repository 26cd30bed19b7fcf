// study: how often the diagnosis is right, against the bars it is held to. See docs/study.md.

#include <fmt/core.h>
#include <glog/logging.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/hidden_effect/bars.h"

namespace {

using namespace hidden_effect;

struct Arguments {
  int seeds = 20, first = 0;
  std::vector<std::string> blocks;
  std::string only, write;
  bool json = false, by_effect = false, misses = false, oracle = false;
  int threads = 0;  // all
};

void declare(CLI::App& app, Arguments& a) {
  std::vector<std::string> ids;
  std::string list = "Blocks:";
  for (const Block& b : blocks()) {
    ids.emplace_back(b.id);
    list += fmt::format("\n  {:<11} {}", b.id, b.what);
  }
  app.footer(list);
  const CLI::Range count(1, 100000);
  app.add_option("--seeds", a.seeds, "of each case")->check(count)->capture_default_str();
  app.add_option("--first", a.first, "first seed; rules were chosen with the seeds from 0 on")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  app.add_option("--blocks", a.blocks, "by comma; default: all")
      ->delimiter(',')
      ->check(CLI::IsMember(ids));
  app.add_option("--only", a.only,
                 "the plans, or kinds of the block real, with this text in their name");
  app.add_option("--threads", a.threads, "default: all")->check(count);
  app.add_flag("--json", a.json, "bars as JSON");
  app.add_flag("--by-effect", a.by_effect, "what each hidden effect was taken for");
  app.add_flag("--misses", a.misses, "the sentence of each verdict that is not right");
  app.add_flag("--oracle", a.oracle, "also judge each record with its true noise and base law");
  app.add_option(
      "--write", a.write,
      "diagnose nothing: model.toml, train.csv and truth.json of each rig into a folder of its own "
      "below this one");
}

/// A bar on a terminal, nothing elsewhere.
class Progress {
 public:
  explicit Progress(std::size_t all) : all_(all), shown_(isatty(STDERR_FILENO) != 0) {}
  ~Progress() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void operator()(std::size_t done) {
    const auto now = std::chrono::steady_clock::now();
    if (!shown_ || (done < all_ && now - last_ < std::chrono::milliseconds(100))) return;
    last_ = now;
    const double share = static_cast<double>(done) / static_cast<double>(all_);
    const double gone = std::chrono::duration<double>(now - start_).count();
    const auto filled = static_cast<std::size_t>(40.0 * share);
    std::fprintf(stderr, "\r\033[K[%s%s] %zu of %zu, %.0f s left", std::string(filled, '=').c_str(),
                 std::string(40 - filled, ' ').c_str(), done, all_, gone / share - gone);
    std::fflush(stderr);
  }

 private:
  std::size_t all_;
  bool shown_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), last_{};
};

std::string number(double value, int digits = 1) {
  if (std::isnan(value)) return "-";
  if (std::abs(value) > 1e200) return "";
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.*f", digits, value);
  return buffer;
}

int digits_of(const Bar& bar) { return bar.unit == "%" && !std::isnan(bar.interval.lower) ? 1 : 3; }

void print_table(const std::vector<Bar>& table) {
  std::printf("%-4s %-56s %9s %9s %9s  %-15s %6s\n", "bar", "", "must", "good", "measured",
              "95 % interval", "cases");
  for (const Bar& b : table) {
    if (b.trials == 0) continue;
    const std::string sign = b.at_least ? ">= " : "<= ";
    const auto limit = [&](double v) {
      std::string text = number(v, v == std::floor(v) ? 0 : 2);
      return text.empty() ? text : sign + text;
    };
    const bool is_share = !std::isnan(b.interval.lower);
    const std::string interval =
        is_share ? number(b.interval.lower) + " to " + number(b.interval.upper) : "";
    std::printf("%-4s %-56s %9s %9s %9s  %-15s %6d %s\n", b.number.c_str(), b.what.c_str(),
                limit(b.must).c_str(), limit(b.good).c_str(),
                (number(b.measured, digits_of(b)) + (is_share ? "" : " " + b.unit)).c_str(),
                interval.c_str(), b.trials,
                b.missed()    ? "!"
                : b.is_good() ? "+"
                              : "");
  }
  std::puts("\nShares in %. !: misses what it must reach. +: reaches what is called good.");
}

std::string share_text(int count, int cases) {
  const Interval w = wilson(count, cases);
  return fmt::format("{:5.1f} ({:.1f} to {:.1f})", 100.0 * count / cases, 100.0 * w.lower,
                     100.0 * w.upper);
}

/// The shares of the diagnosis beside those of the oracle, the honest bar.
void print_carried(const std::vector<Carried>& table) {
  std::printf("\n%-40s %-34s %6s  %-22s %-22s %-12s %s\n", "what the data can carry", "", "cases",
              "diagnosis", "oracle", "oracle alone", "wrong names of both");
  for (const Carried& c : table)
    std::printf("%-40s %-34s %6d  %-22s %-22s %-12d %d, %d\n", c.kind.c_str(), c.what.c_str(),
                c.cases, share_text(c.diagnosis, c.cases).c_str(),
                share_text(c.oracle, c.cases).c_str(), c.oracle - c.both, c.diagnosis_wrong,
                c.oracle_wrong);
}

std::string oracle_text(const OracleAnswer& o) {
  return fmt::format(
      "oracle {}: gain {:.1f} (needed {:.1f}), lead {:.1f} over {}, least loss {:.1f}",
      o.decides()    ? "decides"
      : o.includes() ? "includes the truth"
                     : "misses",
      o.gain, o.needed, o.lead, o.rival, o.least_loss);
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& w : words) out += (out.empty() ? "" : " | ") + w;
  return out;
}

/// What each hidden effect was taken for.
void print_by_effect(const std::vector<Outcome>& outcomes) {
  std::map<std::string, std::map<std::string, int>> answers;
  std::map<std::string, std::vector<double>> det, sep, error;
  for (const Outcome& o : outcomes) {
    std::string key(o.trial.block);
    for (const Wish& w : o.trial.setup.hidden) key += " " + std::string(w.id);
    if (!o.trial.kind.empty()) key += " [" + std::string(o.trial.kind) + "]";
    if (o.trial.setup.hidden.empty()) key += " " + std::string(name(o.trial.setup.noise));
    ++answers[key][o.answer.verdict + " " + joined(o.answer.names) + o.answer.message +
                   (o.changed_by.empty() ? "" : " [changed by " + o.changed_by + "]")];
    if (o.improvement.converged) error[key].push_back(100.0 * o.improvement.validation);
    det[key].push_back(o.visibility.detection);
    sep[key].push_back(o.visibility.separation);
  }
  for (const auto& [key, counts] : answers) {
    const auto range = [](const std::vector<double>& v) {
      return number(*std::min_element(v.begin(), v.end()), 0) + " to " +
             number(*std::max_element(v.begin(), v.end()), 0);
    };
    std::printf("\n%s (lambda_det %s, lambda_sep %s)\n", key.c_str(), range(det[key]).c_str(),
                range(sep[key]).c_str());
    if (!error[key].empty())
      std::printf("  validation error after adding: %.2f %% at most\n",
                  *std::max_element(error[key].begin(), error[key].end()));
    std::vector<std::pair<int, std::string>> sorted;
    for (const auto& [answer, n] : counts) sorted.emplace_back(n, answer);
    std::sort(sorted.rbegin(), sorted.rend());
    for (const auto& [n, answer] : sorted) std::printf("  %4d  %s\n", n, answer.c_str());
  }
  std::puts("");
}

/// The sentence of every verdict that is neither exact nor a rightly named set.
void print_misses(const std::vector<Outcome>& outcomes) {
  for (const Outcome& o : outcomes) {
    const bool right = o.trial.setup.hidden.empty() && o.accepted.empty()
                           ? o.is({"nothing-missing"})
                           : (o.outside ? o.is({"not-in-catalogue"}) : o.in_set());
    const bool undecided = !o.after_proposed.empty() && !o.right_after_proposed;
    if ((right && !undecided) || o.too_small) continue;
    std::printf("\n%s %s", std::string(o.trial.block).c_str(), std::string(o.trial.kind).c_str());
    for (const Wish& w : o.trial.setup.hidden) std::printf(" %s", std::string(w.id).c_str());
    std::printf(" (seed %llu, lambda_det %s, lambda_sep %s): %s\n  %s\n",
                static_cast<unsigned long long>(o.trial.setup.seed),
                number(o.visibility.detection).c_str(), number(o.visibility.separation).c_str(),
                o.answer.verdict.c_str(), o.answer.sentence.c_str());
    if (o.oracle) std::printf("  %s\n", oracle_text(*o.oracle).c_str());
    if (undecided) std::printf("  with the proposed points: %s\n", o.after_proposed.c_str());
    if (undecided && o.oracle_after_proposed)
      std::printf("  %s\n", oracle_text(*o.oracle_after_proposed).c_str());
  }
  std::puts("");
}

/// The files of each rig, in folders that are named by kind and number.
void write(const std::vector<Trial>& all, const std::string& folder) {
  std::map<std::string, int> numbers;
  for (const Trial& t : all) {
    std::string kind(t.kind.empty() ? t.block : t.kind);
    std::replace_if(
        kind.begin(), kind.end(), [](char c) { return c == ' ' || c == ',' || c == '%'; }, '_');
    const std::filesystem::path own =
        std::filesystem::path(folder) / (kind + "-" + std::to_string(numbers[kind]++));
    std::filesystem::create_directories(own);
    const Rig rig = make_rig(t.setup);
    std::ofstream(own / "model.toml") << model_text(rig);
    std::ofstream(own / "train.csv") << measurement_text(rig, rig.train);
    std::ofstream(own / "truth.json") << truth_text(rig);
  }
}

void print_json(const std::vector<Bar>& table, const std::vector<Carried>& by_oracle,
                const Arguments& arguments, std::size_t rigs) {
  nlohmann::ordered_json bars = nlohmann::ordered_json::array();
  // An interval or a limit that a bar lacks is not finite, and null in JSON.
  const auto value = [](double v) {
    return std::abs(v) < 1e200 ? nlohmann::ordered_json(v) : nlohmann::ordered_json();
  };
  for (const Bar& b : table)
    if (b.trials > 0)
      bars.push_back({{"bar", b.number},
                      {"what", b.what},
                      {"sense", b.at_least ? ">=" : "<="},
                      {"must", value(b.must)},
                      {"good", value(b.good)},
                      {"measured", value(b.measured)},
                      {"lower", value(b.interval.lower)},
                      {"upper", value(b.interval.upper)},
                      {"unit", b.unit},
                      {"cases", b.trials},
                      {"missed", b.missed()}});
  nlohmann::ordered_json document = {{"seeds", arguments.seeds},
                                     {"first", arguments.first},
                                     {"rigs", rigs},
                                     {"bars", std::move(bars)}};
  for (const Carried& c : by_oracle)
    document["carried"].push_back({{"kind", c.kind},
                                   {"what", c.what},
                                   {"diagnosis", c.diagnosis},
                                   {"oracle", c.oracle},
                                   {"both", c.both},
                                   {"diagnosis_wrong", c.diagnosis_wrong},
                                   {"oracle_wrong", c.oracle_wrong},
                                   {"cases", c.cases}});
  std::puts(document.dump(1).c_str());
}

}  // namespace

int main(int argc, char** argv) try {
  FLAGS_minloglevel = google::GLOG_FATAL;  // Ceres logs trial points without balance as errors
  Arguments arguments;
  CLI::App app(
      "Hides effects in measurements of a generator of its own, has them diagnosed and holds what "
      "comes out against the bars");
  declare(app, arguments);
  CLI11_PARSE(app, argc, argv)
  if (arguments.blocks.empty())
    for (const Block& b : blocks()) arguments.blocks.emplace_back(b.id);
  std::unique_ptr<tbb::global_control> limit;
  if (arguments.threads > 0)
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(arguments.threads));
  std::vector<Trial> all;
  for (const std::string& id : arguments.blocks)
    for (const Trial& t : trials(id, arguments.seeds, arguments.first, arguments.only)) {
      const std::string_view called = t.kind.empty() ? name(t.setup.plan) : t.kind;
      if (called.find(arguments.only) != called.npos) all.push_back(t);
    }
  for (Trial& t : all) t.oracle = arguments.oracle;
  if (!arguments.write.empty()) {
    write(all, arguments.write);
    return 0;
  }
  std::vector<Outcome> outcomes;
  {
    Progress progress(all.size());
    outcomes = judge_all(all, [&](std::size_t done) { progress(done); });
  }
  const std::vector<Bar> table = bars(outcomes);
  const auto small =
      std::count_if(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return o.too_small; });
  if (small > 0)
    std::fprintf(stderr,
                 "%td of %zu rigs left out: no size that leaves a torque gives half the effect\n",
                 small, outcomes.size());
  if (arguments.json) {
    print_json(table, carried(outcomes), arguments, all.size());
  } else {
    if (arguments.by_effect) print_by_effect(outcomes);
    if (arguments.misses) print_misses(outcomes);
    print_table(table);
    if (arguments.oracle) print_carried(carried(outcomes));
  }
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "study: %s\n", e.what());
  return 1;
}
