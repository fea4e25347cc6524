// SPDX-License-Identifier: MIT
#include "fencers.hpp"

namespace fight {
namespace {

using namespace batuta::fencing;

Fencer<float> fencer_with(const Keys* keys, Who who) {
  Fencer<float> fencer = who == Who::kFirst ? first_fencer<float>() : second_fencer<float>();
  if (keys != nullptr) fencer.map = {keys->data(), kColumns, kRows};
  return fencer;
}

}  // namespace

Pair pair_with(const Keys* keys, Who attacker, Who defender) {
  return {fencer_with(keys, attacker), fencer_with(keys, defender)};
}

}  // namespace fight
