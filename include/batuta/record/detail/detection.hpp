// SPDX-License-Identifier: MIT
#pragma once
// The members of the options of room detection, for record/archive.hpp.

#include "batuta/detection/advancement.hpp"
#include "batuta/detection/stepping.hpp"
#include "batuta/record/detail/mechanics.hpp"

namespace batuta {

constexpr EpsilonIn last_of(EpsilonIn) {
  return EpsilonIn::kMetres;
}

template <class Scalar>
void archive(Archive& ar, AdvancementOptions<Scalar>& options) {
  auto& [contact_tolerance, budget] = options;
  ar(contact_tolerance, budget);
}

template <class Scalar>
void archive(Archive& ar, SteppingOptions<Scalar>& options) {
  auto& [epsilon, unit, max_steps, halvings] = options;
  ar(epsilon, unit, max_steps, halvings);
}

}  // namespace batuta
