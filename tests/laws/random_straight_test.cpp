// SPDX-License-Identifier: MIT
// Random scenes of bodies that do not turn, of both engines: see random_checks.hpp.
#include "random_checks.hpp"

namespace batuta::test {
namespace {

template <class S, const RandomKind& kKind>
using Of = RandomScene<S, kKind>;
using Straight =
    ::testing::Types<Of<float, kStraight>, Of<double, kStraight>, Of<float, kSmallBalls>,
                     Of<double, kSmallBalls>, Of<float, kSmallCramped>, Of<double, kSmallCramped>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Straight, RandomScenes, Straight);

}  // namespace
}  // namespace batuta::test
