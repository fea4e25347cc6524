// SPDX-License-Identifier: MIT
#include "batuta/mechanics/solid.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "samples.hpp"

namespace batuta {
namespace {

using samples::Real;
using samples::Source;

using Vec = Eigen::Matrix<Real, 3, 1>;
using Mat = Eigen::Matrix<Real, 3, 3>;

struct PointMass {
  Real mass;
  Vec x;
};

/// The capsule as points with the same moments up to the second: discs at Gauss points along the
/// axis, each of them four points at 1/sqrt(2) of its radius.
std::vector<PointMass> cloud_of(const Capsule<Real>& capsule, Real density) {
  const Vec middle = (capsule.axis.a + capsule.axis.b) / 2;
  const Vec along = capsule.axis.b - capsule.axis.a;
  const Real core = along.norm();
  const Vec e = core > 0 ? Vec(along / core) : Vec(1, 2, 3).normalized();
  const Vec f = e.unitOrthogonal();
  const Vec g = e.cross(f);
  const Real end = core / 2 + capsule.radius;
  const std::array<Real, 4> borders = {-end, -core / 2, core / 2, end};
  std::vector<PointMass> points;
  for (std::size_t part = 0; part < 3; ++part) {
    const Real half = (borders[part + 1] - borders[part]) / 2;
    for (int k = -1; k <= 1;
         ++k) {  // three-point Gauss: the square of a disc's area is of degree 4
      const Real x = borders[part] + half * (1 + static_cast<Real>(k) * std::sqrt(Real(3) / 5));
      const Real weight = half * (k == 0 ? Real(8) / 9 : Real(5) / 9);
      const Real beyond = std::max(Real(0), std::abs(x) - core / 2);
      const Real rr = capsule.radius * capsule.radius - beyond * beyond;
      const Real ring = std::sqrt(rr / 2);
      const Real mass = density * weight * Real(3.14159265358979323846264338327950288L) * rr / 4;
      for (const Vec& side : {f, Vec(-f), g, Vec(-g)}) {
        points.push_back({mass, middle + x * e + ring * side});
      }
    }
  }
  return points;
}

/// What the points come to in W.
struct Sums {
  Real mass = 0;
  Vec center = Vec::Zero();
  Mat inertia = Mat::Zero();  ///< about the centre
  Vec p = Vec::Zero();
  Vec b = Vec::Zero();  ///< about the centre

