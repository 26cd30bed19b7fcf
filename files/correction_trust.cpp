#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correction/numbers.h"
#include "correction/trust.h"
#include "files/detail/displacement_keys.h"
#include "record/digits.h"
#include "record/series_channel.h"
#include "text/number_text.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/correction_trust.h"
#include "files/detail/number_lists.h"

namespace raceway::files {
namespace {

constexpr Key correction_together_keys[]{
    {"columns", a_list, is_required,
     "inputs that varied in the record of the fit; identify, calibrate and add write this table"},
    {"mean", a_list, is_required, "mean of each input"},
    {"std", a_list, is_required, "standard deviation of each input"},
    {"correlation", a_list, is_required, "correlation of the inputs: lower triangle, row by row"},
    {"farthest", between(0, 1e9), is_required,
     "largest Mahalanobis distance of a row of the training data from the mean of the inputs"},
};
constexpr Key correction_residual_keys[]{
    {"rms_um", between(0, 1e9, "um"), is_required,
     "RMS residual on held-out parts of the record, or on all readings if no part was held out"},
    {"correlation_time_s", between(0, 1e12, "s"), unset, "correlation time of the residual"},
};

constexpr Key correction_trust_keys[]{
    {"error_um", between(0, 1e9, "um"), unset,
     "RMS error on held-out readings; missing if no readings were held out. The commands identify, "
     "calibrate and add write this table, and export rates the trust in the correction with it"},
    {"uncorrected_um", between(0, 1e9, "um"), is_required,
     "RMS of the displacement without correction, after the mean of each run is subtracted"},
    {"duration_s", between(0, 1e12, "s"), is_required,
     "duration of the readings in the longest run"},
    {"course", one_of("returns|one-way"), is_required,
     "course of the readings; one-way: they change once, in one direction, such as in a warm-up "
     "without cool-down; returns: any other course"},
    {"judged_by", one_of("held-out|other-record"), is_required,
     "source of the held-out readings: parts of the record, or another record (identify "
     "--validate)"},
};

using correction::Model;
using record::Channel;

std::vector<std::string> quoted_words(const Section& s, std::string_view key) {
  const toml::node& node = required_node(s, key);
  const toml::array* const list = node.as_array();
  std::vector<std::string> result;
  if (list)
    for (const toml::node& one : *list)
      if (const auto word = one.value<std::string>()) result.push_back(*word);
  if (!list || result.size() != list->size())
    s.fail(key, fmt::format("{} = {}: must be a list of names in quotes", key, text::shown(node)));
  return result;
}

Eigen::VectorXd numbers_of(const Section& s, std::string_view key, std::size_t count) {
  const std::vector<double> list = numbers(s, key, required_node(s, key), count);
  return Eigen::Map<const Eigen::VectorXd>(list.data(), static_cast<Eigen::Index>(count));
}

correction::SeenTogether read_together(const Section& s) {
  correction::SeenTogether seen;
  for (const std::string& name : quoted_words(s, "columns")) {
    const Channel* const c = record::series_channel(name);
    if (!c || !c->is_input())
      s.fail("columns", fmt::format("columns: {} cannot be an input of a correction", name));
    seen.columns.push_back(c);
  }
  const std::size_t count = seen.columns.size();
  seen.mean = numbers_of(s, "mean", count);
  seen.std = numbers_of(s, "std", count);
  if (count == 0 || !(seen.std.minCoeff() > 0.0)) s.fail("std", "std: all values must be above 0");
  // covariance_of() checks the correlation.
  const Eigen::VectorXd scale = seen.std.cwiseInverse();
  seen.correlation = scale.asDiagonal() * covariance_of(s, count) * scale.asDiagonal();
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    seen.mean[at] = seen.columns[k]->to_SI(seen.mean[at]);
    seen.std[at] *= seen.columns[k]->factor;
  }
  seen.farthest = s.required("farthest");
  return seen;
}

/// Why the covariance is not that of the model; empty where it is.
std::string other_numbers(const fit::Covariance& c, const std::vector<std::string>& units,
                          const Model& model) {
  constexpr double same = 1e-9;
  const std::vector<record::Parameter> known = correction::parameters(model);
  for (std::size_t k = 0; k < c.names.size(); ++k) {
    const auto p = std::find_if(known.begin(), known.end(),
                                [&](const auto& one) { return one.name == c.names[k]; });
    if (p == known.end() || p->unit != units[k])
      return fmt::format("the model has no parameter {} with the unit {}", c.names[k], units[k]);
    const double value = c.values[static_cast<Eigen::Index>(k)];
    if (!(std::abs(p->value - value) <= same * std::max(std::abs(p->value), std::abs(value))))
      return fmt::format(
          "the model has {0} = {1:.6g}, but the covariance was calculated for {0} = {2:.6g}",
          p->name, p->value, value);
  }
  return {};
}

void read_correction_covariance(const Section& s, Model& m, std::vector<std::string>& notes) {
  fit::Covariance c;
  c.names = quoted_words(s, "parameters");
  const std::size_t count = c.names.size();
  const std::vector<std::string> units = quoted_words(s, "units");
  if (units.size() != count) fail_count(s, "units", required_node(s, "units"), count);
  c.values = numbers_of(s, "values", count);
  c.matrix = covariance_of(s, count);
  if (const std::string why = other_numbers(c, units, m); !why.empty()) {
    notes.push_back(
        fmt::format("{}: [correction.covariance] is not used: {}. Results have no error band; "
                    "identify, calibrate or add calculate a new covariance",
                    m.displacement->name, why));
    m.left.reset();
    m.evidence.reset();
    return;
  }
  m.covariance = std::move(c);
}

correction::Left read_left(const Section& s, const Model& m) {
  correction::Left left{.rms = s.required(correction::in_unit_of(m, "rms_um")) * um};
  s.take("correlation_time_s", left.correlation_time);
  return left;
}

correction::Evidence read_evidence(const Section& s, const Model& m) {
  const auto word = [&](std::string_view key) {
    if (auto value = s.choice(key)) return *value;
    s.fail_missing(key);
  };
  correction::Evidence e{
      .uncorrected = s.required(correction::in_unit_of(m, "uncorrected_um")) * um,
      .duration = s.required("duration_s"),
      .one_way = word("course") == "one-way",
      .other_record = word("judged_by") == "other-record"};
  s.take(correction::in_unit_of(m, "error_um"), e.error, um);
  return e;
}

/// To six digits, away from the middle, so that the record itself stays within.
double outward(double value, bool up) {
  const double near = record::with_digits(value, 6);
  if (value == 0.0 || (up ? near >= value : near <= value)) return near;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5);
  return record::with_digits(near + (up ? unit : -unit), 6);
}

