#include "cli/fitted_models.h"

#include <algorithm>
#include <filesystem>

#include "cli/open_input.h"
#include "fit/several_records.h"
#include "io/names.h"
#include "model/model_subject.h"

namespace raceway::cli {
namespace {

/// The subject where records have values of their own, else null.
const fit::SeveralRecords* several(const fit::Subject& subject) {
  const auto* const of = dynamic_cast<const fit::SeveralRecords*>(&subject);
  return of && !of->own().empty() ? of : nullptr;
}

/// "a-monday.toml" of "a.toml" and "monday".
std::string file_of(const std::string& output, std::string record) {
  std::replace(record.begin(), record.end(), '/', '-');
  const std::filesystem::path path(output);
  return (path.parent_path() / (path.stem().string() + "-" + record + path.extension().string()))
      .string();
}

/// The model of one record as the fit has left it.
model::Model fitted_model(const fit::Calibration& calibration, std::size_t record) {
  const auto* const of = dynamic_cast<const fit::SeveralRecords*>(calibration.subject.get());
  return of ? model::model_of(*of->model_of(record)) : model::model_of(*calibration.subject);
}

}  // namespace

std::vector<std::string> FittedModels::files(const fit::Subject& subject) const {
  if (output_.empty()) return {};
  const fit::SeveralRecords* const of = several(subject);
  if (!of) return {output_};
  std::vector<std::string> list;
  for (const std::string& record : of->records()) list.push_back(file_of(output_, record));
  return list;
}

std::string FittedModels::names(const fit::Subject& subject) const {
  return io::listed(files(subject));
}

void FittedModels::require_writable(const fit::Subject& subject) const {
  for (const std::string& file : files(subject)) io::require_writable(file, if_exists_);
}

void FittedModels::write(const io::ModelFile& file, const fit::Calibration& calibration) const {
  const std::vector<std::string> paths = files(*calibration.subject);
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < paths.size(); ++k)
    texts.push_back(io::with_model(file, fitted_model(calibration, k)));
  for (std::size_t k = 0; k < paths.size(); ++k) {
    io::write_text(paths[k], texts[k], if_exists_);
    say(paths[k] + " written");
  }
}

}  // namespace raceway::cli
