// spindle_study: spindles with a known truth for the diagnosis of spindle models.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/spindle_study/judge.h"
#include "tests/spindle_study/reference.h"
#include "tests/spindle_study/rig.h"
#include "tests/spindle_study/simulator.h"

namespace {

using namespace spindle_study;

struct Arguments {
  std::string write, rigs, run, raceway = "raceway";
  bool check = false;
  unsigned seeds = 1, first = 1, threads = 1;
  std::vector<std::string> only;

  [[nodiscard]] std::vector<const Class*> wished() const {
    std::vector<const Class*> found;
    for (const Class& c : classes())
      if (only.empty() || std::find(only.begin(), only.end(), c.id) != only.end())
        found.push_back(&c);
    return found;
  }
};

void declare(CLI::App& app, Arguments& a) {
  std::vector<std::string> ids;
  for (const Class& c : classes()) ids.emplace_back(c.id);
  const CLI::Range count(1U, 100000U);
  CLI::Option_group* const job = app.add_option_group("one of");
  job->add_flag("--check", a.check, "hold the simulator to data/reference/spindle_reference.json");
  job->add_option("--write", a.write, "put each spindle into a folder of its own below this one");
  job->add_option("--rigs", a.rigs, "have those in this folder diagnosed");
  job->add_option("--run", a.run, "write them into this folder and have them diagnosed");
  job->require_option(1);
  app.add_option("--raceway", a.raceway, "program that diagnoses")->capture_default_str();
  app.add_option("--seeds", a.seeds, "spindles of each class")->check(count)->capture_default_str();
  app.add_option("--first", a.first, "first seed")->check(count)->capture_default_str();
  app.add_option("--threads", a.threads, "threads")->check(count)->capture_default_str();
  app.add_option("--only", a.only, "of these classes alone")
      ->delimiter(',')
      ->check(CLI::IsMember(ids));
}

/// Names of what was written. A drawn spindle that runs away is left out and counted.
std::vector<std::string> write(const Arguments& a, const std::string& folder) {
  std::vector<std::pair<const Class*, unsigned>> wished;
  for (const Class* c : a.wished())
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
      } catch (const Runaway& e) {
        const std::scoped_lock lock(telling);
        std::printf("%s-%u left out: %s\n", std::string(wished[k].first->id).c_str(),
                    wished[k].second, e.what());
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
  std::erase(names, "");
  if (names.size() < wished.size())
    std::printf("%zu of %zu spindles left out\n", wished.size() - names.size(), wished.size());
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
  std::vector<Case> cases = cases_in(a.run, a.wished());
  std::erase_if(cases, [&](const Case& c) {
    return std::find(names.begin(), names.end(), c.name) == names.end();
  });
  judge_rigs(a, cases);
}

}  // namespace

int main(int argc, char** argv) try {
  Arguments a;
  CLI::App app("Spindles with a known truth for the diagnosis of spindle models");
  declare(app, a);
  CLI11_PARSE(app, argc, argv)
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
    judge_rigs(a, cases_in(a.rigs, a.wished()));
  } else {
    run(a);
  }
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "spindle_study: %s\n", e.what());
  return 1;
}
