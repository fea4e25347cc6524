// SPDX-License-Identifier: MIT
#pragma once
// The members of drivers, for core/archive.hpp.

#include "batuta/response/archive.hpp"
#include "batuta/world/driver.hpp"

namespace batuta {

template <class Scalar>
void archive(Archive& /*ar*/, Fixed<Scalar>& /*driver*/) {}

template <class Scalar>
void archive(Archive& /*ar*/, FreeFlight<Scalar>& /*driver*/) {}

template <class Scalar>
void archive(Archive& ar, Hand<Scalar>& hand) {
  auto& [target_W, step, struck] = hand;
  ar(target_W, step, struck);
}

}  // namespace batuta
