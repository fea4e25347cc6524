// SPDX-License-Identifier: MIT
// Compiled with the processor's fused multiply-add by somebody who knows of no flag: what
// config.hpp says holds for what stands below it, Eigen included.
#undef BATUTA_CONTRACTION_IS_OFF
#include "batuta/core/arithmetic.hpp"
#include "batuta/core/types.hpp"
#include "contracted.hpp"

namespace batuta::test {

namespace {

template <class Scalar>
bool rounds_dot_product() {
  constexpr Scalar e = std::numeric_limits<Scalar>::epsilon();
  const volatile Scalar operand = Scalar(1) + e;
  const volatile Scalar rounded = -(Scalar(1) + 2 * e);
  const auto x = [&] {
    return Scalar(operand);
  };  // read anew: a product that serves twice is not fused
  const auto z = [&] { return Scalar(rounded); };
  const Vec3<Scalar> a(x(), 1, 0);
  const Vec3<Scalar> b(x(), z(), 0);
  const Vec3<Scalar> c(1, x(), 0);
  const Vec3<Scalar> d(z(), x(), 0);
  return a.dot(b) == Scalar(0) && c.dot(d) == Scalar(0);
}

}  // namespace

bool unflagged_rounds_each_operation() {
  return rounds_each_operation<float>() && rounds_each_operation<double>();
}

bool unflagged_rounds_dot_products() {
  return rounds_dot_product<float>() && rounds_dot_product<double>();
}

}  // namespace batuta::test
