// SPDX-License-Identifier: MIT
#pragma once
// What a query's answer has to be.

#include "ensemble.hpp"

namespace batuta::report {

struct Truth {
  bool contact = false;  ///< the gap is <= 0 somewhere in [0, duration]
  double time = 0;       ///< of the first contact, s; duration if there is none
  double least_gap = 0;  ///< m, over [0, duration]; of an overlap at the start, that at the start
};

/// The independent truth of tests/support.
Truth truth_of(const test::Query& query);

/// A query with what it is judged by, in both scalars.
struct Case {
  MovingCapsule<double> A;
  MovingCapsule<double> B;
  MovingCapsule<float> A_float;
  MovingCapsule<float> B_float;
  Truth truth;
  bool meets = false;  ///< the boxes of the two sweeps meet, so that a world would search this pair

  template <class Scalar>
  const MovingCapsule<Scalar>& first() const {
    if constexpr (std::is_same_v<Scalar, float>) {
      return A_float;
    } else {
      return A;
    }
  }
  template <class Scalar>
  const MovingCapsule<Scalar>& second() const {
    if constexpr (std::is_same_v<Scalar, float>) {
      return B_float;
    } else {
      return B;
    }
  }
};

Case case_of(const test::Query& query);

/// That of a family's query.
Case make_case(test::Family family, std::uint64_t seed, std::uint64_t index);

}  // namespace batuta::report
