#include "files/catalogue_file.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "files/catalogue_defaults.h"
#include "files/detail/data_directories.h"
#include "text/csv.h"
#include "text/error.h"
#include "text/input_file.h"
#include "text/names.h"

namespace raceway::files {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view cage_suffix = "TA";

/// Upper case without blanks.
std::string compact(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (c != ' ' && c != '\t')
      result += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return result;
}

std::string without_cage_suffix(std::string name) {
  if (name.size() > cage_suffix.size() && name.ends_with(cage_suffix))
    name.erase(name.size() - cage_suffix.size());
  return name;
}

/// What two names of one bearing have in common.
std::string key_of(std::string_view name, std::string_view maker) {
  std::string key = without_cage_suffix(compact(name));
  const std::string prefix = compact(maker);
  if (key.size() > prefix.size() && key.starts_with(prefix)) key.erase(0, prefix.size());
  return key;
}

std::string maker_of(const text::CsvTable& table, const std::string& path) {
  constexpr std::string_view mark = "# maker:";
  for (const std::string& comment : table.comments) {
    if (!comment.starts_with(mark)) continue;
    const std::size_t begin = comment.find_first_not_of(' ', mark.size());
    if (begin != comment.npos) return comment.substr(begin);
  }
  const std::string stem = fs::path(path).stem().string();
  return compact(stem.substr(0, stem.find('_')));
}

/// In the order of their names.
std::vector<std::string> csv_files(const fs::path& folder) {
  std::error_code error;
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".csv") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

/// The program, or the shared library that this code is in: it is installed with its data.
fs::path this_binary() {
  std::error_code ignored;
  Dl_info info{};
  if (dladdr(reinterpret_cast<void*>(&read_catalogue), &info) != 0 && info.dli_fname != nullptr)
    if (const fs::path path = info.dli_fname;
        path.filename().string().find(".so") != path.native().npos)
      return fs::canonical(path, ignored);
  return fs::read_symlink("/proc/self/exe", ignored);
}

/// What bin/raceway, lib/x86_64-linux-gnu/libraceway_c.so or lib/python3/dist-packages/... is
/// below.
fs::path own_prefix() {
  const fs::path place = this_binary().parent_path();
  for (fs::path folder = place; folder.has_relative_path(); folder = folder.parent_path())
    if (const fs::path name = folder.filename(); name == "bin" || name == "lib" || name == "lib64")
      return folder.parent_path();
  return place.parent_path();
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

}  // namespace

std::string own_data_directory() {
  const char* const named = std::getenv("RACEWAY_DATA");
  if (!named || !*named) return {};
  if (!is_folder(named))
    throw text::InputError(fmt::format("RACEWAY_DATA = {}: this folder does not exist", named),
                           {.file = named, .key = "RACEWAY_DATA"});
  return named;
}

std::string data_file(const std::string& name) {
  const std::array candidates{own_prefix() / "share/raceway", fs::path(built_data_directory),
                              fs::path(installed_data_directory)};
  std::error_code ignored;
  for (const fs::path& candidate : candidates)
    if (fs::exists(candidate / name, ignored)) return (candidate / name).string();
  return {};
}

std::string data_directory() { return fs::path(data_file("bearings")).parent_path().string(); }

std::vector<CatalogueBearing> read_catalogue(const std::string& path) {
  return parse_catalogue(text::read_text(path), path);
}

std::vector<CatalogueBearing> parse_catalogue(std::string text, const std::string& path) {
  const text::CsvTable table = text::parse_csv(std::move(text), path);
  const std::string maker = maker_of(table, path);
  struct Reading {
    std::string_view column;
    double unit;
    double upper;
    bool optional;
    double& (*member)(CatalogueBearing&);
  };
  using Row = CatalogueBearing;
  constexpr double newton_per_um = N_per_um;
  const std::array readings{
      Reading{"bore_mm", mm, 5000, false, [](Row& r) -> double& { return r.geometry.bore; }},
      Reading{"outer_diameter_mm", mm, 10000, false,
              [](Row& r) -> double& { return r.geometry.outer_diameter; }},
      Reading{"width_mm", mm, 5000, true, [](Row& r) -> double& { return r.width; }},
      Reading{"pitch_diameter_mm", mm, 5000, false,
              [](Row& r) -> double& { return r.geometry.pitch_diameter; }},
      Reading{"ball_diameter_mm", mm, 300, false,
              [](Row& r) -> double& { return r.geometry.ball_diameter; }},
      Reading{"contact_angle_deg", degree, 65, false,
              [](Row& r) -> double& { return r.geometry.contact_angle; }},
      Reading{"mass_kg", 1, 1e5, true, [](Row& r) -> double& { return r.mass; }},
      Reading{"dynamic_load_rating_N", 1, 1e9, true,
              [](Row& r) -> double& { return r.dynamic_load_rating; }},
      Reading{"static_load_rating_steel_N", 1, 1e9, false,
              [](Row& r) -> double& { return r.geometry.static_load_rating; }},
      Reading{"static_load_rating_Si3N4_N", 1, 1e9, true,
              [](Row& r) -> double& { return r.static_load_rating_silicon_nitride; }},
      Reading{"speed_limit_oil_rpm", rpm, 1e7, true,
              [](Row& r) -> double& { return r.speed_limit_oil; }},
      Reading{"speed_limit_grease_rpm", rpm, 1e7, true,
              [](Row& r) -> double& { return r.speed_limit_grease; }},
      Reading{"preload_L_N", 1, 1e8, true, [](Row& r) -> double& { return r.light.force; }},
      Reading{"axial_rigidity_pair_L_N_per_um", newton_per_um, 1e6, true,
              [](Row& r) -> double& { return r.light.axial_rigidity; }},
      Reading{"preload_M_N", 1, 1e8, true, [](Row& r) -> double& { return r.medium.force; }},
      Reading{"axial_rigidity_pair_M_N_per_um", newton_per_um, 1e6, true,
              [](Row& r) -> double& { return r.medium.axial_rigidity; }},
      Reading{"preload_S_N", 1, 1e8, true, [](Row& r) -> double& { return r.strong.force; }},
      Reading{"axial_rigidity_pair_S_N_per_um", newton_per_um, 1e6, true,
              [](Row& r) -> double& { return r.strong.axial_rigidity; }},
      Reading{"min_spring_preload_at_max_speed_N", 1, 1e8, true,
              [](Row& r) -> double& { return r.spring_preload_at_speed_limit; }}};

  const auto required = [&](std::string_view name) {
    const auto column = table.column(name);
    if (!column)
      throw text::InputError(fmt::format("{}:{}: column {} is missing{}", path, table.header_line,
                                         name, text::suggestion(name, table.header)),
                             {path, table.header_line, std::string(name)});
    return *column;
  };
  const std::size_t designation = required("designation");
  const std::size_t ball_count = required("ball_count");
  std::vector<CatalogueBearing> rows(table.rows());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].maker = maker;
    rows[i].designation = table.cell(i, designation);
    if (rows[i].designation.empty())
      throw text::InputError(fmt::format("{}:{}: designation is empty", path, table.line(i)),
                             {path, table.line(i), "designation"});
    if (rows[i].full_name().find_first_of("\"\\") != std::string::npos)
      throw text::InputError(
          fmt::format("{}:{}: designation = {}: must not contain quotes or backslashes", path,
                      table.line(i), text::quoted(rows[i].full_name())),
          {path, table.line(i), "designation"});
    const double balls = table.number(i, ball_count);
    if (!(balls >= 3 && balls <= 200) || balls != std::floor(balls))
      throw text::InputError(
          fmt::format("{}:{}: ball_count = {}: must be a whole number from 3 to 200", path,
                      table.line(i), balls),
          {path, table.line(i), "ball_count"});
    rows[i].geometry.ball_count = static_cast<int>(balls);
    rows[i].geometry.inner_conformity = catalogue_conformity;
    rows[i].geometry.outer_conformity = catalogue_conformity;
  }
  for (const Reading& reading : readings) {
    if (reading.optional && !table.column(reading.column)) continue;
    const std::size_t column = required(reading.column);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (reading.optional && table.cell(i, column).empty()) continue;
      const double value = table.number(i, column);
      if (!(value >= 0 && value <= reading.upper))
        throw text::InputError(fmt::format("{}:{}: {} = {}: must be from 0 to {}", path,
                                           table.line(i), reading.column, value, reading.upper),
                               {path, table.line(i), std::string(reading.column)});
      reading.member(rows[i]) = value * reading.unit;
    }
  }
  return rows;
}

