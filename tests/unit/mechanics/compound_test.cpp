// SPDX-License-Identifier: MIT
#include "batuta/mechanics/compound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "samples.hpp"

namespace batuta {
namespace {

using samples::Real;
using samples::real;
using samples::Source;
using samples::u;

template <class Scalar>
class CompoundBody : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(CompoundBody, Scalars);

constexpr Real kPi = 3.14159265358979323846264338327950288L;

/// Mass and its first and second moment about the origin, by adding up thin discs: no parallel-axis
/// theorem and no formula for a capsule.
class Integral {
 public:
  template <class Scalar>
  void add(const CapsulePart<Scalar>& part) {
    const Vec3<Real> a = real(part.capsule_S.axis.a);
    const Vec3<Real> along = real(part.capsule_S.axis.b) - a;
    const Real core = along.norm();
    const Vec3<Real> e = core > 0 ? Vec3<Real>(along / core) : Vec3<Real>::UnitX();
    const auto r = static_cast<Real>(part.capsule_S.radius);
    const Rod rod = {a, e, core, r, static_cast<Real>(part.density)};
    add_piece(rod, -r, 0);
    add_piece(rod, 0, core);
    add_piece(rod, core, core + r);
  }
  Real mass() const { return mass_; }
  Vec3<Real> center() const { return first_ / mass_; }
  Mat3<Real> inertia() const {
    const Mat3<Real> C = second_ - mass_ * center() * center().transpose();
    return C.trace() * Mat3<Real>::Identity() - C;
  }

 private:
  struct Rod {
    Vec3<Real> a, e;
    Real core, radius, density;
  };
  // Three-point Gauss integrates polynomials up to the fifth degree, as these are, exactly.
  void add_piece(const Rod& rod, Real from, Real to) {
    const Real half = (to - from) / 2;
    const Real middle = (to + from) / 2;
    const Real outer = std::sqrt(Real(3) / 5) * half;
    add_disc(rod, middle - outer, half * 5 / 9);
    add_disc(rod, middle, half * 8 / 9);
    add_disc(rod, middle + outer, half * 5 / 9);
  }
  void add_disc(const Rod& rod, Real s, Real width) {
    const Real beyond = std::max({Real(0), -s, s - rod.core});
    const Real rr = rod.radius * rod.radius - beyond * beyond;
    const Real dm = rod.density * kPi * rr * width;
    const Vec3<Real> x = rod.a + s * rod.e;
    mass_ += dm;
    first_ += dm * x;
    second_ +=
        dm * (x * x.transpose() + rr / 4 * (Mat3<Real>::Identity() - rod.e * rod.e.transpose()));
  }

