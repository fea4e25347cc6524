// SPDX-License-Identifier: MIT
#include "batuta/world/detail/lasting_contact.hpp"

#include "batuta/geometry/direction.hpp"

namespace batuta::detail {
namespace {

template <class Scalar>
Vec3<Scalar> other_tangent(const ContactPoint<Scalar>& point) {
  return point.normal_W.cross(point.tangent_W);
}

/// Where axes run along each other: the ends of the shorter one are so near the other one that a
/// tilt within D is possible, times kTilt (world.md, "Lines").
template <class Scalar>
bool may_be_line(const Capsule<Scalar>& A_W, const Capsule<Scalar>& B_W, Scalar rest_gap) {
  constexpr Scalar kTilt = 128;
  const Vec3<Scalar> d_A = A_W.axis.direction();
  const Vec3<Scalar> d_B = B_W.axis.direction();
  const Scalar a = d_A.squaredNorm();
  const Scalar b = d_B.squaredNorm();
  const Scalar across = d_A.cross(d_B).squaredNorm();  // of both lengths and the angle
  const Scalar longer = max_of(a, b);
  return min_of(a, b) > Scalar(0) && across < kTilt * (A_W.radius + B_W.radius) * rest_gap * longer;
}

/// A point between two places on the axes; nearer to the smaller radius, where it is known best.
template <class Scalar>
ContactPoint<Scalar> point_between(const Capsule<Scalar>& A_W, const Capsule<Scalar>& B_W,
                                   const Vec3<Scalar>& on_A, const Vec3<Scalar>& on_B,
                                   const Vec3<Scalar>& normal_BA_W, Scalar gap) {
  ContactPoint<Scalar> point;
  point.normal_W = normal_BA_W;
  point.gap = gap;
  if (A_W.radius < B_W.radius) {
    point.point_W = on_A - (A_W.radius + gap / 2) * normal_BA_W;
  } else {
    point.point_W = on_B + (B_W.radius + gap / 2) * normal_BA_W;
  }
  return point;
}

/// The ends of a line of contact, and the closest points between or beyond them.
template <class Scalar>
struct LineEnds {
  std::array<ContactPoint<Scalar>, 2> ends;  ///< by place
  bool found = false;

