// The cells against closed forms of heat conduction.
#include "spindle/mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "spindle/conductance_solver.h"
#include "tests/spindle/reference_cases.h"

namespace raceway::spindle {
namespace {

model::SolidMaterial solid(double conductivity, double density_heat_capacity = 3.6e6) {
  model::SolidMaterial m = model::steel_of_shafts;
  m.conductivity = conductivity;
  m.density = density_heat_capacity / m.heat_capacity;
  return m;
}

Region region(double length, double inner, double outer, const model::SolidMaterial& material) {
  Region r;
  r.start = 0.0, r.end = length, r.inner_radius = inner, r.outer_radius = outer;
  r.material = material;
  return r;
}

HeatPaths paths_in(const Mesh& mesh) {
  HeatPaths p;
  p.capacity.resize(static_cast<Eigen::Index>(mesh.size()));
  for (std::size_t k = 0; k < mesh.size(); ++k)
    p.capacity[static_cast<Eigen::Index>(k)] = mesh.cells[k].heat_capacity();
  p.source.setZero(p.capacity.size());
  for (const Touch& t : mesh.touches) p.links.push_back({t.first, t.second, conductance_of(t)});
  p.temperature = {1.0, 0.0, 0.0};  // one reservoir at 1, one at 0
  return p;
}

void hold(HeatPaths& p, const OpenFace& face, Reservoir reservoir, double film = 0.0) {
  const double resistance = face.half + (film > 0.0 ? 1.0 / (film * face.area) : 0.0);
  p.outlets.push_back({face.cell, reservoir, 1.0 / resistance});
}

Vector settled(const HeatPaths& p) {
  ConductanceSolver solver(p);
  EXPECT_TRUE(solver.factorise(p, 0.0));
  return solver.solve(p.constant_inflow());
}

void heat_evenly(const Mesh& mesh, HeatPaths& p, double per_volume) {
  for (std::size_t k = 0; k < mesh.size(); ++k)
    p.source[static_cast<Eigen::Index>(k)] =
        per_volume * mesh.cells[k].section() * mesh.cells[k].length();
}

using FaceSide = OpenFace::Side;

TEST(Cells, ABarHeatedWithinExpandsAsItsClosedForm) {
  for (const ReferenceCase& c : reference_cases("bar_heat")) {
    const Mesh mesh = make_mesh(std::vector{region(c.in("L_m"), 0.0, 0.01, solid(c.in("lam")))},
                                c.in("L_m") / 60.0, 1.0);
    HeatPaths p = paths_in(mesh);
    heat_evenly(mesh, p, c.in("q_W_m3"));
    for (const OpenFace& f : mesh.open)
      if (!f.radial()) hold(p, f, Reservoir::machine);
    const Vector t = settled(p);
    c.holds("dT_max_K", t.maxCoeff());
    double elongation = 0.0;
    for (std::size_t k = 0; k < mesh.size(); ++k)
      elongation += c.in("alpha") * t[static_cast<Eigen::Index>(k)] * mesh.cells[k].length();
    c.holds("elongation_um", elongation / um);
  }
}

TEST(Cells, APinIsTheFinOfItsClosedForm) {
  for (const ReferenceCase& c : reference_cases("pin_fin")) {
    const double d = c.in("d_m"), length = c.in("L_m");
    const Mesh mesh = make_mesh(std::vector{region(length, 0.0, 0.5 * d, solid(c.in("lam")))},
                                length / 200.0, 1.0);
    HeatPaths p = paths_in(mesh);
    for (const OpenFace& f : mesh.open) {
      if (f.side == FaceSide::front) hold(p, f, Reservoir::air);  // the base, at 1
      // A fin is of one temperature across: no resistance within it.
      if (f.side == FaceSide::outer)
        p.outlets.push_back({f.cell, Reservoir::machine, c.in("h") * f.area});
    }
    const Vector t = settled(p);
    c.holds("tip", t[t.size() - 1]);
    c.holds("base_W_K", -p.outflow(t)[0]);
  }
}

TEST(Cells, AnAnnulusResistsAsItsLogarithm) {
  for (const ReferenceCase& c : reference_cases("annulus")) {
    const Mesh mesh = make_mesh(
        std::vector{region(c.in("width"), c.in("r_in"), c.in("r_out"), solid(c.in("lam")))}, 1.0,
        0.004);
    HeatPaths p = paths_in(mesh);
    for (const OpenFace& f : mesh.open) {
      if (f.side == FaceSide::inner) hold(p, f, Reservoir::air);
      if (f.side == FaceSide::outer) hold(p, f, Reservoir::machine);
    }
    c.holds("R_K_W", -1.0 / p.outflow(settled(p))[0]);
  }
}

TEST(Cells, AHollowCylinderHeatedWithinIsAsHotAsItsClosedForm) {
  for (const ReferenceCase& c : reference_cases("hollow_cylinder_")) {
    const double r_in = c.in("r_in"), r_out = c.in("r_out");
    const Mesh mesh = make_mesh(std::vector{region(0.1, r_in, r_out, solid(c.in("lam")))}, 1.0,
                                (r_out - r_in) / 20.0);
    HeatPaths p = paths_in(mesh);
    heat_evenly(mesh, p, c.in("q_W_m3"));
    for (const OpenFace& f : mesh.open)
      if (f.side == FaceSide::outer) hold(p, f, Reservoir::machine, c.in("h_out"));
    c.holds("T_in_above_ambient_K", settled(p)[0]);
  }
}

TEST(Cells, AFiniteCylinderIsTheBesselSeries) {
  for (const ReferenceCase& c : reference_cases("finite_cylinder_")) {
    const double radius = c.in("radius"), height = c.in("height");
    const Mesh mesh = make_mesh(std::vector{region(height, 0.0, radius, solid(46.0))},
                                height / 64.0, radius / 40.0);
    HeatPaths p = paths_in(mesh);
    for (const OpenFace& f : mesh.open)
      hold(p, f, f.side == FaceSide::front ? Reservoir::air : Reservoir::machine);
    const Vector t = settled(p);
    const auto at = [&](double z, double r) {
      // Bilinear between the middles of cells.
      double sum = 0.0, weight = 0.0;
      const double dz = height / 64.0, dr = radius / 40.0;
      for (std::size_t k = 0; k < mesh.size(); ++k) {
        const Cell& cell = mesh.cells[k];
        const double wz = 1.0 - std::abs(0.5 * (cell.start + cell.end) - z) / dz;
        const double wr = 1.0 - std::abs(cell.middle_radius() - r) / dr;
        if (wz <= 0.0 || wr <= 0.0) continue;
        sum += wz * wr * t[static_cast<Eigen::Index>(k)];
        weight += wz * wr;
      }
      return sum / weight;
    };
    c.holds("T_axis_z20", at(0.02, 0.0));
    c.holds("T_axis_z40", at(0.04, 0.0));
    c.holds("T_r25_z20", at(0.02, 0.025));
  }
}

}  // namespace
}  // namespace raceway::spindle
