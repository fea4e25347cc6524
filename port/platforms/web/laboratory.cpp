// SPDX-License-Identifier: MIT
// Between the searches and the laboratory page: two capsules that move in a plane and turn in it,
// and what a search says of them with so many distance evaluations. In static memory, from one
// context.

#include <algorithm>
#include <array>

#include "batuta/detection/search.hpp"
#include "batuta/mechanics/trigonometry.hpp"

namespace batuta::web {
namespace {

/// A capsule in the plane, about the middle of its axis. SI units, rad.
struct LabBody {
  float x = 0;
  float y = 0;
  float angle = 0;  ///< 0: the axis is along x
  float v_x = 0;
  float v_y = 0;
  float turn_rate = 0;
  float half_length = 0;
  float radius = 0;
};

/// What is asked and what is answered, in the order that page/lab_search.js repeats.
struct Lab {
  std::array<LabBody, 2> bodies{};
  float duration = 0;   ///< s
  float tolerance = 0;  ///< of Advancement, over S
  float epsilon = 0;    ///< of the paper's stepping, m
  float halvings = 0;   ///< of its bisection
  float t_free = 0;     ///< the answer
  float t_hit = 0;
  float gap = 0;  ///< of the witness, m
  float evaluations = 0;
};

Lab lab;

MovingCapsule<float> moving(const LabBody& body, float duration) {
  const Vec3<float> half(body.half_length, 0, 0);
  const auto turn = detail::sin_cos(0.5F * body.angle);
  MovingCapsule<float> moving;
  moving.capsule_B.axis = {-half, half};
  moving.capsule_B.radius = body.radius;
  moving.motion.X_WB.p_W = Vec3<float>(body.x, body.y, 0);
  moving.motion.X_WB.q_WB = Quat<float>(turn.cos, 0, 0, turn.sin);
  moving.motion.twist = {Vec3<float>(body.v_x, body.v_y, 0), Vec3<float>(0, 0, body.turn_rate)};
  moving.motion.duration = duration;
  return moving;
}

SearchResult<float> ask(const MovingPair<float>& pair, bool is_paper, std::uint32_t most) {
  if (is_paper) {
    SteppingOptions<float> options;
    options.epsilon = lab.epsilon;
    options.unit = EpsilonIn::kMetres;
    options.max_steps = most;
    options.halvings = static_cast<int>(lab.halvings);
    return Stepping<float>::search(pair, options, Vec3<float>::Zero());
  }
  const auto options = Advancement<float>::options(most, lab.tolerance);
  return Advancement<float>::search(pair, options, Vec3<float>::Zero());
}

}  // namespace

extern "C" {

/// Lab.
float* lab_numbers() {
  return &lab.bodies[0].x;
}
int lab_size() {
  return static_cast<int>(sizeof lab / sizeof(float));
}

/// @param is_paper  0: Advancement, with at most `most` evaluations; else the paper's stepping,
/// with at most so many steps
/// @returns an Outcome
int lab_search(int is_paper, int most) {
  const auto pair =
      make_moving_pair(moving(lab.bodies[0], lab.duration), moving(lab.bodies[1], lab.duration));
  if (!pair.ok()) return static_cast<int>(Outcome::kInvalid);
  const auto found = ask(pair.value, is_paper != 0, static_cast<std::uint32_t>(std::max(most, 1)));
  lab.t_free = found.t_free;
  lab.t_hit = found.t_hit;
  lab.gap = found.witness.gap;
  lab.evaluations = static_cast<float>(found.evaluations);
  return static_cast<int>(found.outcome);
}

}  // extern "C"

}  // namespace batuta::web
