// SPDX-License-Identifier: MIT
#include "batuta/response/line_contact.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "batuta/geometry/direction.hpp"
#include "batuta/response/friction.hpp"
#include "draws.hpp"
#include "friction_truth.hpp"

namespace batuta {
namespace {

using exact::Real;
using exact::RealVec;
using V = Vec3<double>;

template <class Scalar>
struct Landing {
  Collider<Scalar> A;
  Collider<Scalar> B;
  Capsule<Scalar> A_W;
  Capsule<Scalar> B_W;
  Contact<Scalar> nearest;
  Scalar slack = 0;

  Contact<Scalar> pressure() const { return pressure_contact(A, B, A_W, B_W, nearest, slack); }
};

Collider<double> rod(test::Draws& draws, const Quat<double>& q) {
  Collider<double> body;
  body.X_WB.q_WB = q;
  body.inverse_mass = draws.power_of_two(-4, 5);
  const double across = body.inverse_mass * draws.between(3, 30);
  body.inverse_moments = V(across, across, across * draws.between(1, 50));
  return body;
}

Capsule<double> capsule_on(const Collider<double>& body, double half, double radius) {
  const V axis = detail::to_matrix(body.X_WB.q_WB).col(2);
  return {{body.X_WB.p_W - half * axis, body.X_WB.p_W + half * axis}, radius};
}

/// Two rods along z of a random frame, A on B's +x side, B shifted along the axis; both at rest but
/// for A's fall. The nearest point is any of those that share the closest distance.
Landing<double> flat_landing(test::Draws& draws, double shift, double place) {
  const Quat<double> q = draws.rotation();
  const Mat3<double> R = detail::to_matrix(q);
  const V n = R.col(0);
  Landing<double> land;
  land.A = rod(draws, q);
  land.B = rod(draws, q * exp_map<double>({0, 0, draws.between(-3, 3)}));
  const double half_A = draws.between(0.2, 1);
  const double half_B = draws.between(0.2, 1);
  const double radius_A = draws.between(0.01, 0.1);
  const double radius_B = draws.between(0.01, 0.1);
  land.slack = 1e-5;
  land.A.X_WB.p_W = n * (radius_A + radius_B + land.slack / 4);
  land.B.X_WB.p_W = shift * (half_A + half_B) * R.col(2);
  land.A_W = capsule_on(land.A, half_A, radius_A);
  land.B_W = capsule_on(land.B, half_B, radius_B);
  const double center = land.B.X_WB.p_W.dot(R.col(2));
  const double low = max_of(-half_A, center - half_B);
  const double high = min_of(half_A, center + half_B);
  land.nearest = {radius_B * n + (low + place * (high - low)) * R.col(2), n, land.slack / 4};
  land.A.twist.v_W = -n;
  return land;
}

template <class Scalar>
Collider<Scalar> cast(const Collider<double>& body) {
  return {{body.X_WB.p_W.cast<Scalar>(), body.X_WB.q_WB.cast<Scalar>()},
          {body.twist.v_W.cast<Scalar>(), body.twist.w_W.cast<Scalar>()},
          static_cast<Scalar>(body.inverse_mass),
          body.inverse_moments.cast<Scalar>()};
}
template <class Scalar>
Capsule<Scalar> cast(const Capsule<double>& c) {
  return {{c.axis.a.cast<Scalar>(), c.axis.b.cast<Scalar>()}, static_cast<Scalar>(c.radius)};
}
template <class Scalar>
Landing<Scalar> cast(const Landing<double>& land) {
  return {cast<Scalar>(land.A),
          cast<Scalar>(land.B),
          cast<Scalar>(land.A_W),
          cast<Scalar>(land.B_W),
          {land.nearest.point_W.cast<Scalar>(), land.nearest.normal_BA_W.cast<Scalar>(),
           static_cast<Scalar>(land.nearest.gap)},
          static_cast<Scalar>(land.slack)};
}

template <class Scalar>
bool is_nearest(const Landing<Scalar>& land) {
  const Contact<Scalar> contact = land.pressure();
  return std::memcmp(&contact, &land.nearest, sizeof(contact)) == 0;
}

template <class Scalar>
class LineContactOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(LineContactOf, Scalars);

TYPED_TEST(LineContactOf, FlatLanding_CreatesNoSpin) {  // I11
  const double u = static_cast<double>(kRoundOff<TypeParam>);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    for (const double place : {0.0, 0.3, 0.5, 1.0}) {
      test::Draws draws(1, 0, i);
      const auto land = cast<TypeParam>(flat_landing(draws, 0, place));
      const auto hit = friction_impulse<TypeParam>(land.A, land.B, land.pressure(),
                                                   {TypeParam(0.5), TypeParam(0.5), 0});
      ASSERT_GT(hit.value.magnitude, TypeParam(0));
      // Lever: 16 u of lengths of 1 m; moments up to 30 per unit of inverse mass and more about z.
      const double spin = static_cast<double>(hit.value.twist_A.w_W.norm());
      const double largest = static_cast<double>(land.A.inverse_moments.maxCoeff());
      EXPECT_LE(spin, 16 * u * static_cast<double>(hit.value.magnitude) * largest);
    }
  }
}

TYPED_TEST(LineContactOf, AnyOfTheClosestPoints_GivesTheSamePlace) {
  const double u = static_cast<double>(kRoundOff<TypeParam>);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    V first = V::Zero();
    for (const double place : {0.0, 0.2, 0.7, 1.0}) {
      test::Draws draws(2, 0, i);
      const double shift = draws.between(-0.8, 0.8);
      const auto land = cast<TypeParam>(flat_landing(draws, shift, place));
      const V point = land.pressure().point_W.template cast<double>();
      if (place == 0.0) first = point;
      EXPECT_LE((point - first).norm(), 64 * u);
      EXPECT_EQ(land.pressure().gap, land.nearest.gap);
    }
  }
}

