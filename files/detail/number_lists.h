#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_section.h"

/// Reads lists of numbers in a table of a model file. All functions throw InputError with file and
/// line.
namespace raceway::files {

/// Keys of a table with the covariance of fitted parameters.
inline constexpr Key covariance_keys[]{
    {"parameters", a_list, is_required, "names of the fitted parameters, as in [calibration] free"},
    {"units", a_list, is_required, "unit of each parameter, as calibrate prints it"},
    {"values", a_list, is_required, "values of the parameters in the model, to 9 digits"},
    {"std", a_list, is_required, "standard errors"},
    {"correlation", a_list, is_required,
     "correlation of the parameters: lower triangle, row by row; each row ends with 1"},
};

/// Returns the value of a required key.
[[nodiscard]] const toml::node& required_node(const Section& s, std::string_view key);

[[noreturn]] void fail_count(const Section& s, std::string_view key, const toml::node& node,
                             std::size_t count);

/// Reads a list of `count` finite numbers.
[[nodiscard]] std::vector<double> numbers(const Section& s, std::string_view key,
                                          const toml::node& node, std::size_t count);

/// Returns the covariance matrix of `count` parameters from their standard errors `std` and the
/// lower triangle `correlation`, whose diagonal is 1.
[[nodiscard]] Eigen::MatrixXd covariance_of(const Section& s, std::size_t count);

}  // namespace raceway::files
