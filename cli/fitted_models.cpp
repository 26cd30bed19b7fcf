#include "cli/fitted_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/messages.h"
#include "cli/run_files.h"
#include "fit/several_records.h"
#include "io/names.h"
#include "model/corrected_data.h"
#include "model/model_subject.h"
#include "model/parameters.h"

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

std::filesystem::path folder(const std::string& file) {
  return std::filesystem::weakly_canonical(std::filesystem::absolute(file)).parent_path();
}

/// What of a covariance concerns one record, by the names of its model.
fit::Covariance of_record(const fit::Covariance& all, const fit::SeveralRecords& several,
                          std::size_t record) {
  fit::Covariance own;
  std::vector<Eigen::Index> rows;
  for (std::size_t k = 0; k < all.names.size(); ++k)
    if (std::string name = several.name_in(record, all.names[k]); !name.empty()) {
      own.names.push_back(std::move(name));
      rows.push_back(static_cast<Eigen::Index>(k));
    }
  own.values = all.values(rows);
  own.matrix = all.matrix(rows, rows);
  return own;
}

/// Names of the covariance that are no parameters of the model as it is written: data that are put
/// right where they stand.
std::vector<std::string> corrected(const model::Model& model) {
  const std::vector<record::Parameter> known = model::parameters(model::with_corrected_data(model));
  std::vector<std::string> names;
  for (const std::string& name : model.covariance->names)
    if (std::none_of(known.begin(), known.end(), [&](const auto& p) { return p.name == name; }))
      names.push_back(name);
  return names;
}

/// The model of one record as the fit has left it, with the covariance of what was fitted.
model::Model fitted_model(const fit::Calibration& calibration, std::size_t record) {
  const auto* const of = dynamic_cast<const fit::SeveralRecords*>(calibration.subject.get());
  model::Model model =
      of ? model::model_of(*of->model_of(record)) : model::model_of(*calibration.subject);
  model.covariance = fit::covariance_of(calibration);
  if (model.covariance && of) model.covariance = of_record(*model.covariance, *of, record);
  return model;
}

}  // namespace

const model::Model& FittedModels::model(const fit::Calibration& calibration) {
  const auto* const of = dynamic_cast<const fit::SeveralRecords*>(calibration.subject.get());
  return model::model_of(of ? of->shared() : *calibration.subject);
}

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
  const std::vector<std::string> list = files(subject);
  check_outputs(list);
  for (const std::string& file : list) io::require_writable(file, if_exists_);
}

void FittedModels::write(const io::ModelFile& file, const fit::Calibration& calibration) const {
  const std::vector<std::string> paths = files(*calibration.subject);
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    model::Model model = fitted_model(calibration, k);
    // What is left without them would be another covariance.
    if (model.covariance)
      if (const std::vector<std::string> data = corrected(model); !data.empty()) {
        model.covariance.reset();
        if (k == 0)
          tell(
              {fmt::format("{} {} written as a corrected datum, so no covariance is: calibrate "
                           "{} for one",
                           io::listed(data), data.size() == 1 ? "is" : "are", paths[k])});
      }
    texts.push_back(io::with_model(file, model));
  }
  for (std::size_t k = 0; k < paths.size(); ++k) {
    io::write_text(paths[k], texts[k], if_exists_);
    say(paths[k] + " written");
    if (!file.sensor_file.empty() && folder(paths[k]) != folder(file.source))
      warn(
          fmt::format("{}: the file of its [torque_sensor] is looked for from there; this run read "
                      "{}",
                      paths[k], file.sensor_file));
  }
}

void write_model(const std::string& path, const std::string& text, bool replace) {
  if (path.empty()) return;
  io::write_text(path, text, replace ? io::IfExists::replace : io::IfExists::refuse);
  say(path + " written");
}

}  // namespace raceway::cli
