// correction_study: machines with a known truth for the diagnosis of correction models.

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "tests/correction_study/rig.h"

namespace {

using namespace correction_study;

struct Arguments {
  std::string folder;
  unsigned seeds = 3, first = 1;
  std::vector<Class> wished;
};

void usage() {
  std::puts(
      "correction_study --write FOLDER [--seeds N] [--first SEED] [--only CLASS,CLASS]\n\n"
      "Machines with a known truth for the diagnosis of correction models: N of each class\n"
      "(default 3), each in a folder of its own. Classes:\n");
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
  if (a.folder.empty()) throw std::invalid_argument("--write FOLDER is missing; see --help");
  if (a.wished.empty()) a.wished.assign(classes().begin(), classes().end());
  return a;
}

}  // namespace

int main(int argc, char** argv) try {
  const Arguments a = parse(argc, argv);
  for (const Class& c : a.wished)
    for (unsigned seed = a.first; seed < a.first + a.seeds; ++seed) {
      const Rig rig = make_rig(c, seed);
      write_rig(rig, a.folder);
      std::printf("%-40s tolerance %4.1f  base %6.2f %6.2f  right %5.2f %5.2f um\n",
                  rig.truth.id.c_str(), rig.truth.tolerance, rig.truth.base.train,
                  rig.truth.base.test, rig.truth.right.train, rig.truth.right.test);
      std::fflush(stdout);
    }
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "correction_study: %s\n", e.what());
  return 1;
}
