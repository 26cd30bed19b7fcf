#include "cli/fitted_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/messages.h"
#include "cli/run_files.h"
#include "text/names.h"

namespace raceway::cli {
namespace {

/// "a-monday.toml" of "a.toml" and "monday".
std::string file_of(const std::string& output, std::string record) {
  std::replace(record.begin(), record.end(), '/', '-');
  const std::filesystem::path path(output);
  return (path.parent_path() / (path.stem().string() + "-" + record + path.extension().string()))
      .string();
}

}  // namespace

std::vector<std::string> FittedModels::files(const fit::Subject& subject) const {
  if (output_.empty()) return {};
  const std::vector<std::string> records = session::records_apart(subject);
  if (records.empty()) return {output_};
  std::vector<std::string> list;
  for (const std::string& record : records) list.push_back(file_of(output_, record));
  return list;
}

std::string FittedModels::names(const fit::Subject& subject) const {
  return text::listed(files(subject));
}

std::string FittedModels::existing(const fit::Subject& subject) const {
  std::vector<std::string> list = files(subject);
  std::erase_if(list, [](const std::string& file) { return !std::filesystem::exists(file); });
  return list.empty() ? "" : text::listed(list);
}

void FittedModels::require_writable(const fit::Subject& subject) const {
  const std::vector<std::string> list = files(subject);
  if (list.size() > 1) check_outputs(list);
  for (const std::string& file : list) text::require_writable(file, if_exists_);
}

void FittedModels::write(const session::LoopQuestion& asked,
                         const verdict::Calibration& calibration) const {
  const std::vector<std::string> paths = files(*calibration.subject);
  if (paths.empty()) return;
  const session::FittedTexts fitted = session::fitted_texts(asked, calibration);
  if (const std::vector<std::string>& data = fitted.corrected_data; !data.empty())
    tell(
        {fmt::format("{} {} corrected in the written file, so the file has no covariance of the "
                     "parameters; to add the covariance, run raceway calibrate {} DATA -o FILE",
                     text::listed(data), data.size() == 1 ? "is" : "are", paths.front())});
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < paths.size(); ++k)
    texts.push_back(files::with_names_from(fitted.texts[k], asked.model->about().files, paths[k]));
  std::vector<text::OutputFile> files;
  for (std::size_t k = 0; k < paths.size(); ++k) files.push_back({paths[k], texts[k]});
  text::write_files(files, if_exists_);
  for (const std::string& path : paths) say(path + " written");
}

}  // namespace raceway::cli