  void offer(const ContactPoint<Scalar>& point) {
    if (!found) ends = {point, point};
    if (point.place < ends[0].place) ends[0] = point;
    if (point.place > ends[1].place) ends[1] = point;
    found = true;
  }
  Scalar span() const { return ends[1].place - ends[0].place; }
  /// Axes that cross a little are nearer to each other between the ends than at them. Then both
  /// ends are those of a straight line through the nearest point, with its normal and its gap: what
  /// holds at both ends holds between them.
  void dip_to(const ContactPoint<Scalar>& nearest, const Vec3<Scalar>& along) {
    const Scalar share = clamp((nearest.place - ends[0].place) / span(), Scalar(0), Scalar(1));
    const Scalar dip = ends[0].gap + share * (ends[1].gap - ends[0].gap) - nearest.gap;
    if (!(dip > Scalar(0))) return;
    for (ContactPoint<Scalar>& end : ends) {  // Bound: 2
      end.gap = nearest.gap;
      end.normal_W = nearest.normal_W;
      end.point_W = nearest.point_W + (end.place - nearest.place) * along;
    }
  }
};

/// The end of an axis over the other axis, where that is as near as the closest points, to D.
template <class Scalar>
void offer_end(LineEnds<Scalar>& line, const Capsule<Scalar>& A_W, const Capsule<Scalar>& B_W,
               int which, Scalar farthest, const Vec3<Scalar>& along) {
  const bool of_A = which < 2;
  const Segment<Scalar>& own = of_A ? A_W.axis : B_W.axis;
  const Vec3<Scalar> end = which % 2 == 0 ? own.a : own.b;
  const auto other = closest_point(of_A ? B_W.axis : A_W.axis, end);
  const Scalar gap = other.distance - A_W.radius - B_W.radius;
  const Vec3<Scalar> apart = end - other.point;
  if (!(gap < farthest) || is_zero(apart)) return;
  const Vec3<Scalar> outwards = unit<Scalar>(apart);
  const Vec3<Scalar> normal = of_A ? outwards : Vec3<Scalar>(-outwards);
  auto point = point_between<Scalar>(A_W, B_W, of_A ? end : other.point, of_A ? other.point : end,
                                     normal, gap);
  point.place = along.dot(point.point_W - A_W.axis.a);
  line.offer(point);
}

/// What is being solved across the normal.
template <class Scalar>
Vec3<Scalar> tangential(const ContactPoint<Scalar>& point) {
  return point.along * point.tangent_W + point.across * other_tangent(point);
}

/// Old impulses, in the directions of a new point.
template <class Scalar>
void carry(ContactPoint<Scalar>& point, const ContactPoint<Scalar>& old, Scalar share) {
  const Vec3<Scalar> tangent_W = tangential(old);
  point.normal += share * old.normal;
  point.along += share * point.tangent_W.dot(tangent_W);
  point.across += share * other_tangent(point).dot(tangent_W);
  point.spent_normal += share * old.spent_normal;
  point.spent_tangent_W += share * old.spent_tangent_W;
}

template <class Scalar>
void carry_all(LastingContact<Scalar>& contact, const std::array<ContactPoint<Scalar>, 2>& old,
               int old_count) {
  auto& points = contact.points;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& point = points[static_cast<std::size_t>(i)];
    point.tangent_W = perpendicular(point.normal_W);
    if (old_count == contact.count) {
      carry(point, old[static_cast<std::size_t>(i)], Scalar(1));
    } else if (old_count == 2) {
      carry(point, old[0], Scalar(1));
      carry(point, old[1], Scalar(1));
    } else if (old_count == 1) {
      const Scalar to_first = std::abs(old[0].place - points[0].place);
      const Scalar to_second = std::abs(old[0].place - points[1].place);
      const Scalar sum = to_first + to_second;
      const Scalar mine = i == 0 ? to_second : to_first;
      carry(point, old[0], sum > Scalar(0) ? mine / sum : Scalar(0.5));
    }
  }
}

/// The inverse of the tangential part of K, and a bound of it.
template <class Scalar>
void set_grip(ContactPoint<Scalar>& point, Scalar a, Scalar b, Scalar d) {
  constexpr Scalar kSingular = 16 * kRoundOff<Scalar>;
  const Scalar det = a * d - b * b;
  if (det > kSingular * a * d) {
    point.grip = {d / det, -b / det, a / det};
  } else {
    const Scalar sum = a + d;
    const Scalar share = sum > Scalar(0) ? 1 / sum : Scalar(0);
    point.grip = {share, Scalar(0), share};
  }
  using std::sqrt;
  point.softest = (a + d) / 2 + sqrt((a - d) * (a - d) / 4 + b * b);
}

template <class Scalar>
void prepare_point(ContactPoint<Scalar>& point, const SolvedBody<Scalar>& A,
                   const SolvedBody<Scalar>& B) {
  const std::array<Vec3<Scalar>, 3> d = {point.normal_W, point.tangent_W, other_tangent(point)};
  std::array<Vec3<Scalar>, 3> moment_A;
  std::array<Vec3<Scalar>, 3> moment_B;
  for (std::size_t k = 0; k < 3; ++k) {  // Bound: 3
    moment_A[k] = point.arm_A_W.cross(d[k]);
    moment_B[k] = point.arm_B_W.cross(d[k]);
    point.turn_A_W[k] = A.inverse_inertia_W * moment_A[k];
    point.turn_B_W[k] = B.inverse_inertia_W * moment_B[k];
  }
  const Scalar mass = A.inverse_mass + B.inverse_mass;
  const auto give = [&](std::size_t i, std::size_t k) {
    return moment_A[i].dot(point.turn_A_W[k]) + moment_B[i].dot(point.turn_B_W[k]);
  };
  const Scalar softness = mass + give(0, 0);
  point.stiffness = softness > Scalar(0) ? 1 / softness : Scalar(0);
  set_grip(point, mass + give(1, 1), give(1, 2), mass + give(2, 2));
}

/// Impulses along the normal and both tangents, given to both bodies.
template <class Scalar>
void push(const ContactPoint<Scalar>& point, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
          Scalar normal, Scalar along, Scalar across) {
  const Vec3<Scalar> J =
      normal * point.normal_W + along * point.tangent_W + across * other_tangent(point);
  A.v_W += A.inverse_mass * J;
  B.v_W -= B.inverse_mass * J;
  A.w_W += normal * point.turn_A_W[0] + along * point.turn_A_W[1] + across * point.turn_A_W[2];
  B.w_W -= normal * point.turn_B_W[0] + along * point.turn_B_W[1] + across * point.turn_B_W[2];
}

template <class Scalar>
Vec3<Scalar> slip_of(const ContactPoint<Scalar>& point, const SolvedBody<Scalar>& A,
                     const SolvedBody<Scalar>& B) {
  return (A.v_W - B.v_W) + (A.w_W.cross(point.arm_A_W) - B.w_W.cross(point.arm_B_W));
}

/// The same, along the normal alone: most visits need no more.
template <class Scalar>
void push_normal(const ContactPoint<Scalar>& point, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                 Scalar normal) {
  A.v_W += (A.inverse_mass * normal) * point.normal_W;
  B.v_W -= (B.inverse_mass * normal) * point.normal_W;
  A.w_W += normal * point.turn_A_W[0];
  B.w_W -= normal * point.turn_B_W[0];
}

/// And along both tangents.
template <class Scalar>
void push_across(const ContactPoint<Scalar>& point, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                 const Vec3<Scalar>& J_W, Scalar along, Scalar across) {
  A.v_W += A.inverse_mass * J_W;
  B.v_W -= B.inverse_mass * J_W;
  A.w_W += along * point.turn_A_W[1] + across * point.turn_A_W[2];
  B.w_W -= along * point.turn_B_W[1] + across * point.turn_B_W[2];
}

/// The part of friction: stops the slip within the cone. Where that is beyond it, a step down the
/// slope of the energy, back onto the cone: neither adds energy, unless the cone has become smaller
/// than what was there.
/// @returns what it adds to the energy at most, J
template <class Scalar>
Scalar relax_friction(ContactPoint<Scalar>& point, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                      Scalar friction) {
  if (point.normal == Scalar(0) && point.along == Scalar(0) && point.across == Scalar(0)) {
    return Scalar(0);
  }
  const Vec3<Scalar> slip = slip_of(point, A, B);
  const Vec3<Scalar> other = other_tangent(point);
  const Scalar u = point.tangent_W.dot(slip);
  const Scalar v = other.dot(slip);
  const Scalar limit = friction * point.normal;
  Scalar along = point.along - (point.grip[0] * u + point.grip[1] * v);
  Scalar across = point.across - (point.grip[1] * u + point.grip[2] * v);
  Scalar bend = 0;
  if (along * along + across * across > limit * limit) {
    bend = point.softest;
    const Scalar share = point.softest > Scalar(0) ? 1 / point.softest : Scalar(0);
    along = point.along - share * u;
    across = point.across - share * v;
    const Scalar square = along * along + across * across;
    if (square > limit * limit) {
      using std::sqrt;
      const Scalar scale = limit / sqrt(square);
      along *= scale;
      across *= scale;
    }
  }
  const Scalar change = along - point.along;
  const Scalar aside = across - point.across;
  const Vec3<Scalar> J_W = change * point.tangent_W + aside * other;
  push_across(point, A, B, J_W, change, aside);
  point.along = along;
  point.across = across;
  const Scalar slope = change * u + aside * v;
  return bend > Scalar(0) ? slope + bend * (change * change + aside * aside) / 2 : slope / 2;
}

/// How much of a change leaves a vector no longer than `limit`. @pre |from| <= limit
template <class Scalar>
Scalar share_within(const Vec3<Scalar>& from, const Vec3<Scalar>& change, Scalar limit) {
  const Scalar a = change.squaredNorm();
  const Scalar b = from.dot(change);
  const Scalar c = limit * limit - from.squaredNorm();
  if (!(a + 2 * b > c)) return Scalar(1);
  using std::sqrt;
  return clamp((sqrt(max_of(Scalar(0), b * b + a * max_of(Scalar(0), c))) - b) / a, Scalar(0),
               Scalar(1));
}

/// Resists rolling with a torque of at most `lever` times the load: towards the one that stops the
/// relative spin, as far as that goes; along the way the energy falls, unless the limit has become
/// smaller than what was there.
/// @returns what it adds to the energy, J
template <class Scalar>
Scalar relax_rolling(ContactPoint<Scalar>& point, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                     Scalar lever) {
  Mat3<Scalar> softness = A.inverse_inertia_W + B.inverse_inertia_W;
  const Scalar size = softness.trace();
  if (!(size > Scalar(0))) return Scalar(0);
  softness /= size;  // of a trace of one: the cube of what is soft overflows
  if (!(softness.determinant() > Scalar(0))) return Scalar(0);
  const Scalar limit = lever * point.normal;
  const Vec3<Scalar> before = point.rolling_W;
  const Scalar square = before.squaredNorm();
  using std::sqrt;
  if (square > limit * limit) point.rolling_W *= limit / sqrt(square);
  const Vec3<Scalar> spin = A.w_W - B.w_W;
  const Vec3<Scalar> wanted = before - point.rolling_W - softness.inverse() * (spin / size).eval();
  point.rolling_W += share_within<Scalar>(point.rolling_W, wanted, limit) * wanted;
  const Vec3<Scalar> change = point.rolling_W - before;
  A.w_W += A.inverse_inertia_W * change;
  B.w_W -= B.inverse_inertia_W * change;
  return change.dot(spin) + size * change.dot(softness * change) / 2;
}

/// The impulses of a point.
template <class Scalar>
struct PointImpulses {
  Scalar normal = 0;
  Scalar along = 0;
  Scalar across = 0;
  Vec3<Scalar> rolling_W = Vec3<Scalar>::Zero();
};

/// A point's impulses become those of before the visit.
template <class Scalar>
void take_back(ContactPoint<Scalar>& point, const PointImpulses<Scalar>& before,
               SolvedBody<Scalar>& A, SolvedBody<Scalar>& B) {
  push(point, A, B, before.normal - point.normal, before.along - point.along,
       before.across - point.across);
  const Vec3<Scalar> torque = before.rolling_W - point.rolling_W;
  A.w_W += A.inverse_inertia_W * torque;
  B.w_W -= B.inverse_inertia_W * torque;
  point.normal = before.normal;
  point.along = before.along;
  point.across = before.across;
  point.rolling_W = before.rolling_W;
}

}  // namespace

