// SPDX-License-Identifier: MIT
#include "batuta/world/detail/group_motion.hpp"

#include "batuta/geometry/direction.hpp"

// What happens only where bodies go on together is compiled for size.
#define BATUTA_RARE [[gnu::cold, gnu::noinline]]

namespace batuta::detail {
namespace {

// By component and by calls, where expressions would double the code.

template <class Scalar>
BATUTA_RARE Vec3<Scalar> crossed(const Vec3<Scalar>& a, const Vec3<Scalar>& b) {
  return a.cross(b);
}

template <class Scalar>
BATUTA_RARE void add(Vec3<Scalar>& sum, Scalar factor, const Vec3<Scalar>& x) {
  for (int i = 0; i < 3; ++i) sum[i] += factor * x[i];  // Bound: 3
}

template <class Scalar>
BATUTA_RARE Scalar dot(const Vec3<Scalar>& a, const Vec3<Scalar>& b) {
  return a.dot(b);
}

/// x with A x = y of a symmetric A of these columns, by its cofactors; zero where A has none.
template <class Scalar>
BATUTA_RARE Vec3<Scalar> solved(const std::array<Vec3<Scalar>, 3>& A, const Vec3<Scalar>& y) {
  Vec3<Scalar> x;
  Scalar volume = 0;
  for (std::size_t i = 0; i < 3; ++i) {  // Bound: 3
    const Vec3<Scalar> cofactors = crossed(A[(i + 1) % 3], A[(i + 2) % 3]);
    x[static_cast<int>(i)] = dot(y, cofactors);
    volume = dot(A[i], cofactors);
  }
  const Scalar scale = volume > Scalar(0) ? 1 / volume : Scalar(0);
  for (int i = 0; i < 3; ++i) x[i] *= scale;  // Bound: 3
  return x;
}

/// w with I w = L, to the rounding of L: solved twice, the second time for what the first left, in
/// units in which the trace of I is one, because the cube of a small moment would vanish. An
/// inertia that is thinner than rounding about an axis counts as that.
template <class Scalar>
BATUTA_RARE Vec3<Scalar> spin_of(const RigidGroup<Scalar>& group, const Vec3<Scalar>& L_W) {
  constexpr int kTimes = 2;
  constexpr Scalar kLeast = 4 * kRoundOff<Scalar>;
  Vec3<Scalar> w_W = Vec3<Scalar>::Zero();
  std::array<Vec3<Scalar>, 3> stiffer_W = group.inertia_W;
  const Scalar size = stiffer_W[0].x() + stiffer_W[1].y() + stiffer_W[2].z();
  if (!group.turns || !(size > Scalar(0))) return w_W;
  for (std::size_t i = 0; i < 3; ++i) {  // Bound: 3
    stiffer_W[i] /= size;
    stiffer_W[i][static_cast<int>(i)] += kLeast;
  }
  for (int time = 0; time < kTimes; ++time) {  // Bound: kTimes
    Vec3<Scalar> left_W = L_W;
    for (std::size_t i = 0; i < 3; ++i) {  // Bound: 3
      add(left_W, -w_W[static_cast<int>(i)], group.inertia_W[i]);
    }
    left_W /= size;
    add(w_W, Scalar(1), solved(stiffer_W, left_W));
  }
  if (!is_finite(w_W)) w_W.setZero();  // beyond the numbers
  return w_W;
}

}  // namespace

/// By the reduced mass of what is there and what comes: nothing cancels, and two bodies are the
/// problem of two bodies.
template <class Scalar>
BATUTA_RARE void add_to_group(RigidGroup<Scalar>& group, const Body<Scalar>& body) {
  const Scalar mass = 1 / body.inverse_mass;
  const Scalar sum = group.mass + mass;
  const Scalar share = mass / sum;
  const Scalar reduced = share * group.mass;
  Momentum<Scalar>& all = group.momentum;
  const Momentum<Scalar>& own = body.momentum;
  Vec3<Scalar> r_W = body.X_WB.p_W;
  add(r_W, Scalar(-1), group.center_W);
  Vec3<Scalar> relative_W = Vec3<Scalar>::Zero();
  add(relative_W, group.mass / sum, own.linear_W);
  add(relative_W, -share, all.linear_W);
  add(all.angular_W, Scalar(1), own.angular_W);
  add(all.angular_W, Scalar(1), crossed(r_W, relative_W));
  add(all.linear_W, Scalar(1), own.linear_W);
  group.turns = group.turns && is_finite(all.angular_W);
  group.mass = sum;
  add(group.center_W, share, r_W);
  for (std::size_t k = 0; k < 3; ++k) {  // Bound: 3: the angular momentum of a turn about each axis
    Twist<Scalar> turn;
    turn.w_W[static_cast<int>(k)] = 1;
    add(group.inertia_W[k], Scalar(1), momentum_of(body, turn).angular_W);
    add(group.inertia_W[k], reduced, crossed(r_W, crossed(turn.w_W, r_W)));
    group.turns = group.turns && body.inverse_moments[static_cast<int>(k)] > Scalar(0);
    group.turns = group.turns && is_finite(group.inertia_W[k]);
  }
}

template <class Scalar>
void add_to_group(StraightGroup<Scalar>& group, const StraightBody<Scalar>& body) {
  group.mass += 1 / body.inverse_mass;
  group.momentum_W += body.momentum_W;
}

template <class Scalar>
BATUTA_RARE Twist<Scalar> group_twist(const RigidGroup<Scalar>& group, const Vec3<Scalar>& L_W) {
  Twist<Scalar> twist;
  add(twist.v_W, 1 / group.mass, group.momentum.linear_W);
  twist.w_W = spin_of(group, L_W);
  return twist;
}

/// What rounding makes of L . I^-1 L, at most.
template <class Scalar>
BATUTA_RARE Scalar rounding_of_energy(const RigidGroup<Scalar>& group, const Vec3<Scalar>& w_W) {
  constexpr Scalar kUlps = 4;
  const auto& I = group.inertia_W;
  return kUlps * kRoundOff<Scalar> * (I[0].x() + I[1].y() + I[2].z()) * dot(w_W, w_W);
}

/// Each pass turns L back by the turn of the pass before, to L', and turns about I^-1 (L + L') / 2:
/// where that is the axis already, the energy stays (world.md, "Together").
template <class Scalar>
BATUTA_RARE Motion<Scalar> group_motion(const RigidGroup<Scalar>& group, Scalar duration) {
  constexpr Scalar kHalfTurn = Scalar(3.14159265358979323846);
  constexpr int kFewest = 1;  // passes: to second order
  constexpr int kEnough = 4;  // for a turn that loses energy
  constexpr int kMost = 8;
  Motion<Scalar> motion;
  motion.X_WB.p_W = group.center_W;
  motion.duration = duration;
  const Vec3<Scalar>& L_W = group.momentum.angular_W;
  motion.twist = group_twist(group, L_W);
  Vec3<Scalar>& w_W = motion.twist.w_W;
  const Scalar energy = dot(L_W, w_W);
  const Scalar rounding = rounding_of_energy(group, w_W);
  for (int i = 0; i < kMost && duration * length(w_W) < kHalfTurn; ++i) {  // Bound: kMost
    Pose<Scalar> turn = pose_at(motion, duration);
    turn.p_W.setZero();
    Vec3<Scalar> sum_W = to_body(turn, L_W);
    const Scalar gained = dot(sum_W, spin_of(group, sum_W)) - energy;
    const bool is_kept = i >= kFewest && gained >= -rounding;
    if (gained <= rounding && (is_kept || i >= kEnough)) return motion;
    add(sum_W, Scalar(1), L_W);
    w_W = spin_of(group, sum_W);
    w_W /= 2;
  }
  w_W.setZero();
  return motion;
}

template <class Scalar>
StraightMotion<Scalar> group_motion(const StraightGroup<Scalar>& group, Scalar duration) {
  return {Vec3<Scalar>::Zero(), group.momentum_W / group.mass, duration};
}

template <class Scalar>
BATUTA_RARE void take_along(Body<Scalar>& body, const Vec3<Scalar>& from_W,
                            const Pose<Scalar>& X_WG) {
  add(body.X_WB.p_W, Scalar(-1), from_W);
  body.X_WB = {to_world(X_WG, body.X_WB.p_W), composed(X_WG.q_WB, body.X_WB.q_WB)};
  body.flight = {};  // it was turned as no flight of its own turns it
}

template <class Scalar>
BATUTA_RARE void turn_along(Body<Scalar>& body, const Pose<Scalar>& X_WG) {
  body.momentum.angular_W = to_world({Vec3<Scalar>::Zero(), X_WG.q_WB}, body.momentum.angular_W);
}

template <class Scalar>
BATUTA_RARE void give_momentum(Body<Scalar>& body, const Vec3<Scalar>& center_W,
                               const Twist<Scalar>& twist, Momentum<Scalar>& left) {
  Vec3<Scalar> r_W = body.X_WB.p_W;
  add(r_W, Scalar(-1), center_W);
  Twist<Scalar> own = {crossed(twist.w_W, r_W), twist.w_W};
  add(left.angular_W, -1 / body.inverse_mass, crossed(r_W, own.v_W));
  add(own.v_W, Scalar(1), twist.v_W);
  body.momentum = momentum_of(body, own);
  add(left.linear_W, Scalar(-1), body.momentum.linear_W);
  add(left.angular_W, Scalar(-1), body.momentum.angular_W);
}

#define BATUTA_INSTANTIATE(S)                                            \
  template void add_to_group(RigidGroup<S>&, const Body<S>&);            \
  template void add_to_group(StraightGroup<S>&, const StraightBody<S>&); \
  template Motion<S> group_motion(const RigidGroup<S>&, S);              \
  template StraightMotion<S> group_motion(const StraightGroup<S>&, S);   \
  template void take_along(Body<S>&, const Vec3<S>&, const Pose<S>&);    \
  template void turn_along(Body<S>&, const Pose<S>&);                    \
  template Twist<S> group_twist(const RigidGroup<S>&, const Vec3<S>&);   \
  template void give_momentum(Body<S>&, const Vec3<S>&, const Twist<S>&, Momentum<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE
#undef BATUTA_RARE

}  // namespace batuta::detail