using Pair = Eigen::Matrix<Real, 2, 1>;

/// The two ends of the line of contact, and what happens there along n, in long double.
struct Supports {
  std::array<Contact<double>, 2> at;
  Pair u = Pair::Zero();  ///< velocities before
  Eigen::Matrix<Real, 2, 2> K = Eigen::Matrix<Real, 2, 2>::Zero();
};

std::array<double, 2> span(const Landing<double>& land, const Capsule<double>& capsule) {
  const V d = unit<double>(land.A_W.axis.direction());
  const double a = d.dot(capsule.axis.a - land.nearest.point_W);
  const double b = d.dot(capsule.axis.b - land.nearest.point_W);
  return {min_of(a, b), max_of(a, b)};
}

/// Velocity along n at one place for a unit impulse at another.
Real answer_of(const Collider<double>& body, const Contact<double>& place,
               const Contact<double>& by) {
  const RealVec n = place.normal_BA_W.cast<Real>();
  const RealVec c = body.X_WB.p_W.cast<Real>();
  const RealVec spun = exact::inverse_inertia(body) * (by.point_W.cast<Real>() - c).cross(n);
  return Real(body.inverse_mass) + (place.point_W.cast<Real>() - c).cross(n).dot(spun);
}

Supports supports_of(const Landing<double>& land) {
  Supports two{{land.nearest, land.nearest}};
  const V d = unit<double>(land.A_W.axis.direction());
  const auto on_A = span(land, land.A_W);
  const auto on_B = span(land, land.B_W);
  two.at[0].point_W += max_of(on_A[0], on_B[0]) * d;
  two.at[1].point_W += min_of(on_A[1], on_B[1]) * d;
  const RealVec n = land.nearest.normal_BA_W.cast<Real>();
  for (int a = 0; a < 2; ++a) {
    const auto& place = two.at[static_cast<std::size_t>(a)];
    two.u[a] = n.dot(exact::velocity(land.A, land.A.twist, place) -
                     exact::velocity(land.B, land.B.twist, place));
    for (int b = 0; b < 2; ++b) {
      const auto& by = two.at[static_cast<std::size_t>(b)];
      two.K(a, b) = answer_of(land.A, place, by) + answer_of(land.B, place, by);
    }
  }
  return two;
}

/// l >= 0, u + K l >= 0, l (u + K l) = 0, by trying all four sets of pressed points; l < 0: none.
Pair pressures_of(const Supports& two) {
  const std::array<Pair, 4> tries{Pair(0, 0), Pair(-two.u[0] / two.K(0, 0), 0),
                                  Pair(0, -two.u[1] / two.K(1, 1)),
                                  Pair(two.K.fullPivLu().solve(-two.u))};
  const Real noise = 1e-15L * two.u.cwiseAbs().maxCoeff();
  for (const Pair& l : tries) {
    if (l.minCoeff() >= 0 && (two.u + two.K * l).minCoeff() >= -noise) return l;
  }
  return {-1, -1};
}

