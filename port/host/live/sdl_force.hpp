// SPDX-License-Identifier: MIT
#pragma once
// Force through SDL: endless constant effects of SDL_Haptic, of which only the level changes; where
// the device has none, rumble.

#include <array>
#include <memory>

#include "host/live/force_backend.hpp"
#include "host/live/sdl_effects.hpp"
#include "host/live/sdl_stick.hpp"

namespace batuta::host {

class SdlForce final : public ForceBackend {
 public:
  explicit SdlForce(std::shared_ptr<SdlStick> stick) : stick_(std::move(stick)) {}
  ~SdlForce() override;

  /// kForce where the stick has SDL_HAPTIC_CONSTANT, else kRumble where SDL can shake it.
  ForceKind open() override;
  /// Constant force as two effects, one for each axis; as one with a direction where there is room
  /// for one only; as one to the right for a wheel. Spring and damper where there is room left. A
  /// rumble ends by itself if it is not renewed.
  /// What SDL does not take is a device that is to be opened anew: it says no more than that.
  Rendered render(const Feel& feel) override;
  bool is_there() override;
  void end_thread() override { SDL_TLSCleanup(); }

 private:
  enum Place : std::uint8_t { kX, kY, kSpring, kDamper, kPlaces };
  static constexpr int kNone = -1;

  void close();
  bool open_haptic();
  bool render_constant(const Feel& feel);
  bool update(Place place, SDL_HapticEffect effect);

  SdlSession session_;
  std::shared_ptr<SdlStick> stick_;
  SdlStick::Handle handle_;
  SDL_Haptic* haptic_ = nullptr;
  unsigned features_ = 0;
  int room_ = 0;  ///< effects that the device holds at the same time
  int axes_ = 0;
  std::array<int, kPlaces> effects_{kNone, kNone, kNone, kNone};
  ForceKind kind_ = ForceKind::kNone;
};

}  // namespace batuta::host