std::string range_text(const Model& m) {
  std::string text = "[correction.range]  # range of the inputs in the training data\n";
  for (const correction::SeenRange& r : m.range) {
    const auto shown_to = [&](double v, bool up) {
      return text::toml_float(outward(r.column ? r.column->in_unit(v) : v, up));
    };
    const std::string key = r.column ? r.name : fmt::format("\"{} power_W\"", r.name);
    text += fmt::format("{} = [{}, {}]\n", key, shown_to(r.lower, false), shown_to(r.upper, true));
  }
  return text;
}

std::string still_text(const Model& m) {
  std::string text;
  for (const correction::SeenRange& r : m.range)
    if (std::isfinite(r.still))
      text += fmt::format("{} = {}\n", r.name, text::toml_float(record::with_digits(r.still, 6)));
  if (text.empty()) return text;
  return "[correction.still_s]  # longest time without a change of each temperature in the "
         "training data\n" +
         text;
}

std::string list_of(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words) quoted.push_back(fmt::format("\"{}\"", word));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

std::string list_of(const Eigen::VectorXd& numbers, int digits) {
  std::vector<std::string> list;
  for (const double v : numbers) list.push_back(text::toml_float(record::with_digits(v, digits)));
  return fmt::format("[{}]", fmt::join(list, ", "));
}

template <typename At>
std::string triangle(Eigen::Index size, int digits, const At& at) {
  std::string text = "correlation = [\n";
  for (Eigen::Index k = 0; k < size; ++k) {
    Eigen::VectorXd row(k + 1);
    for (Eigen::Index j = 0; j <= k; ++j) row[j] = at(k, j);
    text += fmt::format("  {},\n", list_of(row, digits));
  }
  return text + "]\n";
}

std::string together_text(const correction::SeenTogether& seen) {
  std::vector<std::string> names;
  Eigen::VectorXd mean = seen.mean, std = seen.std;
  for (std::size_t k = 0; k < seen.columns.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    names.emplace_back(seen.columns[k]->name);
    mean[at] = seen.columns[k]->in_unit(mean[at]);
    std[at] /= seen.columns[k]->factor;
  }
  constexpr int digits = 8;
  return fmt::format(
             "[correction.together]  # statistics of all inputs together in the training data\n"
             "columns = {}\n"
             "mean = {}\n"
             "std = {}\n",
             list_of(names), list_of(mean, digits), list_of(std, digits)) +
         triangle(seen.correlation.rows(), digits,
                  [&](Eigen::Index k, Eigen::Index j) { return seen.correlation(k, j); }) +
         fmt::format("farthest = {}\n", text::toml_float(outward(seen.farthest, true)));
}

