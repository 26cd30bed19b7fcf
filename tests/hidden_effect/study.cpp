// study: how often the diagnosis is right, against the bars it is held to. See docs/study.md.

#include <glog/logging.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/hidden_effect/bars.h"

namespace {

using namespace hidden_effect;

struct Arguments {
  int seeds = 20;
  std::vector<std::string> blocks;
  std::string only, write;
  bool json = false, by_effect = false, misses = false;
  int threads = 0;  // all
};

void usage() {
  std::puts(
      "study [--seeds N] [--blocks LIST] [--json] [--by-effect] [--misses] [--threads N]\n"
      "      [--only TEXT] [--write FOLDER]\n\n"
      "Hides effects in measurements of a generator of its own, has them diagnosed and holds what\n"
      "comes out against the bars. N seeds for each case (default 20). Of the block real only "
      "kinds with TEXT in\n"
      "their name. With --write nothing is asked: model.toml, train.csv and truth.json of each "
      "rig\n"
      "go to a folder of its own, for another version of the program. Blocks, by comma:\n");
  for (const Block& b : blocks())
    std::printf("  %-11s %s\n", std::string(b.id).c_str(), std::string(b.what).c_str());
}

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const auto value = [&]() -> std::string {
      if (i + 1 >= argc) throw std::invalid_argument(std::string(word) + " needs a value");
      return argv[++i];
    };
    const auto count = [&]() {
      const std::string text = value();
      char* end = nullptr;
      const long n = std::strtol(text.c_str(), &end, 10);
      if (*end != '\0' || n < 1 || n > 100000)
        throw std::invalid_argument(std::string(word) + " " + text + ": a whole number from 1 on");
      return static_cast<int>(n);
    };
    if (word == "--seeds") {
      a.seeds = count();
    } else if (word == "--threads") {
      a.threads = count();
    } else if (word == "--only") {
      a.only = value();
    } else if (word == "--write") {
      a.write = value();
    } else if (word == "--json") {
      a.json = true;
    } else if (word == "--by-effect") {
      a.by_effect = true;
    } else if (word == "--misses") {
      a.misses = true;
    } else if (word == "--blocks") {
      std::istringstream list(value());
      for (std::string id; std::getline(list, id, ',');) {
        if (std::none_of(blocks().begin(), blocks().end(),
                         [&](const Block& b) { return b.id == id; }))
          throw std::invalid_argument("no block \"" + id + "\"; see study --help");
        a.blocks.push_back(id);
      }
    } else if (word == "--help" || word == "-h") {
      usage();
      std::exit(0);
    } else {
      throw std::invalid_argument("unknown option " + std::string(word));
    }
  }
  if (a.blocks.empty())
    for (const Block& b : blocks()) a.blocks.emplace_back(b.id);
  return a;
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
    if (undecided) std::printf("  with the proposed points: %s\n", o.after_proposed.c_str());
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

void print_json(const std::vector<Bar>& table, const Arguments& arguments, std::size_t rigs) {
  const auto value = [](double v) {
    return std::isnan(v) || std::abs(v) > 1e200 ? std::string("null") : number(v, 6);
  };
  std::printf("{\"seeds\": %d, \"rigs\": %zu, \"bars\": [", arguments.seeds, rigs);
  const char* separator = "\n";
  for (const Bar& b : table) {
    if (b.trials == 0) continue;
    std::printf(
        "%s  {\"bar\": \"%s\", \"what\": \"%s\", \"sense\": \"%s\", \"must\": %s, \"good\": %s, "
        "\"measured\": %s, \"lower\": %s, \"upper\": %s, \"unit\": \"%s\", \"cases\": %d, "
        "\"missed\": %s}",
        separator, b.number.c_str(), b.what.c_str(),
        b.at_least ? ">=" : "<=", value(b.must).c_str(), value(b.good).c_str(),
        value(b.measured).c_str(), value(b.interval.lower).c_str(), value(b.interval.upper).c_str(),
        b.unit.c_str(), b.trials, b.missed() ? "true" : "false");
    separator = ",\n";
  }
  std::puts("\n]}");
}

}  // namespace

int main(int argc, char** argv) try {
  FLAGS_minloglevel = google::GLOG_FATAL;  // Ceres logs trial points without balance as errors
  const Arguments arguments = parse(argc, argv);
  std::unique_ptr<tbb::global_control> limit;
  if (arguments.threads > 0)
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(arguments.threads));
  std::vector<Trial> all;
  for (const std::string& id : arguments.blocks)
    for (const Trial& t : trials(id, arguments.seeds))
      if (arguments.only.empty() || t.kind.find(arguments.only) != t.kind.npos) all.push_back(t);
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
    print_json(table, arguments, all.size());
  } else {
    if (arguments.by_effect) print_by_effect(outcomes);
    if (arguments.misses) print_misses(outcomes);
    print_table(table);
  }
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "study: %s\n", e.what());
  return 1;
}
