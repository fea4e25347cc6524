// SPDX-License-Identifier: MIT
#pragma once
// Force through SDL: constant effects of SDL_Haptic, of which only the level changes, and which are
// run again before they end; where the device has none, rumble.

#include <array>
#include <memory>

#include "programs/live/mapped_force.hpp"
#include "programs/live/sdl_effects.hpp"
#include "programs/live/sdl_stick.hpp"

namespace batuta::host {

class SdlForce final : public MappedForce {
 public:
  /// SDL says of a call that failed neither why nor whether it is worth another try. So often in a
  /// row, with the stick still attached, it is taken for a refusal.
  static constexpr int kMostFailures = 20;

  explicit SdlForce(std::shared_ptr<SdlStick> stick) : stick_(std::move(stick)) {}
  ~SdlForce() override { shut(); }

  /// kForce where the stick has SDL_HAPTIC_CONSTANT, else kRumble where SDL can shake it.
  ForceKind open() override;
  void close() override { shut(); }
  bool is_there() override;
  void end_thread() override { SDL_TLSCleanup(); }

 private:
  static constexpr int kNone = -1;

  /// A wheel, with one axis, is pushed to the right.
  Taken push_axis(Place axis, std::int16_t level) override;
  Taken push_both(float x, float y) override;
  Taken resist(Place place, const ConditionPair& condition) override;
  /// It ends by itself if it is not renewed.
  Taken shake(const Rumble& rumble) override;
  void remove(Place place) override;

  Abilities open_haptic();
  void shut();
  bool has_hold() const;
  Taken update(Place place, SDL_HapticEffect effect);
  bool run(int id);
  Taken judge(Place place, bool done);

  SdlSession session_;
  std::shared_ptr<SdlStick> stick_;
  SdlStick::Handle handle_;
  SDL_Haptic* haptic_ = nullptr;
  std::array<int, kPlaces> effects_{kNone, kNone, kNone, kNone};
  std::array<int, kPlaces> failures_{};  ///< in a row
  bool shaken_ = false;
};

}  // namespace batuta::host
