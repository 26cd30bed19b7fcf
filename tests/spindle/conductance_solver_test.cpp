#include "spindle/conductance_solver.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "record/units.h"

namespace raceway::spindle {
namespace {

/// A strip of bodies, three wide, with one body that touches a third of all others, as a coolant.
HeatPaths strip(int length) {
  HeatPaths p;
  const int n = 3 * length + 1;
  p.capacity = Vector::LinSpaced(n, 5.0, 50.0);
  p.source.setZero(n);
  for (int k = 0; k + 1 < n; ++k) {
    if (k % 3 != 2) p.links.push_back({k, k + 1, 1.0 + 0.1 * (k % 7)});
    if (k + 3 < n - 1) p.links.push_back({k + 3, k, 2.0 + 0.3 * (k % 5)});
    if (k % 3 == 0) p.links.push_back({n - 1, k, 0.2});
  }
  p.links.push_back({0, 1, 0.7});  // two ways between the same bodies
  p.outlets = {{n - 1, Reservoir::coolant, 3.0}, {4, Reservoir::air, 0.1}};
  return p;
}

Matrix dense(const HeatPaths& p, double capacity_factor) {
  Matrix a = (capacity_factor * p.capacity).asDiagonal();
  for (const HeatPaths::Link& way : p.links) {
    a(way.first, way.first) += way.conductance;
    a(way.second, way.second) += way.conductance;
    a(way.first, way.second) -= way.conductance;
    a(way.second, way.first) -= way.conductance;
  }
  for (const HeatPaths::Outlet& way : p.outlets) a(way.node, way.node) += way.conductance;
  return a;
}

TEST(ConductanceSolver, AgreesWithADenseSolution) {
  HeatPaths p = strip(20);
  ConductanceSolver solver(p);
  for (const double capacity_factor : {0.0, 1e-3, 10.0}) {
    for (HeatPaths::Link& way : p.links) way.conductance *= 1.3;
    ASSERT_TRUE(solver.factorise(p, capacity_factor));
    const Vector right = Vector::LinSpaced(p.size(), -1.0, 3.0);
    const Vector expected = dense(p, capacity_factor).partialPivLu().solve(right);
    EXPECT_LT((solver.solve(right) - expected).norm(), 1e-12 * expected.norm());
  }
}

TEST(ConductanceSolver, FirstHalvesGiveWhatFewBodiesFeelOfEachOther) {
  HeatPaths p = strip(20);
  ConductanceSolver solver(p);
  Matrix of = Matrix::Zero(p.size(), 3);
  of(7, 0) = 1.0;
  of(41, 1) = 0.3;
  of(42, 1) = 0.7;
  of.col(2).setLinSpaced(-1.0, 3.0);
  for (const double capacity_factor : {0.0, 1e-3, 10.0}) {
    ASSERT_TRUE(solver.factorise(p, capacity_factor));
    const Matrix first = solver.first_half(solver.in_order(of));
    const Matrix found = first.transpose() * solver.inverse().asDiagonal() * first;
    const Matrix solved = dense(p, capacity_factor).partialPivLu().solve(of);
    EXPECT_LT((found - of.transpose() * solved).norm(), 1e-12 * found.norm());
    for (int k = 0; k < 3; ++k)
      EXPECT_LT((solver.second_half(first.col(k)) - solved.col(k)).norm(),
                1e-12 * solved.col(k).norm());
  }
}

TEST(ConductanceSolver, RefusesHeatWithoutAWayOut) {
  HeatPaths p = strip(5);
  p.outlets.clear();
  p.links.clear();
  ConductanceSolver solver(p);
  EXPECT_FALSE(solver.factorise(p, 0.0));
  EXPECT_TRUE(solver.factorise(p, 1.0));
  p.capacity[3] = unset;
  EXPECT_FALSE(solver.factorise(p, 1.0));
}

}  // namespace
}  // namespace raceway::spindle
