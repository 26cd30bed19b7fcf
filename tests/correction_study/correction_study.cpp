// correction_study: machines with a known truth for the diagnosis of correction models.

#include <stdlib.h>  // mkdtemp

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "tests/correction_study/bars.h"
#include "tests/correction_study/judge.h"
#include "tests/correction_study/rig.h"

namespace {

using namespace correction_study;

struct Arguments {
  std::string folder, rigs;
  bool run = false;
  unsigned seeds = 3, first = 1, threads = 2;
  std::vector<std::string> only;

  [[nodiscard]] std::vector<Class> wished() const {
    std::vector<Class> found;
    for (const Class& c : classes())
      if (is_wished(c.id)) found.push_back(c);
    return found;
  }
  [[nodiscard]] bool is_wished(std::string_view id) const {
    return only.empty() || std::find(only.begin(), only.end(), id) != only.end();
  }
};

void declare(CLI::App& app, Arguments& a) {
  std::vector<std::string> ids;
  for (const Class& c : classes()) ids.emplace_back(c.id);
  const CLI::Range count(1U, 100000U);
  CLI::Option_group* const job = app.add_option_group("one of");
  job->add_option("--write", a.folder, "put each machine into a folder of its own below this one");
  job->add_flag("--run", a.run, "have them diagnosed");
  job->add_option("--rigs", a.rigs, "have those that lie in this folder diagnosed");
  job->require_option(1);
  app.add_option("--seeds", a.seeds, "machines of each class")->check(count)->capture_default_str();
  app.add_option("--first", a.first, "first seed")->check(count)->capture_default_str();
  app.add_option("--threads", a.threads, "threads that diagnose")
      ->check(count)
      ->capture_default_str();
  app.add_option("--only", a.only, "of these classes alone")
      ->delimiter(',')
      ->check(CLI::IsMember(ids));
}

void write(const Arguments& a) {
  for (const Class& c : a.wished())
    for (unsigned seed = a.first; seed < a.first + a.seeds; ++seed) {
      const Rig rig = make_rig(c, seed);
      write_rig(rig, a.folder);
      std::printf("%-40s tolerance %4.1f  base %6.2f %6.2f  right %5.2f %5.2f um\n",
                  rig.truth.id.c_str(), rig.truth.tolerance, rig.truth.base.train,
                  rig.truth.base.test, rig.truth.right.train, rig.truth.right.test);
      std::fflush(stdout);
    }
}

std::vector<Case> cases_in(const Arguments& a) {
  std::vector<Case> cases;
  for (const auto& entry : std::filesystem::directory_iterator(a.rigs)) {
    std::optional<Case> c = read_case(entry.path());
    if (c && a.is_wished(c->kind)) cases.push_back(std::move(*c));
  }
  std::sort(cases.begin(), cases.end(),
            [](const Case& x, const Case& y) { return x.name < y.name; });
  return cases;
}

void judge_rigs(const Arguments& a) {
  const std::vector<Outcome> outcomes = judge_all(cases_in(a), a.threads, [](const Outcome& o) {
    std::printf("%s\n", line(o).c_str());
    std::fflush(stdout);
  });
  std::printf("\n%s\n%s", confusion(outcomes).c_str(), table(bars(outcomes)).c_str());
}

/// A folder of its own, gone at the end.
class Scratch {
 public:
  Scratch() : path_((std::filesystem::temp_directory_path() / "correction_study.XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr)
      throw std::runtime_error("cannot make the folder " + path_);
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace

int main(int argc, char** argv) try {
  Arguments a;
  CLI::App app("Machines with a known truth for the diagnosis of correction models");
  declare(app, a);
  CLI11_PARSE(app, argc, argv)
  if (!a.folder.empty()) {
    write(a);
  } else if (!a.rigs.empty()) {
    judge_rigs(a);
  } else {
    const Scratch scratch;
    a.folder = a.rigs = scratch.path();
    write(a);
    judge_rigs(a);
  }
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "correction_study: %s\n", e.what());
  return 1;
}