  Real mass_ = 0;
  Vec3<Real> first_ = Vec3<Real>::Zero();
  Mat3<Real> second_ = Mat3<Real>::Zero();
};

template <class Scalar>
Pose<Scalar> random_pose(Source<Scalar>& source) {
  return {source.vector(1), source.rotation()};
}

template <class Scalar>
CapsulePart<Scalar> random_part(Source<Scalar>& source) {
  return {{{source.vector(1), source.vector(1)}, source.uniform(0.02, 0.3)},
          source.log_uniform(100, 10000)};
}

template <class Scalar>
Mat3<Real> matrix(const Quat<Scalar>& q) {
  return real(q).normalized().toRotationMatrix();
}

/// Moments and axes of a body as a tensor in W.
template <class Scalar>
Mat3<Real> inertia_W(const Body<Scalar>& body) {
  const Mat3<Real> R = matrix(body.X_WB.q_WB);
  return R * real(body.inverse_moments).cwiseInverse().asDiagonal() * R.transpose();
}

double largest(const Mat3<Real>& M) {
  return static_cast<double>(M.cwiseAbs().maxCoeff());
}

/// Distance of the ends of a body's capsule from where X_WS puts the modelled one.
template <class Scalar>
double misplaced(const Body<Scalar>& body, const Capsule<Scalar>& capsule_B,
                 const Pose<Scalar>& X_WS, const Capsule<Scalar>& capsule_S) {
  const Capsule<Scalar> is_W = to_world(body.X_WB, capsule_B);
  const Capsule<Scalar> want_W = to_world(X_WS, capsule_S);
  return static_cast<double>(
      std::max((is_W.axis.a - want_W.axis.a).norm(), (is_W.axis.b - want_W.axis.b).norm()));
}

TYPED_TEST(CompoundBody, RandomParts_AgreeWithTheIntegralAndLieWhereTheyWereModelled) {
  Source<TypeParam> source(1);
  for (int i = 0; i < 2000; ++i) {
    const CapsulePart<TypeParam> parts[] = {random_part(source), random_part(source),
                                            random_part(source)};
    const Pose<TypeParam> X_WS = random_pose(source);
    const auto made = make_compound(parts, X_WS);
    ASSERT_TRUE(made.ok());
    Integral truth;
    for (const auto& part : parts) truth.add(part);
    const Body<TypeParam>& body = made.value.body;
    EXPECT_NEAR(static_cast<double>(static_cast<Real>(body.inverse_mass) * truth.mass()), 1,
                16 * u<TypeParam>);
    const Mat3<Real> R = matrix(X_WS.q_WB);
    EXPECT_LE((real(body.X_WB.p_W) - real(X_WS.p_W) - R * truth.center()).norm(),
              40 * u<TypeParam>);
    const Mat3<Real> I = R * truth.inertia() * R.transpose();
    EXPECT_LE(largest(inertia_W(body) - I), 100 * u<TypeParam> * largest(I));
    ASSERT_EQ(made.value.capsules_B.size(), 3);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(made.value.capsules_B[k].radius, parts[k].capsule_S.radius);
      EXPECT_LE(misplaced(body, made.value.capsules_B[k], X_WS, parts[k].capsule_S),
                64 * u<TypeParam>);
    }
    EXPECT_EQ(body.momentum.linear_W, Vec3<TypeParam>(0, 0, 0)) << "at rest";
    EXPECT_EQ(body.momentum.angular_W, Vec3<TypeParam>(0, 0, 0));
  }
}

TYPED_TEST(CompoundBody, BentLimb_HasItsCentreInsideTheBend) {
  // Two equal legs at a right angle, and their exact moments: parallel axes by hand.
  const TypeParam r(0.125);
  const Capsule<TypeParam> upper = {{{0, 0, 0}, {1, 0, 0}}, r};
  const Capsule<TypeParam> lower = {{{1, 0, 0}, {1, 1, 0}}, r};
  const auto made = make_compound<TypeParam>({{upper, 1000}, {lower, 1000}}, {});
  ASSERT_TRUE(made.ok());
  const Body<TypeParam>& body = made.value.body;
  EXPECT_LE((body.X_WB.p_W - Vec3<TypeParam>(TypeParam(0.75), TypeParam(0.25), 0)).norm(),
            8 * u<TypeParam>);
  const auto leg = solid_capsule(upper, TypeParam(1000)).value;
  const auto axial = static_cast<double>(leg.inertia_S(0, 0));
  const auto across = static_cast<double>(leg.inertia_S(1, 1));
  const auto m = static_cast<double>(leg.mass);
  // Centres at (-1/4, -1/4) and (1/4, 1/4): the light axis is the line through them.
  const double truth[] = {axial + across, axial + across + m / 4, 2 * across + m / 4};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(1 / static_cast<double>(body.inverse_moments(i)), truth[i],
                32 * u<TypeParam> * truth[2]);
  }
  EXPECT_TRUE(body.spin_shows);
}

