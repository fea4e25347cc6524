// SPDX-License-Identifier: MIT
#pragma once
// One row of a file of exact times of contact: the query and its truth.

#include <string>

#include "batuta/detection/moving_pair.hpp"
#include "host/answer/fields.hpp"

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

/// @param body  "A" or "B"
/// The quaternion is renewed in Scalar.
template <class Scalar>
MovingCapsule<Scalar> read_body(host::QueryRow& row, const std::string& body) {
  MovingCapsule<Scalar> moving;
  moving.motion.duration = answer::number<Scalar>(row, "T");
  moving.motion.X_WB.p_W = answer::vector<Scalar>(row, body + "c");
  moving.motion.X_WB.q_WB = answer::rotation<Scalar>(row, body + "q");
  moving.motion.twist.v_W = answer::vector<Scalar>(row, body + "v");
  moving.motion.twist.w_W = answer::vector<Scalar>(row, body + "w");
  moving.capsule_B.axis.a = answer::vector<Scalar>(row, body + "e0");
  moving.capsule_B.axis.b = answer::vector<Scalar>(row, body + "e1");
  moving.capsule_B.radius = answer::number<Scalar>(row, body + "r");
  return moving;
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
