#include "correction/catalogue.h"

#include <array>
#include <limits>

#include "correction/own_effect.h"

namespace raceway::correction {
namespace {

using record::NumberCard;

constexpr double free_size = std::numeric_limits<double>::infinity();
constexpr double shortest_lag = 1.0,
                 longest_lag = 1e7;  // of any time constant [s]; a record narrows it

constexpr NumberCard gain_number{"gain", "um/u", 0.0, -free_size, free_size};
constexpr NumberCard time_constant{"time_constant_s", "s",          3600,        shortest_lag,
                                   longest_lag,       shortest_lag, longest_lag, unset};

constexpr std::array own_share{gain_number, time_constant};
constexpr std::array motor{gain_number, time_constant,
                           NumberCard{"decay_speed_rpm", "rpm", 2000, 300, 8000, 300, 8000, unset}};
constexpr std::array cooling{NumberCard{"gain_ratio", "1", 1.0, 0.1, 10, 0.1, 10, 1.0},
                             NumberCard{"time_constant_ratio", "1", 1.0, 0.1, 10, 0.1, 10, 1.0}};
constexpr std::array sensor{
    NumberCard{"sensor_time_constant_s", "s", 0.0, 0.0, 3600, 0.0, 3600, 0.0}};
constexpr std::array kinematic{NumberCard{"A", "um", 0.0, -free_size, free_size},
                               NumberCard{"B", "1", 0.7, 0.0, 1.2, 0.0, 1.2, unset},
                               NumberCard{"C", "1/rpm", 5e-4, 1e-4, 3e-3, 1e-4, 3e-3, unset}};
constexpr std::array speed_dependent{NumberCard{"s", "1", 0.0, 0.0, 6.0, 0.0, 6.0, 0.0},
                                     NumberCard{"g", "1", 1.0, 0.0, 1.5, 0.0, 1.5, unset}};
constexpr std::array asymmetry{NumberCard{"ratio", "1", 1.0, 0.2, 5.0, 0.2, 5.0, 1.0}};
constexpr NumberCard size_of(std::string_view name) {
  return {name, "um", 0.0, -free_size, free_size};
}
constexpr NumberCard time_of(std::string_view name) {
  return {name, "s", 0.0, -free_size, free_size, -free_size, free_size, unset};
}
constexpr std::array jump{size_of("size"),     time_of("time_s"), size_of("size_2"),
                          time_of("time_2_s"), size_of("size_3"), time_of("time_3_s")};
constexpr std::array drift{NumberCard{"size", "um", 0.0, -free_size, free_size}, time_constant};

constexpr std::array cards{
    EffectCard{.id = "ambient-drift",
               .title = "the room moves the machine",
               .form = "+ K/(1 + tau s) (mean of the room's temperatures)",
               .needs = "a temperature of the room, else of the base, that the model does not use",
               .confused = "slow-drift, a slow section, the motor's temperature",
               .numbers = own_share},
    EffectCard{
        .id = "cooling-switch",
        .title = "the machine answers otherwise with its coolant off",
        .form = "dx/dt = (K u - x)/tau with K and tau times their ratios where coolant_on = 0",
        .needs = "coolant_on that switches",
        .confused = "motor-heat, thermal-asymmetry",
        .numbers = cooling,
        .of_channel = true},
    EffectCard{.id = "feed-axis-heat",
               .title = "the screw of an axis warms up as it moves",
               .form = "+ K/(1 + tau s) |feed|",
               .needs = "a feed that moves independently of the speed",
               .confused = "ambient-drift; second-time-constant where the feed follows the speed",
               .numbers = own_share},
    EffectCard{.id = "kinematic-displacement",
               .title = "the shaft moves with speed, at once",
               .form = "+ A n^(1 - B exp(-C n))",
               .needs = "readings while it turns, at several speeds",
               .confused = "a section faster than 3 min; an offset-jump at a change of speed",
               .numbers = kinematic},
    EffectCard{.id = "motor-heat",
               .title = "a motor that warms up with or against the spindle",
               .form = "+ K/(1 + tau s) T of the motor; without that column of exp(-n/n0), n > 0",
               .needs = "a temperature of the motor, or speeds that change",
               .confused = "speed-dependent-time-constant; a body that follows the motor",
               .numbers = motor},
    EffectCard{.id = "offset-jump",
               .title = "the reading jumps: a collet, a probe, a cable",
               .form = "+ sum of c H(t - t1), three at most",
               .needs = "dense readings, of which one leaps",
               .confused = "kinematic-displacement, a hidden heat that is switched on",
               .numbers = jump,
               .of_reading = true},
    EffectCard{.id = "second-time-constant",
               .title = "a second body behind the first",
               .form = "+ K/(1 + tau s) u on a channel",
               .needs = "transients longer than three times the fast time constant",
               .confused = "sensor-lag, kinematic-displacement (fast), slow-drift (slow)",
               .numbers = own_share},
    EffectCard{.id = "sensor-lag",
               .title = "the sensor lags behind what it measures",
               .form = "the input is T (1 + tau s s)",
               .needs = "a temperature as input",
               .confused = "second-time-constant, nearly the same",
               .numbers = sensor,
               .of_channel = true},
    EffectCard{.id = "sensor-quantisation",
               .title = "the displacement steps with the last digit of a sensor",
               .form = "y steps by K0 q, with a feedthrough K0 and a quantum q",
               .needs = "a feedthrough, and a quantum that the record shows",
               .confused = "second-time-constant",
               .numbers = {},
               .of_reading = true,
               .evidence = true},
    EffectCard{.id = "slow-drift",
               .title = "something nobody measures settles over the whole record",
               .form = "+ c (1 - exp(-t/tau))",
               .needs = "rests, and a room that is known",
               .confused = "ambient-drift, a slow section",
               .numbers = drift,
               .of_reading = true},
    EffectCard{.id = "speed-dependent-time-constant",
               .title = "the faster it turns, the sooner it is warm",
               .form = "tau = tau0 f, K = K0 f^g, f = 1/(1 + s n/10 000 rpm)",
               .needs = "several speeds and phases of cooling",
               .confused = "thermal-asymmetry, motor-heat",
               .numbers = speed_dependent,
               .of_channel = true},
    EffectCard{.id = "thermal-asymmetry",
               .title = "it cools otherwise than it warms",
               .form = "tau times the ratio where u < x",
               .needs = "falls between two speeds that are not zero",
               .confused = "speed-dependent-time-constant",
               .numbers = asymmetry,
               .of_channel = true}};

}  // namespace

std::span<const EffectCard> catalogue() { return cards; }

const EffectCard* find_card(std::string_view id) {
  for (const EffectCard& card : cards)
    if (card.id == id) return &card;
  return nullptr;
}

double value_of(const Effect& effect, std::string_view name) {
  const EffectCard& card = card_of(effect);
  for (std::size_t k = 0; k < effect.values.size(); ++k)
    if (card.numbers[k].name == name) return effect.values[k];
  return unset;
}

}  // namespace raceway::correction
