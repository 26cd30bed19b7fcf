#include "correction/band.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "correction/alignment.h"
#include "correction/simulation.h"
#include "files/correction_file.h"
#include "files/series_file.h"
#include "loop/loop.h"
#include "tests/correction_study/rig.h"

namespace correction_study {
namespace {

namespace correction = raceway::correction;
namespace fit = raceway::fit;
namespace loop = raceway::loop;
namespace verdict = raceway::verdict;
namespace files = raceway::files;

/// How often the truth lies within a band.
struct Coverage {
  std::size_t rows = 0, within = 0;
  double width = 0.0;             ///< sum of half widths [m]
  std::size_t within_zeroed = 0;  ///< one constant of the record taken off

  [[nodiscard]] double share(std::size_t of) const {
    return static_cast<double>(of) / static_cast<double>(rows);
  }
};

struct Judged {
  Coverage in_range, beyond;

  void add(bool is_beyond, double error, double mean, double half_width) {
    Coverage& c = is_beyond ? beyond : in_range;
    ++c.rows;
    c.width += half_width;
    if (std::abs(error) <= half_width) ++c.within;
    if (std::abs(error - mean) <= half_width) ++c.within_zeroed;
  }
};

/// The band of the right class, from the first record, against the clean displacement of another
/// profile of the same machine.
void judge(const Rig& rig, const std::filesystem::path& folder, Judged& all) {
  write_rig(rig, folder);
  const std::filesystem::path path = folder / rig.truth.id;
  const bool own = std::filesystem::exists(path / "model.toml");
  const correction::Model start =
      files::read_correction((path / (own ? "model.toml" : "correction.toml")).string())
          .models.front();
  const auto open = [&](const char* name) {
    return files::read_series((path / name).string(), {start.displacement},
                              correction::inputs_of(start));
  };
  const raceway::record::Record train = open("train.csv"), test = open("test.csv");
  const correction::CorrectionSubject base(start);
  const correction::Model model = correction::trusted(
      rig.truth.hidden.empty() ? loop::calibrate(base, train)
                               : loop::add(base, rig.truth.hidden, train).calibration,
      train);
  const auto subject = correction::aligned(model, test, correction::Zero::none);
  const auto series = std::make_shared<const correction::Series>(test);
  const correction::Beyond beyond = correction::beyond_range(model, *series);
  const std::vector<double> half =
      correction::band_of(*subject, model, series, beyond).half_width();
  std::vector<double> error = fit::predict(*subject, test);
  double mean = 0.0;
  for (std::size_t k = 0; k < error.size(); ++k) {
    error[k] -= rig.truth.clean_test[k] * raceway::um;
    mean += error[k] / static_cast<double>(error.size());
  }
  for (std::size_t k = 0; k < error.size(); ++k) all.add(beyond.at_row[k], error[k], mean, half[k]);
}

/// Fifteen machines of a generator of another kind than the models. Errors of one record go
/// together, so that few machines decide.
TEST(Band, HoldsTheTruthOfAnotherProfile) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "band_study";
  Judged all;
  for (const char* const id : {"nothing-missing", "ambient-drift", "motor-heat",
                               "kinematic-displacement", "motor-heat+ambient-drift"})
    for (unsigned seed = 910; seed < 913; ++seed)
      judge(make_rig(find_class(id), seed), folder, all);
  std::filesystem::remove_all(folder);
  const Coverage &in = all.in_range, &out = all.beyond;
  const std::string figures = fmt::format(
      "in range {:.3f}, zeroed {:.3f}, +- {:.2f} um of {}; beyond {:.3f}, {:.3f}, +- {:.2f} um of "
      "{}",
      in.share(in.within), in.share(in.within_zeroed),
      1e6 * in.width / static_cast<double>(in.rows), in.rows, out.share(out.within),
      out.share(out.within_zeroed), 1e6 * out.width / static_cast<double>(out.rows), out.rows);
  RecordProperty("coverage", figures);
  EXPECT_GE(in.share(in.within), 0.90) << figures;
  EXPECT_LE(in.share(in.within), 0.98) << figures;
  EXPECT_GE(in.share(in.within_zeroed), 0.93) << figures;
  EXPECT_GE(out.share(out.within), 0.95) << figures;
  EXPECT_GT(out.width / static_cast<double>(out.rows), in.width / static_cast<double>(in.rows))
      << figures;
}

}  // namespace
}  // namespace correction_study
