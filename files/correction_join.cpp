#include "files/correction_join.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correction/numbers.h"
#include "correction/prior.h"
#include "files/model_file.h"
#include "text/error.h"
#include "text/format_number.h"
#include "text/number_text.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/correction_trust.h"
#include "files/detail/table_lines.h"

namespace raceway::files {
namespace {

using correction::Model;

[[noreturn]] void refuse(const CorrectionFile& file, const std::string& problem,
                         const std::string& key = {}) {
  throw text::InputError(fmt::format("{}: {}", file.source, problem),
                         {.file = file.source, .key = key});
}

struct Lines {
  std::size_t begin, end;
};

/// Lines of a table in brackets, with the comment above it.
Lines lines_of(const std::string& text, const toml::table& table) {
  Lines lines{text::line_start(text, table.source().begin.line),
              text.find('\n', text::line_start(text, last_line(table)))};
  lines.end = lines.end == text.npos ? text.size() : lines.end + 1;
  lines.begin = with_comment_above(text, lines.begin);
  return lines;
}

/// The tables of a file that the sum takes as they stand.
std::string parts_of(const CorrectionFile& file, const std::string& text) {
  const toml::table root = text::parse_toml(text, file.source);
  const toml::node* const node = root.get("correction");
  const toml::table& correction = *(node->is_array() ? node->as_array()->get(0) : node)->as_table();
  std::string parts;
  const auto take = [&](const toml::table& table, std::string_view key) {
    if (table.is_inline())
      refuse(file,
             fmt::format("{0} is an inline table in braces: write it as [correction.{0}] or "
                         "[[correction.{0}]] to join the files",
                         key),
             std::string(key));
    const Lines lines = lines_of(text, table);
    parts += "\n" + text.substr(lines.begin, lines.end - lines.begin);
    if (!parts.ends_with('\n')) parts += '\n';
  };
  for (const std::string_view key : {"channel", "kinematic", "effect"}) {
    const toml::node* const part = correction.get(key);
    if (!part) continue;
    if (const toml::table* const table = part->as_table()) take(*table, key);
    if (const toml::array* const list = part->as_array())
      for (const toml::node& one : *list) take(*one.as_table(), key);
  }
  return parts;
}

/// Priors of a file: what the record of its numbers told, what it states, and of what it has from a
/// computation and does not fit itself. The offset has none: the zero of a record says nothing.
std::vector<correction::NumberPrior> priors_of(const Model& m) {
  std::vector<correction::NumberPrior> list;
  for (std::size_t k = 0; m.covariance && k < m.covariance->names.size(); ++k)
    if (const std::string& name = m.covariance->names[k]; name != "offset")
      list.push_back({name,
                      {.value = m.covariance->values[static_cast<Eigen::Index>(k)],
                       .std = m.covariance->std(k)}});
  const std::size_t told = list.size();
  for (const correction::NumberPrior& p :
       m.priors.empty() && m.free.empty() ? correction::computed_priors(m) : m.priors)
    if (std::none_of(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(told),
                     [&](const auto& known) { return known.name == p.name; }))
      list.push_back(p);
  return list;
}

/// Names of the parameters that a file fits, and of those with a prior.
std::vector<std::string> free_of(const Model& m,
                                 const std::vector<correction::NumberPrior>& priors) {
  std::vector<std::string> names = correction::free_names(m);
  if (m.free.empty())
    std::erase_if(names, [](const std::string& name) { return name.starts_with("kinematic."); });
  for (const correction::NumberPrior& p : priors)
    if (std::find(names.begin(), names.end(), p.name) == names.end()) names.push_back(p.name);
  return names;
}

/// Narrows a range to what both files have seen; throws where they have nothing in common.
void narrow(std::vector<correction::SeenRange>& ranges, const correction::SeenRange& other,
            const CorrectionFile& file) {
  const auto known = std::find_if(ranges.begin(), ranges.end(), [&](const auto& r) {
    return r.name == other.name && (r.column == nullptr) == (other.column == nullptr);
  });
  if (known == ranges.end()) {
    ranges.push_back(other);
    return;
  }
  known->lower = std::max(known->lower, other.lower);
  known->upper = std::min(known->upper, other.upper);
  known->still = std::fmax(known->still, other.still);
  if (known->lower > known->upper)
    refuse(file,
           fmt::format("{}: the range of this input does not overlap its range in an earlier file, "
                       "so no operating point is inside both ranges",
                       other.name),
           other.name);
}

void require_alike(std::span<const CorrectionFile> files) {
  if (files.size() < 2)
    throw text::InputError("raceway join: only one file is given; name at least two corrections",
                           {.key = "MODEL"});
  for (const CorrectionFile& file : files) {
    if (file.models.size() != 1)
      refuse(file,
             "the file has several tables [[correction]]; each file to join may have only one");
    const Model& first = files.front().models.front();
    const Model& m = file.models.front();
    if (!(*m.displacement == *first.displacement))
      refuse(file,
             fmt::format(
                 "corrects {}, but {} corrects {}; all files must correct the same displacement",
                 m.displacement->name, files.front().source, first.displacement->name),
             "displacement");
  }
}

/// Keys of [correction] itself: of the sum, or of the first file that has them.
std::string head_of(std::span<const CorrectionFile> files, const std::string& name) {
  double offset = 0.0, tolerance = unset, std = unset, sampling = unset;
  const auto first = [](double& of_sum, double value) {
    if (std::isnan(of_sum)) of_sum = value;
  };
  for (const CorrectionFile& file : files) {
    const Model& m = file.models.front();
    offset += m.offset;
    first(tolerance, m.tolerance);
    first(std, m.measured_std);
    if (!std::isnan(sampling) && !std::isnan(m.sampling) && sampling != m.sampling)
      refuse(
          file,
          fmt::format(
              "sampling_s = {:g} s, but an earlier file has {:g} s; all files need the same value",
              m.sampling, sampling),
          "sampling_s");
    first(sampling, m.sampling);
  }
  std::string text =
      fmt::format("[correction]\nname = {}\ndisplacement = \"{}\"\n", text::in_quotes(name),
                  files.front().models.front().displacement->name);
  const auto add = [&](std::string_view key, double value) {
    if (std::isfinite(value))
      text += fmt::format("{} = {}\n", key, text::toml_float(text::with_15_digits(value)));
  };
  const Model& own = files.front().models.front();
  add(correction::in_unit_of(own, "tolerance_um"), tolerance / um);
  add(correction::in_unit_of(own, "measurement_std_um"), std / um);
  add("sampling_s", sampling);
  if (offset != 0.0) add(correction::in_unit_of(own, "offset_um"), offset / um);
  return text;
}

/// Tables beside [correction]: of the first file that has them.
std::string tables_beside(std::span<const CorrectionFile> files, std::vector<record::Note>& notes) {
  std::string text;
  for (const std::string_view key : {"columns", "transducers", "export"}) {
    const CorrectionFile* from = nullptr;
    for (const CorrectionFile& file : files) {
      const toml::table root = text::parse_toml(file.text, file.source);
      const toml::node* const node = root.get(key);
      if (!node) continue;
      if (from) {
        notes.push_back(record::note::unused(
            fmt::format("{}: [{}] is not used; the joined correction has the table of {}",
                        file.source, key, from->source),
            {.file = file.source, .key = std::string(key)}));
        continue;
      }
      from = &file;
      const Lines lines = lines_of(file.text, *node->as_table());
      text += "\n" + file.text.substr(lines.begin, lines.end - lines.begin);
    }
  }
  return text;
}

}  // namespace

JoinedCorrection join_corrections(std::span<const CorrectionFile> files, const std::string& path) {
  require_alike(files);
  JoinedCorrection joined;
  Model seen;
  std::vector<std::string> channels, names, free;
  std::string parts;
  bool has_law = false;
  for (const CorrectionFile& file : files) {
    const Model& m = file.models.front();
    if (std::find(names.begin(), names.end(), m.name) == names.end()) names.push_back(m.name);
    for (const correction::DrivenChannel& c : m.channels) {
      if (std::find(channels.begin(), channels.end(), c.name) != channels.end())
        refuse(file,
               fmt::format("an earlier file also has a channel \"{}\": rename one of them", c.name),
               c.name);
      channels.push_back(c.name);
    }
    if (m.kinematic && has_law)
      refuse(file,
             "an earlier file also has [correction.kinematic], but a shaft has only one: remove "
             "one table",
             "kinematic");
    has_law = has_law || m.kinematic;
    for (const correction::SeenRange& r : m.range) narrow(seen.range, r, file);
    parts += parts_of(file, with_names_from(file.text, file.files, path));
    const std::vector<correction::NumberPrior> priors = priors_of(m);
    seen.priors.insert(seen.priors.end(), priors.begin(), priors.end());
    for (std::string& name : free_of(m, priors))
      if (std::find(free.begin(), free.end(), name) == free.end()) free.push_back(std::move(name));
    for (const NamedFile& named : file.files)
      if (path.empty()) joined.files.push_back({named.path, named.path, named.text});
  }
  joined.text = fmt::format("# {}\n{}{}{}", fmt::join(names, " and "), text::format_line,
                            head_of(files, fmt::format("{}", fmt::join(names, " and "))), parts);
  joined.text += tables_beside(files, joined.notes);
  if (const std::string priors = prior_text(seen); !priors.empty()) joined.text += "\n" + priors;
  if (const std::string range = trust_text(seen); !range.empty()) joined.text += "\n" + range;
  joined.text += fmt::format("\n[calibration]\nfree = [\"{}\"]\n", fmt::join(free, "\", \""));
  joined.notes.push_back(
      record::note::limits("the trust in the joined correction is unknown: compare the correction "
                           "with a record of the whole machine"));
  return joined;
}

}  // namespace raceway::files
