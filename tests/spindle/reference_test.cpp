#include "tests/spindle/reference.h"

#include <algorithm>

namespace raceway::spindle {
namespace {

bool exists(std::string_view name) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t)
      if (name == std::string(suite.name()) + "." + suite.GetTestInfo(t)->name()) return true;
  }
  return false;
}

TEST(References, EveryCaseIsHeldByATest) {
  for (const nlohmann::json& one : references()) {
    const std::string id = one.at("id");
    EXPECT_NE(kind_of(id), nullptr) << "spindle_reference.json: no test holds " << id;
  }
  for (const Kind& kind : kinds) {
    EXPECT_TRUE(exists(kind.test)) << kind.test;
    EXPECT_TRUE(std::any_of(references().begin(), references().end(),
                            [&](const nlohmann::json& one) {
                              return kind_of(one.at("id").get<std::string>()) == &kind;
                            }))
        << "no case " << kind.beginning;
  }
}

}  // namespace
}  // namespace raceway::spindle