TEST(LineContact, OnePointOfPressure_DoesWhatTwoImpulsesDo) {
  std::array<int, 3> pressed{};
  for (std::uint64_t i = 0; i < 20000; ++i) {
    test::Draws draws(3, 0, i);
    const double shift = draws.between(-0.8, 0.8);
    Landing<double> land = flat_landing(draws, shift, draws.unit());
    for (Collider<double>* body : {&land.A, &land.B}) {
      body->twist.v_W += draws.in_ball(0.5);
      body->twist.w_W += draws.in_ball(3);
    }
    const Supports two = supports_of(land);
    const double e = draws.unit();
    const Pair l = (1 + Real(e)) * pressures_of(two);
    ASSERT_GE(l.minCoeff(), 0);
    ++pressed[static_cast<std::size_t>((l[0] > 0) + (l[1] > 0))];

    const auto one = collision_impulse(land.A, land.B, land.pressure(), e);
    RealVec torque = RealVec::Zero();
    for (int k = 0; k < 2; ++k) {
      const auto& place = two.at[static_cast<std::size_t>(k)];
      torque += (place.point_W - land.A.X_WB.p_W).cross(place.normal_BA_W).cast<Real>() * l[k];
    }
    const double bound = 1e-12 * (1 + static_cast<double>(l.sum()));
    EXPECT_NEAR(one.value.magnitude, static_cast<double>(l.sum()), bound);
    EXPECT_LE((one.value.on_A.angular_W - torque.cast<double>()).norm(), bound);
  }
  EXPECT_GT(pressed[0], 100);
  EXPECT_GT(pressed[1], 2000);
  EXPECT_GT(pressed[2], 2000);
}

/// Tilts A about `axis` (in the frame of the landing) through `pivot` and finds the contact anew.
Landing<double> tilted(const Landing<double>& flat, const V& axis_W, const V& pivot_W,
                       double angle) {
  Landing<double> land = flat;
  const Mat3<double> turn = detail::to_matrix(exp_map<double>(angle * axis_W));
  for (V* end : {&land.A_W.axis.a, &land.A_W.axis.b}) *end = pivot_W + turn * (*end - pivot_W);
  land.A.X_WB.p_W = (land.A_W.axis.a + land.A_W.axis.b) / 2;
  land.nearest = contact_from(capsule_gap(land.A_W, land.B_W), V::Zero().eval());
  return land;
}

TEST(LineContact, TiltingCapsule_MovesThePressureWithoutAJump) {
  constexpr int kSteps = 4000;
  for (std::uint64_t i = 0; i < 20; ++i) {
    test::Draws draws(4, 0, i);
    Landing<double> flat = flat_landing(draws, draws.between(-0.5, 0.5), 0.5);
    flat.A.twist.w_W = draws.in_ball(0.3);
    const V n = flat.nearest.normal_BA_W;
    const V along = unit<double>(flat.A_W.axis.direction());
    const auto on_A = span(flat, flat.A_W);
    const auto on_B = span(flat, flat.B_W);
    const double overlap = min_of(on_A[1], on_B[1]) - max_of(on_A[0], on_B[0]);
    // In the common plane about one end, and across it about the middle.
    const double across = 4 * std::sqrt(2 * flat.slack * (flat.A_W.radius + flat.B_W.radius));
    const std::array<V, 2> axes{V(n.cross(along)), n};
    const std::array<V, 2> pivots{flat.A_W.axis.a, flat.A.X_WB.p_W};
    const std::array<double, 2> last{4 * flat.slack / overlap, across / overlap};
    for (std::size_t way = 0; way < 2; ++way) {
      V before = flat.pressure().point_W;
      double largest_step = 0;
      for (int k = 0; k <= kSteps; ++k) {
        const auto land = tilted(flat, axes[way], pivots[way], last[way] * k / kSteps);
        const V now = land.pressure().point_W;
        largest_step = max_of(largest_step, (now - before).norm());
        before = now;
        if (k == kSteps) {
          EXPECT_LE((now - land.nearest.point_W).norm(), 1e-15);
        }
      }
      EXPECT_LE(largest_step, 16 * overlap / kSteps) << i << " " << way;
    }
  }
}

Landing<double> pair_of(const Capsule<double>& A_W, const Capsule<double>& B_W) {
  test::Draws draws(5, 0, 0);
  Landing<double> land;
  land.A = rod(draws, Quat<double>::Identity());
  land.B = rod(draws, Quat<double>::Identity());
  land.A_W = A_W;
  land.B_W = B_W;
  land.A.X_WB.p_W = (A_W.axis.a + A_W.axis.b) / 2;
  land.B.X_WB.p_W = (B_W.axis.a + B_W.axis.b) / 2;
  land.nearest = contact_from(capsule_gap(A_W, B_W), V::Zero().eval());
  land.A.twist.v_W = -land.nearest.normal_BA_W;
  land.A.twist.w_W = V(0.1, 0.2, 0.3);
  land.slack = 1e-4;
  return land;
}

