// spindle_study: spindles with a known truth for the diagnosis of spindle models.

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "tests/spindle_study/judge.h"
#include "tests/spindle_study/reference.h"
#include "tests/spindle_study/rig.h"

namespace {

using namespace spindle_study;

struct Arguments {
  std::string write, rigs, run, raceway = "raceway";
  bool check = false;
  unsigned seeds = 1, first = 1, threads = 1;
  std::vector<const Class*> wished;
};

void usage() {
  std::puts(
      "spindle_study --check\n"
      "spindle_study --write FOLDER [--seeds N] [--first SEED] [--only CLASS,CLASS] [--threads N]\n"
      "spindle_study --rigs FOLDER --raceway PROGRAM [--only CLASS,CLASS] [--threads N]\n"
      "spindle_study --run FOLDER --raceway PROGRAM [--seeds N] [--first SEED] [...]\n\n"
      "Spindles with a known truth for the diagnosis of spindle models: N of each class (default\n"
      "1). --check holds the simulator to data/reference/spindle_reference.json, --write puts "
      "each\n"
      "spindle into a folder of its own, --rigs has those in a folder diagnosed by the program,\n"
      "--run does both. Classes:\n");
  for (const Class& c : classes()) std::printf("  %s\n", std::string(c.id).c_str());
}

unsigned count(std::string_view word, const std::string& text) {
  unsigned n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc() || end != text.data() + text.size() || n < 1 || n > 100000)
    throw std::invalid_argument(std::string(word) + " " + text +
                                ": a whole number from 1 to 100000");
  return n;
}

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const auto value = [&]() -> std::string {
      if (i + 1 >= argc) throw std::invalid_argument(std::string(word) + " needs a value");
      return argv[++i];
    };
    if (word == "--write") {
      a.write = value();
    } else if (word == "--rigs") {
      a.rigs = value();
    } else if (word == "--run") {
      a.run = value();
    } else if (word == "--raceway") {
      a.raceway = value();
    } else if (word == "--check") {
      a.check = true;
    } else if (word == "--seeds") {
      a.seeds = count(word, value());
    } else if (word == "--first") {
      a.first = count(word, value());
    } else if (word == "--threads") {
      a.threads = count(word, value());
    } else if (word == "--only") {
      std::istringstream list(value());
      for (std::string id; std::getline(list, id, ',');) a.wished.push_back(&find_class(id));
    } else if (word == "--help" || word == "-h") {
      usage();
      std::exit(0);
    } else {
      throw std::invalid_argument("unknown option " + std::string(word) + "; see --help");
    }
  }
  if (int{!a.write.empty()} + int{!a.rigs.empty()} + int{!a.run.empty()} + int{a.check} != 1)
    throw std::invalid_argument("one of --check, --write, --rigs, --run; see --help");
  if (a.wished.empty())
    for (const Class& c : classes()) a.wished.push_back(&c);
  return a;
}

/// Names of what was written.
std::vector<std::string> write(const Arguments& a, const std::string& folder) {
  std::vector<std::pair<const Class*, unsigned>> wished;
  for (const Class* c : a.wished)
    for (unsigned seed = a.first; seed < a.first + a.seeds; ++seed) wished.emplace_back(c, seed);
  std::vector<std::string> names(wished.size());
  std::atomic<std::size_t> next = 0;
  std::mutex telling;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t k = next++; k < wished.size(); k = next++) try {
        const Rig rig = make_rig(*wished[k].first, wished[k].second);
        write_rig(rig, folder);
        const std::scoped_lock lock(telling);
        names[k] = rig.id;
        std::printf("%-26s %zu cells  size %9.3g  signal %6.2f\n", rig.id.c_str(), rig.cells,
                    rig.size, rig.signal);
        std::fflush(stdout);
      } catch (...) {
        const std::scoped_lock lock(telling);
        failure = std::current_exception();
        next = wished.size();
      }
  };
  std::vector<std::thread> workers;
  for (unsigned k = 0; k < a.threads; ++k) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
  if (failure) std::rethrow_exception(failure);
  return names;
}

void judge_rigs(const Arguments& a, const std::vector<Case>& cases) {
  const std::vector<Outcome> outcomes =
      judge_all(cases, a.raceway, a.threads, [](const Outcome& o) {
        std::printf("%s\n", line(o).c_str());
        std::fflush(stdout);
      });
  std::printf("\n%s", table(outcomes).c_str());
}

/// Writes and judges what it wrote; what else lies in the folder stays.
void run(const Arguments& a) {
  const std::vector<std::string> names = write(a, a.run);
  std::vector<Case> cases = cases_in(a.run, a.wished);
  std::erase_if(cases, [&](const Case& c) {
    return std::find(names.begin(), names.end(), c.name) == names.end();
  });
  judge_rigs(a, cases);
}

}  // namespace

int main(int argc, char** argv) try {
  const Arguments a = parse(argc, argv);
  if (a.check) {
    bool good = true;
    for (const std::vector<Compared>& figures : {steady_states(), start_ups()})
      for (const Compared& f : figures) {
        std::printf("%s\n", line(f).c_str());
        good = good && f.good();
      }
    return good ? 0 : 2;
  }
  if (!a.write.empty()) {
    write(a, a.write);
  } else if (!a.rigs.empty()) {
    judge_rigs(a, cases_in(a.rigs, a.wished));
  } else {
    run(a);
  }
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "spindle_study: %s\n", e.what());
  return 1;
}
