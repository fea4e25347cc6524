// SPDX-License-Identifier: MIT
#pragma once
// One row of a file of exact times of contact: the query and its truth.

#include <string>

#include "ensemble.hpp"
#include "programs/query_file.hpp"

namespace batuta::test {

enum ContactKind { kNever = 0, kOnTheWay = 1, kAtStart = 2 };

struct ContactTruth {
  int kind = kNever;
  double t = 0;          ///< of the first contact, s
  double rate = 0;       ///< d gap / dt there, m/s
  double least_gap = 0;  ///< over the whole step, m
  double gap_error = 0;  ///< of least_gap, m
  double lasts = 0;      ///< the first contact, s
};

/// The numbers as they are, so that the quaternion is only nearly unit.
/// @param body  "A" or "B"
inline MovingCapsule<float> read_bits(host::QueryRow& row, const std::string& body) {
  const auto vector = [&](const char* name) {
    const float x = row.number(body + name + 'x');
    const float y = row.number(body + name + 'y');
    const float z = row.number(body + name + 'z');
    return Vec3<float>(x, y, z);
  };
  MovingCapsule<float> moving;
  const Vec3<float> q = vector("q");
  moving.motion.duration = row.number("T");
  moving.motion.X_WB = {vector("c"), Quat<float>(row.number(body + "qw"), q.x(), q.y(), q.z())};
  moving.motion.twist.v_W = vector("v");
  moving.motion.twist.w_W = vector("w");
  moving.capsule_B = {{vector("e0"), vector("e1")}, row.number(body + 'r')};
  return moving;
}

/// Both bodies, the quaternions renewed in Scalar.
template <class Scalar>
Result<MovingPair<Scalar>> read_pair(host::QueryRow& row) {
  return make_moving_pair(cast<Scalar>(read_bits(row, "A")), cast<Scalar>(read_bits(row, "B")));
}

inline ContactTruth read_truth(host::QueryRow& row) {
  ContactTruth truth;
  truth.kind = static_cast<int>(row.decimal("kind"));
  truth.t = row.decimal("t");
  truth.rate = row.decimal("rate");
  truth.least_gap = row.decimal("gmin");
  truth.gap_error = row.decimal("gerr");
  truth.lasts = row.decimal("dur");
  return truth;
}

}  // namespace batuta::test
