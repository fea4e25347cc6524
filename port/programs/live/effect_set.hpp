// SPDX-License-Identifier: MIT
#pragma once
// Kinds of effects, as a set: what a device offers, what it does not take.

#include <cstdint>
#include <string>

namespace batuta::host {

enum class Effect : std::uint8_t { kConstant, kSpring, kDamper, kRumble };
inline constexpr int kEffects = 4;

class EffectSet {
 public:
  EffectSet& add(Effect effect) {
    bits_ |= bit(effect);
    return *this;
  }
  EffectSet& add(EffectSet others) {
    bits_ |= others.bits_;
    return *this;
  }
  bool has(Effect effect) const { return (bits_ & bit(effect)) != 0; }
  bool empty() const { return bits_ == 0; }

 private:
  static unsigned bit(Effect effect) { return 1U << static_cast<unsigned>(effect); }

  unsigned bits_ = 0;
};

/// "constant, spring", for a message.
std::string names_of(EffectSet effects);

}  // namespace batuta::host