TYPED_TEST(CompoundBody, ChoiceOfS_ChangesNothingInTheWorld) {
  Source<TypeParam> source(2);
  for (int i = 0; i < 2000; ++i) {
    const CapsulePart<TypeParam> parts[] = {random_part(source), random_part(source)};
    const Pose<TypeParam> X_WS = random_pose(source);
    const Pose<TypeParam> X_ST = random_pose(source);  // the other model's frame T
    CapsulePart<TypeParam> others[] = {parts[0], parts[1]};
    for (auto& part : others) {
      part.capsule_S.axis = {to_body(X_ST, part.capsule_S.axis.a),
                             to_body(X_ST, part.capsule_S.axis.b)};
    }
    const Pose<TypeParam> X_WT = {to_world(X_WS, X_ST.p_W), X_WS.q_WB * X_ST.q_WB};
    const auto one = make_compound(parts, X_WS);
    const auto other = make_compound(others, X_WT);
    ASSERT_TRUE(one.ok() && other.ok());
    EXPECT_LE((one.value.body.X_WB.p_W - other.value.body.X_WB.p_W).norm(), 64 * u<TypeParam>);
    const Mat3<Real> I = inertia_W(one.value.body);
    // A thin short rod's tensor goes with the cube of its length, whose ends T rounds anew.
    EXPECT_LE(largest(inertia_W(other.value.body) - I), 400 * u<TypeParam> * largest(I));
    for (int k = 0; k < 2; ++k) {
      EXPECT_LE(misplaced(other.value.body, other.value.capsules_B[k], X_WS, parts[k].capsule_S),
                64 * u<TypeParam>);
    }
  }
}

/// Three pieces of one rod along e.
template <class Scalar>
std::vector<CapsulePart<Scalar>> rod_along(const Vec3<Scalar>& e) {
  const auto at = [&](double s) -> Vec3<Scalar> { return static_cast<Scalar>(s) * e; };
  const auto r = Scalar(0.02);
  return {{{{at(-0.4), at(0.5)}, r}, Scalar(7850)},
          {{{at(-0.5), at(-0.4)}, 2 * r}, Scalar(900)},
          {{{at(-0.55), at(-0.55)}, 3 * r}, Scalar(7850)}};
}

template <class Scalar>
Compound<Scalar, 3> made_of(const std::vector<CapsulePart<Scalar>>& parts) {
  const auto made = make_compound<3>(parts.data(), static_cast<int>(parts.size()), Pose<Scalar>());
  EXPECT_TRUE(made.ok());
  return made.value;
}

TYPED_TEST(CompoundBody, RodAlongAnAxisOfS_HasTheAxesOfS) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto rod = made_of(rod_along<TypeParam>(Vec3<TypeParam>::Unit(axis)));
    const Mat3<TypeParam> R = detail::to_matrix(rod.body.X_WB.q_WB).cwiseAbs();
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(R.col(k).maxCoeff(), 1, 4 * u<TypeParam>);
    EXPECT_NEAR(R(axis, 0), 1, 4 * u<TypeParam>) << "the light axis comes first";
    EXPECT_FALSE(rod.body.spin_shows);
  }
}

TYPED_TEST(CompoundBody, RoundingDoesNotTurnARod) {
  Source<TypeParam> source(3);
  for (int i = 0; i < 500; ++i) {
    auto parts = rod_along(source.direction());
    const auto rod = made_of(parts);
    EXPECT_EQ(rod.body.inverse_moments(1), rod.body.inverse_moments(2)) << "a body of revolution";
    EXPECT_FALSE(rod.body.spin_shows);
    const auto lighter = [](const auto& a, const auto& b) { return a.density < b.density; };
    std::stable_sort(parts.begin(), parts.end(), lighter);
    std::swap(parts[1], parts[2]);
    const auto same = made_of(parts);  // in another order, with other rounding
    EXPECT_LE(largest(matrix(rod.body.X_WB.q_WB) - matrix(same.body.X_WB.q_WB)),
              100 * u<TypeParam>);
  }
}

TYPED_TEST(CompoundBody, CrossOfThreeRods_HasTheAxesOfS) {
  const TypeParam r(0.0625);
  const TypeParam l(0.25);
  const auto cross = make_compound<TypeParam>({{{{{-l, 0, 0}, {l, 0, 0}}, r}, 800},
                                               {{{{0, -l, 0}, {0, l, 0}}, r}, 800},
                                               {{{{0, 0, -l}, {0, 0, l}}, r}, 800}},
                                              {});
  ASSERT_TRUE(cross.ok());
  const Body<TypeParam>& body = cross.value.body;
  EXPECT_EQ(body.X_WB.q_WB.coeffs(), Quat<TypeParam>::Identity().coeffs());
  EXPECT_EQ(body.inverse_moments(0), body.inverse_moments(1));
  EXPECT_EQ(body.inverse_moments(1), body.inverse_moments(2));
}

