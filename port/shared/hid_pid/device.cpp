// SPDX-License-Identifier: MIT

#include "shared/hid_pid/device.hpp"

#include "batuta/core/assert.hpp"

namespace batuta::pid {
namespace {

Status status_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kTaken:
      return Status::kOk;
    case Verdict::kNoBlock:
      return Status::kStaleHandle;
    case Verdict::kFull:
      return Status::kPoolFull;
    default:
      return Status::kInvalidArgument;
  }
}

bool is_zero(const std::uint8_t* bytes, int count) {
  for (int i = 0; i < count; ++i) {  // Bound: count
    if (bytes[i] != 0) return false;
  }
  return true;
}

Vec2<float> share_of(const Vec2<float>& value, float full) {
  return {clamp(value.x() / full, -1.0F, 1.0F), clamp(value.y() / full, -1.0F, 1.0F)};
}

std::int16_t counts_of(float share) {
  const float counts = share * static_cast<float>(kFullStick);
  return static_cast<std::int16_t>(counts < 0.0F ? counts - 0.5F : counts + 0.5F);
}

}  // namespace

std::uint32_t Counters::refused() const {
  std::uint32_t sum = 0;
  for (const std::uint32_t count : reports) sum += count;  // Bound: kVerdicts
  return sum - count(Verdict::kTaken);
}

DeviceBase::DeviceBase(Effect* effects, int blocks, const Scales& scales)
    : effects_(effects), blocks_(blocks), scales_(scales) {
  BATUTA_ASSERT(is_positive(scales.velocity) && is_positive(scales.acceleration) &&
                is_positive(scales.friction_knee));
}

Status DeviceBase::receive(ReportType type, std::uint8_t id, const std::uint8_t* bytes, int size) {
  const auto name = static_cast<ReportId>(id);
  Verdict verdict = Verdict::kUnknown;
  if (type == ReportType::kOutput) verdict = judge_output(name, bytes, size);
  if (type == ReportType::kFeature) verdict = judge_feature(name, bytes, size);
  ++counters_.reports[static_cast<std::size_t>(verdict)];
  return status_of(verdict);
}

Verdict DeviceBase::judge_output(ReportId id, const std::uint8_t* bytes, int size) {
  switch (id) {
    case ReportId::kSetEffect:
      return take<SetEffect>(bytes, size);
    case ReportId::kSetEnvelope:
      return take<SetEnvelope>(bytes, size);
    case ReportId::kSetCondition:
      return take<SetCondition>(bytes, size);
    case ReportId::kSetPeriodic:
      return take<SetPeriodic>(bytes, size);
    case ReportId::kSetConstant:
      return take<SetConstant>(bytes, size);
    case ReportId::kSetRamp:
      return take<SetRamp>(bytes, size);
    case ReportId::kEffectOperation:
      return take<EffectOperation>(bytes, size);
    case ReportId::kBlockFree:
      return take<BlockFree>(bytes, size);
    case ReportId::kDeviceControl:
      return take<DeviceControl>(bytes, size);
    case ReportId::kDeviceGain:
      return take<DeviceGain>(bytes, size);
    default:
      return Verdict::kUnknown;
  }
}

Verdict DeviceBase::judge_feature(ReportId id, const std::uint8_t* bytes, int size) {
  if (id != ReportId::kCreateNewEffect) return Verdict::kUnknown;
  // Whatever is wrong with it, the host must not take the last block for a new one.
  loaded_block_ = 0;
  load_status_ = LoadStatus::kError;
  return take<CreateNewEffect>(bytes, size);
}

template <class Report>
Verdict DeviceBase::take(const std::uint8_t* bytes, int size) {
  if (size < Report::kSize || !is_zero(bytes + Report::kSize, size - Report::kSize))
    return Verdict::kLength;
  Report report;
  if (!decode(bytes, Report::kSize, report)) return Verdict::kRange;
  const Verdict verdict = apply(report);
  if (size > Report::kSize && verdict == Verdict::kTaken) ++counters_.padded;
  return verdict;
}

/// The parameters of an effect.
template <class Report>
Verdict DeviceBase::apply(const Report& report) {
  Effect* const effect = find(report.block);
  if (effect == nullptr) return Verdict::kNoBlock;
  return effect->set(report) ? Verdict::kTaken : Verdict::kOtherEffect;
}

Verdict DeviceBase::apply(const EffectOperation& report) {
  Effect* const effect = find(report.block);
  if (effect == nullptr) return Verdict::kNoBlock;
  if (report.operation == Operation::kStop) {
    effect->stop();
    return Verdict::kTaken;
  }
  if (report.operation == Operation::kStartSolo) stop_all();
  effect->start(report.loops);
  return Verdict::kTaken;
}

Verdict DeviceBase::apply(const BlockFree& report) {
  Effect* const effect = find(report.block);
  if (effect == nullptr) return Verdict::kNoBlock;
  *effect = Effect();
  return Verdict::kTaken;
}

Verdict DeviceBase::apply(const DeviceControl& report) {
  told_flags_ = false;
  switch (report.control) {
    case Control::kEnableActuators:
    case Control::kDisableActuators:
      enabled_ = report.control == Control::kEnableActuators;
      break;
    case Control::kStopAll:
      stop_all();
      break;
    case Control::kReset:
      reset();
      break;
    case Control::kPause:
    case Control::kContinue:
      paused_ = report.control == Control::kPause;
      break;
  }
  return Verdict::kTaken;
}

Verdict DeviceBase::apply(const DeviceGain& report) {
  gain_ = report.gain;
  return Verdict::kTaken;
}

