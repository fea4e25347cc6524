// SPDX-License-Identifier: MIT
#pragma once
// SDL's own virtual joystick in place of hardware.

#include <SDL.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>

#include "programs/live/sdl_stick.hpp"

namespace batuta::test {

/// Attached for as long as this lives, unless it is detached before.
class VirtualStick {
 public:
  explicit VirtualStick(const char* name, SDL_JoystickType type = SDL_JOYSTICK_TYPE_FLIGHT_STICK,
                        int axes = 2, bool rumbles = true)
      : name_(name), type_(type), axes_(axes), rumbles_(rumbles) {
    attach();
  }
  VirtualStick(const VirtualStick&) = delete;
  VirtualStick& operator=(const VirtualStick&) = delete;
  ~VirtualStick() { detach(); }

  void attach() {
    SDL_VirtualJoystickDesc about{};
    about.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    about.type = static_cast<Uint16>(type_);
    about.naxes = static_cast<Uint16>(axes_);
    about.nbuttons = 4;
    about.nhats = 1;
    about.name = name_;
    about.userdata = this;
    if (rumbles_) {
      about.Rumble = [](void* self, Uint16 low, Uint16 high) {
        auto* const stick = static_cast<VirtualStick*>(self);
        stick->strong = low;
        stick->weak = high;
        stick->hardest = std::max<unsigned>(stick->hardest, low);
        return 0;
      };
    }
    const int index = SDL_JoystickAttachVirtualEx(&about);
    ASSERT_GE(index, 0) << SDL_GetError();
    joystick_ = SDL_JoystickOpen(index);
    ASSERT_NE(joystick_, nullptr) << SDL_GetError();
  }

  void detach() {
    if (joystick_ == nullptr) return;
    const SDL_JoystickID instance = SDL_JoystickInstanceID(joystick_);
    SDL_JoystickClose(joystick_);
    joystick_ = nullptr;
    for (int i = 0; i < SDL_NumJoysticks(); ++i) {
      if (SDL_JoystickGetDeviceInstanceID(i) == instance) SDL_JoystickDetachVirtual(i);
    }
  }

  void move(Sint16 x, Sint16 y) {
    SDL_JoystickSetVirtualAxis(joystick_, 0, x);
    SDL_JoystickSetVirtualAxis(joystick_, 1, y);
  }
  void tilt(int axis, Sint16 value) { SDL_JoystickSetVirtualAxis(joystick_, axis, value); }
  void hat(Uint8 value) { SDL_JoystickSetVirtualHat(joystick_, 0, value); }
  void press(int button, bool pressed) {
    SDL_JoystickSetVirtualButton(joystick_, button, pressed ? SDL_PRESSED : SDL_RELEASED);
  }

  std::atomic<unsigned> strong{0};
  std::atomic<unsigned> weak{0};
  std::atomic<unsigned> hardest{0};

 private:
  const char* name_;
  SDL_JoystickType type_;
  int axes_;
  bool rumbles_;
  SDL_Joystick* joystick_ = nullptr;
};

class LiveSdl : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(session_.is_open()) << SDL_GetError();
    if (SDL_NumJoysticks() > 0) GTEST_SKIP() << "there is a real stick";
  }

 private:
  host::SdlSession session_;
};

/// A stick as the program has it.
struct Opened {
  explicit Opened(const std::string& choice = {})
      : stick(std::make_shared<host::SdlStick>(choice)) {
    there = stick->open();
  }
  std::shared_ptr<host::SdlStick> stick;
  bool there = false;
};

}  // namespace batuta::test