/// However it lies in S: what is left beside its equal moments is rounding, and must not choose.
TYPED_TEST(CompoundBody, TurnedCrossOfThreeRods_HasTheAxesOfS) {
  Source<TypeParam> source(4);
  for (int i = 0; i < 200; ++i) {
    const Vec3<TypeParam> along = source.direction() / 4;
    const Vec3<TypeParam> across = along.cross(source.direction()).normalized() / 4;
    std::vector<CapsulePart<TypeParam>> parts;
    for (const Vec3<TypeParam>& end : {along, across, Vec3<TypeParam>(4 * along.cross(across))}) {
      parts.push_back({{{-end, end}, TypeParam(0.0625)}, 800});
    }
    const Body<TypeParam> body = made_of(parts).body;
    EXPECT_EQ(body.X_WB.q_WB.coeffs(), Quat<TypeParam>::Identity().coeffs()) << i;
    EXPECT_EQ(body.inverse_moments(0), body.inverse_moments(2)) << i;
  }
}

TYPED_TEST(CompoundBody, GivenMassProperties_AreThoseOfTheBody) {
  Source<TypeParam> source(4);
  const Capsule<TypeParam> shape = random_part(source).capsule_S;
  const MassProperties<TypeParam> mass = {
      2, {1, 2, 3}, Vec3<TypeParam>(5, 4, 3).asDiagonal().toDenseMatrix()};
  const Pose<TypeParam> X_WS = {{10, 0, 0}, Quat<TypeParam>(0, 0, 0, 1)};  // half a turn about z
  const auto made = make_compound(mass, {shape, shape}, X_WS);
  ASSERT_TRUE(made.ok());
  const Body<TypeParam>& body = made.value.body;
  EXPECT_EQ(body.inverse_mass, TypeParam(0.5));
  EXPECT_EQ(body.X_WB.p_W, Vec3<TypeParam>(9, -2, 3));
  const Vec3<Real> moments(5, 4, 3);
  EXPECT_LE(largest(inertia_W(body) - Mat3<Real>(moments.asDiagonal())), 32 * u<TypeParam>);
  EXPECT_LE(misplaced(body, made.value.capsules_B[1], X_WS, shape), 64 * u<TypeParam>);
}

TYPED_TEST(CompoundBody, InvalidPartsAndCounts_AreRefused) {
  const Capsule<TypeParam> good = {{{0, 0, 0}, {1, 0, 0}}, TypeParam(0.1)};
  const Capsule<TypeParam> bad = {{{0, 0, 0}, {1, 0, 0}}, TypeParam(-1)};
  const std::array<CapsulePart<TypeParam>, 3> parts = {
      {{good, TypeParam(1)}, {good, TypeParam(1)}, {good, TypeParam(1)}}};
  const Pose<TypeParam> here;
  EXPECT_EQ(make_compound<2>(parts.data(), 0, here).status, Status::kInvalidArgument);
  EXPECT_EQ(make_compound<2>(parts.data(), -1, here).status, Status::kInvalidArgument);
  EXPECT_EQ(make_compound<2>(parts.data(), 2, here).status, Status::kOk);
  EXPECT_EQ(make_compound<2>(parts.data(), 3, here).status, Status::kInvalidArgument);
  EXPECT_EQ(make_compound<TypeParam>({{good, 1}, {bad, 1}}, here).status, Status::kInvalidArgument);
  EXPECT_EQ(make_compound<TypeParam>({{good, 1}, {good, 0}}, here).status,
            Status::kInvalidArgument);
  Pose<TypeParam> nowhere;
  nowhere.q_WB.x() = std::numeric_limits<TypeParam>::quiet_NaN();
  EXPECT_EQ(make_compound<TypeParam>({{good, 1}}, nowhere).status, Status::kInvalidArgument);
  nowhere.q_WB.coeffs().setZero();
  EXPECT_EQ(make_compound<TypeParam>({{good, 1}}, nowhere).status, Status::kInvalidArgument);
  nowhere = {{0, std::numeric_limits<TypeParam>::infinity(), 0}, Quat<TypeParam>::Identity()};
  EXPECT_EQ(make_compound<TypeParam>({{good, 1}}, nowhere).status, Status::kInvalidArgument);
}

