#include "friction/lubricant.h"

#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "bearing/validation.h"

namespace raceway::friction {
namespace {

struct SupplyText {
  Supply supply;
  std::string_view name, words;
};

constexpr std::array supplies{SupplyText{Supply::oil_air, "oil-air", "oil-air"},
                              SupplyText{Supply::grease, "grease", "grease"},
                              SupplyText{Supply::jet, "jet", "an oil jet"},
                              SupplyText{Supply::bath, "bath", "an oil bath"}};

constexpr const SupplyText& text_of(Supply supply) {
  for (const SupplyText& text : supplies)
    if (text.supply == supply) return text;
  return supplies.front();
}

double thin_oil_term(double nu) { return std::exp(-1.47 - 1.84 * nu - 0.51 * nu * nu); }

// Natural logarithms change A but neither B nor the line.
double log_log_z(double nu) { return std::log(std::log(nu + 0.7 + thin_oil_term(nu))); }

double viscosity_of_z(double z) {
  const double x = z - 0.7;
  // The exponential is below rounding here, and its cubic would overflow further up.
  if (x > 10.0) return x;
  double nu = x - std::exp(-0.7487 - 3.295 * x + 0.6119 * x * x - 0.3193 * x * x * x);
  for (int i = 0; i < 3; ++i) {
    const double e = thin_oil_term(nu);
    nu -= (nu + e - x) / (1.0 - (1.84 + 1.02 * nu) * e);
  }
  return nu;
}

}  // namespace

std::string_view name(Supply supply) { return text_of(supply).name; }

std::string_view words(Supply supply) { return text_of(supply).words; }

std::optional<Supply> find_supply(std::string_view name) {
  for (const SupplyText& text : supplies)
    if (text.name == name) return text.supply;
  return std::nullopt;
}

Lubricant::Lubricant(double viscosity_40C, double viscosity_100C)
    : viscosity_40C_(viscosity_40C), viscosity_100C_(viscosity_100C) {
  bearing::require_between("viscosity_40C", viscosity_40C, 1 * mm2_per_s, 1e5 * mm2_per_s,
                           mm2_per_s, "mm2/s");
  bearing::require_between("viscosity_100C", viscosity_100C, 0.5 * mm2_per_s, 1e5 * mm2_per_s,
                           mm2_per_s, "mm2/s");
  if (viscosity_100C >= viscosity_40C) {
    std::ostringstream text;
    text << "viscosity_100C = " << viscosity_100C / mm2_per_s
         << " mm2/s: must be below viscosity_40C = " << viscosity_40C / mm2_per_s << " mm2/s";
    throw std::invalid_argument(text.str());
  }
  const double cold = log_log_z(viscosity_40C / mm2_per_s);
  const double hot = log_log_z(viscosity_100C / mm2_per_s);
  slope_ = (cold - hot) / std::log(kelvin(100) / kelvin(40));
  offset_ = cold + slope_ * std::log(kelvin(40));
}

double Lubricant::kinematic_viscosity(double temperature) const {
  const double z = std::exp(std::exp(offset_ - slope_ * std::log(temperature)));
  return viscosity_of_z(z) * mm2_per_s;
}

double Lubricant::viscosity_slope(double temperature) const {
  const double log_z = std::exp(offset_ - slope_ * std::log(temperature));
  const double z = std::exp(log_z);
  const double nu = viscosity_of_z(z);
  const double z_of_nu = 1.0 - (1.84 + 1.02 * nu) * thin_oil_term(nu);  // dZ/dν
  return z * log_z * slope_ / (temperature * z_of_nu * nu);
}

}  // namespace raceway::friction
