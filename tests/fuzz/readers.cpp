#include "tests/fuzz/readers.h"

#include <memory>
#include <stdexcept>
#include <vector>

#include "cli/axis_flag.h"
#include "io/catalogue_file.h"
#include "io/csv.h"
#include "io/data_file.h"
#include "io/displacement_curve.h"
#include "io/error.h"
#include "io/model_file.h"
#include "io/sensor_file.h"
#include "io/subject.h"
#include "io/table_file.h"
#include "tests/support/model_text.h"

namespace raceway::fuzz {
namespace {

using Subject = std::shared_ptr<const model::ModelSubject>;

Subject subject(const std::string& more) {
  return io::make_subject(io::parse_model(tests::model_text + more, "model.toml").model);
}

void refusable(const auto& read) {
  try {
    read();
  } catch (const io::InputError& e) {
    if (std::string(e.what()).empty()) throw std::logic_error("an error without a message");
  }
}

/// A model that is taken can be written again, and then says the same.
void model(const std::string& text) {
  refusable([&] {
    const io::ModelFile file = io::parse_model(text, "model.toml");
    const std::string again = io::with_model(file, file.model);
    if (io::parse_model(again, "model.toml").model.name != file.model.name)
      throw std::logic_error("written again it is another model");
  });
}

void data(const std::string& text) {
  static const Subject rig = subject("[rig]\naxial_load_N = 300.0\ninertia_kgm2 = 0.5\n");
  static const Subject shaft =
      subject("[arrangement]\nlayout = \"O\"\nfront = 2\nrear = 1\npreload_N = 600\n");
  for (const Subject& of : {rig, shaft})
    refusable([&] { (void)io::parse_record(text, "data.csv", *of); });
  refusable([&] {
    const io::SensorReadings read = io::parse_sensor_readings(text, "data.csv");
    try {
      (void)rig::calibrate_sensor(read.readings);
    } catch (const std::invalid_argument&) {  // said by the command, with the file
    }
  });
}

void catalogue(const std::string& text) {
  refusable([&] {
    const std::vector<io::CatalogueBearing> rows = io::parse_catalogue(text, "own.csv");
    refusable([&] { (void)io::parse_model(io::new_model_text(rows.front()), "new.toml"); });
    refusable([&] { (void)io::find_bearing(rows, text); });
  });
}

void table(const std::string& text) {
  refusable([&] { (void)io::parse_table(text, "table.csv"); });
  refusable([&] { (void)io::merged_table_text({{"1.csv", text}}); });
  refusable([&] { (void)io::merged_table_text({{"1.csv", text}, {"2.csv", text}}); });
}

void curve(const std::string& text) {
  refusable([&] { (void)io::parse_displacement_curve(text, "curve.csv"); });
}

void command_line(const std::string& text) {
  refusable([&] { cli::require_all(cli::axis(text, "--speed"), cli::speed_range, "--speed"); });
  for (const bool comma : {false, true}) (void)io::parse_number(text, comma);
}

constexpr Reader all[] = {{"model", model}, {"data", data},   {"catalogue", catalogue},
                          {"table", table}, {"curve", curve}, {"command_line", command_line}};

}  // namespace

std::span<const Reader> readers() { return all; }

}  // namespace raceway::fuzz
