// SPDX-License-Identifier: MIT
#include "batuta/detection/swept_volume.hpp"

#include "round_up.hpp"

namespace batuta {

namespace {

/// The sphere is rounded outward by this times the sum of the lengths involved (swept_volume.md).
template <class Scalar>
inline constexpr Scalar kSphereOutward = 64 * kRoundOff<Scalar>;

/// Bounds on what rounding does to a support, as a share of the lever and the travel, and of the
/// distance from the origin and the radius (swept_volume.md).
template <class Scalar>
inline constexpr Scalar kLocalOutward = 160 * kRoundOff<Scalar>;
template <class Scalar>
inline constexpr Scalar kOriginOutward = 8 * kRoundOff<Scalar>;

/// An error of the angle of turn, as a share of it, moves the end of the path (moving_pair.md).
template <class Scalar>
inline constexpr Scalar kTurnError = 6 * kRoundOff<Scalar>;

/// A function leaves its chord by at most this times the second derivative times the square of the
/// interval: 1/8, and room for the rounding of what it is compared with (swept_volume.md).
template <class Scalar>
inline constexpr Scalar kSagitta = Scalar(0.13);

/// From this turn on, rad, the box of the whole circle is never larger than chord and sagitta
/// (swept_volume.md).
template <class Scalar>
inline constexpr Scalar kLongTurn = Scalar(4);

/// Up to this turn, rad, the coarse form takes each end along its tangent: a face is further out by
/// at most turn^2 of the lever, a 256th of it (swept_volume.md).
template <class Scalar>
inline constexpr Scalar kShortTurn = Scalar(1) / 16;

template <class Scalar>
inline constexpr Scalar kFullTurn = Scalar(6.28318530717958647693);

/// Height of an end along a direction over its height at the start, at the angle a of the turn:
/// travel a / turn + (cos a - 1) cosine + sin a sine.
template <class Scalar>
struct Wave {
  Scalar travel = 0;
  Scalar cosine = 0;
  Scalar sine = 0;
};

/// Lowest and highest value, m.
template <class Scalar>
struct ArcExtent {
  Scalar low = 0;
  Scalar high = 0;
};

template <class Scalar>
ArcExtent<Scalar> joined(const ArcExtent<Scalar>& P, const ArcExtent<Scalar>& Q) {
  return {min_of(P.low, Q.low), max_of(P.high, Q.high)};
}

template <class Scalar>
ArcExtent<Scalar> shifted(const ArcExtent<Scalar>& x, Scalar by) {
  return {x.low + by, x.high + by};
}

/// A wave in units of the larger of its amplitudes, where that has extremes: where its slope in the
/// angle, slope - amplitude sin(a - phase), vanishes.
template <class Scalar>
struct Crests {
  Scalar size = 0;  ///< 0: rises or falls all the way
  Scalar cosine = 0;
  Scalar sine = 0;
  Scalar slope = 0;
  Scalar steepness = 0;  ///< sqrt(amplitude^2 - slope^2)
};

template <class Scalar>
Crests<Scalar> crests_of(const Wave<Scalar>& wave, Scalar turn) {
  const Scalar size = max_of(std::abs(wave.cosine), std::abs(wave.sine));
  if (!(size > Scalar(0) && turn > Scalar(0))) return {};
  const Scalar cosine = wave.cosine / size;
  const Scalar sine = wave.sine / size;
  const Scalar slope = wave.travel / turn / size;
  const Scalar square = cosine * cosine + sine * sine - slope * slope;
  if (!(square > Scalar(0))) return {};
  return {size, cosine, sine, slope, std::sqrt(square)};
}

/// The highest crest within the turn (sign 1), or the depth of the deepest trough (sign -1); 0,
/// which the start reaches, where there is none. Where the wave climbs it is the last one, else the
/// first: no loop over turns.
template <class Scalar>
Scalar crest(const Crests<Scalar>& at, Scalar sign, Scalar turn) {
  if (at.size == Scalar(0)) return Scalar(0);
  const Scalar slope = sign * at.slope;
  const Scalar cosine = sign * at.cosine;
  const Scalar sine = sign * at.sine;
  const Scalar nearest = detail::arc_tangent(sine * at.steepness + cosine * slope,
                                             cosine * at.steepness - sine * slope);
  Scalar angle = nearest < Scalar(0) ? nearest + kFullTurn<Scalar> : nearest;
  if (angle > turn) return Scalar(0);
  if (slope > Scalar(0)) {
    const int more = static_cast<int>((turn - angle) / kFullTurn<Scalar>);
    angle += static_cast<Scalar>(more) * kFullTurn<Scalar>;
  }
  return at.size * (slope * angle + (at.steepness - cosine));
}

/// A direction along an axis: a height is a component.
template <class Scalar>
struct AxisDirection {
  Eigen::Index axis;
  Scalar of(const Vec3<Scalar>& p) const { return p[axis]; }
};

/// Any direction.
template <class Scalar>
struct FreeDirection {
  Vec3<Scalar> direction;
  Scalar of(const Vec3<Scalar>& p) const { return direction.dot(p); }
};

/// The i-th direction of a Kdop. @pre 0 <= i < K / 2
template <class Scalar, int K>
auto direction_of(int i) {
  if constexpr (K == 6) {
    return AxisDirection<Scalar>{i};
  } else {
    return FreeDirection<Scalar>{detail::kdop_direction<Scalar, K>(i)};
  }
}

/// One end of the capsule along one direction.
template <class Scalar>
struct EndWave {
  Scalar first = 0;  ///< height at the start, m
  Wave<Scalar> wave;
};

template <class Scalar, class Direction>
EndWave<Scalar> end_wave(const detail::CapsuleSweep<Scalar>& sweep,
                         const detail::EndPath<Scalar>& end, const Direction& height) {
  return {height.of(end.start),
          {height.of(sweep.travel_W), height.of(end.arm), height.of(end.side)}};
}

/// Over the start and the end of the motion, relative to the start.
template <class Scalar>
ArcExtent<Scalar> ends_of(const detail::CapsuleSweep<Scalar>& sweep, const Wave<Scalar>& wave) {
  const Scalar turned = wave.sine * sweep.at_end.sin - (Scalar(1) - sweep.at_end.cos) * wave.cosine;
  const Scalar last = wave.travel + turned;
  const Scalar slip =
      kTurnError<Scalar> * sweep.turn * (std::abs(wave.cosine) + std::abs(wave.sine));
  return {min_of(Scalar(0), last - slip), max_of(Scalar(0), last + slip)};
}

/// sqrt(cosine^2 + sine^2) at any scale.
template <class Scalar>
Scalar amplitude_of(const Wave<Scalar>& wave) {
  const Scalar cosine = std::abs(wave.cosine);
  const Scalar sine = std::abs(wave.sine);
  const Scalar size = max_of(cosine, sine);
  if (size == Scalar(0)) return size;
  const Scalar slant = min_of(cosine, sine) / size;
  return size * std::sqrt(Scalar(1) + slant * slant);
}

/// Over whole circles carried along.
template <class Scalar>
ArcExtent<Scalar> circles_of(const Wave<Scalar>& wave, Scalar amplitude) {
  return {min_of(Scalar(0), wave.travel) - wave.cosine - amplitude,
          max_of(Scalar(0), wave.travel) - wave.cosine + amplitude};
}

/// Whether the slope keeps its sign, by its values at both ends and its second derivative.
template <class Scalar>
bool is_monotone(const detail::CapsuleSweep<Scalar>& sweep, const Wave<Scalar>& wave) {
  const Scalar turn = sweep.turn;
  const Scalar first = wave.travel + turn * wave.sine;
  const Scalar last =
      wave.travel + turn * (sweep.at_end.cos * wave.sine - sweep.at_end.sin * wave.cosine);
  const Scalar bulge =
      kSagitta<Scalar> * turn * turn * turn * (std::abs(wave.cosine) + std::abs(wave.sine));
  return min_of(first, last) >= bulge || max_of(first, last) <= -bulge;
}

/// Of one end over the motion. A type each, not a function that is passed on: no call goes where
/// the compiler's call graph does not see it.
struct ExactExtent {
  template <class Scalar>
  static ArcExtent<Scalar> of(const detail::CapsuleSweep<Scalar>& sweep,
                              const EndWave<Scalar>& end);
};
struct CoarseExtent {
  template <class Scalar>
  static ArcExtent<Scalar> of(const detail::CapsuleSweep<Scalar>& sweep,
                              const EndWave<Scalar>& end);
};

template <class Scalar>
ArcExtent<Scalar> ExactExtent::of(const detail::CapsuleSweep<Scalar>& sweep,
                                  const EndWave<Scalar>& end) {
  if (!(sweep.turn <= detail::kMaxAngle<Scalar>)) {
    return shifted(circles_of(end.wave, amplitude_of(end.wave)), end.first);
  }
  const ArcExtent<Scalar> ends = ends_of(sweep, end.wave);
  if (is_monotone(sweep, end.wave)) return shifted(ends, end.first);
  const Crests<Scalar> crests = crests_of(end.wave, sweep.turn);
  const ArcExtent<Scalar> inner{-crest(crests, Scalar(-1), sweep.turn),
                                crest(crests, Scalar(1), sweep.turn)};
  return shifted(joined(ends, inner), end.first);
}

/// Chord and sagitta, or the whole circle carried along, whichever is less.
template <class Scalar>
ArcExtent<Scalar> CoarseExtent::of(const detail::CapsuleSweep<Scalar>& sweep,
                                   const EndWave<Scalar>& end) {
  const Scalar amplitude = amplitude_of(end.wave);
  const ArcExtent<Scalar> circles = circles_of(end.wave, amplitude);
  if (!(sweep.turn < kLongTurn<Scalar>)) return shifted(circles, end.first);
  const ArcExtent<Scalar> ends = ends_of(sweep, end.wave);
  const Scalar sagitta = sweep.turn * sweep.turn * amplitude / 8;
  const ArcExtent<Scalar> tighter{max_of(circles.low, ends.low - sagitta),
                                  min_of(circles.high, ends.high + sagitta)};
  return shifted(tighter, end.first);
}

/// How far an end of the axis is from the centre of mass at most, m.
template <class Scalar>
Scalar bounding_radius_of(const MovingCapsule<Scalar>& moving) {
  const Segment<Scalar>& axis_B = moving.capsule_B.axis;
  return max_of(length(axis_B.a), length(axis_B.b));
}

/// The whole space.
template <class Scalar, int K>
Kdop<Scalar, K> unbounded() {
  Kdop<Scalar, K> all;
  all.low.fill(std::numeric_limits<Scalar>::lowest());
  all.high.fill(std::numeric_limits<Scalar>::max());
  return all;
}

/// Of both ends along `direction`, relative to start_W.
/// @tparam EndExtent  ExactExtent or CoarseExtent
template <class EndExtent, class Scalar, class Direction>
ArcExtent<Scalar> extent_of(const detail::CapsuleSweep<Scalar>& sweep, const Direction& direction) {
  return joined(EndExtent::of(sweep, end_wave(sweep, sweep.path.ends[0], direction)),
                EndExtent::of(sweep, end_wave(sweep, sweep.path.ends[1], direction)));
}

template <class Scalar, int K, class EndExtent>
Kdop<Scalar, K> kdop_over(const MovingCapsule<Scalar>& moving) {
  const detail::CapsuleSweep<Scalar> sweep = detail::capsule_sweep(moving);
  if (!sweep.is_bounded) return unbounded<Scalar, K>();
  Kdop<Scalar, K> swept;
  for (int i = 0; i < Kdop<Scalar, K>::kDirections; ++i) {  // Bound: K / 2
    const auto up = direction_of<Scalar, K>(i);
    const ArcExtent<Scalar> along = shifted(extent_of<EndExtent>(sweep, up), up.of(sweep.start_W));
    const auto k = static_cast<std::size_t>(i);
    swept.low[k] = along.low;
    swept.high[k] = along.high;
  }
  return inflated(swept, sweep.path.radius + sweep.outward);
}

/// Both ends along their tangents, and as far aside as the turn leads them. @pre turn <= kShortTurn
template <class Scalar, int K>
Kdop<Scalar, K> kdop_along(const MovingCapsule<Scalar>& moving, Scalar turn) {
  const auto& [X_WB, twist, duration] = moving.motion;
  const Scalar radius = moving.capsule_B.radius;
  const Vec3<Scalar> arm_a = X_WB.q_WB * moving.capsule_B.axis.a;
  const Vec3<Scalar> arm_b = X_WB.q_WB * moving.capsule_B.axis.b;
  const Vec3<Scalar> travel = duration * twist.v_W;
  const Vec3<Scalar> spin = duration * twist.w_W;
  const Scalar reach = bounding_radius_of(moving);
  const Scalar local = reach + travel.cwiseAbs().sum();
  const Scalar other = X_WB.p_W.cwiseAbs().sum() + radius;
  if (!(local + other <= kLargestCoordinate<Scalar>)) return unbounded<Scalar, K>();
  const Segment<Scalar> from{X_WB.p_W + arm_a, X_WB.p_W + arm_b};
  const Segment<Scalar> to{from.a + (travel + spin.cross(arm_a)),
                           from.b + (travel + spin.cross(arm_b))};
  const Scalar aside = turn * turn * reach / 2;
  const Scalar outward = kLocalOutward<Scalar> * local + kOriginOutward<Scalar> * other;
  return detail::kdop_of<Scalar, K>(from, to, radius + (aside + outward));
}

}  // namespace

template <class Scalar>
detail::SweptSphere<Scalar> detail::swept_sphere(const MovingCapsule<Scalar>& moving) {
  const Vec3<Scalar>& start_W = moving.motion.X_WB.p_W;
  const Vec3<Scalar> travel = moving.motion.twist.v_W * moving.motion.duration;
  const Scalar radius = bounding_radius_of(moving) + moving.capsule_B.radius;
  const Scalar size = length(start_W) + length(travel) + radius;
  return {start_W, start_W + travel, radius + kSphereOutward<Scalar> * size};
}

template <class Scalar>
detail::CapsuleSweep<Scalar> detail::capsule_sweep(const MovingCapsule<Scalar>& moving) {
  const Vec3<Scalar>& start_W = moving.motion.X_WB.p_W;
  const auto path = detail::capsule_path(moving, start_W, detail::zero<Scalar>());
  const Vec3<Scalar> travel_W = path.v * moving.motion.duration;
  const Scalar turn = path.turn_rate * moving.motion.duration;
  detail::SinCos<Scalar> at_end;
  if (turn > Scalar(0) && turn <= detail::kMaxAngle<Scalar>) at_end = detail::sin_cos(turn);
  // Where a sum of lengths may overflow, 0 * infinity could make a face vanish.
  const Scalar local = path.bounding_radius + length(travel_W);
  const Scalar other = length(start_W) + path.radius;
  const bool is_bounded = local + other <= kLargestCoordinate<Scalar> && turn >= Scalar(0);
  const Scalar outward = kLocalOutward<Scalar> * local + kOriginOutward<Scalar> * other;
  return {path, start_W, travel_W, turn, at_end, outward, is_bounded};
}

template <class Scalar>
Scalar detail::swept_support(const detail::CapsuleSweep<Scalar>& sweep,
                             const Vec3<Scalar>& direction) {
  if (!sweep.is_bounded) return std::numeric_limits<Scalar>::max();
  const FreeDirection<Scalar> up{direction};
  const ArcExtent<Scalar> extent = extent_of<ExactExtent>(sweep, up);
  const Scalar margin = length(direction) * (sweep.path.radius + sweep.outward);
  return direction.dot(sweep.start_W) + (extent.high + margin);
}

template <class Scalar, int K>
Kdop<Scalar, K> detail::swept_kdop(const MovingCapsule<Scalar>& moving) {
  return kdop_over<Scalar, K, ExactExtent>(moving);
}

template <class Scalar, int K>
Kdop<Scalar, K> detail::coarse_swept_kdop(const MovingCapsule<Scalar>& moving) {
  const Scalar turn = length(moving.motion.twist.w_W) * moving.motion.duration;
  if (turn <= kShortTurn<Scalar>) return kdop_along<Scalar, K>(moving, turn);
  return kdop_over<Scalar, K, CoarseExtent>(moving);
}

template <class Scalar>
Aabb<Scalar> swept_aabb(const MovingCapsule<Scalar>& moving) {
  return detail::swept_kdop<Scalar, 6>(moving);
}

template <class Scalar>
Aabb<Scalar> detail::coarse_swept_aabb(const MovingCapsule<Scalar>& moving) {
  return detail::coarse_swept_kdop<Scalar, 6>(moving);
}

template <class Scalar>
bool overlaps(const detail::SweptSphere<Scalar>& P, const detail::SweptSphere<Scalar>& Q) {
  const Vec3<Scalar> travel_P = P.end_W - P.start_W;
  const Vec3<Scalar> travel_Q = Q.end_W - Q.start_W;
  const Vec3<Scalar> between = Q.start_W - P.start_W;
  const Scalar size = length(travel_P) + length(travel_Q) + length(between);
  // Seen from P's start, so that the distance from the world's origin costs nothing.
  const Segment<Scalar> axis_P{Vec3<Scalar>::Zero(), travel_P};
  const Segment<Scalar> axis_Q{between, between + travel_Q};
  const Scalar apart = closest_points(axis_P, axis_Q).distance - kSphereOutward<Scalar> * size;
  return !(apart > kRoundUp<Scalar> * (P.radius + Q.radius));
}

#define BATUTA_INSTANTIATE_K(Scalar, K)                                      \
  template Kdop<Scalar, K> detail::swept_kdop(const MovingCapsule<Scalar>&); \
  template Kdop<Scalar, K> detail::coarse_swept_kdop(const MovingCapsule<Scalar>&);
#define BATUTA_INSTANTIATE(Scalar)                                                                 \
  template detail::SweptSphere<Scalar> detail::swept_sphere(const MovingCapsule<Scalar>&);         \
  template detail::CapsuleSweep<Scalar> detail::capsule_sweep(const MovingCapsule<Scalar>&);       \
  template Scalar detail::swept_support(const detail::CapsuleSweep<Scalar>&, const Vec3<Scalar>&); \
  template Aabb<Scalar> swept_aabb(const MovingCapsule<Scalar>&);                                  \
  template Aabb<Scalar> detail::coarse_swept_aabb(const MovingCapsule<Scalar>&);                   \
  BATUTA_INSTANTIATE_K(Scalar, 6)                                                                  \
  BATUTA_INSTANTIATE_K(Scalar, 14)                                                                 \
  BATUTA_INSTANTIATE_K(Scalar, 18)                                                                 \
  BATUTA_INSTANTIATE_K(Scalar, 26)                                                                 \
  template bool overlaps(const detail::SweptSphere<Scalar>&, const detail::SweptSphere<Scalar>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE
#undef BATUTA_INSTANTIATE_K

}  // namespace batuta
