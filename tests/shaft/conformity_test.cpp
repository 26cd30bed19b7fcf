#include "shaft/conformity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/reference_table.h"

namespace raceway::shaft {
namespace {

using fit::FitStatus;
using record::Bound;

bearing::Bearing sample(double conformity) {
  return {{.ball_count = 20,
           .ball_diameter = 11.906 * mm,
           .pitch_diameter = 90 * mm,
           .contact_angle = 25 * degree,
           .inner_conformity = conformity,
           .outer_conformity = conformity},
          bearing::steel(),
          bearing::steel()};
}

std::vector<PairRigidity> rigidities(double conformity) {
  std::vector<PairRigidity> classes;
  for (const auto& [name, preload] : {std::pair{"L", 240.0}, {"M", 700.0}, {"S", 1400.0}})
    classes.push_back({.preload_class = name,
                       .preload = preload,
                       .printed = pair_rigidity(sample(conformity), preload)});
  return classes;
}

TEST(Conformity, IsFoundFromTheRigiditiesThatItMakes) {
  for (const double truth : {0.51, 0.52, 0.535, 0.55}) {
    // The bearing's own conformity plays no part.
    const ConformityFit fit = fit_conformity(sample(0.53), rigidities(truth));
    ASSERT_EQ(fit.status, FitStatus::converged);
    EXPECT_NEAR(fit.conformity, truth, 1e-6);
    EXPECT_LT(fit.std, 1e-5);
    EXPECT_EQ(fit.at_bound, Bound::none);
    for (const PairRigidity& c : fit.classes) EXPECT_NEAR(c.deviation(), 0.0, 1e-5);
  }
}

TEST(Conformity, StandardErrorIsThatOfTheClassesAboutTheirMean) {
  auto classes = rigidities(0.52);
  classes[0].printed *= 1.02;
  classes[2].printed /= 1.02;
  const ConformityFit fit = fit_conformity(sample(0.52), classes);
  // One unknown, three values: the scatter of ln R over its slope, by a difference made here.
  const double slope =
      std::log(rigidities(0.521)[1].printed / rigidities(0.519)[1].printed) / 0.002;
  EXPECT_NEAR(fit.std, std::log(1.02) / std::sqrt(3.0) / std::abs(slope), 0.05 * fit.std);
  EXPECT_NEAR(fit.conformity, 0.52, 0.3 * fit.std);
}

TEST(Conformity, StopsAtItsBoundsAndSaysSo) {
  auto classes = rigidities(0.52);
  for (PairRigidity& c : classes) c.printed *= 2.0;
  const ConformityFit stiff = fit_conformity(sample(0.52), classes);
  EXPECT_EQ(stiff.at_bound, Bound::lower);
  EXPECT_EQ(stiff.conformity, lowest_conformity);
  EXPECT_TRUE(std::isnan(stiff.std));
  for (PairRigidity& c : classes) c.printed /= 8.0;
  EXPECT_EQ(fit_conformity(sample(0.52), classes).at_bound, Bound::upper);
}

TEST(Conformity, OfOneClassHasNoStandardError) {
  auto classes = rigidities(0.53);
  classes.resize(1);
  const ConformityFit fit = fit_conformity(sample(0.52), classes);
  EXPECT_NEAR(fit.conformity, 0.53, 1e-6);
  EXPECT_TRUE(std::isnan(fit.std));
}

TEST(Conformity, RefusesClassesWithoutValues) {
  EXPECT_THROW((void)fit_conformity(sample(0.52), {}), std::invalid_argument);
  auto classes = rigidities(0.52);
  classes[1].preload = 0.0;
  EXPECT_THROW((void)fit_conformity(sample(0.52), classes), std::invalid_argument);
  classes = rigidities(0.52);
  classes[1].printed = unset;
  EXPECT_THROW((void)fit_conformity(sample(0.52), classes), std::invalid_argument);
}

// The maker's printed values of every second bearing: each its own conformity.
TEST(Conformity, OfCatalogueRowsIsPlausibleAndReproducesTheirRigidities) {
  std::map<std::string, std::vector<double>> by_series;
  int rows = 0, within = 0, inside = 0;
  for (const auto& row : tests::reference_table("gmn_axial_rigidity.csv")) {
    if (++rows % 2 == 0) continue;
    const bearing::Bearing bearing{{.ball_count = static_cast<int>(row["ball_count"]),
                                    .ball_diameter = row["ball_diameter_mm"] * mm,
                                    .pitch_diameter = row["pitch_diameter_mm"] * mm,
                                    .contact_angle = row["contact_angle_deg"] * degree,
                                    .inner_conformity = 0.52,
                                    .outer_conformity = 0.52},
                                   bearing::steel(),
                                   bearing::steel()};
    std::vector<PairRigidity> classes;
    for (const std::string name : {"L", "M", "S"})
      classes.push_back({.preload_class = name,
                         .preload = row["preload_" + name + "_N"],
                         .printed = row["axial_rigidity_pair_" + name + "_N_per_um"] * N_per_um});
    const ConformityFit fit = fit_conformity(bearing, classes);
    ASSERT_EQ(fit.status, FitStatus::converged);
    for (const PairRigidity& c : fit.classes) within += std::abs(c.deviation()) <= 0.05 ? 1 : 0;
    inside += fit.at_bound == Bound::none ? 1 : 0;
    const std::string& designation = row.text("designation");
    by_series[designation.substr(0, designation.find(' '))].push_back(fit.conformity);
  }
  const int fitted = (rows + 1) / 2;
  std::printf("%d of %d classes within 5 %%, %d of %d rows inside the bounds\n", within, 3 * fitted,
              inside, fitted);
  const auto median = [&](const std::string& series) {
    std::vector<double>& all = by_series.at(series);
    std::sort(all.begin(), all.end());
    std::printf("%s: %.4f .. %.4f .. %.4f\n", series.c_str(), all.front(), all[all.size() / 2],
                all.back());
    return all[all.size() / 2];
  };
  EXPECT_GE(within, 0.95 * 3 * fitted);
  EXPECT_GE(inside, 0.95 * fitted);
  EXPECT_NEAR(median("S"), 0.52, 0.006);
  EXPECT_NEAR(median("SM"), 0.535, 0.006);
  EXPECT_NEAR(median("KH"), 0.54, 0.006);
}

}  // namespace
}  // namespace raceway::shaft