  Sums(const std::vector<PointMass>& points, const Vec& v, const Vec& w) {
    for (const PointMass& point : points) mass += point.mass;
    for (const PointMass& point : points) center += point.mass / mass * point.x;
    for (const PointMass& point : points) {
      const Vec r = point.x - center;
      const Vec speed = v + w.cross(r);
      inertia += point.mass * (r.squaredNorm() * Mat::Identity() - r * r.transpose());
      p += point.mass * speed;
      b += point.mass * r.cross(speed);
    }
  }
};

template <class S>
Capsule<Real> exact(const Capsule<S>& capsule) {
  return {{capsule.axis.a.template cast<Real>(), capsule.axis.b.template cast<Real>()},
          static_cast<Real>(capsule.radius)};
}

template <class S>
std::vector<PointMass> placed(std::vector<PointMass> points, const Pose<S>& X) {
  const Eigen::Quaternion<Real> q = X.q_WB.template cast<Real>().normalized();
  for (PointMass& point : points) point.x = X.p_W.template cast<Real>() + q * point.x;
  return points;
}

template <class Scalar>
class Solid : public ::testing::Test {
 protected:
  static constexpr Real kRounding = 64 * samples::u<Scalar>;
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Solid, Scalars);

/// Lengths from a ball to a rod, along an axis of G or anyhow, about its origin or beside it.
template <class S>
Capsule<S> draw(Source<S>& source, int i) {
  const S radius = source.log_uniform(1e-2, 1);
  const std::array<Vec3<S>, 4> ways = {Vec3<S>(Vec3<S>::UnitX()), Vec3<S>(-Vec3<S>::UnitY()),
                                       Vec3<S>(Vec3<S>::UnitZ()), source.direction()};
  const S length = i % 5 == 0 ? S(0) : source.log_uniform(1e-2, 10);
  const Vec3<S> half = length / 2 * ways[static_cast<std::size_t>(i % 4)];
  const Vec3<S> middle = i % 3 == 0 ? Vec3<S>(Vec3<S>::Zero()) : source.vector(1);
  return {{middle - half, middle + half}, radius};
}

TYPED_TEST(Solid, Capsules_HaveTheMomentsOfTheirVolume) {
  using S = TypeParam;
  Source<S> source(17);
  for (int i = 0; i < 600; ++i) {
    const Capsule<S> capsule_G = draw(source, i);
    const Pose<S> X_WG = {source.vector(3), source.rotation()};
    const Twist<S> twist = {source.vector(5), source.vector(20)};
    const auto made = solid_body(capsule_G, S(7850), X_WG, twist);
    ASSERT_TRUE(made.ok()) << i;
    const Body<S>& body = made.value.body;
    const Sums truth(placed(cloud_of(exact(capsule_G), 7850), X_WG),
                     twist.v_W.template cast<Real>(), twist.w_W.template cast<Real>());

    const Real size = 10;  // of places and lengths, m
    EXPECT_NEAR(static_cast<double>(body.inverse_mass * truth.mass), 1,
                static_cast<double>(this->kRounding));
    EXPECT_LT((body.X_WB.p_W.template cast<Real>() - truth.center).norm(), this->kRounding * size);
    const Mat R = body.X_WB.q_WB.toRotationMatrix().template cast<Real>();
    const Vec moments = body.inverse_moments.template cast<Real>().cwiseInverse();
    const Mat inertia = R * moments.asDiagonal() * R.transpose();
    EXPECT_LT((inertia - truth.inertia).norm(), this->kRounding * truth.inertia.norm()) << i;
    EXPECT_LT((body.momentum.linear_W.template cast<Real>() - truth.p).norm(),
              this->kRounding * truth.p.norm());
    EXPECT_LT((body.momentum.angular_W.template cast<Real>() - truth.b).norm(),
              this->kRounding * truth.inertia.norm() * 40);
  }
}

TYPED_TEST(Solid, Capsules_StayWhereTheyWere) {
  using S = TypeParam;
  Source<S> source(19);
  for (int i = 0; i < 600; ++i) {
    const Capsule<S> capsule_G = draw(source, i);
    const Pose<S> X_WG = {source.vector(3), source.rotation()};
    const auto made = solid_body(capsule_G, S(1), X_WG, Twist<S>{});
    ASSERT_TRUE(made.ok());
    const Capsule<S> before = to_world(X_WG, capsule_G);
    const Capsule<S> after = to_world(made.value.body.X_WB, made.value.capsule_B);
    const S near = static_cast<S>(this->kRounding) * 10;
    EXPECT_LT((after.axis.a - before.axis.a).norm(), near) << i;
    EXPECT_LT((after.axis.b - before.axis.b).norm(), near) << i;
    EXPECT_EQ(after.radius, before.radius);
    // The middle is the body's own point, exactly.
    EXPECT_EQ(made.value.capsule_B.axis.a, -made.value.capsule_B.axis.b);
  }
}

TYPED_TEST(Solid, CapsuleAboutTheOriginAlongAnAxis_KeepsItsFrame) {
  using S = TypeParam;
  const Pose<S> X_WG = {{S(0.1), S(-0.7), S(2)}, renewed(Quat<S>(S(0.3), S(0.1), S(-0.8), S(0.2)))};
  for (int i = 0; i < 3; ++i) {
    Vec3<S> half = Vec3<S>::Zero();
    half[i] = S(-0.45);
    const Capsule<S> capsule_G = {{-half, half}, S(0.005)};
    const auto made = solid_body(capsule_G, S(7850), X_WG, Twist<S>{});
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(made.value.body.X_WB.p_W, X_WG.p_W);
    EXPECT_EQ(made.value.body.X_WB.q_WB.coeffs(), renewed(X_WG.q_WB).coeffs());
    EXPECT_EQ(made.value.capsule_B.axis.a, capsule_G.axis.a);
    EXPECT_EQ(made.value.capsule_B.axis.b, capsule_G.axis.b);
  }
}

TYPED_TEST(Solid, InfiniteDensity_IsFixed) {
  using S = TypeParam;
  const S infinity = std::numeric_limits<S>::infinity();
  const Capsule<S> post = {{{0, S(-2), 0}, {0, S(2), 0}}, S(0)};
  const Pose<S> X_WG = {{1, 0, 0}, Quat<S>::Identity()};
  const auto made = solid_body(post, infinity, X_WG, Twist<S>{});
  ASSERT_TRUE(made.ok());
  EXPECT_TRUE(is_fixed(made.value.body));
  Twist<S> twist;
  twist.w_W.y() = S(1e-3);
  EXPECT_EQ(solid_body(post, infinity, X_WG, twist).status, Status::kInvalidArgument);
}

TYPED_TEST(Solid, WhatCannotBe_IsRefused) {
  using S = TypeParam;
  const S nan = std::numeric_limits<S>::quiet_NaN();
  const S infinity = std::numeric_limits<S>::infinity();
  const S most = std::numeric_limits<S>::max();
  const Capsule<S> good = {{{0, 0, -1}, {0, 0, 1}}, S(0.1)};
  const Pose<S> X = {{0, 0, 0}, Quat<S>::Identity()};
  const auto refuses = [](const auto& capsule, S density, const auto& pose, const auto& twist) {
    const auto made = solid_body<S>(capsule, density, pose, twist);
    return made.status == Status::kInvalidArgument && made.value.body.inverse_mass == S(0);
  };
  ASSERT_FALSE(refuses(good, S(1), X, Twist<S>{}));
  for (const S density :
       {S(0), S(-1), nan, -infinity, most, std::numeric_limits<S>::denorm_min()}) {
    EXPECT_TRUE(refuses(good, density, X, Twist<S>{})) << density;
  }
  EXPECT_TRUE(refuses(good, S(1), Pose<S>{{0, 0, 0}, Quat<S>(0, 0, 0, 0)}, Twist<S>{}));
  EXPECT_TRUE(refuses(good, infinity, Pose<S>{{0, 0, 0}, Quat<S>(0, 0, 0, 0)}, Twist<S>{}));
  for (const S bad : {nan, infinity, -infinity}) {
    Capsule<S> capsule = good;
    capsule.axis.b.y() = bad;
    EXPECT_TRUE(refuses(capsule, S(1), X, Twist<S>{}));
    capsule = good;
    capsule.radius = bad;
    EXPECT_TRUE(refuses(capsule, S(1), X, Twist<S>{}));
    Pose<S> pose = X;
    pose.p_W.x() = bad;
    EXPECT_TRUE(refuses(good, S(1), pose, Twist<S>{}));
    pose = X;
    pose.q_WB.w() = bad;
    EXPECT_TRUE(refuses(good, S(1), pose, Twist<S>{}));
    for (const S density : {S(1), infinity}) {
      Twist<S> twist;
      twist.v_W.z() = bad;
      EXPECT_TRUE(refuses(good, density, X, twist));
      twist = {};
      twist.w_W.z() = bad;
      EXPECT_TRUE(refuses(good, density, X, twist));
    }
  }
  Twist<S> fast;
  fast.v_W.x() = most;
  EXPECT_TRUE(refuses(good, S(1000), X, fast)) << "its momentum overflows";
  for (const S radius : {S(0), S(-0.1)}) {
    Capsule<S> capsule = good;
    capsule.radius = radius;
    EXPECT_TRUE(refuses(capsule, S(1000), X, Twist<S>{}));
  }
}

/// However thin: M r^2 / 2 of the cylinder and 2/5 H r^2 of both half balls. The tensor of a
/// capsule that lies askew has it as a difference, and a needle's is lost there.
TYPED_TEST(Solid, AxialMoment_HasAllDigits) {
  using S = TypeParam;
  constexpr long double kPi = 3.14159265358979323846264338327950288L;
  for (const S radius : {S(1), S(1e-2), S(1e-3), S(1e-4), S(1e-6)}) {
    for (const Vec3<S>& half : {Vec3<S>(0, 0, S(0.45)), Vec3<S>(0, S(-0.45), 0),
                                Vec3<S>(S(0.27), 0, S(0.36)), Vec3<S>(0, 0, 0)}) {
      const auto made = solid_body<S>({{-half, half}, radius}, S(7850), {}, {});
      ASSERT_EQ(made.status, Status::kOk) << radius;
      const auto r = static_cast<long double>(radius);
      const auto L = static_cast<long double>(made.value.capsule_B.axis.b.norm() * 2);
      const long double axial = 7850 * kPi * r * r * (L * r * r / 2 + 4 * r / 3 * r * r * 2 / 5);
      const auto largest = static_cast<long double>(made.value.body.inverse_moments.maxCoeff());
      EXPECT_NEAR(static_cast<double>(largest * axial), 1, 32 * static_cast<double>(kRoundOff<S>))
          << radius << ' ' << half.z();
    }
  }
}

/// The direction of a quaternion is the orientation; its length is nobody's.
TYPED_TEST(Solid, OrientationOfAnyLength_IsTheOneOfItsDirection) {
  using S = TypeParam;
  const Capsule<S> far = {{{0, 0, 1}, {0, 0, 3}}, S(0.1)};
  const Pose<S> X_WG = {{1, 2, 3}, Quat<S>(S(0.5), S(0.5), S(-0.5), S(0.5))};
  const auto truth = solid_body<S>(far, 1000, X_WG, {});
  ASSERT_EQ(truth.status, Status::kOk);
  for (const S length : {S(1.001), S(0.5), S(2), S(1e-3), S(1e6)}) {
    Pose<S> scaled = X_WG;
    scaled.q_WB.coeffs() *= length;
    const auto made = solid_body<S>(far, 1000, scaled, {});
    ASSERT_EQ(made.status, Status::kOk);
    const Vec3<S> off = made.value.body.X_WB.p_W - truth.value.body.X_WB.p_W;
    EXPECT_LT(off.norm(), 64 * kRoundOff<S>) << length;
    EXPECT_NEAR(std::abs(made.value.body.X_WB.q_WB.dot(truth.value.body.X_WB.q_WB)), S(1),
                16 * kRoundOff<S>);
  }
}

}  // namespace
}  // namespace batuta