Verdict DeviceBase::apply(const CreateNewEffect& report) {
  for (int i = 0; i < blocks_; ++i) {  // Bound: the blocks
    if (effects_[i].live()) continue;
    effects_[i] = Effect(report.type);
    created_ = report;
    loaded_block_ = static_cast<std::uint8_t>(i + 1);
    load_status_ = LoadStatus::kSuccess;
    return Verdict::kTaken;
  }
  load_status_ = LoadStatus::kFull;
  return Verdict::kFull;
}

int DeviceBase::answer(std::uint8_t id, std::uint8_t* bytes, int room) const {
  constexpr int kBlockBytes = static_cast<int>(sizeof(Effect));
  static_assert(kMostBlocks * kBlockBytes <= kLongestTime, "the pool's size has 15 bits");
  if (id == static_cast<std::uint8_t>(ReportId::kBlockLoad)) {
    const auto available = static_cast<std::uint16_t>(free_blocks() * kBlockBytes);
    return encode(BlockLoad{loaded_block_, load_status_, available}, bytes, room);
  }
  if (id == static_cast<std::uint8_t>(ReportId::kPool)) {
    Pool pool;
    pool.size = static_cast<std::uint16_t>(blocks_ * kBlockBytes);
    pool.simultaneous = static_cast<std::uint8_t>(blocks_);
    return encode(pool, bytes, room);
  }
  const bool is_creation = id == static_cast<std::uint8_t>(ReportId::kCreateNewEffect);
  return is_creation ? encode(created_, bytes, room) : 0;
}

int DeviceBase::answer_input(std::uint8_t id, std::uint8_t* bytes, int room) const {
  if (id == static_cast<std::uint8_t>(ReportId::kJoystick)) return encode(stick_, bytes, room);
  const bool is_state = id == static_cast<std::uint8_t>(ReportId::kState);
  return is_state ? encode(state_of(0), bytes, room) : 0;
}

/// With the block of this index.
PidState DeviceBase::state_of(int index) const {
  return {paused_,
          enabled_,
          false,
          powered_,
          effects_[index].playing(),
          static_cast<std::uint8_t>(index + 1)};
}

bool DeviceBase::next_state(PidState& report) {
  int changed = told_flags_ ? -1 : 0;
  for (int i = 0; i < blocks_ && changed < 0; ++i) {  // Bound: the blocks
    const bool told = (told_playing_ >> static_cast<unsigned>(i)) % 2U != 0;
    if (effects_[i].playing() != told) changed = i;
  }
  if (changed < 0) return false;
  report = state_of(changed);
  const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(changed);
  told_playing_ = report.playing ? told_playing_ | bit : told_playing_ & ~bit;
  told_flags_ = true;
  return true;
}

Vec2<float> DeviceBase::force(const Stick& stick, Microseconds now) {
  const std::uint32_t step_us = step_to(now);
  const Metrics metrics = metrics_of(stick);
  if (paused_) return {0.0F, 0.0F};
  const Vec2<float> sum = sum_of(metrics, step_us);
  if (!enabled_) return {0.0F, 0.0F};
  const float gain = static_cast<float>(gain_) / static_cast<float>(kFullGain);
  const Vec2<float> whole = sum * gain;
  Vec2<float> force = share_of(whole, 1.0F);
  if (force != whole) ++counters_.clipped;
  return force;
}

Vec2<float> DeviceBase::sum_of(const Metrics& metrics, std::uint32_t step_us) {
  Vec2<float> sum(0.0F, 0.0F);
  for (int i = 0; i < blocks_; ++i) {  // Bound: the blocks
    effects_[i].advance(step_us);
    sum += effects_[i].force(metrics);
  }
  return sum;
}

/// Before the first call no time is known, and it does not matter: nothing plays before it begins.
std::uint32_t DeviceBase::step_to(Microseconds now) {
  const std::int32_t step_us = elapsed_us(last_, now);
  last_ = now;
  return step_us > 0 ? static_cast<std::uint32_t>(step_us) : 0U;
}

Metrics DeviceBase::metrics_of(const Stick& stick) {
  if (!is_finite(stick.position) || !is_finite(stick.velocity) || !is_finite(stick.acceleration)) {
    ++counters_.bad_sticks;
    return {};
  }
  return {share_of(stick.position, 1.0F), share_of(stick.velocity, scales_.velocity),
          share_of(stick.acceleration, scales_.acceleration), scales_.friction_knee};
}

void DeviceBase::reset() {
  for (int i = 0; i < blocks_; ++i) effects_[i] = Effect();  // Bound: the blocks
  paused_ = false;
  enabled_ = true;
  told_flags_ = false;
  loaded_block_ = 0;
  load_status_ = LoadStatus::kError;
}

void DeviceBase::forget_host() {
  reset();
  gain_ = kFullGain;
}

void DeviceBase::stop_all() {
  for (int i = 0; i < blocks_; ++i) effects_[i].stop();  // Bound: the blocks
}

void DeviceBase::tell_actuator(bool powered) {
  if (powered_ != powered) told_flags_ = false;
  powered_ = powered;
}

Effect* DeviceBase::find(std::uint8_t block) {
  const int index = block - 1;
  if (index < 0 || index >= blocks_) return nullptr;
  Effect* const effect = effects_ + index;
  return effect->live() ? effect : nullptr;
}

int DeviceBase::free_blocks() const {
  int count = 0;
  for (int i = 0; i < blocks_; ++i) count += effects_[i].live() ? 0 : 1;  // Bound: the blocks
  return count;
}

int DeviceBase::playing() const {
  int count = 0;
  for (int i = 0; i < blocks_; ++i) count += effects_[i].playing() ? 1 : 0;  // Bound: the blocks
  return count;
}

Joystick joystick_of(const InputSample& sample) {
  return {static_cast<std::uint16_t>(sample.buttons & 0xFFFFU), counts_of(sample.x),
          counts_of(-sample.y)};
}

}  // namespace batuta::pid
