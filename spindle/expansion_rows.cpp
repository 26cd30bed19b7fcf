#include "spindle/expansion_rows.h"

#include <map>

namespace raceway::spindle {

Vector expansion_row(const Mesh& mesh, Body body, double from, double to, Eigen::Index nodes) {
  Vector row = Vector::Zero(nodes);
  const double sign = to < from ? -1.0 : 1.0;
  if (to < from) std::swap(from, to);
  std::map<int, double> stiffness;  // E A of a column
  const auto within = [&](const Cell& c) {
    const double middle = 0.5 * (c.start + c.end);
    return c.body == body && middle > from && middle < to;
  };
  for (const Cell& c : mesh.cells)
    if (within(c)) stiffness[c.column] += c.material.elastic_modulus * c.section();
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    const Cell& c = mesh.cells[k];
    if (!within(c)) continue;
    row[static_cast<Eigen::Index>(k)] = sign * c.length() * c.material.thermal_expansion *
                                        c.material.elastic_modulus * c.section() /
                                        stiffness[c.column];
  }
  return row;
}

}  // namespace raceway::spindle
