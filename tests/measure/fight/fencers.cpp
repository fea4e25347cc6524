// SPDX-License-Identifier: MIT
#include "fencers.hpp"

namespace fight {

Pair pair_with(const Keys* keys) {
  auto fencer = batuta::fencing::first_fencer<float>();
  (void)keys;
  return {fencer, fencer};
}

}  // namespace fight
