#include "fit/subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "record/nearest_names.h"

namespace raceway::fit {

namespace {

constexpr std::size_t rows_at_once = 4096;  // that a prediction holds in memory

}  // namespace

std::shared_ptr<const void> Subject::prepare(const Record&) const { return nullptr; }

std::vector<std::string> Subject::catalogue() const {
  std::vector<std::string> ids;
  for (const Candidate& candidate : candidates()) ids.push_back(candidate.id);
  return ids;
}

std::unique_ptr<Subject> Subject::informed_by(const Record&) const { return nullptr; }

std::string Subject::correction(const std::string&, std::span<const double>) const { return {}; }

std::unique_ptr<Subject> Subject::without_free_candidates() const { return nullptr; }

std::unique_ptr<Subject> Subject::with_shape(const std::string&, const Shape&) const {
  return nullptr;
}

std::vector<OtherBase> Subject::other_bases() const { return {}; }

std::string Subject::rules_out(const std::string&) const { return {}; }
std::vector<Axis> Subject::axes(const Record& record) const {
  return has_memory() ? std::vector<Axis>() : Judged::axes(record);
}

std::vector<Parameter> find_parameters(const Subject& subject,
                                       const std::vector<std::string>& names) {
  const std::vector<Parameter> known = subject.parameters();
  std::vector<Parameter> list;
  for (const std::string& name : names) {
    const auto same = [&](const Parameter& p) { return p.name == name; };
    if (std::any_of(list.begin(), list.end(), same))
      throw std::invalid_argument("free parameter \"" + name + "\" is listed twice");
    const auto found = std::find_if(known.begin(), known.end(), same);
    if (found == known.end()) {
      std::vector<std::string> all;
      for (const Parameter& p : known) all.push_back(p.name);
      throw std::invalid_argument(
          "free parameter \"" + name +
          "\": the model has no such parameter; nearest: " + record::nearest_names(name, all, 4));
    }
    list.push_back(*found);
  }
  // Two that stand for one number.
  for (const Parameter& wide : list) {
    if (wide.addresses.size() < 2) continue;
    std::vector<std::string> narrow;
    for (const Parameter& other : known)
      if (other.name != wide.name && other.addresses.size() == 1 &&
          std::find(wide.addresses.begin(), wide.addresses.end(), other.addresses.front()) !=
              wide.addresses.end())
        narrow.push_back(other.name);
    if (std::any_of(list.begin(), list.end(), [&](const Parameter& p) {
          return std::find(narrow.begin(), narrow.end(), p.name) != narrow.end();
        }))
      throw std::invalid_argument(fmt::format(
          "free parameter \"{0}\" already includes {1}: remove either {0} or {1} from the list",
          wide.name, fmt::join(narrow, " and ")));
  }
  return list;
}

std::vector<double> predict(const Subject& subject, const Record& record) {
  const std::size_t rows = record.rows(), channels = subject.measured().size();
  std::vector<double> readings(channels * rows);
  if (subject.has_memory() || rows <= rows_at_once) {
    subject.predictor(record, {}, nullptr)->readings({}, readings);
    return readings;
  }
  // A predictor keeps what it has found of each row, which of many rows is more than is looked at
  // again: piece by piece.
  std::vector<std::size_t> some;
  for (std::size_t first = 0; first < rows; first += some.size()) {
    some.resize(std::min(rows_at_once, rows - first));
    std::iota(some.begin(), some.end(), first);
    const Record piece = record.picked(some);
    std::vector<double> found(channels * some.size());
    subject.predictor(piece, {}, nullptr)->readings({}, found);
    for (std::size_t c = 0; c < channels; ++c)
      std::copy_n(found.begin() + static_cast<std::ptrdiff_t>(c * some.size()), some.size(),
                  readings.begin() + static_cast<std::ptrdiff_t>(c * rows + first));
  }
  return readings;
}

}  // namespace raceway::fit
