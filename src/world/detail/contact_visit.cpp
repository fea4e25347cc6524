// SPDX-License-Identifier: MIT
#include "batuta/world/detail/lasting_contact.hpp"

namespace batuta::detail {
namespace {

/// The normals of a contact's points, while they are visited: its moments on both bodies, and what
/// is asked of it.
template <class Scalar>
struct NormalSide {
  Vec3<Scalar> moment_A_W = Vec3<Scalar>::Zero();  ///< of a unit impulse, m
  Vec3<Scalar> moment_B_W = Vec3<Scalar>::Zero();
  Scalar softness = 0;  ///< 1/kg
  Scalar rate = 0;      ///< along the normal, less what it may be, m/s
  Scalar impulse = 0;   ///< so far, N s
  Scalar change = 0;    ///< of it, N s
};

/// The impulse that leaves no approach, if the other point stays as it is.
template <class Scalar>
Scalar alone(const NormalSide<Scalar>& side) {
  if (!(side.softness > Scalar(0))) return Scalar(0);
  return max_of(Scalar(0), side.impulse - side.rate / side.softness) - side.impulse;
}

/// One of two presses; the other one lets go. @returns whether that is the solution
template <class Scalar>
bool solve_one(NormalSide<Scalar>& on, NormalSide<Scalar>& off, Scalar mutual) {
  off.change = -off.impulse;
  on.change = -(on.rate + mutual * off.change) / on.softness;
  const Scalar left = off.rate + mutual * on.change + off.softness * off.change;
  return !(on.impulse + on.change < Scalar(0)) && !(left < Scalar(0));
}

/// The impulses of two normals at which neither approaches, and one that parts does not press: the
/// least of the energy over both (world.md, "Contacts that last"). The same for either of the two.
/// @param mutual  what an impulse along one does along the other, 1/kg
/// @returns false: not to be told apart, or not to be told by rounding
template <class Scalar>
bool solve_both(NormalSide<Scalar>& P, NormalSide<Scalar>& Q, Scalar mutual) {
  constexpr Scalar kSingular = 16 * kRoundOff<Scalar>;
  const Scalar product = P.softness * Q.softness;
  const Scalar det = product - mutual * mutual;
  if (!(det > kSingular * product)) return false;
  P.change = (mutual * Q.rate - Q.softness * P.rate) / det;
  Q.change = (mutual * P.rate - P.softness * Q.rate) / det;
  if (!(P.impulse + P.change < Scalar(0)) && !(Q.impulse + Q.change < Scalar(0))) return true;
  P.change = -P.impulse;
  Q.change = -Q.impulse;
  const Scalar left_P = P.rate + P.softness * P.change + mutual * Q.change;
  const Scalar left_Q = Q.rate + Q.softness * Q.change + mutual * P.change;
  if (!(left_P < Scalar(0)) && !(left_Q < Scalar(0))) return true;
  return solve_one(P, Q, mutual) || solve_one(Q, P, mutual);
}

template <class Traits, class Scalar>
NormalSide<Scalar> side_of(const ContactPoint<Traits>& point, const SolvedBody<Scalar>& A,
                           const SolvedBody<Scalar>& B) {
  NormalSide<Scalar> side;
  side.moment_A_W = point.arm_A_W.cross(point.normal_W);
  side.moment_B_W = arm_B(point, A, B).cross(point.normal_W);
  side.rate =
      point.normal_W.dot(A.v_W - B.v_W) + A.w_W.dot(side.moment_A_W) - B.w_W.dot(side.moment_B_W);
  return side;
}

/// Both ends of a line together; each alone, the second after the first, where they cannot be told
/// apart. @returns what it adds to the energy, J
template <class Traits, class Scalar>
Scalar push_line(const LastingContact<Traits>& contact, NormalSide<Scalar>& P,
                 NormalSide<Scalar>& Q, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B) {
  const Scalar first = alone(P);
  if (first == Scalar(0) && alone(Q) == Scalar(0)) return Scalar(0);
  const Vec3<Scalar>& n_P = contact.points.front().normal_W;
  const Vec3<Scalar>& n_Q = contact.points.back().normal_W;
  const Vec3<Scalar> turn_A = A.inverse_inertia_W * P.moment_A_W;
  const Vec3<Scalar> turn_B = B.inverse_inertia_W * P.moment_B_W;
  const Scalar mutual = (A.inverse_mass + B.inverse_mass) * n_P.dot(n_Q) +
                        Q.moment_A_W.dot(turn_A) + Q.moment_B_W.dot(turn_B);
  if (!solve_both(P, Q, mutual)) {
    P.change = first;
    NormalSide<Scalar> after = Q;
    after.rate += mutual * first;
    Q.change = alone(after);
  }
  const Vec3<Scalar> J_W = P.change * n_P + Q.change * n_Q;
  A.v_W += A.inverse_mass * J_W;
  B.v_W -= B.inverse_mass * J_W;
  A.w_W += A.inverse_inertia_W * (P.change * P.moment_A_W + Q.change * Q.moment_A_W);
  B.w_W -= B.inverse_inertia_W * (P.change * P.moment_B_W + Q.change * Q.moment_B_W);
  return P.change * (P.rate + P.softness * P.change / 2) +
         Q.change * (Q.rate + Q.softness * Q.change / 2) + mutual * P.change * Q.change;
}

template <class Traits>
using NormalSides =
    std::array<NormalSide<typename Traits::Scalar>, LastingContact<Traits>::kPoints>;

/// Solves the normals of a contact, and gives both bodies what that changes.
/// @returns what it adds to the energy, J, <= 0 but for rounding
template <class Traits, class Scalar>
Scalar push_normals(const LastingContact<Traits>& contact, NormalSides<Traits>& sides,
                    SolvedBody<Scalar>& A, SolvedBody<Scalar>& B) {
  if (contact.count > 1) return push_line(contact, sides.front(), sides.back(), A, B);
  NormalSide<Scalar>& side = sides.front();
  side.change = alone(side);
  if (side.change == Scalar(0)) return Scalar(0);
  const Vec3<Scalar>& normal_W = contact.points.front().normal_W;
  A.v_W += (A.inverse_mass * side.change) * normal_W;
  B.v_W -= (B.inverse_mass * side.change) * normal_W;
  A.w_W += A.inverse_inertia_W * (side.change * side.moment_A_W);
  B.w_W -= B.inverse_inertia_W * (side.change * side.moment_B_W);
  return side.change * (side.rate + side.softness * side.change / 2);
}

/// The impulse of the least energy on the circle where friction slips: (K + s) x = p, |x| = limit,
/// with p = K x_old - slip, by Newton's method for 1 / |x| (world.md, "About an axle").
/// @param K  what is soft across: 11, 12, 22, 1/kg  @param p  along both tangents, m/s
/// @pre the circle does not hold the least of all. Bound: kNewtonSteps
template <class Scalar>
Vec2<Scalar> least_on_circle(const std::array<Scalar, 3>& K, const Vec2<Scalar>& p, Scalar limit) {
  constexpr int kNewtonSteps = 12;
  constexpr Scalar kNear = 1 + 16 * kRoundOff<Scalar>;
  Vec2<Scalar> x = Vec2<Scalar>::Zero();
  Scalar s = 16 * kRoundOff<Scalar> * (K[0] + K[2]);  // or what is not soft would be divided by
  Scalar size = 0;
  for (int i = 0; i < kNewtonSteps && limit > Scalar(0); ++i) {  // Bound: kNewtonSteps
    const Scalar a = K[0] + s;
    const Scalar d = K[2] + s;
    const Scalar det = a * d - K[1] * K[1];
    if (!(det > Scalar(0))) return Vec2<Scalar>::Zero();
    x = {(d * p.x() - K[1] * p.y()) / det, (a * p.y() - K[1] * p.x()) / det};
    size = std::sqrt(x.x() * x.x() + x.y() * x.y());
    if (!(size > kNear * limit)) break;
    // -|x| d|x| / ds
    const Scalar fall = (d * x.x() * x.x() - 2 * K[1] * x.x() * x.y() + a * x.y() * x.y()) / det;
    s += (size / limit - 1) * (size * size / fall);
  }
  return size > limit ? Vec2<Scalar>(limit / size * x) : x;
}

/// Along both tangents, what stops a slip of u and v, m/s; roughly, where K is singular.
template <class Scalar>
Vec2<Scalar> stopping(const std::array<Scalar, 3>& K, Scalar u, Scalar v) {
  constexpr Scalar kSingular = 16 * kRoundOff<Scalar>;
  const auto& [a, b, d] = K;
  const Scalar det = a * d - b * b;
  const bool is_regular = det > kSingular * a * d;
  const Scalar size = is_regular ? det : a + d;
  const Scalar share = size > Scalar(0) ? 1 / size : Scalar(0);
  return {-share * (is_regular ? d * u - b * v : u), -share * (is_regular ? a * v - b * u : v)};
}

/// The part of friction: stops the slip within the cone. Where that is beyond it, a step down the
/// slope of the energy, back onto the cone; about an axle, which is soft one way and stiff the
/// other, the least of the energy on the cone. None adds energy, unless the cone has become smaller
/// than what was there.
/// @returns what it adds to the energy at most, J
template <class Traits, class Scalar>
Scalar relax_friction(ContactPoint<Traits>& point, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                      Scalar friction) {
  if (point.normal == Scalar(0) && point.along == Scalar(0) && point.across == Scalar(0)) {
    return Scalar(0);
  }
  using std::sqrt;
  const auto tangents = tangents_of(point.normal_W);
  const Vec3<Scalar> slip = slip_across(point, A, B);
  const Scalar u = tangents.along_W.dot(slip);
  const Scalar v = tangents.across_W.dot(slip);
  const auto& [a, b, d] = point.softness_across;
  const Vec2<Scalar> stop = stopping(point.softness_across, u, v);
  Scalar change = stop.x();
  Scalar aside = stop.y();
  const Scalar limit = friction * point.normal;
  const auto square = [&] {
    const Scalar along = point.along + change;
    const Scalar across = point.across + aside;
    return along * along + across * across;
  };
  Scalar bend = 0;  // an upper bound of K's tangential part
  const bool slips = square() > limit * limit;
  const bool slips_on_axle = slips && (is_on_axle(A) || is_on_axle(B));
  if (slips_on_axle) {
    const Vec2<Scalar> pull = {a * point.along + b * point.across - u,
                               b * point.along + d * point.across - v};
    const Vec2<Scalar> best = least_on_circle(point.softness_across, pull, limit);
    change = best.x() - point.along;
    aside = best.y() - point.across;
  } else if (slips) {
    bend = (a + d) / 2 + sqrt((a - d) * (a - d) / 4 + b * b);
    change = bend > Scalar(0) ? -u / bend : Scalar(0);
    aside = bend > Scalar(0) ? -v / bend : Scalar(0);
    const Scalar beyond = square();
    if (beyond > limit * limit) {
      const Scalar scale = limit / sqrt(beyond);
      change = scale * (point.along + change) - point.along;
      aside = scale * (point.across + aside) - point.across;
    }
  }
  push_at<Traits, Scalar>(point, A, B, change * tangents.along_W + aside * tangents.across_W);
  point.along += change;
  point.across += aside;
  const Scalar slope = change * u + aside * v;
  if (slips_on_axle) {
    return slope + (a * change * change + 2 * b * change * aside + d * aside * aside) / 2;
  }
  return bend > Scalar(0) ? slope + bend * (change * change + aside * aside) / 2 : slope / 2;
}

/// Resists rolling with a torque of at most `lever` times the load: the one that stops the relative
/// spin; where that is beyond the limit, a step down the slope of the energy, back to the limit, as
/// for friction.
/// @returns what it adds to the energy, J
template <class Traits, class Scalar>
Scalar relax_rolling(ContactPoint<Traits>& point, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                     Scalar lever) {
  Mat3<Scalar> softness = A.inverse_inertia_W + B.inverse_inertia_W;
  const Scalar size = softness.trace();
  if (!(size > Scalar(0))) return Scalar(0);
  softness /= size;  // of a trace of one: the cube of what is soft overflows
  const Scalar limit = lever * point.normal;
  const Vec3<Scalar> spin = A.w_W - B.w_W;
  const Vec3<Scalar> slope = spin / size;
  Vec3<Scalar> change = -slope;
  if (softness.determinant() > Scalar(0)) change = -(softness.inverse() * slope);
  const Vec3<Scalar> before = point.rolling_W;
  point.rolling_W += change;
  if (point.rolling_W.squaredNorm() > limit * limit) {
    const Scalar bend = softness.cwiseAbs().rowwise().sum().maxCoeff();  // at least its norm
    point.rolling_W = before - slope / bend;
    const Scalar square = point.rolling_W.squaredNorm();
    using std::sqrt;
    if (square > limit * limit) point.rolling_W *= limit / sqrt(square);
  }
  change = point.rolling_W - before;
  A.w_W += A.inverse_inertia_W * change;
  B.w_W -= B.inverse_inertia_W * change;
  return change.dot(spin) + size * change.dot(softness * change) / 2;
}

/// How fast the gap of a point is to open, m/s; negative: may close.
template <class Traits, class Scalar>
Scalar opening_goal(const ContactPoint<Traits>& point, Scalar D, Scalar time, Scalar share) {
  constexpr Scalar kWanted = Scalar(0.5);  // of D
  const Scalar missing = (point.normal > Scalar(0) ? kWanted * D : Scalar(0)) - point.gap;
  if (missing > Scalar(0)) return share * missing / time;
  if (!(share > Scalar(0))) return Scalar(0);
  return min_of(Scalar(0), (kWanted * D - point.gap) / time + point.room);
}

/// What a visit may have to take back.
template <class Traits, class Scalar>
struct BeforeVisit {
  std::array<ContactPoint<Traits>, LastingContact<Traits>::kPoints> points;
  std::array<Vec3<Scalar>, 4> velocities;
};

/// What a visit has made of what gravity makes in half of what is left of the step, J (carried_W).
template <class Traits, class Scalar>
Scalar lift_of(const BeforeVisit<Traits, Scalar>& before, const SolvedBody<Scalar>& A,
               const SolvedBody<Scalar>& B, const Vec3<Scalar>& carried_W) {
  const Scalar soft = A.inverse_mass + B.inverse_mass;
  if (is_zero(carried_W) || !(soft > Scalar(0))) return Scalar(0);
  const bool is_A = A.inverse_mass > Scalar(0);
  const Vec3<Scalar> dv_W = is_A ? A.v_W - before.velocities[0] : before.velocities[2] - B.v_W;
  return carried_W.dot(dv_W) / soft;
}

/// The state of before the visit.
template <class Traits, class Scalar>
void take_back(const BeforeVisit<Traits, Scalar>& before, LastingContact<Traits>& contact,
               SolvedBody<Scalar>& A, SolvedBody<Scalar>& B) {
  contact.points = before.points;
  A.v_W = before.velocities[0];
  A.w_W = before.velocities[1];
  B.v_W = before.velocities[2];
  B.w_W = before.velocities[3];
}

/// Friction and rolling resistance at a point. @returns `gain`, and what they add at most, J
template <class Traits, class Scalar>
Scalar relax_along([[maybe_unused]] const LastingContact<Traits>& contact,
                   [[maybe_unused]] ContactPoint<Traits>& point,
                   [[maybe_unused]] SolvedBody<Scalar>& A, [[maybe_unused]] SolvedBody<Scalar>& B,
                   Scalar gain) {
  if constexpr (Traits::kFriction) {
    if (contact.friction > Scalar(0)) gain += relax_friction(point, A, B, contact.friction);
  }
  if constexpr (Traits::kRolling) {
    if (contact.rolling > Scalar(0)) gain += relax_rolling(point, A, B, contact.rolling);
  }
  return gain;
}

/// How fast the two part by a change of an impulse, m/s (world.md, "About an axle").
template <class Scalar>
Scalar speed_of(const NormalSide<Scalar>& side, const SolvedBody<Scalar>& A,
                const SolvedBody<Scalar>& B) {
  const bool turns = is_on_axle(A) || is_on_axle(B);
  return std::abs(side.change) * (turns ? side.softness : A.inverse_mass + B.inverse_mass);
}

}  // namespace

template <class Traits, class Scalar>
Scalar relax(LastingContact<Traits>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
             Scalar& energy, const Vec3<Scalar>& carried_W) {
  const BeforeVisit<Traits, Scalar> before = {contact.points, {A.v_W, A.w_W, B.v_W, B.w_W}};
  NormalSides<Traits> sides;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto k = static_cast<std::size_t>(i);
    const auto& point = contact.points[k];
    sides[k] = side_of(point, A, B);
    sides[k].softness = point.softness;
    sides[k].rate += point.room;
    sides[k].impulse = point.normal;
  }
  Scalar gain = push_normals(contact, sides, A, B);
  Scalar most = 0;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto k = static_cast<std::size_t>(i);
    auto& point = contact.points[k];
    point.normal += sides[k].change;
    gain -= sides[k].change * point.room;  // what counts is energy
    most = max_of(most, speed_of(sides[k], A, B));
    gain = relax_along(contact, point, A, B, gain);
  }
  // What was carried and falls again has gained nothing.
  const Scalar lift = lift_of(before, A, B, carried_W);
  const Scalar least = gain + min_of(lift, Scalar(0));
  if (least > Scalar(0) && energy + least > Scalar(0)) {
    take_back(before, contact, A, B);
    return Scalar(0);
  }
  energy = min_of(Scalar(0), energy + gain + lift);
  return most;
}