template <class Scalar>
void find_points(LastingContact<Scalar>& contact, const Capsule<Scalar>& A_W,
                 const Capsule<Scalar>& B_W, const ClosestPoints<Scalar>& axes, bool line) {
  const std::array<ContactPoint<Scalar>, 2> old = contact.points;
  const int old_count = contact.is_new ? 0 : contact.count;
  const Scalar gap = axes.distance - A_W.radius - B_W.radius;
  const Vec3<Scalar> d_A = A_W.axis.direction();
  const Vec3<Scalar> d_B = B_W.axis.direction();
  const Vec3<Scalar> shorter = d_A.squaredNorm() < d_B.squaredNorm() ? d_A : d_B;
  const Scalar size = length(shorter);
  const Vec3<Scalar> along =
      size > Scalar(0) ? Vec3<Scalar>(shorter / size) : Vec3<Scalar>(Vec3<Scalar>::Zero());
  auto nearest = point_between<Scalar>(A_W, B_W, axes.p_A, axes.p_B, -axes.normal_AB, gap);
  nearest.place = along.dot(nearest.point_W - A_W.axis.a);
  contact.count = 1;
  contact.points[0] = nearest;
  if (line && may_be_line(A_W, B_W, contact.rest_gap)) {
    LineEnds<Scalar> ends;
    for (int which = 0; which < 4; ++which) {  // Bound: four ends
      offer_end(ends, A_W, B_W, which, max_of(gap, Scalar(0)) + contact.rest_gap, along);
    }
    if (ends.found) ends.offer(nearest);
    if (ends.found && ends.span() > min_of(A_W.radius, B_W.radius) / 16) {
      ends.dip_to(nearest, along);
      contact.count = 2;
      contact.points = ends.ends;
    }
  }
  carry_all(contact, old, old_count);
}

