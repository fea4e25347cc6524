// SPDX-License-Identifier: MIT
// Random scenes in which contacts last: see random_checks.hpp.
#include "random_checks.hpp"

namespace batuta::test {
namespace {

template <class S, const RandomKind& kKind>
using Of = RandomLaws<S, kKind>;
using Lasting = ::testing::Types<Of<float, kHeap>, Of<double, kHeap>, Of<float, kDrift>,
                                 Of<double, kDrift>, Of<float, kCramped>, Of<double, kCramped>,
                                 Of<float, kHands>, Of<double, kHands>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Lasting, RandomScenes, Lasting);

}  // namespace
}  // namespace batuta::test
