// SPDX-License-Identifier: MIT
#include "fencers.hpp"

namespace fight {

Pair pair_with(const Keys* keys) {
  auto fencer = batuta::fencing::first_fencer<float>();
  if (keys != nullptr) fencer.map = {keys->data(), kColumns, kRows};
  return {fencer, fencer};
}

}  // namespace fight