template <class Scalar>
void prepare(LastingContact<Scalar>& contact, const SolvedBody<Scalar>& A,
             const SolvedBody<Scalar>& B, const Vec3<Scalar>& p_A_W, const Vec3<Scalar>& p_B_W,
             Scalar time) {
  constexpr Scalar kUpTo = Scalar(0.6);      // of D: what is nearer may not approach (world.md)
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& point = contact.points[static_cast<std::size_t>(i)];
    point.arm_A_W = point.point_W - p_A_W;
    point.arm_B_W = point.point_W - p_B_W;
    point.room = max_of(Scalar(0), point.gap - kUpTo * contact.rest_gap) / time;
    point.opening = 0;
    prepare_point(point, A, B);
  }
}

template <class Scalar>
Vec3<Scalar> velocity_across(const ContactPoint<Scalar>& point, const SolvedBody<Scalar>& A,
                             const SolvedBody<Scalar>& B) {
  return slip_of(point, A, B);
}

template <class Scalar>
Scalar fastest_approach(const LastingContact<Scalar>& contact, const SolvedBody<Scalar>& A,
                        const SolvedBody<Scalar>& B) {
  Scalar fastest = std::numeric_limits<Scalar>::max();
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    fastest = min_of(fastest, point.normal_W.dot(velocity_across(point, A, B)));
  }
  return fastest;
}

