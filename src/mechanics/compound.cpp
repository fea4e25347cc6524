// SPDX-License-Identifier: MIT
#include "batuta/mechanics/compound.hpp"

#include "batuta/geometry/direction.hpp"
#include "batuta/mechanics/motion.hpp"

namespace batuta {
namespace {

/// How far moments and elements that are equal may be apart, relative to the largest moment, for
/// rounding alone (compound.md).
template <class Scalar>
constexpr Scalar kRounding = 64 * kRoundOff<Scalar>;

/// Symmetric to within rounding. False where an element is not finite.
template <class Scalar>
bool is_symmetric(const Mat3<Scalar>& I) {
  const Vec3<Scalar> upper(I(0, 1), I(0, 2), I(1, 2));
  const Vec3<Scalar> lower(I(1, 0), I(2, 0), I(2, 1));
  // No element of a body's tensor is larger than its trace.
  const Scalar apart = detail::largest_component(Vec3<Scalar>(upper - lower));
  return is_finite(I) && apart <= kRounding<Scalar> * I.trace();
}

/// No moment of a body exceeds the sum of the other two, because it is a sum of two squared
/// distances. @pre moments ascend
template <class Scalar>
bool are_of_a_body(const Vec3<Scalar>& moments) {
  return moments(2) - moments(1) <= moments(0) + kRounding<Scalar> * moments(2);
}

/// The axes of a body of revolution: the odd one is kept, the free ones are chosen by rule.
template <class Scalar>
Quat<Scalar> axes_about(const Quat<Scalar>& q_SB, int odd) {
  Mat3<Scalar> R;
  const Vec3<Scalar> along = detail::to_matrix(q_SB).col(odd);
  const Vec3<Scalar> across = detail::perpendicular(along);
  R.col(odd) = along;
  R.col((odd + 1) % 3) = across;
  R.col((odd + 2) % 3) = along.cross(across);
  return detail::to_quaternion(R);
}

/// Moves the capsules from S to B. @returns whether all are valid, before and after
template <class Scalar>
bool move_to_body(const Pose<Scalar>& X_SB, Capsule<Scalar>* capsules, int count) {
  for (int i = 0; i < count; ++i) {  // Bound: count
    Capsule<Scalar>& capsule = capsules[i];
    if (!is_valid(capsule)) return false;
    capsule.axis = {to_body(X_SB, capsule.axis.a), to_body(X_SB, capsule.axis.b)};
    if (!is_valid(capsule)) return false;
  }
  return true;
}

/// Whether spin about an axis of symmetry shows on one of the capsules.
template <class Scalar>
bool shows_spin(const Body<Scalar>& body, const Capsule<Scalar>* capsules, int count) {
  for (int i = 0; i < count; ++i) {  // Bound: count
    if (!detail::hides_spin(body, capsules[i])) return true;
  }
  return false;
}

}  // namespace

template <class Scalar>
Result<MassProperties<Scalar>> detail::mass_of_parts(const CapsulePart<Scalar>* parts, int count) {
  Result<MassProperties<Scalar>> sum;
  for (int i = 0; i < count; ++i) {  // Bound: count
    auto part = solid_capsule(parts[i].capsule_S, parts[i].density);
    if (!part.ok()) return part;
    sum = success(i == 0 ? part.value : sum.value + part.value);
  }
  const MassProperties<Scalar>& all = sum.value;
  const bool sound = is_finite(all.mass) && is_finite(all.center_S) && is_finite(all.inertia_S);
  return sound ? sum : failure<MassProperties<Scalar>>(Status::kInvalidArgument);
}

template <class Scalar>
PrincipalFrame<Scalar> detail::settled_frame(const MassProperties<Scalar>& mass) {
  PrincipalFrame<Scalar> result = principal_frame(mass);
  Vec3<Scalar>& m = result.moments;
  const Scalar least_apart = kRounding<Scalar> * m(2);
  const bool low = m(1) - m(0) <= least_apart;
  const bool high = m(2) - m(1) <= least_apart;
  if (low && high) {
    m = Vec3<Scalar>::Constant(m(1));
    result.q_SB = Quat<Scalar>::Identity();
  } else if (low || high) {
    const int odd = low ? 2 : 0;
    const int one = low ? 0 : 1;
    m(one) = m(one + 1) = m(one) + (m(one + 1) - m(one)) / 2;
    result.q_SB = axes_about(result.q_SB, odd);
  }
  return result;
}

template <class Scalar>
Result<Body<Scalar>> detail::place_compound(const MassProperties<Scalar>& mass,
                                            const Pose<Scalar>& X_WS, Capsule<Scalar>* capsules,
                                            int count) {
  constexpr auto kRefused = Status::kInvalidArgument;
  if (count < 1 || !is_symmetric(mass.inertia_S)) return failure<Body<Scalar>>(kRefused);
  const PrincipalFrame<Scalar> frame = detail::settled_frame(mass);
  const Pose<Scalar> X_SB = {frame.center_S, frame.q_SB};
  const bool possible = are_of_a_body(frame.moments) && detail::points(X_WS.q_WB) &&
                        move_to_body(X_SB, capsules, count);
  if (!possible) return failure<Body<Scalar>>(kRefused);
  const Pose<Scalar> X_WS_unit = {X_WS.p_W, unit_of(X_WS.q_WB)};
  const Pose<Scalar> X_WB = {to_world(X_WS_unit, X_SB.p_W), X_WS_unit.q_WB * X_SB.q_WB};
  auto body = make_body(X_WB, mass.mass, frame.moments);
  if (!body.ok()) return body;
  const bool movable = body.value.inverse_mass > Scalar(0);
  if (!movable) return failure<Body<Scalar>>(kRefused);
  body.value.spin_shows = shows_spin(body.value, capsules, count);
  return body;
}

#define BATUTA_INSTANTIATE(S)                                                               \
  template PrincipalFrame<S> detail::settled_frame(const MassProperties<S>&);               \
  template Result<MassProperties<S>> detail::mass_of_parts(const CapsulePart<S>*, int);     \
  template Result<Body<S>> detail::place_compound(const MassProperties<S>&, const Pose<S>&, \
                                                  Capsule<S>*, int);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
