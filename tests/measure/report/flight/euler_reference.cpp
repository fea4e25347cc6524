// SPDX-License-Identifier: MIT
#include "euler_reference.hpp"

namespace batuta::report {
namespace {

using Coefficients = Eigen::Matrix<Wide, 4, 1>;  // of a quaternion

/// Rates of change.
struct Rate {
  Coefficients q;
  Vec3<Wide> w;
};

Rate rate_of(const Coefficients& q, const Vec3<Wide>& w, const Vec3<Wide>& moments) {
  const Quat<Wide> half(0, w.x() / 2, w.y() / 2, w.z() / 2);
  const Vec3<Wide> b = moments.cwiseProduct(w);
  return {(Quat<Wide>(q) * half).coeffs(), b.cross(w).cwiseQuotient(moments)};
}

}  // namespace

Spin turned_by_euler(Spin spin, const Vec3<Wide>& moments, Wide duration, long steps) {
  const Wide h = duration / static_cast<Wide>(steps);
  Coefficients q = spin.q_WB.coeffs();
  Vec3<Wide> w = spin.w_B;
  for (long i = 0; i < steps; ++i) {
    const Rate k1 = rate_of(q, w, moments);
    const Rate k2 = rate_of(q + h / 2 * k1.q, w + h / 2 * k1.w, moments);
    const Rate k3 = rate_of(q + h / 2 * k2.q, w + h / 2 * k2.w, moments);
    const Rate k4 = rate_of(q + h * k3.q, w + h * k3.w, moments);
    q += h / 6 * (k1.q + 2 * k2.q + 2 * k3.q + k4.q);
    w += h / 6 * (k1.w + 2 * k2.w + 2 * k3.w + k4.w);
  }
  spin.q_WB = Quat<Wide>(q).normalized();
  spin.w_B = w;
  return spin;
}

}  // namespace batuta::report
