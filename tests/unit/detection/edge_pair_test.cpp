// SPDX-License-Identifier: MIT
// Vectors with given products with two edges, and the normal that is made perpendicular to them.
#include "../../../src/detection/edge_pair.hpp"

#include <gtest/gtest.h>

#include "moving.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

template <class Scalar>
class EdgePairOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(EdgePairOf, Scalars);

/// Two edges of lengths around 1 with an angle of at least half a radian between them, and a unit
/// vector that is off their common normal by as much as is said.
template <class Scalar>
struct Draw {
  Vec3<Scalar> a;
  Vec3<Scalar> b;
  ClosestPoints<Scalar> closest;  ///< both inside
};

template <class Scalar>
Draw<Scalar> draw(std::mt19937& random, double off) {
  Vec3<double> a = Vec3<double>::Zero();
  Vec3<double> b = Vec3<double>::Zero();
  do {
    a = random_vector(random, 1);
    b = random_vector(random, 1);
  } while (a.norm() < 0.3 || b.norm() < 0.3 || a.cross(b).norm() < 0.5 * a.norm() * b.norm());
  const Vec3<double> n = (a.cross(b).normalized() + off * random_vector(random, 1)).normalized();
  Draw<Scalar> one{a.cast<Scalar>(), b.cast<Scalar>(), {}};
  one.closest.s = Scalar(0.5);
  one.closest.u = Scalar(0.25);
  one.closest.normal_AB = n.cast<Scalar>();
  return one;
}

// Bounds: 1 / sin^2 of the angle is up to 4, lengths are 0.3 ... 1.8.

TYPED_TEST(EdgePairOf, BothHold_SolutionHasBothProductsAndLiesInTheirPlane) {
  using S = TypeParam;
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    const Draw<S> one = draw<S>(random, 0);
    const EdgePair<S> edges(one.closest, one.a, one.b);
    ASSERT_TRUE(edges.on_A && edges.on_B);
    const S with_a = static_cast<S>(signed_unit(random));
    const S with_b = static_cast<S>(signed_unit(random));
    const Vec3<S> x = edges.solve(with_a, with_b);
    const S bound = 1024 * kRoundOff<S>;  // and kDamping, 16 u over sin^2
    ASSERT_NEAR(x.dot(one.a), with_a, bound) << i;
    ASSERT_NEAR(x.dot(one.b), with_b, bound) << i;
    ASSERT_NEAR(x.dot(one.closest.normal_AB), S(0), bound) << i;
  }
}

TYPED_TEST(EdgePairOf, OneHolds_SolutionIsAlongIt) {
  using S = TypeParam;
  std::mt19937 random(8);
  for (int i = 0; i < 200; ++i) {
    Draw<S> one = draw<S>(random, 0.25);
    one.closest.u = one.closest.normal_AB.dot(one.b) < S(0) ? S(1) : S(0);  // outward at this end
    const EdgePair<S> edges(one.closest, one.a, one.b);
    ASSERT_TRUE(edges.on_A);
    ASSERT_FALSE(edges.on_B);
    const Vec3<S> x = edges.solve(S(0.5), S(3));
    ASSERT_NEAR(x.dot(one.a), S(0.5), 16 * kRoundOff<S>);
    ASSERT_LE(x.cross(one.a).norm(), 16 * kRoundOff<S>);
  }
}

TYPED_TEST(EdgePairOf, Sharpened_IsUnitAndPerpendicularToBoth) {
  using S = TypeParam;
  std::mt19937 random(9);
  for (const double off : {1e-2, 1e-3, 1e-5}) {
    for (int i = 0; i < 500; ++i) {
      const Draw<S> one = draw<S>(random, off);
      const EdgePair<S> edges(one.closest, one.a, one.b);
      const Vec3<S> n = sharpened(one.closest.normal_AB, edges);
      ASSERT_NEAR(n.norm(), S(1), 8 * kRoundOff<S>);
      ASSERT_LE(std::abs(n.dot(one.a)), 256 * kRoundOff<S>) << off;
      ASSERT_LE(std::abs(n.dot(one.b)), 256 * kRoundOff<S>) << off;
    }
  }
}

}  // namespace
}  // namespace batuta