TYPED_TEST(CompoundBody, ImpossibleMassProperties_AreRefused) {
  using Limits = std::numeric_limits<TypeParam>;
  const Capsule<TypeParam> good = {{{0, 0, 0}, {1, 0, 0}}, TypeParam(0.1)};
  const auto status_of = [&](TypeParam mass, const Mat3<TypeParam>& inertia) {
    return make_compound<TypeParam>({mass, {0, 0, 0}, inertia}, {good}, {}).status;
  };
  const Mat3<TypeParam> one = Mat3<TypeParam>::Identity();
  const auto moments = [](double a, double b, double c) -> Mat3<TypeParam> {
    return Vec3<double>(a, b, c).asDiagonal().toDenseMatrix().cast<TypeParam>();
  };
  Mat3<TypeParam> skew = one;
  skew(0, 1) = TypeParam(0.1);
  for (int i = 0; i < 9; ++i) {
    for (const TypeParam bad : {Limits::quiet_NaN(), Limits::infinity()}) {
      Mat3<TypeParam> hole = one;
      hole(i / 3, i % 3) = hole(i % 3, i / 3) = bad;
      EXPECT_EQ(status_of(1, hole), Status::kInvalidArgument);
    }
  }
  EXPECT_EQ(status_of(1, one), Status::kOk);
  for (const TypeParam mass :
       {TypeParam(0), TypeParam(-1), Limits::infinity(), Limits::quiet_NaN()}) {
    EXPECT_EQ(status_of(mass, one), Status::kInvalidArgument);
  }
  EXPECT_EQ(status_of(1, skew), Status::kInvalidArgument);
  EXPECT_EQ(status_of(1, skew.transpose()), Status::kInvalidArgument);
  EXPECT_EQ(status_of(1, moments(1, 1, 2)), Status::kOk) << "a flat body";
  EXPECT_EQ(status_of(1, moments(1, 1, 2.01)), Status::kInvalidArgument) << "no body";
  EXPECT_EQ(status_of(1, moments(0, 1, 1)), Status::kInvalidArgument) << "all in one line";
  EXPECT_EQ(status_of(1, moments(-1, 1, 1)), Status::kInvalidArgument);
  EXPECT_EQ(
      (make_compound<TypeParam>({1, {0, 0, 0}, one}, {{good.axis, TypeParam(-1)}}, {}).status),
      Status::kInvalidArgument);
}

/// The direction of a quaternion is the orientation; its length is nobody's.
TYPED_TEST(CompoundBody, OrientationOfAnyLength_IsTheOneOfItsDirection) {
  using S = TypeParam;
  const Capsule<S> far = {{{0, 0, 1}, {0, 0, 3}}, S(0.1)};
  const Pose<S> X_WS = {{1, 2, 3}, Quat<S>(S(0.5), S(0.5), S(-0.5), S(0.5))};
  const auto truth = make_compound<S>({{far, 1000}}, X_WS);
  ASSERT_EQ(truth.status, Status::kOk);
  for (const S length : {S(1.001), S(0.5), S(2), S(1e-3), S(1e6)}) {
    Pose<S> scaled = X_WS;
    scaled.q_WB.coeffs() *= length;
    const auto made = make_compound<S>({{far, 1000}}, scaled);
    ASSERT_EQ(made.status, Status::kOk);
    EXPECT_LT((made.value.body.X_WB.p_W - truth.value.body.X_WB.p_W).norm(), 64 * kRoundOff<S>)
        << length;
  }
}

}  // namespace
}  // namespace batuta
