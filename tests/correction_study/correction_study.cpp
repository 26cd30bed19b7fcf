// correction_study: machines with a known truth for the diagnosis of correction models.

#include <stdlib.h>  // mkdtemp

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <optional>
#include <sstream>
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
  bool run = false, all = false;
  unsigned seeds = 3, first = 1, threads = 2;
  std::vector<Class> wished;
};

void usage() {
  std::puts(
      "correction_study --write FOLDER [--seeds N] [--first SEED] [--only CLASS,CLASS]\n"
      "correction_study --run [--seeds N] [--first SEED] [--only CLASS,CLASS] [--threads N]\n"
      "correction_study --rigs FOLDER [--only CLASS,CLASS] [--threads N]\n\n"
      "Machines with a known truth for the diagnosis of correction models: N of each class\n"
      "(default 3). --write puts each into a folder of its own, --run has them diagnosed, --rigs\n"
      "those that lie in a folder. Classes:\n");
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
      a.folder = value();
    } else if (word == "--run") {
      a.run = true;
    } else if (word == "--rigs") {
      a.rigs = value();
    } else if (word == "--threads") {
      a.threads = count(word, value());
    } else if (word == "--seeds") {
      a.seeds = count(word, value());
    } else if (word == "--first") {
      a.first = count(word, value());
    } else if (word == "--only") {
      std::istringstream list(value());
      for (std::string id; std::getline(list, id, ',');) a.wished.push_back(find_class(id));
    } else if (word == "--help" || word == "-h") {
      usage();
      std::exit(0);
    } else {
      throw std::invalid_argument("unknown option " + std::string(word) + "; see --help");
    }
  }
  if (int{!a.folder.empty()} + int{!a.rigs.empty()} + int{a.run} != 1)
    throw std::invalid_argument("one of --write FOLDER, --run, --rigs FOLDER; see --help");
  if (a.wished.empty()) {
    a.wished.assign(classes().begin(), classes().end());
    a.all = true;
  }
  return a;
}

void write(const Arguments& a) {
  for (const Class& c : a.wished)
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
    const auto is_its = [&](const Class& wished) { return wished.id == c->kind; };
    if (c && (a.all || std::any_of(a.wished.begin(), a.wished.end(), is_its)))
      cases.push_back(std::move(*c));
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
  Arguments a = parse(argc, argv);
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
