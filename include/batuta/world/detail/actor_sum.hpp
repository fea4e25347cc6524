// SPDX-License-Identifier: MIT
#pragma once
// What a caller may change of an actor besides its pose and momenta, as one number: it tells
// whether what sleeps, or carries a sleeper, is what it was (src/world/world.md, "Sleep").

#include <cstring>
#include <limits>

#include "batuta/world/actor.hpp"

namespace batuta::detail {

/// FNV-1a over words of 32 bits, of which each product is folded: a product carries upwards alone,
/// so that two signs that change would cancel.
class BitSum {
 public:
  void add(std::uint32_t word) {
    sum_ = (sum_ ^ word) * kPrime;
    sum_ ^= sum_ >> 15U;
  }
  /// Its bits; all that are no number are one, as in an archive: sign and payload are left open by
  /// IEEE 754. Bound: the words of a number.
  template <class Scalar>
  void add_number(Scalar number) {
    if (!(number == number)) number = std::numeric_limits<Scalar>::quiet_NaN();
    constexpr std::size_t kWords = sizeof(Scalar) / sizeof(std::uint32_t);
    std::array<std::uint32_t, kWords> words;
    std::memcpy(words.data(), &number, sizeof number);
    for (const std::uint32_t word : words) add(word);  // Bound: kWords
  }
  template <class Scalar>
  void add_vector(const Vec3<Scalar>& v) {
    for (int i = 0; i < 3; ++i) add_number(v(i));  // Bound: 3
  }
  std::uint32_t value() const { return sum_; }

 private:
  static constexpr std::uint32_t kPrime = 16777619U;
  std::uint32_t sum_ = 2166136261U;
};

/// Of its shape, mass, friction, and of whom it meets. Bound: kCapsulesPerBody.
template <class SceneT>
std::uint32_t sum_of(const Actor<SceneT>& actor) {
  BitSum sum;
  for (int i = 0; i < parts_of(actor); ++i) {  // Bound: kCapsulesPerBody
    const auto& capsule = part_of(actor, i);
    sum.add_vector(capsule.axis.a);
    sum.add_vector(capsule.axis.b);
    sum.add_number(capsule.radius);
  }
  sum.add_number(actor.body.inverse_mass);
  sum.add_vector(actor.body.inverse_moments);
  if constexpr (SceneT::kFriction) sum.add_number(actor.friction);
  if constexpr (SceneT::kRollingResistance) sum.add_number(actor.rolling_resistance);
  if constexpr (SceneT::kOwners) sum.add(actor.owner);
  if constexpr (SceneT::kFilters) {
    sum.add(std::uint32_t{actor.filter.groups} << 16U | actor.filter.meets);
  }
  return sum.value();
}

}  // namespace batuta::detail
