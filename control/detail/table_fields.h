#pragma once

#include <array>
#include <string>
#include <string_view>

#include "control/plan.h"

/// Names of the numbers and texts of a ControlPlan in a table of coefficients. control_csv() writes
/// this table, and read_control_table() reads it.
namespace raceway::control {

template <typename Part>
struct NumberField {
  std::string_view name;
  double Part::*number;
  std::string_view unit;  ///< "u": um per unit of the drive u; "input": unit of the input
  bool required = false;  ///< false: optional, with the default in `Part{}`
  double lowest = -1e30;
  double highest = 1e30;
};

template <typename Part>
struct TextField {
  std::string_view name;
  std::string Part::*text;
  std::string_view allowed{};  ///< allowed words, separated by blanks; empty: any text
};

inline constexpr std::string_view table_mark = "# raceway coefficient table 1";
inline constexpr std::string_view table_header = "of,channel,part,name,value,unit";

using Setting = correction::ControlSettings;
inline constexpr std::array setting_numbers{
    NumberField<Setting>{"longest_gap", &Setting::longest_gap_s, "s", true, 1e-3},
    NumberField<Setting>{"clock_jump", &Setting::clock_jump_s, "s", true, 1e-3},
    NumberField<Setting>{"hold", &Setting::hold_s, "s", true, 0.0},
    NumberField<Setting>{"fade", &Setting::fade_s, "s", true, 0.1}};
inline constexpr std::array setting_texts{
    TextField<Setting>{"on_fault", &Setting::on_fault, " hold last-safe zero "},
    TextField<Setting>{"restart", &Setting::restart, " decay resume rest "},
    TextField<Setting>{"touch_off", &Setting::touch_off, " keep clear "},
    TextField<Setting>{"disabled", &Setting::disabled, " zero freeze "},
    TextField<Setting>{"beyond_range", &Setting::beyond_range, " linear hold "}};

inline constexpr std::array input_numbers{
    NumberField<ControlInput>{"lowest", &ControlInput::lowest, "input"},
    NumberField<ControlInput>{"highest", &ControlInput::highest, "input"},
    NumberField<ControlInput>{"plausible_low", &ControlInput::plausible_low, "input"},
    NumberField<ControlInput>{"plausible_high", &ControlInput::plausible_high, "input"},
    NumberField<ControlInput>{"fastest", &ControlInput::fastest_per_s, "input/s", false, 0.0},
    NumberField<ControlInput>{"stuck", &ControlInput::stuck_s, "s", false, 0.0},
    NumberField<ControlInput>{"smoothing", &ControlInput::smoothing_s, "s", false, 0.0}};

inline constexpr std::array axis_numbers{
    NumberField<ControlAxis>{"offset", &ControlAxis::offset_um, "um", true},
    NumberField<ControlAxis>{"sign", &ControlAxis::sign, "1", true, -1.0, 1.0},
    NumberField<ControlAxis>{"limit", &ControlAxis::limit_um, "um", true, 1e-6},
    NumberField<ControlAxis>{"slew", &ControlAxis::slew_um_s, "um/s", true, 1e-9},
    NumberField<ControlAxis>{"unit", &ControlAxis::unit_um, "um", true, 1e-9}};
inline constexpr std::array axis_texts{
    TextField<ControlAxis>{"name", &ControlAxis::name},
    TextField<ControlAxis>{"axis", &ControlAxis::letter, " x y z u v w a b c "},
    TextField<ControlAxis>{"output", &ControlAxis::output},
    TextField<ControlAxis>{"trust", &ControlAxis::trust, " good within-range do-not-use "},
    TextField<ControlAxis>{"trust_because", &ControlAxis::trust_because}};

inline constexpr std::array section_numbers{
    NumberField<ControlSection>{"gain", &ControlSection::gain, "u", true},
    NumberField<ControlSection>{"time_constant", &ControlSection::time_constant_s, "s", true, 1e-9},
    NumberField<ControlSection>{"direct", &ControlSection::direct, "1"},
    NumberField<ControlSection>{"off_gain", &ControlSection::off_gain, "1"},
    NumberField<ControlSection>{"off_time_constant", &ControlSection::off_time_constant, "1", false,
                                1e-9},
    NumberField<ControlSection>{"speed_factor", &ControlSection::speed_factor, "1", false, 0.0},
    NumberField<ControlSection>{"gain_power", &ControlSection::gain_power, "1"},
    NumberField<ControlSection>{"falling", &ControlSection::falling, "1", false, 1e-9}};

inline constexpr std::array element_numbers{
    NumberField<ControlElement>{"scale", &ControlElement::scale, "1", true},
    NumberField<ControlElement>{"from", &ControlElement::from, "input"},
    NumberField<ControlElement>{"limit", &ControlElement::limit, "input", true, 0.0}};

inline constexpr std::array feedthrough_numbers{
    NumberField<ControlFeedthrough>{"gain", &ControlFeedthrough::gain, "u", true}};

inline constexpr std::array equation_numbers{
    NumberField<ControlEquation>{"scale", &ControlEquation::scale, "1", true},
    NumberField<ControlEquation>{"sampling", &ControlEquation::sampling_s, "s", true, 1e-3}};

inline constexpr std::array kinematic_numbers{
    NumberField<ControlKinematic>{"A", &ControlKinematic::A_um, "um", true},
    NumberField<ControlKinematic>{"B", &ControlKinematic::B, "1", true},
    NumberField<ControlKinematic>{"C", &ControlKinematic::C_per_rpm, "1/rpm", true}};

inline constexpr std::array drive_numbers{
    NumberField<ControlDrive>{"exponent", &ControlDrive::exponent, "1", false, 1e-3},
    NumberField<ControlDrive>{"decay_speed", &ControlDrive::decay_rpm, "rpm", false, 1e-9},
    NumberField<ControlDrive>{"temperature_value", &ControlDrive::temperature_C, "C"},
    NumberField<ControlDrive>{"lowest_power", &ControlDrive::lowest, "W"},
    NumberField<ControlDrive>{"highest_power", &ControlDrive::highest, "W"},
    NumberField<ControlDrive>{"window_from", &ControlDrive::window_from, "input"},
    NumberField<ControlDrive>{"window_full_from", &ControlDrive::window_full_from, "input"},
    NumberField<ControlDrive>{"window_full_to", &ControlDrive::window_full_to, "input"},
    NumberField<ControlDrive>{"window_to", &ControlDrive::window_to, "input"}};
inline constexpr std::array drive_kinds{"rise", "size", "power", "motor"};

}  // namespace raceway::control
