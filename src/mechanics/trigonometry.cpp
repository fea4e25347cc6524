// SPDX-License-Identifier: MIT
#include "batuta/mechanics/trigonometry.hpp"

#include <array>
#include <cstddef>

namespace batuta {
namespace {

/// Largest |angle| whose products in reduced() are exact: 2047 = 2^11 - 1 quarter turns. A little
/// more than kMaxAngle, so that an angle computed as rate times time may pass kMaxAngle by its
/// rounding.
template <class Scalar>
constexpr Scalar kReducibleAngle = Scalar(3215);

template <class Scalar>
constexpr Scalar kQuartersPerRadian = Scalar(0x1.45f306dc9c883p-1);  // 2 / pi

/// A value in two parts: hi + lo, |lo| small.
template <class Scalar>
struct TwoPart {
  Scalar hi;
  Scalar lo;
};

// How these numbers were made: trigonometry.md.
template <class Scalar>
struct Table;

template <>
struct Table<float> {
  /// pi / 2 as a sum; all but the last have at most 13 bits.
  static constexpr std::array<float, 4> kQuarterTurn = {0x1.921p+0F, 0x1.f6ap-13F, 0x1.11p-26F,
                                                        0x1.68c234p-39F};
  static constexpr std::array<float, 3> kSine = {-0x1.555546p-3F, 0x1.11073p-7F, -0x1.99406cp-13F};
  static constexpr std::array<float, 3> kCosine = {0x1.55554ap-5F, -0x1.6c0c2ap-10F,
                                                   0x1.99e884p-16F};
  static constexpr std::array<float, 6> kArcTangent = {-0x1.555552p-2F, 0x1.9996ecp-3F,
                                                       -0x1.244accp-3F, 0x1.c0248ap-4F,
                                                       -0x1.470706p-4F, 0x1.3d38ap-5F};
  /// j pi / 4, j = 0 ... 4.
  static constexpr std::array<TwoPart<float>, 5> kEighthTurns = {
      {{0.0F, 0.0F},
       {0x1.921fb6p-1F, -0x1.777a5cp-26F},
       {0x1.921fb6p+0F, -0x1.777a5cp-25F},
       {0x1.2d97c8p+1F, -0x1.99bc5cp-28F},
       {0x1.921fb6p+1F, -0x1.777a5cp-24F}}};
};

template <>
struct Table<double> {
  /// pi / 2 as a sum; all but the last have at most 42 bits.
  static constexpr std::array<double, 3> kQuarterTurn = {0x1.921fb544428p+0, 0x1.4611a62633p-42,
                                                         0x1.45c06e0e68948p-86};
  static constexpr std::array<double, 6> kSine = {-0x1.5555555555548p-3,  0x1.111111110f791p-7,
                                                  -0x1.a01a019bf5aeap-13, 0x1.71de356069debp-19,
                                                  -0x1.ae5e54943d23ap-26, 0x1.5d8e0834f393bp-33};
  static constexpr std::array<double, 6> kCosine = {0x1.555555555554bp-5,  -0x1.6c16c16c14f49p-10,
                                                    0x1.a01a019c7d04ap-16, -0x1.27e4f7e55e67cp-22,
                                                    0x1.1ee9d3f316cd2p-29, -0x1.8fa29ce9ca96dp-37};
  static constexpr std::array<double, 12> kArcTangent = {
      -0x1.5555555555516p-2, 0x1.9999999991152p-3, -0x1.249249215e25ap-3, 0x1.c71c7090fae1bp-4,
      -0x1.745cf4ccaf7c9p-4, 0x1.3b113dd4d06e6p-4, -0x1.10f31fcabfd62p-4, 0x1.dfe97fd8fe3e5p-5,
      -0x1.a39884f115e51p-5, 0x1.56f61153e203dp-5, -0x1.c180a420b521bp-6, 0x1.4b850dee4ca86p-7};
  static constexpr std::array<TwoPart<double>, 5> kEighthTurns = {
      {{0.0, 0.0},
       {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
       {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54},
       {0x1.2d97c7f3321d2p+1, 0x1.a79394c9e8a0ap-54},
       {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53}}};
};

/// c[0] + c[1] z + c[2] z^2 + ... Bound: N terms.
template <class Scalar, std::size_t N>
Scalar polynomial(const std::array<Scalar, N>& c, Scalar z) {
  Scalar sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = sum * z + c[i];  // Bound: N terms
  return sum;
}

template <class Scalar>
int nearest_integer(Scalar x) {
  return static_cast<int>(x < Scalar(0) ? x - Scalar(0.5) : x + Scalar(0.5));
}

/// angle - quarters pi / 2 in two parts. Each product but the last is exact, and so is each
/// difference together with what its rounding left behind. Bound: the parts of Table::kQuarterTurn.
template <class Scalar>
TwoPart<Scalar> reduced(Scalar angle, int quarters) {
  constexpr auto& parts = Table<Scalar>::kQuarterTurn;
  const auto k = static_cast<Scalar>(quarters);
  TwoPart<Scalar> rest = {angle - k * parts[0], Scalar(0)};
  for (std::size_t i = 1; i + 1 < parts.size(); ++i) {  // Bound: the parts
    const Scalar product = k * parts[i];
    const Scalar difference = rest.hi - product;
    rest.lo += (rest.hi - difference) - product;
    rest.hi = difference;
  }
  rest.lo -= k * parts[parts.size() - 1];
  return rest;
}

/// @pre |x| <= pi / 4
template <class Scalar>
Scalar sine_near_zero(const TwoPart<Scalar>& x) {
  const Scalar z = x.hi * x.hi;
  const Scalar cubic = x.hi * (z * polynomial(Table<Scalar>::kSine, z));
  return x.hi + (cubic + x.lo);
}

/// @pre |x| <= pi / 4
template <class Scalar>
Scalar cosine_near_zero(const TwoPart<Scalar>& x) {
  const Scalar z = x.hi * x.hi;
  const Scalar half = z / Scalar(2);
  const Scalar parabola = Scalar(1) - half;
  const Scalar lost = (Scalar(1) - parabola) - half;
  return parabola + (lost + (z * z * polynomial(Table<Scalar>::kCosine, z) - x.hi * x.lo));
}

/// An angle as eighths pi / 4 + arctan(slope).
template <class Scalar>
struct Octant {
  std::size_t eighths;
  Scalar slope;  ///< |slope| <= 1 / 2
};

/// arctan(low / high). @pre 0 <= low <= high, 0 < high
template <class Scalar>
Octant<Scalar> first_octant(Scalar low, Scalar high) {
  if (low <= high / Scalar(2)) return {0, low / high};
  // Halved if large: the sum must not overflow. The difference is exact, since low > high / 2.
  const Scalar scale = high > Scalar(1) ? Scalar(0.5) : Scalar(1);
  return {1, (scale * low - scale * high) / (scale * low + scale * high)};
}

}  // namespace

template <class Scalar>
detail::SinCos<Scalar> detail::sin_cos(Scalar angle) {
  BATUTA_ASSERT(angle >= -kReducibleAngle<Scalar> && angle <= kReducibleAngle<Scalar>);
  const int quarters = nearest_integer(angle * kQuartersPerRadian<Scalar>);
  const TwoPart<Scalar> rest = reduced(angle, quarters);
  const Scalar s = sine_near_zero(rest);
  const Scalar c = cosine_near_zero(rest);
  switch (static_cast<unsigned>(quarters) % 4U) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

template <class Scalar>
Scalar detail::arc_tangent(Scalar y, Scalar x) {
  const Scalar up = y < Scalar(0) ? -y : y;
  const Scalar along = x < Scalar(0) ? -x : x;
  if (up == Scalar(0) && along == Scalar(0)) return Scalar(0);

  const bool steep = up > along;
  Octant<Scalar> at = steep ? first_octant(along, up) : first_octant(up, along);
  if (steep) at = {2 - at.eighths, -at.slope};
  if (x < Scalar(0)) at = {4 - at.eighths, -at.slope};

  const TwoPart<Scalar> base = Table<Scalar>::kEighthTurns[at.eighths];
  const Scalar z = at.slope * at.slope;
  const Scalar cubic = at.slope * (z * polynomial(Table<Scalar>::kArcTangent, z));
  // The largest part comes last, so that only one rounding counts.
  const Scalar angle = base.hi + (at.slope + (cubic + base.lo));
  return y < Scalar(0) ? -angle : angle;
}

#define BATUTA_INSTANTIATE(Scalar)                         \
  template detail::SinCos<Scalar> detail::sin_cos(Scalar); \
  template Scalar detail::arc_tangent(Scalar, Scalar);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
