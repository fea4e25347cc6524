// SPDX-License-Identifier: MIT
#pragma once
// How what a hand is to feel becomes effects, for every API alike, best first: a constant force for
// each axis, with spring and damper where there is room left; one constant force with a direction;
// rumble; nothing. A device that announces an effect and then does not take it goes one down, and
// is neither lost nor opened anew for it.

#include <string>

#include "programs/live/force_backend.hpp"

namespace batuta::host {

class MappedForce : public ForceBackend {
 public:
  ForceKind kind() const final { return kind_; }
  Rendered render(const Feel& feel) final;
  void renew() final { renews_ = true; }
  EffectSet left_out() const final { return left_out_; }
  std::string problem() const final { return problem_; }

 protected:
  /// What became of one effect; the worse, the greater.
  enum class Taken : std::uint8_t { kDone, kLater, kRefused, kGone };
  enum Place : std::uint8_t { kX, kY, kSpring, kDamper, kPlaces };

  struct Abilities {
    EffectSet effects;
    int room = 0;  ///< effects that the device holds at the same time
    int axes = 2;
  };

  /// A device has been opened. @returns its kind; kNone: it has neither room nor an effect for that
  ForceKind begin(const Abilities& abilities);
  /// It has been closed. @param problem  why, as problem() says it
  void end(const std::string& problem);
  /// Whether an effect that was played is to be played again.
  bool renews() const { return renews_; }

 private:
  // Each uploads the effect of a place, or changes it, and sees to it that it plays; where
  // it is to renews(), from now on. One that is refused is not on the device afterwards.
  virtual Taken push_axis(Place axis, std::int16_t level) = 0;
  virtual Taken push_both(float x, float y) = 0;                          ///< in place kX
  virtual Taken resist(Place place, const ConditionPair& condition) = 0;  ///< kSpring or kDamper
  /// In place kX. No rumble is silence at once, not the effect's end by itself.
  virtual Taken shake(const Rumble& rumble) = 0;
  /// Takes an effect off the device, if it is there.
  virtual void remove(Place place) = 0;

  Taken push(const Feel& feel);
  Taken overlay(const Feel& feel);
  void step_down();
  void note_left_out(const Feel& feel);

  Abilities abilities_;
  EffectSet left_out_;  ///< of all that was wanted since begin(), also what it does not announce
  EffectSet refused_;   ///< since begin()
  EffectSet overlaid_;  ///< of spring and damper, those on the device
  std::string problem_;
  ForceKind kind_ = ForceKind::kNone;
  bool renews_ = false;
};

}  // namespace batuta::host
