// SPDX-License-Identifier: MIT
#include "batuta/core/pool.hpp"
#include "batuta/core/types.hpp"
#include "batuta/geometry/kdop.hpp"

#ifdef EXPECTED_LEVEL
static_assert(BATUTA_ASSERT_LEVEL == EXPECTED_LEVEL);
#endif

batuta::Status use(batuta::Pool<int, 4>& pool);
batuta::Status use(batuta::Pool<int, 4>& pool) {
  const auto made = pool.make(3);
  return made.ok() ? pool.remove(made.value) : made.status;
}

batuta::Vec3<float> turn(const batuta::Mat3<float>& R, const batuta::Vec3<float>& v);
batuta::Vec3<float> turn(const batuta::Mat3<float>& R, const batuta::Vec3<float>& v) {
  return R * v;
}

using Box = batuta::Kdop<float, 6>;
static_assert(Box::kDirections == 3);
