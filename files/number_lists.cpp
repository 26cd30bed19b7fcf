#include <algorithm>
#include <cmath>

#include "algebra/detail/decompositions.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/number_lists.h"

namespace raceway::files {
namespace {

Eigen::MatrixXd correlation(const Section& s, std::size_t count) {
  constexpr double rounding = 1e-9;  // of the digits that are written
  const toml::node& node = required_node(s, "correlation");
  const toml::array* const rows = node.as_array();
  if (!rows || rows->size() != count) fail_count(s, "correlation", node, count);
  const auto size = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd matrix(size, size);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<double> row = numbers(s, "correlation", *rows->get(i), i + 1);
    for (std::size_t j = 0; j <= i; ++j) {
      if (i == j ? row[j] != 1.0 : std::abs(row[j]) > 1.0)
        throw text::InputError(
            fmt::format("{}: correlation = {}: {}", s.place(rows->get(i)), row[j],
                        i == j
                            ? "each row must end with 1, the correlation of a parameter with itself"
                            : "must be from -1 to 1"),
            s.at("correlation", rows->get(i)));
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          matrix(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) = row[j];
    }
  }
  const double least = algebra::symmetric_eigen(matrix).values.minCoeff();
  if (least < -rounding)
    s.fail("correlation",
           fmt::format("correlation: the matrix is not positive semidefinite (smallest eigenvalue "
                       "{:.2g}), so it is not a valid correlation",
                       least));
  return matrix;
}

}  // namespace

const toml::node& required_node(const Section& s, std::string_view key) {
  const toml::node* const node = s.find(key);
  if (!node) s.fail(key, fmt::format("[{}] {} is missing", s.name(), key));
  return *node;
}

void fail_count(const Section& s, std::string_view key, const toml::node& node, std::size_t count) {
  throw text::InputError(fmt::format("{}: {} = {}: must be a list of length {}", s.place(&node),
                                     key, text::shown(node), count),
                         s.at(key, &node));
}

std::vector<double> numbers(const Section& s, std::string_view key, const toml::node& node,
                            std::size_t count) {
  const toml::array* const list = node.as_array();
  if (!list || list->size() != count) fail_count(s, key, node, count);
  std::vector<double> result;
  for (const toml::node& entry : *list) {
    const auto value = entry.value<double>();
    if (!value || !std::isfinite(*value))
      throw text::InputError(
          fmt::format("{}: {} = {}: must be a number", s.place(&entry), key, text::shown(entry)),
          s.at(key, &entry));
    result.push_back(*value);
  }
  return result;
}

Eigen::MatrixXd covariance_of(const Section& s, std::size_t count) {
  const std::vector<double> std = numbers(s, "std", required_node(s, "std"), count);
  if (std::any_of(std.begin(), std.end(), [](double v) { return v < 0.0; }))
    s.fail("std", "std: all standard deviations must be 0 or more");
  const auto scale =
      Eigen::Map<const Eigen::VectorXd>(std.data(), static_cast<Eigen::Index>(count));
  return scale.asDiagonal() * correlation(s, count) * scale.asDiagonal();
}

}  // namespace raceway::files
