// SPDX-License-Identifier: MIT
#pragma once
// Force feedback of the Linux input stack (linux/input.h, Documentation/input/ff.rst): effects are
// uploaded once, played, and from then on only changed, and played again before they end. The
// kernel takes them back when the file is closed, also that of a program that has crashed; they end
// by themselves where the program is stopped.

#include <array>
#include <memory>
#include <string>

#include "programs/live/claim.hpp"
#include "programs/live/linux_effects.hpp"
#include "programs/live/mapped_force.hpp"

namespace batuta::host {

class EvdevForce final : public MappedForce {
 public:
  /// @param claim  of whoever reads the device: only what that has is opened. Null: whatever is
  ///   there
  explicit EvdevForce(std::string path, std::shared_ptr<const Claim> claim = nullptr)
      : path_(std::move(path)), claim_(std::move(claim)) {}
  ~EvdevForce() override { shut(); }

  /// kForce where the device has FF_CONSTANT, else kRumble where it has FF_RUMBLE.
  ForceKind open() override;
  void close() override { shut(); }
  bool is_there() override;

 private:
  /// An effect on the device.
  struct Slot {
    ff_effect effect{};
    bool uploaded = false;
    bool playing = false;  ///< it was told to, and not to stop; it may have ended since
  };
  using Features = std::array<unsigned char, FF_CNT / 8>;

  Taken push_axis(Place axis, std::int16_t level) override;
  Taken push_both(float x, float y) override;
  Taken resist(Place place, const ConditionPair& condition) override;
  Taken shake(const Rumble& rumble) override;
  void remove(Place place) override;

  static Abilities abilities(int file, Features& features);
  std::string why_not_opened(int error) const;
  void shut();
  void set(unsigned property, std::int32_t value) const;
  Taken judge(int error) const;
  Taken update(Place place, const ff_effect& effect);
  Taken upload(Place place, ff_effect effect);
  Taken play(Place place, bool on);

  std::string path_;
  std::shared_ptr<const Claim> claim_;
  int file_ = -1;
  std::array<Slot, kPlaces> slots_{};
};

}  // namespace batuta::host
