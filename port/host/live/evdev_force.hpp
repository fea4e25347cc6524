// SPDX-License-Identifier: MIT
#pragma once
// Force feedback of the Linux input stack (linux/input.h, Documentation/input/ff.rst): effects are
// uploaded once, played without an end, and from then on only changed. The kernel takes them back
// when the file is closed, also that of a program that has crashed.

#include <array>
#include <string>

#include "host/live/force_backend.hpp"
#include "host/live/linux_effects.hpp"

namespace batuta::host {

class EvdevForce final : public ForceBackend {
 public:
  explicit EvdevForce(std::string path) : path_(std::move(path)) {}
  ~EvdevForce() override;

  /// kForce where the device has FF_CONSTANT, else kRumble where it has FF_RUMBLE.
  ForceKind open() override;
  /// Constant force as two effects, one for each axis, of which only the level changes; as one with
  /// a direction where there is room for one only. Spring and damper where there is room left.
  Rendered render(const Feel& feel) override;
  bool is_there() override;

 private:
  /// An effect on the device.
  struct Slot {
    ff_effect effect{};
    bool uploaded = false;
    bool playing = false;
  };
  enum Place : std::uint8_t { kX, kY, kSpring, kDamper, kPlaces };

  void close();
  bool has(unsigned feature) const;
  void set(unsigned property, std::int32_t value) const;
  Rendered render_constant(const Feel& feel);
  Rendered update(Slot& slot, ff_effect effect) const;

  std::string path_;
  int file_ = -1;
  int room_ = 0;  ///< effects that the device holds at the same time
  std::array<unsigned char, FF_CNT / 8> features_{};
  std::array<Slot, kPlaces> slots_{};
  ForceKind kind_ = ForceKind::kNone;
};

}  // namespace batuta::host
