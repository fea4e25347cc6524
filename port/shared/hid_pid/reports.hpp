// SPDX-License-Identifier: MIT
#pragma once
// The reports of the report descriptor as plain structures, without their id. Where a field lies
// and what it may be is said once, in exchange(), for reading and for writing: a firmware reads
// output and writes input reports, a test or a host does the opposite. Least significant byte
// first.

#include <cstdint>

#include "shared/hid_pid/limits.hpp"
#include "shared/hid_pid/report_ids.hpp"
#include "shared/link/fields.hpp"

namespace batuta::pid {

using link::Fields;

/// In the order in which the descriptor names them.
enum class EffectType : std::uint8_t {
  kConstant = 1,
  kRamp,
  kSquare,
  kSine,
  kTriangle,
  kSawtoothUp,
  kSawtoothDown,
  kSpring,
  kDamper,
  kInertia,
  kFriction,
};

constexpr bool is_condition(EffectType type) {
  return type >= EffectType::kSpring;
}
constexpr bool is_periodic(EffectType type) {
  return type >= EffectType::kSquare && type <= EffectType::kSawtoothDown;
}

struct SetEffect {
  static constexpr ReportId kId = ReportId::kSetEffect;
  static constexpr int kSize = 17;
  std::uint8_t block = 1;
  EffectType type = EffectType::kConstant;
  std::uint16_t duration_ms = 0;        ///< 0 and kEndless: no end; at most kLongestTime counts
  std::uint16_t trigger_repeat_ms = 0;  ///< any
  std::uint16_t sample_period_ms = 0;   ///< any
  std::uint16_t start_delay_ms = 0;     ///< at most kLongestTime counts
  std::uint8_t gain = kFullGain;
  std::uint8_t trigger_button = 0;  ///< any
  bool axis_x = false;
  bool axis_y = false;
  bool has_direction = true;
  std::uint16_t direction = 0;    ///< 0 ... kFullTurn, clockwise from north
  std::uint16_t direction_2 = 0;  ///< the angle of a third axis, which there is none of: any
};

struct SetEnvelope {
  static constexpr ReportId kId = ReportId::kSetEnvelope;
  static constexpr int kSize = 9;
  std::uint8_t block = 1;
  std::uint16_t attack_level = 0;
  std::uint16_t fade_level = 0;
  std::uint16_t attack_ms = 0;  ///< at most kLongestTime counts
  std::uint16_t fade_ms = 0;    ///< likewise
};

struct SetCondition {
  static constexpr ReportId kId = ReportId::kSetCondition;
  static constexpr int kSize = 14;
  std::uint8_t block = 1;
  std::uint8_t offset = 0;  ///< parameter block: 0 for the first axis, 1 for the second
  std::int16_t centre = 0;
  std::int16_t positive_coefficient = 0;
  std::int16_t negative_coefficient = 0;
  std::uint16_t positive_saturation = 0;
  std::uint16_t negative_saturation = 0;
  std::uint16_t dead_band = 0;
};

struct SetPeriodic {
  static constexpr ReportId kId = ReportId::kSetPeriodic;
  static constexpr int kSize = 9;
  std::uint8_t block = 1;
  std::uint16_t magnitude = 0;
  std::int16_t offset = 0;
  std::uint16_t phase = 0;      ///< 0 ... kFullTurn
  std::uint16_t period_ms = 0;  ///< 0: stands still at its phase; at most kLongestTime counts
};

struct SetConstant {
  static constexpr ReportId kId = ReportId::kSetConstant;
  static constexpr int kSize = 3;
  std::uint8_t block = 1;
  std::int16_t magnitude = 0;
};

struct SetRamp {
  static constexpr ReportId kId = ReportId::kSetRamp;
  static constexpr int kSize = 5;
  std::uint8_t block = 1;
  std::int16_t start = 0;
  std::int16_t end = 0;
};

enum class Operation : std::uint8_t { kStart = 1, kStartSolo, kStop };

struct EffectOperation {
  static constexpr ReportId kId = ReportId::kEffectOperation;
  static constexpr int kSize = 3;
  std::uint8_t block = 1;
  Operation operation = Operation::kStart;
  std::uint8_t loops = 1;  ///< kEndlessLoops: no end; 0: once
};

struct BlockFree {
  static constexpr ReportId kId = ReportId::kBlockFree;
  static constexpr int kSize = 1;
  std::uint8_t block = 1;
};

enum class Control : std::uint8_t {
  kEnableActuators = 1,
  kDisableActuators,
  kStopAll,
  kReset,
  kPause,
  kContinue,
};

struct DeviceControl {
  static constexpr ReportId kId = ReportId::kDeviceControl;
  static constexpr int kSize = 1;
  Control control = Control::kEnableActuators;
};

struct DeviceGain {
  static constexpr ReportId kId = ReportId::kDeviceGain;
  static constexpr int kSize = 1;
  std::uint8_t gain = kFullGain;
};

struct CreateNewEffect {
  static constexpr ReportId kId = ReportId::kCreateNewEffect;
  static constexpr int kSize = 3;
  EffectType type = EffectType::kConstant;
  std::uint16_t byte_count = 0;  ///< of a custom force, which there is none: any
};

enum class LoadStatus : std::uint8_t { kSuccess = 1, kFull, kError };

/// What became of the last CreateNewEffect.
struct BlockLoad {
  static constexpr ReportId kId = ReportId::kBlockLoad;
  static constexpr int kSize = 4;
  std::uint8_t block = 0;  ///< 0: none
  LoadStatus status = LoadStatus::kError;
  std::uint16_t available = 0;  ///< bytes of the pool that are free
};

struct Pool {
  static constexpr ReportId kId = ReportId::kPool;
  static constexpr int kSize = 4;
  std::uint16_t size = 0;          ///< bytes
  std::uint8_t simultaneous = 0;   ///< effects that play at the same time
  bool device_managed = true;      ///< the device chooses the blocks
  bool shared_parameters = false;  ///< an effect's parameters are its own
};

/// Input: sent when it changes.
struct PidState {
  static constexpr ReportId kId = ReportId::kState;
  static constexpr int kSize = 2;
  bool paused = false;
  bool actuators_enabled = true;
  bool actuator_override = false;
  bool actuator_power = false;
  bool playing = false;    ///< that block
  std::uint8_t block = 1;  ///< 1 ... kMostBlocks
};

/// Input: the stick. Y as HID has it: positive towards the user.
struct Joystick {
  static constexpr ReportId kId = ReportId::kJoystick;
  static constexpr int kSize = 6;
  std::uint16_t buttons = 0;
  std::int16_t x = 0;
  std::int16_t y = 0;
};

/// Reads or writes the fields of a report; the first that is out of its range spoils it.
/// Bound: its kSize bytes. Allocates: never. ISR-safe: yes.
void exchange(Fields& fields, SetEffect& report);
void exchange(Fields& fields, SetEnvelope& report);
void exchange(Fields& fields, SetCondition& report);
void exchange(Fields& fields, SetPeriodic& report);
void exchange(Fields& fields, SetConstant& report);
void exchange(Fields& fields, SetRamp& report);
void exchange(Fields& fields, EffectOperation& report);
void exchange(Fields& fields, BlockFree& report);
void exchange(Fields& fields, DeviceControl& report);
void exchange(Fields& fields, DeviceGain& report);
void exchange(Fields& fields, CreateNewEffect& report);
void exchange(Fields& fields, BlockLoad& report);
void exchange(Fields& fields, Pool& report);
void exchange(Fields& fields, PidState& report);
void exchange(Fields& fields, Joystick& report);

/// @returns true | false: a wrong length, or a field out of its range; `report` is then unchanged
template <class Report>
bool decode(const std::uint8_t* bytes, int size, Report& report) {
  if (size != Report::kSize) return false;
  Report read;
  Fields fields = Fields::reader(bytes, size);
  exchange(fields, read);
  if (fields.good()) report = read;
  return fields.good();
}

/// @returns Report::kSize | 0: a field is out of its range, or there is less room than that
template <class Report>
int encode(Report report, std::uint8_t* bytes, int room) {
  Fields fields = Fields::writer(bytes, room);
  exchange(fields, report);
  return fields.good() ? Report::kSize : 0;
}

}  // namespace batuta::pid
