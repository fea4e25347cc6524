// SPDX-License-Identifier: MIT
#pragma once
// The report descriptor of a stick with two axes, sixteen buttons and force feedback: what a host
// reads to know the reports of reports.hpp. Constant data, made while compiling. The order of
// fields here is the order of bytes there; a test parses the one and packs the other. Source:
// PID 1.0; nesting as the Linux driver hid-pidff looks for it.

#include "shared/hid_pid/items.hpp"
#include "shared/hid_pid/limits.hpp"
#include "shared/hid_pid/report_ids.hpp"

namespace batuta::pid {
namespace descriptor {

inline constexpr int kSeconds = 0x1003;  ///< unit: time, English linear, as other devices have it
inline constexpr int kDegrees = 0x14;    ///< unit: angle, English rotation

inline constexpr Number kFlag{0, 1, 0, 1, 1};
inline constexpr Number kLevel{0, kFullLevel, 0, kFullLevel, 16};
inline constexpr Number kSignedLevel{-kFullLevel, kFullLevel, -kFullLevel, kFullLevel, 16};
inline constexpr Number kMilliseconds{0, kLongestTime, 0, kLongestTime, 16, kSeconds, -3};
inline constexpr Number kHundredthDegrees{0, kFullTurn, 0, 36000, 16, kDegrees, -2};
inline constexpr Number kGain{0, kFullGain, 0, kFullLevel, 8};
inline constexpr Number kByte{0, 255, 0, 255, 8};
inline constexpr Number kWord{0, kLongestTime, 0, kLongestTime, 16};
inline constexpr Number kStick{-kFullStick, kFullStick, -kFullStick, kFullStick, 16};

constexpr Number block_number(int blocks) {
  return {1, blocks, 1, blocks, 8};
}

/// Opens a report's collection.
constexpr void open(Items& d, Usage name, ReportId id) {
  d.begin(Collection::kLogical, name);
  d.report(static_cast<std::uint8_t>(id));
}

constexpr void joystick(Items& d) {
  d.report(static_cast<std::uint8_t>(ReportId::kJoystick));
  d.values_from(Way::kInput, kFlag, Usage::kFirstButton, kButtons);
  d.values(Way::kInput, kStick, {Usage::kX, Usage::kY});
}

constexpr void state(Items& d, int blocks) {
  open(d, Usage::kStateReport, ReportId::kState);
  d.values(Way::kInput, kFlag, {Usage::kDevicePaused, Usage::kActuatorsEnabled});
  // Not the safety switch: Linux has one key for it and for the sixteenth button.
  d.padding(Way::kInput, 1);
  d.values(Way::kInput, kFlag, {Usage::kActuatorOverride, Usage::kActuatorPower});
  d.padding(Way::kInput, 3);
  d.values(Way::kInput, kFlag, {Usage::kEffectPlaying});
  d.values(Way::kInput, {1, blocks, 1, blocks, 7}, {Usage::kEffectBlockIndex});
  d.end();
}

constexpr void effect_type(Items& d, Way way) {
  d.begin(Collection::kLogical, Usage::kEffectType);
  d.choice(way, {Usage::kConstantForce, Usage::kRamp, Usage::kSquare, Usage::kSine,
                 Usage::kTriangle, Usage::kSawtoothUp, Usage::kSawtoothDown, Usage::kSpring,
                 Usage::kDamper, Usage::kInertia, Usage::kFriction});
  d.end();
}

constexpr void set_effect(Items& d, int blocks) {
  constexpr Way kOut = Way::kOutput;
  open(d, Usage::kSetEffectReport, ReportId::kSetEffect);
  d.values(kOut, block_number(blocks), {Usage::kEffectBlockIndex});
  effect_type(d, kOut);
  d.values(
      kOut, kMilliseconds,
      {Usage::kDuration, Usage::kTriggerRepeatInterval, Usage::kSamplePeriod, Usage::kStartDelay});
  d.values(kOut, kGain, {Usage::kGain});
  d.values(kOut, {0, kButtons, 0, kButtons, 8}, {Usage::kTriggerButton});
  d.begin(Collection::kLogical, Usage::kAxesEnable);
  d.values(kOut, kFlag, {Usage::kX, Usage::kY});
  d.end();
  d.values(kOut, kFlag, {Usage::kDirectionEnable});
  d.padding(kOut, 5);
  d.begin(Collection::kLogical, Usage::kDirection);
  d.values(kOut, kHundredthDegrees, {Usage::kInstance1, Usage::kInstance2});
  d.end();
  d.end();
}

constexpr void parameters(Items& d, int blocks) {
  constexpr Way kOut = Way::kOutput;
  const Number block = block_number(blocks);
  open(d, Usage::kSetEnvelopeReport, ReportId::kSetEnvelope);
  d.values(kOut, block, {Usage::kEffectBlockIndex});
  d.values(kOut, kLevel, {Usage::kAttackLevel, Usage::kFadeLevel});
  d.values(kOut, kMilliseconds, {Usage::kAttackTime, Usage::kFadeTime});
  d.end();
  open(d, Usage::kSetConditionReport, ReportId::kSetCondition);
  d.values(kOut, block, {Usage::kEffectBlockIndex});
  d.values(kOut, {0, 1, 0, 1, 8}, {Usage::kParameterBlockOffset});
  d.values(kOut, kSignedLevel,
           {Usage::kCentreOffset, Usage::kPositiveCoefficient, Usage::kNegativeCoefficient});
  d.values(kOut, kLevel,
           {Usage::kPositiveSaturation, Usage::kNegativeSaturation, Usage::kDeadBand});
  d.end();
  open(d, Usage::kSetPeriodicReport, ReportId::kSetPeriodic);
  d.values(kOut, block, {Usage::kEffectBlockIndex});
  d.values(kOut, kLevel, {Usage::kMagnitude});
  d.values(kOut, kSignedLevel, {Usage::kOffset});
  d.values(kOut, kHundredthDegrees, {Usage::kPhase});
  d.values(kOut, kMilliseconds, {Usage::kPeriod});
  d.end();
  open(d, Usage::kSetConstantForceReport, ReportId::kSetConstant);
  d.values(kOut, block, {Usage::kEffectBlockIndex});
  d.values(kOut, kSignedLevel, {Usage::kMagnitude});
  d.end();
  open(d, Usage::kSetRampForceReport, ReportId::kSetRamp);
  d.values(kOut, block, {Usage::kEffectBlockIndex});
  d.values(kOut, kSignedLevel, {Usage::kRampStart, Usage::kRampEnd});
  d.end();
}

constexpr void operations(Items& d, int blocks) {
  constexpr Way kOut = Way::kOutput;
  const Number block = block_number(blocks);
  open(d, Usage::kEffectOperationReport, ReportId::kEffectOperation);
  d.values(kOut, block, {Usage::kEffectBlockIndex});
  d.begin(Collection::kLogical, Usage::kEffectOperation);
  d.choice(kOut, {Usage::kEffectStart, Usage::kEffectStartSolo, Usage::kEffectStop});
  d.end();
  d.values(kOut, kByte, {Usage::kLoopCount});
  d.end();
  open(d, Usage::kBlockFreeReport, ReportId::kBlockFree);
  d.values(kOut, block, {Usage::kEffectBlockIndex});
  d.end();
  open(d, Usage::kDeviceControlReport, ReportId::kDeviceControl);
  d.begin(Collection::kLogical, Usage::kDeviceControl);
  d.choice(kOut, {Usage::kEnableActuators, Usage::kDisableActuators, Usage::kStopAllEffects,
                  Usage::kDeviceReset, Usage::kDevicePause, Usage::kDeviceContinue});
  d.end();
  d.end();
  open(d, Usage::kDeviceGainReport, ReportId::kDeviceGain);
  d.values(kOut, kGain, {Usage::kDeviceGain});
  d.end();
}

constexpr void pool(Items& d, int blocks) {
  constexpr Way kBoth = Way::kFeature;
  open(d, Usage::kCreateNewEffectReport, ReportId::kCreateNewEffect);
  effect_type(d, kBoth);
  d.values(kBoth, kWord, {Usage::kByteCount});
  d.end();
  open(d, Usage::kBlockLoadReport, ReportId::kBlockLoad);
  d.values(kBoth, block_number(blocks), {Usage::kEffectBlockIndex});
  d.begin(Collection::kLogical, Usage::kBlockLoadStatus);
  d.choice(kBoth, {Usage::kBlockLoadSuccess, Usage::kBlockLoadFull, Usage::kBlockLoadError});
  d.end();
  d.values(kBoth, kWord, {Usage::kRamPoolAvailable});
  d.end();
  open(d, Usage::kPoolReport, ReportId::kPool);
  d.values(kBoth, kWord, {Usage::kRamPoolSize});
  d.values(kBoth, kByte, {Usage::kSimultaneousEffects});
  d.values(kBoth, kFlag, {Usage::kDeviceManagedPool, Usage::kSharedParameterBlocks});
  d.padding(kBoth, 6);
  d.end();
}

constexpr Items all(int blocks) {
  Items d;
  d.begin(Collection::kApplication, Usage::kJoystick);
  joystick(d);
  state(d, blocks);
  set_effect(d, blocks);
  parameters(d, blocks);
  operations(d, blocks);
  pool(d, blocks);
  d.end();
  return d;
}

template <int kBlocks>
constexpr auto bytes() {
  static_assert(kBlocks >= kFewestBlocks && kBlocks <= kMostBlocks, "see limits.hpp");
  constexpr Items items = all(kBlocks);
  std::array<std::uint8_t, items.size()> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = items[i];  // Bound: the descriptor
  return bytes;
}

}  // namespace descriptor

/// The bytes, for a device with kBlocks effect blocks.
template <int kBlocks>
inline constexpr auto kReportDescriptor = descriptor::bytes<kBlocks>();

}  // namespace batuta::pid
