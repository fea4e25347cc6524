// SPDX-License-Identifier: MIT
#include "batuta/mechanics/solid.hpp"

#include "batuta/geometry/direction.hpp"

namespace batuta {
namespace {

/// How a capsule's own frame B lies in G, and the capsule in it.
template <class Scalar>
struct OwnFrame {
  Pose<Scalar> X_GB;
  Capsule<Scalar> capsule_B;
};

template <class Scalar>
bool is_along_an_axis(const Vec3<Scalar>& v) {
  int zeros = 0;
  for (int i = 0; i < 3; ++i) zeros += v[i] == Scalar(0) ? 1 : 0;  // Bound: 3
  return zeros >= 2;
}

/// @pre capsule valid
template <class Scalar>
OwnFrame<Scalar> own_frame(const Capsule<Scalar>& capsule_G) {
  const Segment<Scalar>& axis = capsule_G.axis;
  const Vec3<Scalar> half_G = axis.b / 2 - axis.a / 2;
  OwnFrame<Scalar> own;
  own.X_GB.p_W = axis.a / 2 + axis.b / 2;
  Vec3<Scalar> half_B = half_G;
  if (!is_along_an_axis(half_G)) {
    // z of B points to where z of G does: the turn is by no more than a right angle, and never by
    // half a turn, whose axis is anybody's.
    const Scalar up = half_G.z() < Scalar(0) ? Scalar(-1) : Scalar(1);
    const Vec3<Scalar> z_G = up * unit(half_G);
    own.X_GB.q_WB = renewed(Quat<Scalar>(Scalar(1) + z_G.z(), -z_G.y(), z_G.x(), Scalar(0)));
    half_B = {0, 0, up * length(half_G)};
  }
  own.capsule_B = {{-half_B, half_B}, capsule_G.radius};
  return own;
}

/// Mass and moments about the middle; infinite for what is fixed.
template <class Scalar>
Result<MassProperties<Scalar>> inertia_of(const Capsule<Scalar>& capsule_B, Scalar density) {
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  if (density != kInfinity) {
    Result<MassProperties<Scalar>> made = solid_capsule(capsule_B, density);
    for (int i = 0; i < 3; ++i) {  // Bound: 3; along one of the axes at most
      if (capsule_B.axis.b[i] == Scalar(0)) continue;
      made.value.inertia_S(i, i) = detail::axial_moment(capsule_B, density);
    }
    return made;
  }
  MassProperties<Scalar> fixed;
  fixed.mass = kInfinity;
  fixed.inertia_S.diagonal().setConstant(kInfinity);
  return success(fixed);
}

template <class Scalar>
bool is_still(const Twist<Scalar>& twist) {
  return detail::is_zero(twist.v_W) && detail::is_zero(twist.w_W);
}

}  // namespace

template <class Scalar>
Result<SolidBody<Scalar>> solid_body(const Capsule<Scalar>& capsule_G, Scalar density,
                                     const Pose<Scalar>& X_WG, const Twist<Scalar>& twist) {
  auto refused = failure<SolidBody<Scalar>>(Status::kInvalidArgument);
  if (!is_valid(capsule_G) || !is_finite(X_WG.p_W) || !detail::points(X_WG.q_WB)) return refused;
  const OwnFrame<Scalar> own = own_frame(capsule_G);
  const auto mass = inertia_of(own.capsule_B, density);
  if (!mass.ok()) return refused;
  const Pose<Scalar> X_WG_unit = {X_WG.p_W, detail::unit_of(X_WG.q_WB)};
  const Pose<Scalar> X_WB = {to_world(X_WG_unit, own.X_GB.p_W), X_WG_unit.q_WB * own.X_GB.q_WB};
  const auto made = make_body(X_WB, mass.value.mass, mass.value.inertia_S.diagonal().eval());
  if (!made.ok()) return refused;
  SolidBody<Scalar> solid = {made.value, own.capsule_B};
  solid.body.momentum = momentum_of(solid.body, twist);
  const bool moves_well = is_finite(twist.v_W) && is_finite(twist.w_W) &&
                          is_finite(solid.body.momentum.linear_W) &&
                          is_finite(solid.body.momentum.angular_W);
  if (!moves_well || (is_fixed(solid.body) && !is_still(twist))) return refused;
  return success(solid);
}

#define BATUTA_INSTANTIATE(S) \
  template Result<SolidBody<S>> solid_body(const Capsule<S>&, S, const Pose<S>&, const Twist<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
