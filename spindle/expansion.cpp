#include "spindle/expansion.h"

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace raceway::spindle {

double free_elongation(std::span<const HeatedLength> lengths) {
  double sum = 0.0;
  for (const HeatedLength& h : lengths) sum += h.thermal_expansion * h.rise * h.length;
  return sum;
}

void displace_by_substitute_forces(std::span<const HeatedLength> lengths, std::span<double> nodes) {
  if (nodes.size() != lengths.size() + 1)
    throw std::invalid_argument("nodes: the number of nodes must be the number of lengths + 1");
  // Each length is a spring E A / l between its nodes; its forces pull both outwards.
  const std::size_t n = lengths.size();
  std::vector<double> force(n + 1, 0.0), diagonal(n + 1, 0.0), below(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const HeatedLength& h = lengths[i];
    const double substitute = h.elastic_modulus * h.area * h.thermal_expansion * h.rise;
    const double stiffness = h.elastic_modulus * h.area / h.length;
    force[i] -= substitute;
    force[i + 1] += substitute;
    diagonal[i] += stiffness;
    diagonal[i + 1] += stiffness;
    below[i + 1] = -stiffness;
  }
  nodes[0] = 0.0;
  // Tridiagonal elimination from the free right end, the left node held.
  for (std::size_t i = n; i > 1; --i) {
    const double share = below[i] / diagonal[i];
    diagonal[i - 1] -= share * below[i];
    force[i - 1] -= share * force[i];
  }
  for (std::size_t i = 1; i <= n; ++i)
    nodes[i] = (force[i] - below[i] * nodes[i - 1]) / diagonal[i];
}

double force_if_held(std::span<const HeatedLength> lengths) {
  double compliance = 0.0;
  for (const HeatedLength& h : lengths) compliance += h.length / (h.elastic_modulus * h.area);
  return -free_elongation(lengths) / compliance;
}

}  // namespace raceway::spindle