std::vector<CatalogueBearing> read_catalogues() {
  const std::string own = own_data_directory();
  std::vector<std::string> files;
  if (!own.empty()) {
    files = csv_files(is_folder(fs::path(own) / "bearings") ? fs::path(own) / "bearings"
                                                            : fs::path(own));
    if (files.empty())
      throw text::InputError(
          fmt::format("RACEWAY_DATA = {0}: no catalogue of bearings was found ({0}/*.csv "
                      "or {0}/bearings/*.csv)",
                      own),
          {.file = own, .key = "RACEWAY_DATA"});
  }
  if (const std::string ours = data_directory(); !ours.empty()) {
    const std::vector<std::string> more = csv_files(fs::path(ours) / "bearings");
    // The folder may be named although it is the one that is found anyway.
    for (const std::string& file : more)
      if (std::none_of(files.begin(), files.end(), [&](const std::string& known) {
            std::error_code ignored;
            return fs::equivalent(known, file, ignored);
          }))
        files.push_back(file);
  }
  if (files.empty())
    throw text::InputError(
        "the folder with the catalogue of bearings was not found; set the environment variable "
        "RACEWAY_DATA to this folder",
        {.key = "RACEWAY_DATA"});
  std::vector<CatalogueBearing> rows;
  for (const std::string& file : files)
    for (CatalogueBearing& row : read_catalogue(file)) rows.push_back(std::move(row));
  return rows;
}

