// SPDX-License-Identifier: MIT
#include "../scene/runs.hpp"

namespace batuta::price {

namespace {

constexpr float kThird = 0.57735F;

const Start blades[2] = {{{0, 0, 0},
                          {0.888074F, -0.325058F, 0.325058F, 0},
                          {kThird, kThird, kThird},
                          {0, 0, 0},
                          {0, 0.5F, 0.2F}},
                         {{-0.05F, 0.13F, 0.01F},
                          {0.459701F, -0.627963F, 0.627963F, 0},
                          {kThird, kThird, -kThird},
                          {0.8F, -0.8F, 0.01F},
                          {0, 0, 0}}};
Start ball;

}  // namespace

/// Two crossed blades, boxes overlapping all the time; the second comes at 1.1 m/s and meets the
/// first a few centimetres off its middle, after about half of the run.
const Start& blade_start(int i) {
  return blades[i];
}

/// Eight balls at the corners of a cube, which fly to its middle, no two at the same speed.
const Start& ball_start(int i) {
  const auto side = [i](int bit) { return ((i >> bit) & 1) != 0 ? 0.2F : -0.2F; };
  ball = blades[0];
  ball.p_W = {side(0), side(1), side(2)};
  ball.v_W = -(5 + 0.3F * static_cast<float>(i)) * ball.p_W;
  return ball;
}

}  // namespace batuta::price
