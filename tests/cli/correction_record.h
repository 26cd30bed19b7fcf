#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>

namespace raceway::tests {

/// A machine of one lag, 4 um/K at 1800 s on its front temperature.
inline std::string z_model(const std::string& more = "") {
  return "[correction]\ndisplacement = \"displacement_z_um\"\ntolerance_um = 0.5\n"
         "measurement_std_um = 0.05\n" +
         more +
         "[[correction.channel]]\nname = \"front\"\ninput = \"front_temperature_C\"\n"
         "sections = [{ gain_um_K = 4.0, time_constant_s = 1800 }]\n";
}

/// Its record of a day with rests, every minute: temperature by a lag of 900 s of the speed, exact
/// steps of the lag, and what else moves it. `columns`: further ones, and their cells of a row.
struct RecordOfADay {
  std::string columns{};
  std::function<std::string(int)> cells = [](int) { return ""; };
  std::function<double(int, double)> moves = [](int, double) { return 0.0; };  // row, speed [rpm]
  std::function<std::string(int, std::string)> line = [](int, std::string text) { return text; };
  int rows = 1440;

  [[nodiscard]] std::string csv() const {
    std::string text = "time_s,speed_rpm,front_temperature_C" + columns + ",displacement_z_um\n";
    double rise = 0.0, y = 0.0;
    constexpr double speeds[] = {4000, 9000, 0, 6500, 2000, 0, 8000, 3000, 0, 7000, 0, 5000};
    for (int k = 0; k < rows; ++k) {
      const double speed = speeds[(k / 120) % 12];
      const double before = rise;
      rise += (25.0 * speed / 10000.0 - rise) * -std::expm1(-60.0 / 900.0);
      // A lag of what goes straight from one row to the next.
      const double z = 60.0 / 1800.0, decay = std::exp(-z), slope = (rise - before) / 60.0;
      y = k == 0 ? 0.0
                 : decay * y + before * (1.0 - decay) + slope * (60.0 - 1800.0 * (1.0 - decay));
      if (k == 0) rise = 0.0;
      text += line(k, fmt::format("{},{},{:.6f}{},{:.5f}\n", 60 * k, speed, 20.0 + rise, cells(k),
                                  4.0 * y + moves(k, speed)));
    }
    return text;
  }
};

/// Two axes that move by turns, and heat nothing.
inline std::string with_feeds() {
  return RecordOfADay{.columns = ",x_feed_m_min,y_feed_m_min",
                      .cells =
                          [](int k) {
                            return fmt::format(",{},{}", (k / 95) % 3 == 1 ? 12 : 0,
                                               (k / 145) % 2 == 1 ? 8 : 0);
                          },
                      .moves = [](int k, double) { return 2.0 * std::sin(k / 7.3); }}
      .csv();
}

/// 3 um every 100 min, told by no column.
inline std::string with_swing() {
  return RecordOfADay{
      .moves = [](int k,
                  double) { return 3.0 * std::sin(2.0 * std::acos(-1.0) * 60.0 * k / 6000.0); }}
      .csv();
}

}  // namespace raceway::tests