template <class Scalar>
void push_share(const LastingContact<Scalar>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                Scalar share) {
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    push(point, A, B, share * point.normal, share * point.along, share * point.across);
  }
}

template <class Scalar>
void scale_impulses(LastingContact<Scalar>& contact, Scalar share) {
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& point = contact.points[static_cast<std::size_t>(i)];
    point.normal *= share;
    point.along *= share;
    point.across *= share;
    point.rolling_W.setZero();
  }
}

template <class Scalar>
Scalar relax(LastingContact<Scalar>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
             Scalar& energy) {
  Scalar most = 0;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& point = contact.points[static_cast<std::size_t>(i)];
    const PointImpulses<Scalar> before = {point.normal, point.along, point.across, point.rolling_W};
    const Scalar u = point.normal_W.dot(slip_of(point, A, B)) + point.room;
    const Scalar normal = max_of(Scalar(0), point.normal - point.stiffness * u);
    const Scalar change = normal - point.normal;
    Scalar gain = 0;
    if (change != Scalar(0)) {
      push_normal(point, A, B, change);
      point.normal = normal;
      gain = change * u + change * change / (2 * point.stiffness);
    }
    if (contact.friction > Scalar(0)) gain += relax_friction(point, A, B, contact.friction);
    if (contact.rolling > Scalar(0)) gain += relax_rolling(point, A, B, contact.rolling);
    if (gain > Scalar(0) && energy + gain > Scalar(0)) {
      take_back(point, before, A, B);
      continue;
    }
    energy += gain;
    most = max_of(most, std::abs(change) * (A.inverse_mass + B.inverse_mass));
  }
  return most;
}

