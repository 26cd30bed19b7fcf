#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>

#include "tests/cli/run_program.h"
#include "tests/fuzz/readers.h"
#include "tests/places.h"

namespace raceway::fuzz {
namespace {

namespace fs = std::filesystem;

class Corpus : public testing::TestWithParam<Reader> {};

/// What was found once: each input is read or refused with a message, and soon.
TEST_P(Corpus, IsReadOrRefused) {
  int inputs = 0;
  for (const auto& entry : fs::directory_iterator(
           fs::path(tests::source_dir() + "/tests/fuzz/corpus") / GetParam().name)) {
    const auto before = std::chrono::steady_clock::now();
    EXPECT_NO_THROW(GetParam().read(tests::file_text(entry.path()))) << entry.path();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - before;
    EXPECT_LT(time.count(), 10.0) << entry.path();
    ++inputs;
  }
  EXPECT_GT(inputs, 0);
}

INSTANTIATE_TEST_SUITE_P(EveryReader, Corpus, testing::ValuesIn(readers().begin(), readers().end()),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace raceway::fuzz