template <class Traits, class Scalar>
void go_ahead(LastingContact<Traits>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
              Scalar share, Scalar& energy) {
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& point = contact.points[static_cast<std::size_t>(i)];
    const Scalar change = max_of(share * point.ahead, -point.normal);
    if (change != Scalar(0)) {
      const NormalSide<Scalar> side = side_of(point, A, B);
      const Scalar gain = change * (side.rate + change * point.softness / 2);
      if (!(gain > Scalar(0)) || !(energy + gain > Scalar(0))) {
        energy += gain;
        point.normal += change;
        A.v_W += (A.inverse_mass * change) * point.normal_W;
        B.v_W -= (B.inverse_mass * change) * point.normal_W;
        A.w_W += A.inverse_inertia_W * (change * side.moment_A_W);
        B.w_W -= B.inverse_inertia_W * (change * side.moment_B_W);
      }
    }
    point.ahead = point.normal - point.start;
    point.start = point.normal;
  }
}

template <class Traits, class Scalar>
Scalar relax_opening(LastingContact<Traits>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                     Scalar time, Scalar share) {
  const Scalar mass = A.inverse_mass + B.inverse_mass;
  NormalSides<Traits> sides;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto k = static_cast<std::size_t>(i);
    const auto& point = contact.points[k];
    auto& side = sides[k];
    side = side_of(point, A, B);
    const Vec3<Scalar> turn_A = A.inverse_inertia_W * side.moment_A_W;
    const Vec3<Scalar> turn_B = B.inverse_inertia_W * side.moment_B_W;
    side.softness = mass + side.moment_A_W.dot(turn_A) + side.moment_B_W.dot(turn_B);
    side.rate -= opening_goal(point, contact.rest_gap, time, share);
    side.impulse = point.opening;
  }
  push_normals(contact, sides, A, B);
  Scalar most = 0;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto k = static_cast<std::size_t>(i);
    contact.points[k].opening += sides[k].change;
    most = max_of(most, speed_of(sides[k], A, B));
  }
  return most;
}

#define BATUTA_INSTANTIATE_CONTACT(S, F, R, L)                                                     \
  template S relax(LastingContact<ContactTraits<S, F, R, L>>&, SolvedBody<S>&, SolvedBody<S>&, S&, \
                   const Vec3<S>&);                                                                \
  template void go_ahead(LastingContact<ContactTraits<S, F, R, L>>&, SolvedBody<S>&,               \
                         SolvedBody<S>&, S, S&);                                                   \
  template S relax_opening(LastingContact<ContactTraits<S, F, R, L>>&, SolvedBody<S>&,             \
                           SolvedBody<S>&, S, S);
#define BATUTA_INSTANTIATE(S) BATUTA_FOR_EACH_CONTACT(BATUTA_INSTANTIATE_CONTACT, S)
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE
#undef BATUTA_INSTANTIATE_CONTACT

}  // namespace batuta::detail
