// SPDX-License-Identifier: MIT
// Whether two swept spheres overlap, where it is known how near their paths come: both cross one
// line at right angles, and what lies between them on it is the distance.
#include <gtest/gtest.h>

#include "batuta/detection/swept_volume.hpp"
#include "batuta/geometry/direction.hpp"
#include "moving.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

template <class Scalar>
class SweptSphereOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SweptSphereOf, Scalars);

/// The share of its path that a sphere has gone where it crosses the line.
double share(std::mt19937& random) {
  return 0.5 + 0.45 * signed_unit(random);
}

/// A path through p, at right angles to n.
template <class Scalar>
detail::SweptSphere<Scalar> sphere_through(std::mt19937& random, const Vec3<double>& p,
                                           const Vec3<double>& n, double radius) {
  const Vec3<double> travel = n.cross(random_vector(random, 2));
  const double s = share(random);
  detail::SweptSphere<Scalar> sphere;
  sphere.start_W = (p - s * travel).cast<Scalar>();
  sphere.end_W = (p + (1 - s) * travel).cast<Scalar>();
  sphere.radius = static_cast<Scalar>(radius);
  return sphere;
}

TYPED_TEST(SweptSphereOf, PathsThatCrossALine_OverlapWhereTheRadiiReach) {
  std::mt19937 random(20061107);
  for (int i = 0; i < 500; ++i) {
    const Vec3<double> n = unit<double>(random_vector(random, 1));
    const Vec3<double> p = random_vector(random, 5);
    const double radius_P = 0.2 + 0.1 * signed_unit(random);
    const double radius_Q = 0.3 + 0.1 * signed_unit(random);
    // A hundredth is far more than the rounding of lengths of some metres, of a float as well.
    for (const double reached : {0.99, 1.01}) {
      const Vec3<double> q = p + (radius_P + radius_Q) * reached * n;
      const auto P = sphere_through<TypeParam>(random, p, n, radius_P);
      const auto Q = sphere_through<TypeParam>(random, q, n, radius_Q);
      EXPECT_EQ(overlaps(P, Q), reached < 1) << i;
      EXPECT_EQ(overlaps(Q, P), reached < 1) << i;
    }
  }
}

}  // namespace
}  // namespace batuta
