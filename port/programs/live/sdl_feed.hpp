// SPDX-License-Identifier: MIT
#pragma once
// Sticks and pads through SDL: a pad by SDL's mapping, with its left stick, and the right one for
// the feet; anything else with its first two axes, and its first hat for the feet. SDL keeps to
// itself when something was reported; it is asked once a millisecond.

#include <memory>

#include "batuta/core/assert.hpp"
#include "batuta/port/sample_builder.hpp"
#include "platforms/host/clock.hpp"
#include "programs/live/feed.hpp"
#include "programs/live/sdl_stick.hpp"

namespace batuta::host {

class SdlFeed final : public Feed {
 public:
  /// @pre `stick` is open
  explicit SdlFeed(std::shared_ptr<SdlStick> stick);

  std::string name() const override { return stick_->name(); }
  void wait() override;
  News look(InputSample& sample) override;
  bool reopen() override;
  std::uint32_t losses() const override { return 0; }
  void end_thread() override { SDL_TLSCleanup(); }

 private:
  /// As far as it has moved since the last one.
  bool sample_now(SDL_Joystick* handle, InputSample& sample);
  void read_axes(SDL_Joystick* handle);
  std::uint32_t buttons_of(SDL_Joystick* handle) const;

  SdlSession session_;
  std::shared_ptr<SdlStick> stick_;
  HostClock clock_;
  SampleBuilder builder_;
  InputSample last_;
  bool has_spoken_ = false;  ///< since it was opened
};

}  // namespace batuta::host