std::string covariance_text(const Model& m) {
  const fit::Covariance& c = *m.covariance;
  const std::vector<record::Parameter> known = correction::parameters(m);
  std::vector<std::string> units;
  Eigen::VectorXd std(c.values.size());
  for (std::size_t k = 0; k < c.names.size(); ++k) {
    std[static_cast<Eigen::Index>(k)] = c.std(k);
    for (const record::Parameter& p : known)
      if (p.name == c.names[k]) units.push_back(p.unit);
  }
  std::string text = fmt::format(
      "[correction.covariance]  # covariance of the fitted parameters, for the error band of "
      "correct\n"
      "parameters = {}\n"
      "units = {}\n"
      "values = {}\n"
      "std = {}\n",
      list_of(c.names), list_of(units), list_of(c.values, 15), list_of(std, 6));
  text += triangle(c.values.size(), 15, [&](Eigen::Index k, Eigen::Index j) {
    return c.correlation(static_cast<std::size_t>(k), static_cast<std::size_t>(j));
  });
  return text;
}

std::string left_text(const Model& m) {
  const correction::Left& left = *m.left;
  std::string text = fmt::format(
      "[correction.residual]  # residual of the model, on held-out parts if there are any\n"
      "{} = {}\n",
      correction::in_unit_of(m, "rms_um"), text::toml_float(record::with_digits(left.rms / um, 6)));
  if (std::isfinite(left.correlation_time))
    text += fmt::format("correlation_time_s = {}\n",
                        text::toml_float(record::with_digits(left.correlation_time, 6)));
  return text;
}

std::string evidence_text(const Model& m) {
  const correction::Evidence& e = *m.evidence;
  const auto number = [](double value) { return text::toml_float(record::with_digits(value, 6)); };
  std::string text =
      fmt::format("[correction.trust]  # {}\n", correction::line_of(correction::trust_of(m)));
  if (std::isfinite(e.error))
    text += fmt::format("{} = {}\n", correction::in_unit_of(m, "error_um"), number(e.error / um));
  return text + fmt::format(
                    "{} = {}\nduration_s = {}\ncourse = \"{}\"\n"
                    "judged_by = \"{}\"\n",
                    correction::in_unit_of(m, "uncorrected_um"), number(e.uncorrected / um),
                    number(e.duration), e.one_way ? "one-way" : "returns",
                    e.other_record ? "other-record" : "held-out");
}

}  // namespace

std::vector<KeyTable> trust_tables() {
  return {{"correction.together", correction_together_keys},
          {"correction.covariance", covariance_keys},
          {"correction.residual", correction_residual_keys},
          {"correction.trust", correction_trust_keys}};
}

void read_trust(const Section& correction, Model& model, std::vector<std::string>& notes) {
  const auto part = [&](const char* key, std::span<const Key> keys) -> std::optional<Section> {
    const toml::node* const node = correction.find(key);
    if (!node) return std::nullopt;
    if (!node->is_table())
      correction.fail(key, fmt::format("{} = {}: must be a table, written as [correction.{}]", key,
                                       text::shown(*node), key));
    return Section(correction.source(), fmt::format("correction.{}", key), node->as_table(),
                   {keys_of(model.displacement, keys)});
  };
  if (const auto table = part("together", correction_together_keys))
    model.together = read_together(*table);
  if (const auto table = part("residual", correction_residual_keys))
    model.left = read_left(*table, model);
  if (const auto table = part("trust", correction_trust_keys))
    model.evidence = read_evidence(*table, model);
  if (const auto table = part("covariance", covariance_keys))
    read_correction_covariance(*table, model, notes);
}

std::string trust_text(const Model& model) {
  std::string text;
  const auto add = [&](const std::string& table) {
    if (!text.empty()) text += '\n';
    text += table;
  };
  if (!model.range.empty()) add(range_text(model));
  if (const std::string still = still_text(model); !still.empty()) add(still);
  if (model.together) add(together_text(*model.together));
  if (model.covariance) add(covariance_text(model));
  if (model.left) add(left_text(model));
  if (model.evidence) add(evidence_text(model));
  return text;
}

}  // namespace raceway::files
