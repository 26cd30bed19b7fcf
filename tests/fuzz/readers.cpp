#include "tests/fuzz/readers.h"

#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "cli/axis_flag.h"
#include "control/formats.h"
#include "control/table_reader.h"
#include "correction/simulation.h"
#include "files/catalogue_file.h"
#include "files/column_map.h"
#include "files/correction_file.h"
#include "files/data_file.h"
#include "files/designation.h"
#include "files/displacement_curve.h"
#include "files/model_file.h"
#include "files/new_correction.h"
#include "files/sensor_file.h"
#include "files/series_doubts.h"
#include "files/series_file.h"
#include "files/spindle_record.h"
#include "files/step_import.h"
#include "files/subject.h"
#include "files/suggest_columns.h"
#include "files/table_file.h"
#include "tests/files/spindle_text.h"
#include "tests/support/model_text.h"
#include "text/csv.h"
#include "text/error.h"
#include "text/timestamp.h"

namespace raceway::fuzz {
namespace {

using Subject = std::shared_ptr<const model::ModelSubject>;

Subject subject(const std::string& more) {
  return files::make_subject(files::parse_model(tests::model_text + more, "model.toml").model);
}

void refusable(const auto& read) {
  try {
    read();
  } catch (const text::InputError& e) {
    if (std::string(e.what()).empty()) throw std::logic_error("an error without a message");
  }
}

/// A model that is taken can be written again, and then says the same.
void model(const std::string& text) {
  refusable([&] {
    const files::ModelFile file = files::parse_model(text, "model.toml");
    const std::string again = files::with_model(file, file.model);
    if (files::parse_model(again, "model.toml").model.name != file.model.name)
      throw std::logic_error("written again it is another model");
  });
}

void data(const std::string& text) {
  static const Subject rig = subject("[rig]\naxial_load_N = 300.0\ninertia_kgm2 = 0.5\n");
  static const Subject shaft =
      subject("[arrangement]\nlayout = \"O\"\nfront = 2\nrear = 1\npreload_N = 600\n");
  for (const Subject& of : {rig, shaft})
    refusable([&] { (void)files::read_record({"data.csv", text}, *of); });
  refusable([&] {
    const files::SensorReadings read = files::read_sensor_readings({"data.csv", text});
    try {
      (void)rig::calibrate_sensor(read.readings);
    } catch (const std::invalid_argument&) {  // said by the command, with the file
    }
  });
}

/// A correction that is taken reads back from the text that its models are written as.
void correction(const std::string& text) {
  refusable([&] {
    const files::CorrectionFile file = files::parse_correction(text, "drift.toml");
    const std::string again = files::with_corrections(file, file.models);
    if (files::parse_correction(again, "drift.toml").models.size() != file.models.size())
      throw std::logic_error("written again it has other models");
  });
}

/// A record over time, of a correction and of a spindle.
void series(const std::string& text) {
  static const files::CorrectionFile drift = files::parse_correction(
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
      "input = \"bearing_temperature_C\"\n"
      "sections = [{ gain_um_K = 4.0, time_constant_s = 3000 }]\n",
      "drift.toml");
  static const model::Model spindle =
      files::parse_model(tests::shortest_spindle, "spindle.toml").model;
  const correction::Model& model = drift.models.front();
  const files::Source source{"data.csv", text};
  for (const bool drop_nan : {false, true})
    refusable([&] {
      const record::Record record = files::read_series(
          source, {model.displacement}, correction::inputs_of(model), {.drop_nan = drop_nan});
      (void)files::asked_about(files::series_doubts(record, drift.models), source,
                               files::over_time({}));
    });
  refusable([&] { (void)files::suggested_columns(source, drift.models); });
  refusable([&] {
    const std::string made = files::new_correction(source, {}).text;
    (void)files::parse_correction(made, "new.toml");
  });
  refusable([&] { (void)files::read_spindle_record(source, *spindle.spindle); });
}

/// Load cases of another program.
void steps(const std::string& text) {
  refusable([&] { (void)files::fit_load_cases(files::parse_load_cases(text, "fe.csv")); });
}

void catalogue(const std::string& text) {
  refusable([&] {
    const std::vector<files::CatalogueBearing> rows = files::parse_catalogue(text, "own.csv");
    refusable([&] { (void)files::parse_model(files::new_model_text(rows.front()), "new.toml"); });
    refusable([&] { (void)files::find_bearing(rows, text); });
  });
}

void table(const std::string& text) {
  refusable([&] { (void)files::parse_table(text, "table.csv"); });
  refusable([&] { (void)files::merged_table_text({{"1.csv", text}}); });
  refusable([&] { (void)files::merged_table_text({{"1.csv", text}, {"2.csv", text}}); });
}

void curve(const std::string& text) {
  refusable([&] { (void)files::read_displacement_curve({"curve.csv", text}); });
}

/// A table of coefficients that is taken is written again as it then reads.
void coefficients(const std::string& text) {
  refusable([&] {
    const std::string written =
        control::control_csv(control::read_control_table(text, "table.csv"));
    if (control::control_csv(control::read_control_table(written, "again.csv")) != written)
      throw std::logic_error("written again it is another table");
  });
}

/// A map, and rows that it is to find their columns in.
void columns(const std::string& text) {
  static const Subject rig = subject("[rig]\ninertia_kgm2 = 0.5\n");
  static const std::string rows =
      "Zeit;Drehzahl [1/min];Axialkraft;Temperatur;Reibmoment;Uhr;Lauf\n;;[kN];[C];[Nm];;\n"
      "12.03.2024 08:15:00;1000;0,3;25;0,09;45363,34375;a\n"
      "12.03.2024 08:15:10;2000;0,3;;0,14;45363,34386;a\n"
      "12.03.2024 08:15:20;4000;0,3;27;0,22;45363,34398;b\n";
  refusable([&] {
    const files::ColumnMap map = files::parse_column_map(text, "map.toml");
    for (const bool drop_nan : {false, true})
      refusable([&] {
        (void)files::read_record({"rows.csv", rows}, *rig, {.columns = map, .drop_nan = drop_nan});
      });
  });
}

/// A time that is taken is written as one, and read again is the same.
void timestamp(const std::string& text) {
  std::optional<double> time = text::parse_timestamp(text);
  if (!time) {
    const text::ParsedNumber days = text::parse_number(text, false);
    if (days.problem.empty()) time = text::seconds_of_excel(days.value);
  }
  if (!time) return;
  const std::string written = text::timestamp_text(*time);
  const std::optional<double> again = text::parse_timestamp(written);
  // A zone may lead out of the years of four digits.
  constexpr double year_1 = -62135596800.0, year_10000 = 253402300800.0;
  if (*time < year_1 || *time > year_10000 - 1.0) return;
  if (!again || std::abs(*again - *time) > 1e-3)
    throw std::logic_error(text + " is written as " + written);
}

void command_line(const std::string& text) {
  (void)files::read_designation(text).boundary();
  refusable([&] {
    cli::require_all(cli::axis(text, text::speed_range, "--speed"), cli::speed_range, "--speed");
  });
  for (const bool comma : {false, true}) (void)text::parse_number(text, comma);
}

constexpr Reader all[] = {
    {"model", model},         {"correction", correction}, {"data", data},
    {"series", series},       {"steps", steps},           {"coefficients", coefficients},
    {"catalogue", catalogue}, {"table", table},           {"curve", curve},
    {"columns", columns},     {"timestamp", timestamp},   {"command_line", command_line}};

}  // namespace

std::span<const Reader> readers() { return all; }

}  // namespace raceway::fuzz