std::vector<CatalogueBearing> matching_bearings(const std::vector<CatalogueBearing>& rows,
                                                std::string_view filter) {
  const std::string part = without_cage_suffix(compact(filter));
  std::vector<CatalogueBearing> result;
  for (const CatalogueBearing& row : rows)
    if (compact(row.full_name()).find(part) != std::string::npos) result.push_back(row);
  return result;
}

const CatalogueBearing* known_bearing(const std::vector<CatalogueBearing>& rows,
                                      std::string_view name) {
  for (const CatalogueBearing& row : rows)
    if (key_of(row.designation, row.maker) == key_of(name, row.maker)) return &row;
  return nullptr;
}

CatalogueBearing find_bearing(const std::vector<CatalogueBearing>& rows, std::string_view name) {
  if (const CatalogueBearing* const row = known_bearing(rows, name)) return *row;
  struct Near {
    std::size_t distance;
    const CatalogueBearing* row;
  };
  std::vector<Near> near;
  for (const CatalogueBearing& row : rows) {
    near.push_back(
        {text::edit_distance(key_of(row.designation, row.maker), key_of(name, row.maker)), &row});
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const Near& a, const Near& b) { return a.distance < b.distance; });
  constexpr std::size_t shown = 3, far = 4;
  std::string names;
  for (std::size_t i = 0; i < std::min(shown, near.size()) && near[i].distance < far; ++i)
    names += (i == 0 ? "; similar designations: " : ", ") + near[i].row->full_name();
  throw text::InputError(
      fmt::format("bearing {} is not in the catalogue{}", text::quoted(name), names),
      {.key = "catalogue"});
}

}  // namespace raceway::files
