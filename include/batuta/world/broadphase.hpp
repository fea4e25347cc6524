// SPDX-License-Identifier: MIT
#pragma once
// Which pairs can meet at all: those whose swept volumes do [Kavan §3.2].

#include "batuta/core/fixed_list.hpp"
#include "batuta/detection/swept_volume.hpp"

namespace batuta {

/// Two bodies by their slots, first < second.
struct BodyPair {
  std::uint16_t first = 0;
  std::uint16_t second = 0;
};

/// What the broad phase knows of a body.
template <class Scalar>
struct Proxy {
  Aabb<Scalar> swept_W;     ///< holds the body over the time in question
  std::uint16_t owner = 0;  ///< bodies of one owner other than 0 never meet
  bool present = false;     ///< the slot holds a body
  bool is_wall = false;     ///< it is still and nothing can push it: walls may stand in each other
};

/// Whether a contact of the two would have to be found.
template <class Scalar>
bool may_meet(const Proxy<Scalar>& P, const Proxy<Scalar>& Q) {
  const bool same_owner = P.owner != 0 && P.owner == Q.owner;
  return P.present && Q.present && !same_owner && !(P.is_wall && Q.is_wall) &&
         overlaps(P.swept_W, Q.swept_W);
}

/// Calls `found` with every pair that may meet, in ascending order of (first, second).
/// Bound: N (N - 1) / 2 box tests.
template <std::size_t N, class Scalar, class Found>
void for_each_pair(const std::array<Proxy<Scalar>, N>& proxies, const Found& found) {
  for (std::size_t i = 0; i + 1 < N; ++i) {  // Bound: N
    if (!proxies[i].present) continue;
    for (std::size_t k = i + 1; k < N; ++k) {  // Bound: N
      if (may_meet(proxies[i], proxies[k])) {
        found(BodyPair{static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(k)});
      }
    }
  }
}

}  // namespace batuta
