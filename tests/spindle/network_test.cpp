// Bodies and conductances against closed forms over time.
#include <gtest/gtest.h>

#include <cmath>

#include "spindle/mesh.h"
#include "spindle/spindle.h"
#include "tests/spindle/base_spindle.h"
#include "tests/spindle/reference_cases.h"

namespace raceway::spindle {
namespace {

model::Model network_of(const ReferenceCase& c) {
  model::Model m = base_spindle();
  model::Network net;
  for (std::size_t k = 0; k < c.inputs["C_J_K"].size(); ++k)
    net.nodes.push_back({.name = "node " + std::to_string(k),
                         .capacity = c.inputs["C_J_K"][k],
                         .heat = c.inputs["heat_W"][k]});
  for (const auto& link : c.inputs["links"])
    net.links.push_back({.from = link[0], .to = link[1], .conductance = link[2]});
  for (const auto& fixed : c.inputs["fixed"]) {
    net.links.push_back({.from = fixed[0], .to = net.nodes.size(), .conductance = fixed[2]});
    net.nodes.push_back({.name = "held", .temperature = kelvin(fixed[1].get<double>())});
  }
  m.spindle->network = net;
  m.spindle->ambient.temperature = kelvin(c.in("T0_C"));
  return m;
}

TEST(Network, IsThatOfTheMatrixExponential) {
  for (const ReferenceCase& c : reference_cases("network_")) {
    model::Model m = network_of(c);
    m.spindle->step = 0.5;
    Simulator simulator(m);
    Report report;
    const Moment steady = simulator.steady({}, report);
    ASSERT_TRUE(report.converged());
    for (std::size_t k = 0; k < c.outputs["steady"].size(); ++k)
      EXPECT_NEAR(celsius(steady.sensors[k]), c.outputs["steady"][k].get<double>(),
                  c.tolerance * c.outputs["steady"][k].get<double>());
    std::vector<ProfileRow> profile;
    for (const auto& t : c.inputs["t_s"]) profile.push_back({.time = t.get<double>()});
    const auto run = simulator.simulate(profile);
    ASSERT_TRUE(run.report.converged());
    for (std::size_t row = 0; row < profile.size(); ++row)
      for (std::size_t k = 0; k < c.outputs["steady"].size(); ++k) {
        const double wanted = c.outputs["transient"][row][k];
        EXPECT_NEAR(celsius(run.moments[row].sensors[k]), wanted, c.tolerance * wanted) << row << k;
      }
  }
}

TEST(Network, ErrorsFallWithTheSquareOfTheStep) {
  const ReferenceCase c = reference_case("network_five_nodes");
  const auto end_of = [&](double step) {
    model::Model m = network_of(c);
    m.spindle->step = step;
    std::vector<double> ends;
    for (double t = step; t < 640.0 + 1e-9; t += step) ends.push_back(t);
    const std::vector<ProfileRow> profile{{.time = 640.0}};
    return Simulator(m).simulate(profile, nullptr, ends).moments.back().sensors[4];
  };
  const double exact = (4.0 * end_of(0.25) - end_of(0.5)) / 3.0;
  const double order = std::log2((end_of(8.0) - exact) / (end_of(4.0) - exact));
  EXPECT_GT(order, 1.98);
  EXPECT_LT(order, 2.02);
}

/// A network in place of the base spindle's cells, all of it at 20 °C at first.
Simulator simulator_of(model::Network network, double step) {
  model::Model m = base_spindle();
  m.spindle->network = std::move(network);
  m.spindle->step = step;
  return Simulator(m);
}

constexpr double rest = kelvin(20);

TEST(Network, OfOneBodyIsTheClosedForm) {
  for (const ReferenceCase& c : reference_cases("lumped_")) {
    model::Network one;
    one.nodes = {{.name = "body", .capacity = c.in("mass_kg") * c.in("c"), .heat = c.in("heat_W")},
                 {.name = "room", .temperature = rest}};
    one.links = {{.from = 0, .to = 1, .conductance = c.in("h") * c.in("area_m2")}};
    // An error of 1e-8 asks for steps of less than a thousandth of the time constant.
    Simulator simulator = simulator_of(one, 2e-4 * c.out("tau_s"));
    const std::vector<ProfileRow> profile{{.time = c.in("t_s")}};
    const auto run = simulator.simulate(profile);
    ASSERT_TRUE(run.report.converged());
    const double rise = run.moments[0].sensors[0] - rest;
    c.holds("rise_K", rise);
    Report report;
    const double final_rise = simulator.steady({}, report).sensors[0] - rest;
    ASSERT_TRUE(report.converged());
    c.holds("tau_s", -c.in("t_s") / std::log1p(-rise / final_rise));
  }
}

TEST(Network, OfCellsWarmsAsAHalfSpace) {
  for (const ReferenceCase& c : reference_cases("semi_infinite_")) {
    // So long that its end feels nothing: 4.5 lengths of diffusion.
    const double reach = std::sqrt(4.0 * c.in("lam") / c.in("rho_c") * c.in("t_s"));
    const int cells = static_cast<int>(std::ceil(4.5 * reach / mm));
    Region bar;
    bar.start = 0.0, bar.end = cells * mm, bar.inner_radius = 0.0, bar.outer_radius = 10 * mm;
    bar.material.conductivity = c.in("lam");
    bar.material.heat_capacity = c.in("rho_c") / bar.material.density;
    const Mesh mesh = make_mesh(std::vector{bar}, 1 * mm, 1.0);
    model::Network network;
    for (const Cell& cell : mesh.cells)
      network.nodes.push_back({.name = {}, .capacity = cell.heat_capacity()});
    for (const Touch& t : mesh.touches)
      network.links.push_back({.from = static_cast<std::size_t>(t.first),
                               .to = static_cast<std::size_t>(t.second),
                               .conductance = conductance_of(t)});
    for (const OpenFace& face : mesh.open)
      if (face.side == OpenFace::Side::front)
        network.links.push_back({.from = static_cast<std::size_t>(face.cell),
                                 .to = mesh.size(),
                                 .conductance = 1.0 / face.half});
    network.nodes.push_back({.name = "surface", .temperature = rest + 1.0});
    const std::vector<ProfileRow> profile{{.time = c.in("t_s")}};
    const auto run = simulator_of(network, 1.0).simulate(profile);
    ASSERT_TRUE(run.report.converged());
    const std::vector<double> places = numbers(c.inputs.at("x_m"));
    for (std::size_t k = 0; k < places.size(); ++k) {
      // Linear between the middles of two cells.
      const double at = places[k] / mm - 0.5;
      const auto before = static_cast<std::size_t>(std::floor(at + 1e-9));
      const double share = at - static_cast<double>(before);
      const double rise = (1.0 - share) * run.moments[0].sensors[before] +
                          share * run.moments[0].sensors[before + 1] - rest;
      const double wanted = c.outputs.at("T")[k];
      EXPECT_NEAR(rise, wanted, c.tolerance * wanted) << c.id << ", " << places[k];
    }
  }
}

}  // namespace
}  // namespace raceway::spindle