TEST(LineContact, PairsThatDoNotRunAlongside_KeepTheNearestPoint) {
  const Capsule<double> bar{{V(-1, 0, 0), V(1, 0, 0)}, 0.1};
  EXPECT_TRUE(is_nearest(pair_of(bar, {{V(0, -1, 0.2), V(0.3, 1, 0.2)}, 0.1})));  // crossing
  EXPECT_TRUE(is_nearest(pair_of(bar, {{V(0, -1, 0.2), V(0, 1, 0.2)}, 0.1})));    // at right angles
  EXPECT_TRUE(is_nearest(pair_of(bar, {{V(1.2, 0, 0), V(3, 0, 0)}, 0.1})));       // end to end
  EXPECT_TRUE(is_nearest(pair_of(bar, {{V(0.5, 0, 0.2), V(0.6, 0, 1)}, 0.1})));   // end on side
  EXPECT_TRUE(is_nearest(pair_of(bar, Capsule<double>::sphere(V(0.3, 0, 0.2), 0.1))));
  EXPECT_TRUE(is_nearest(pair_of(Capsule<double>::sphere(V(0.3, 0, 0.2), 0.1), bar)));
}

TEST(LineContact, NothingToDo_KeepsTheNearestPoint) {
  test::Draws draws(6, 0, 0);
  const Landing<double> land = flat_landing(draws, 0.2, 0.3);
  EXPECT_FALSE(is_nearest(land));
  Landing<double> other = land;
  other.slack = 0;
  EXPECT_TRUE(is_nearest(other));
  other = land;
  other.A.twist.v_W = land.nearest.normal_BA_W;  // parting
  EXPECT_TRUE(is_nearest(other));
  other = land;
  other.A.inverse_moments.setZero();  // nothing can turn: every place is as good
  other.B.inverse_moments.setZero();
  EXPECT_TRUE(is_nearest(other));
  other.A.inverse_mass = other.B.inverse_mass = 0;
  EXPECT_TRUE(is_nearest(other));
  other = land;
  other.A.twist.w_W.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(is_nearest(other));
  other = land;
  other.A_W.axis.a.x() = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_nearest(other));
}

/// About its centre, along a bar that is fixed: half of it comes down, and the end of that half
/// hits first, wherever the nearest points were said to be. Powers of two: nothing is rounded.
TEST(LineContact, RodThatOnlyTurns_PressesWithTheEndThatComesDown) {
  for (const double turn : {-0.5, 0.5}) {
    for (const double place : {-0.25, 0.0, 0.25}) {
      Landing<double> land;
      land.slack = 0x1p-10;
      land.A.X_WB.p_W = V(0.25 + land.slack / 4, 0, 0);
      land.A.inverse_mass = 1;
      land.A.inverse_moments = V(4, 4, 8);
      land.A.twist.w_W = V(0, turn, 0);  // turn z along x
      land.B.inverse_mass = 0;
      land.B.inverse_moments = V::Zero();
      land.A_W = capsule_on(land.A, 1, 0.125);
      land.B_W = capsule_on(land.B, 2, 0.125);
      land.nearest = {V(0.125, 0, place), V(1, 0, 0), land.slack / 4};
      EXPECT_EQ(land.pressure().point_W, V(0.125, 0, turn > 0 ? -1 : 1)) << turn << ' ' << place;
    }
  }
}

/// A bar, half as long as its moment allows, that falls and turns so that the blow at one end stops
/// all of it: k there is 1 + 1/2, the speed 1 + 1/2. Powers of two: nothing is rounded.
TEST(LineContact, BlowThatStopsTheWholeBar_IsAtThatEnd) {
  for (const double turn : {-0.5, 0.5}) {
    Landing<double> land;
    land.slack = 0x1p-10;
    land.A.X_WB.p_W = V(0.25 + land.slack / 4, 0, 0);
    land.A.inverse_mass = 1;
    land.A.inverse_moments = V(0.5, 0.5, 1);
    land.A.twist = {V(-1, 0, 0), V(0, turn, 0)};  // turn z along x
    land.A_W = capsule_on(land.A, 1, 0.125);
    land.B_W = capsule_on(land.B, 2, 0.125);
    land.nearest = {V(0.125, 0, 0), V(1, 0, 0), land.slack / 4};
    EXPECT_EQ(land.pressure().point_W, V(0.125, 0, turn > 0 ? -1 : 1)) << turn;
    const auto hit = collision_impulse(land.A, land.B, land.pressure(), 0.0);
    EXPECT_EQ(hit.value.twist_A.v_W, V(0, 0, 0)) << turn;
    EXPECT_EQ(hit.value.twist_A.w_W, V(0, 0, 0)) << turn;
  }
}

}  // namespace
}  // namespace batuta
