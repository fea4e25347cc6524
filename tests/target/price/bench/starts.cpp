// SPDX-License-Identifier: MIT
#include "../scene/runs.hpp"

namespace batuta::price {

/// Two crossed blades, boxes overlapping all the time; the second comes at 1.1 m/s and meets the
/// first a few centimetres off its middle, after about half of the run.
Start blade_start(int i) {
  constexpr float kThird = 0.57735F;
  if (i == 0) {
    return {{0, 0, 0},
            {0.888074F, -0.325058F, 0.325058F, 0},
            {kThird, kThird, kThird},
            {0, 0, 0},
            {0, 0.5F, 0.2F}};
  }
  return {{-0.05F, 0.13F, 0.01F},
          {0.459701F, -0.627963F, 0.627963F, 0},
          {kThird, kThird, -kThird},
          {0.8F, -0.8F, 0.01F},
          {0, 0, 0}};
}

/// Eight balls at the corners of a cube, which fly to its middle, no two at the same speed.
Start ball_start(int i) {
  Start start = blade_start(0);
  const auto side = [i](int bit) { return ((i >> bit) & 1) != 0 ? 0.2F : -0.2F; };
  start.p_W = {side(0), side(1), side(2)};
  start.v_W = -(5 + 0.3F * static_cast<float>(i)) * start.p_W;
  return start;
}

}  // namespace batuta::price