template <class Scalar>
Scalar relax_opening(LastingContact<Scalar>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                     Scalar time, Scalar share) {
  constexpr Scalar kWanted = Scalar(0.5);  // of D
  Scalar most = 0;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& point = contact.points[static_cast<std::size_t>(i)];
    const Scalar wanted = point.normal > Scalar(0) ? kWanted * contact.rest_gap : Scalar(0);
    const Scalar missing = wanted - point.gap;
    Scalar goal = 0;
    if (missing > Scalar(0)) {
      goal = share * missing / time;
    } else if (share > Scalar(0)) {
      goal = min_of(Scalar(0), (kWanted * contact.rest_gap - point.gap) / time + point.room);
    }
    const Scalar u = point.normal_W.dot(velocity_across(point, A, B));
    const Vec3<Scalar> moment_A = point.arm_A_W.cross(point.normal_W);
    const Vec3<Scalar> moment_B = point.arm_B_W.cross(point.normal_W);
    const Vec3<Scalar> turn_A = A.inverse_inertia_W * moment_A;
    const Vec3<Scalar> turn_B = B.inverse_inertia_W * moment_B;
    const Scalar mass = A.inverse_mass + B.inverse_mass;
    const Scalar softness = mass + moment_A.dot(turn_A) + moment_B.dot(turn_B);
    if (!(softness > Scalar(0))) continue;
    const Scalar opening = max_of(Scalar(0), point.opening + (goal - u) / softness);
    const Scalar change = opening - point.opening;
    if (change == Scalar(0)) continue;
    most = max_of(most, std::abs(change) * mass);
    A.v_W += (A.inverse_mass * change) * point.normal_W;
    B.v_W -= (B.inverse_mass * change) * point.normal_W;
    A.w_W += change * turn_A;
    B.w_W -= change * turn_B;
    point.opening = opening;
  }
  return most;
}

template <class Scalar>
Vec3<Scalar> impulse_of(const ContactPoint<Scalar>& point) {
  return point.normal * point.normal_W + tangential(point);
}

template <class Scalar>
void spend(LastingContact<Scalar>& contact, Scalar share) {
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& point = contact.points[static_cast<std::size_t>(i)];
    point.spent_normal += share * point.normal;
    point.spent_tangent_W += share * tangential(point);
    point.normal -= share * point.normal;
    point.along -= share * point.along;
    point.across -= share * point.across;
  }
}

template <class Scalar>
void take_together(LastingContact<Scalar>& contact) {
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& point = contact.points[static_cast<std::size_t>(i)];
    point.normal += point.spent_normal;
    point.along += point.tangent_W.dot(point.spent_tangent_W);
    point.across += other_tangent(point).dot(point.spent_tangent_W);
    point.spent_normal = 0;
    point.spent_tangent_W.setZero();
  }
}

#define BATUTA_INSTANTIATE(S)                                                            \
  template void find_points(LastingContact<S>&, const Capsule<S>&, const Capsule<S>&,    \
                            const ClosestPoints<S>&, bool);                              \
  template void prepare(LastingContact<S>&, const SolvedBody<S>&, const SolvedBody<S>&,  \
                        const Vec3<S>&, const Vec3<S>&, S);                              \
  template Vec3<S> velocity_across(const ContactPoint<S>&, const SolvedBody<S>&,         \
                                   const SolvedBody<S>&);                                \
  template S fastest_approach(const LastingContact<S>&, const SolvedBody<S>&,            \
                              const SolvedBody<S>&);                                     \
  template void push_share(const LastingContact<S>&, SolvedBody<S>&, SolvedBody<S>&, S); \
  template void scale_impulses(LastingContact<S>&, S);                                   \
  template S relax(LastingContact<S>&, SolvedBody<S>&, SolvedBody<S>&, S&);              \
  template S relax_opening(LastingContact<S>&, SolvedBody<S>&, SolvedBody<S>&, S, S);    \
  template Vec3<S> impulse_of(const ContactPoint<S>&);                                   \
  template void spend(LastingContact<S>&, S);                                            \
  template void take_together(LastingContact<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::detail
