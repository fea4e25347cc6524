// SPDX-License-Identifier: MIT
#include "batuta/geometry/segment_arrays.hpp"

#include "segment_arrays_lanes.hpp"

namespace batuta {

template <class Scalar>
void closest_points(const SegmentArrays<Scalar>& A, const SegmentArrays<Scalar>& B,
                    std::size_t count, const ClosestPointsArrays<Scalar>& result) {
  lanes::closest_points<lanes::kWidth<Scalar>>(A, B, count, result);
}

#define BATUTA_INSTANTIATE(S)                                                                 \
  template void closest_points(const SegmentArrays<S>&, const SegmentArrays<S>&, std::size_t, \
                               const ClosestPointsArrays<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
