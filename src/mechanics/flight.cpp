// SPDX-License-Identifier: MIT
// Free flight, declared in motion.hpp; derived in motion.md.
#include "batuta/geometry/direction.hpp"
#include "batuta/mechanics/motion.hpp"

// What only bodies with three unlike moments need is compiled for size.
#define BATUTA_RARE [[gnu::cold, gnu::noinline]]

namespace batuta {
namespace {

/// How far two moments of a body of revolution are apart at most, relative to them, for rounding
/// alone (motion.md).
template <class Scalar>
constexpr Scalar kEqualMoments = 32 * kRoundOff<Scalar>;

/// How far an end may be from the axis, relative to its distance from the centre, for rounding of
/// the principal axes alone (motion.md).
template <class Scalar>
constexpr Scalar kOnAxis = 64 * kRoundOff<Scalar>;

/// What the spins of the splitting turn at most in one part of it, rad, and half a turn and a
/// whole one. A turn of the body below half a turn takes kMostParts parts at most.
template <class Scalar>
constexpr Scalar kTurnOfPart = Scalar(0.25);
template <class Scalar>
constexpr Scalar kHalfTurn = Scalar(3.14159265358979323846);
constexpr int kMostParts = 26;
static_assert(kMostParts > 2 * kHalfTurn<float> / kTurnOfPart<float>);

/// The share of a part that the first and the last of its three splittings take, 1 / (2 - 2^(1/3));
/// the one between goes back by what is too much. Of fourth order (motion.md).
template <class Scalar>
constexpr Scalar kOuterShare = Scalar(1.35120719195965763405);

/// Corrections of the energy at the end of a flight: one, and so many where it began on a chord,
/// off by more than rounding (motion.md).
constexpr int kPassesFromChord = 4;
/// How far one of them turns at most, of the most that the flight turns: who is far off comes back
/// to its energy over several flights, and does not leap.
template <class Scalar>
constexpr Scalar kOfTurn = Scalar(1) / 32;

/// How far the excess of an orientation may be from the one that is remembered, relative to the
/// largest there is, to be that of the same flight (motion.md).
template <class Scalar>
constexpr Scalar kSameFlight = Scalar(1) / 1024;

template <class Scalar>
bool are_equal_moments(Scalar inverse_a, Scalar inverse_b) {
  const Scalar low = min_of(inverse_a, inverse_b);
  const Scalar high = max_of(inverse_a, inverse_b);
  return high - low <= kEqualMoments<Scalar> * high;
}

/// Turning taken apart: steadily about the angular momentum b by `steady` b, the same for all
/// axes, and about two axes of the body by (1 / I_i - steady) b_i.
template <class Scalar>
struct Splitting {
  Scalar steady = 0;     ///< 1/(kg m^2), of the middle moment
  int odd = 0;           ///< the axis whose moment differs most from the middle one
  int minor = 0;         ///< the other axis that is not the middle one
  bool tumbles = false;  ///< three unlike moments; else the odd axis alone spins
};

template <class Scalar>
Splitting<Scalar> splitting_of(const Vec3<Scalar>& inverse_moments) {
  const Vec3<Scalar>& m = inverse_moments;
  for (int i = 0; i < 3; ++i) {  // Bound: three pairs
    const Scalar a = m(i);
    const Scalar b = m((i + 1) % 3);
    if (are_equal_moments(a, b)) return {a + (b - a) / 2, (i + 2) % 3, i, false};
  }
  int middle = 0;
  for (int i = 1; i < 3; ++i) {  // Bound: two axes
    if ((m(i) < m((i + 1) % 3)) != (m(i) < m((i + 2) % 3))) middle = i;
  }
  const int one = (middle + 1) % 3, other = (middle + 2) % 3;
  const bool is_one = std::abs(m(one) - m(middle)) >= std::abs(m(other) - m(middle));
  return {m(middle), is_one ? one : other, is_one ? other : one, true};
}

template <class Scalar>
bool is_revolution(const Splitting<Scalar>& split) {
  return !split.tumbles && split.steady > Scalar(0);
}

template <class Scalar>
bool turns_about_one_axis(const Vec3<Scalar>& inverse_moments) {
  const Vec3<Scalar>& m = inverse_moments;
  return m.x() * m.y() == Scalar(0) && m.y() * m.z() == Scalar(0) && m.z() * m.x() == Scalar(0);
}

/// Whether the axis of what is seen of the body turns steadily.
template <class Scalar>
bool is_steady(const Body<Scalar>& body, const Splitting<Scalar>& split) {
  return (is_revolution(split) && !body.spin_shows) || turns_about_one_axis(body.inverse_moments);
}

/// Whether the three moments are equal: it turns about the angular momentum, and its axes with it.
template <class Scalar>
bool has_equal_moments(const Vec3<Scalar>& inverse_moments) {
  return are_equal_moments(inverse_moments.minCoeff(), inverse_moments.maxCoeff());
}

/// By the spin of now; of revolution: by what its axis shows of it.
template <class Scalar>
[[gnu::noinline]] Motion<Scalar> steady_motion(const Body<Scalar>& body,
                                               const Splitting<Scalar>& split, Scalar duration) {
  Twist<Scalar> twist = twist_of(body);
  const bool shows = body.spin_shows && !has_equal_moments(body.inverse_moments);
  if (is_revolution(split) && !shows) twist.w_W = split.steady * body.momentum.angular_W;
  return {body.X_WB, twist, duration};
}

template <class Scalar>
bool is_on_axis(const Vec3<Scalar>& point, int axis) {
  const Scalar reach = length(point);
  const Scalar across = max_of(std::abs(point((axis + 1) % 3)), std::abs(point((axis + 2) % 3)));
  return across <= kOnAxis<Scalar> * reach;
}

/// Components of x_W in the body.
template <class Scalar>
[[gnu::noinline]] Vec3<Scalar> in_body(const Quat<Scalar>& q_WB, const Vec3<Scalar>& x_W) {
  return q_WB.conjugate() * x_W;
}

template <class Scalar>
[[gnu::noinline]] Quat<Scalar> turned(const Quat<Scalar>& q_WB, const Vec3<Scalar>& turn_B) {
  return q_WB * exp_map(turn_B);
}

/// q turned about its own axis by what is left of its spin when the steady part is taken off.
template <class Scalar>
[[gnu::noinline]] Quat<Scalar> spun(const Body<Scalar>& body, const Splitting<Scalar>& split,
                                    const Quat<Scalar>& q_WB, int axis, Scalar duration) {
  const Vec3<Scalar> b_B = in_body(q_WB, body.momentum.angular_W);
  const Scalar spin = (body.inverse_moments(axis) - split.steady) * b_B(axis);
  Vec3<Scalar> turn_B = Vec3<Scalar>::Zero();
  turn_B(axis) = spin * duration;
  return turned(q_WB, turn_B);
}

/// A bound on the turn that the flight makes in the time, and on that of each spin of the splitting
/// (motion.md).
template <class Scalar>
[[gnu::noinline]] Scalar most_turn(const Body<Scalar>& body, const Splitting<Scalar>& split,
                                   Scalar duration) {
  const Vec3<Scalar> b_B = in_body(body.X_WB.q_WB, body.momentum.angular_W);
  Scalar squares = 0;
  Scalar product = duration * b_B(3 - split.odd - split.minor);
  product *= split.tumbles ? -product : Scalar(0);
  for (int i = 0; i < 3; ++i) {  // Bound: three axes
    const Scalar rate = body.inverse_moments(i);
    const Scalar turn = duration * rate * b_B(i);
    const Scalar spin = duration * (rate - split.steady) * b_B(i);
    squares += turn * turn + spin * spin;
    if (i == split.odd || i == split.minor) product *= rate - split.steady;
  }
  return std::sqrt(squares + product);
}

/// What the flight keeps of the energy: 2 E - |b|^2 / I_axis, the excess over turning about one
/// axis alone.
template <class Scalar>
struct Excess {
  Vec3<Scalar> b_B;   ///< angular momentum
  Vec3<Scalar> rate;  ///< (1 / I_i - 1 / I_axis) b_i
  Scalar value = 0;   ///< J
  Scalar most = 0;    ///< no two orientations differ by more, J
};

template <class Scalar>
BATUTA_RARE Excess<Scalar> excess_of(const Body<Scalar>& body, const Quat<Scalar>& q_WB, int axis) {
  Excess<Scalar> excess;
  excess.b_B = in_body(q_WB, body.momentum.angular_W);
  for (int i = 0; i < 3; ++i) {  // Bound: three axes
    const Scalar apart = body.inverse_moments(i) - body.inverse_moments(axis);
    excess.rate(i) = apart * excess.b_B(i);
    excess.value += excess.rate(i) * excess.b_B(i);
    excess.most += std::abs(apart);
  }
  excess.most *= body.momentum.angular_W.squaredNorm();
  return excess;
}

/// What is kept of the flight that the body is on; where there is none, of the one that begins now.
/// Its axis is then the one nearest to b: so the excess loses no digits where its terms are small.
template <class Scalar>
BATUTA_RARE detail::FlightMemory<Scalar> memory_of(const Body<Scalar>& body) {
  detail::FlightMemory<Scalar> flight = body.flight;
  const Excess<Scalar> now = excess_of(body, body.X_WB.q_WB, flight.axis);
  const bool is_near = std::abs(now.value - flight.excess) <= kSameFlight<Scalar> * now.most;
  const bool is_same = detail::is_same(flight.angular_W, body.momentum.angular_W);
  if (is_same && (is_near || flight.is_on_chord)) return flight;
  flight.is_on_chord = false;
  flight.axis = 0;
  for (int i = 1; i < 3; ++i) {  // Bound: two axes
    const bool is_nearer = std::abs(now.b_B(i)) > std::abs(now.b_B(flight.axis));
    if (is_nearer) flight.axis = static_cast<std::uint8_t>(i);
  }
  flight.angular_W = body.momentum.angular_W;
  flight.excess = excess_of(body, body.X_WB.q_WB, flight.axis).value;
  return flight;
}

/// q turned on the shortest way to the orientations of the flight's energy, to first order; by a
/// quarter of the way to an axis at most, where the first order ends.
/// @param most_turn  and by no more than that, rad
template <class Scalar>
inline Quat<Scalar> nearer_to(const detail::FlightMemory<Scalar>& flight, const Body<Scalar>& body,
                              const Quat<Scalar>& q_WB, Scalar most_turn) {
  const Excess<Scalar> now = excess_of(body, q_WB, flight.axis);
  const Vec3<Scalar> gradient_B = now.b_B.cross(now.rate);
  const Scalar square = 2 * gradient_B.squaredNorm();
  if (!(square > std::numeric_limits<Scalar>::min())) return q_WB;
  const Scalar most = min_of(square / (4 * now.most), std::sqrt(2 * square) * most_turn);
  const Scalar missing = clamp(flight.excess - now.value, -most, most);
  return turned(q_WB, Vec3<Scalar>((-missing / square) * gradient_B));
}

/// q with the energy of the flight, or nearer to it.
/// @param most  that the flight turns, rad. Bound: kPassesFromChord.
template <class Scalar>
BATUTA_RARE Quat<Scalar> with_energy(const Body<Scalar>& body, const Quat<Scalar>& q_WB,
                                     Scalar most) {
  const detail::FlightMemory<Scalar> flight = memory_of(body);
  const int passes = flight.is_on_chord ? kPassesFromChord : 1;
  const Scalar most_turn = flight.is_on_chord ? kOfTurn<Scalar> * most : kHalfTurn<Scalar>;
  Quat<Scalar> q = q_WB;
  for (int i = 0; i < passes; ++i) {  // Bound: kPassesFromChord
    q = nearer_to(flight, body, q, most_turn);
  }
  return q;
}

/// The spins, one after the other: about the odd axis, the minor one and the odd one again, with
/// halves at both ends, three times a part. @pre most < a whole turn: kMostParts parts at most
/// Bound: 3 kMostParts + 1 spins about the odd axis, 3 kMostParts about the other.
template <class Scalar>
BATUTA_RARE Quat<Scalar> tumbled(const Body<Scalar>& body, const Splitting<Scalar>& split,
                                 Scalar duration, Scalar most) {
  const int parts = 1 + static_cast<int>(most / kTurnOfPart<Scalar>);
  const Quat<Scalar>& q_WB = body.X_WB.q_WB;
  const Scalar part = duration / static_cast<Scalar>(parts);
  Quat<Scalar> q = spun(body, split, q_WB, split.odd, kOuterShare<Scalar> * part / 2);
  for (int i = 1; i <= 3 * parts; ++i) {  // Bound: 3 kMostParts
    const bool is_inner = i % 3 == 2;
    const Scalar share = is_inner ? 1 - 2 * kOuterShare<Scalar> : kOuterShare<Scalar>;
    // Half of this share and half of the next; outer shares make a whole one between parts.
    Scalar odd = (1 - kOuterShare<Scalar>) / 2;
    if (i % 3 == 0) odd = i < 3 * parts ? kOuterShare<Scalar> : kOuterShare<Scalar> / 2;
    q = spun(body, split, q, split.minor, share * part);
    q = spun(body, split, q, split.odd, odd * part);
  }
  return with_energy(body, renewed(q), most);
}

/// The orientation at the end of a flight whose turn is less than `most`.
template <class Scalar>
Quat<Scalar> flown(const Body<Scalar>& body, const Splitting<Scalar>& split, Scalar duration,
                   Scalar most) {
  const Vec3<Scalar> steady_W = (split.steady * duration) * body.momentum.angular_W;
  const Quat<Scalar> q_WB = split.tumbles ? tumbled(body, split, duration, most)
                                          : spun(body, split, body.X_WB.q_WB, split.odd, duration);
  return renewed(Quat<Scalar>(exp_map(steady_W) * q_WB));
}

/// Whether a flight would end with more energy than it has, or than it begins with: what is seen of
/// it is then another flight. So where moments are no matter's, or extreme.
template <class Scalar>
BATUTA_RARE bool wins_energy(const Body<Scalar>& body, const Quat<Scalar>& q_WB) {
  const detail::FlightMemory<Scalar> flight = memory_of(body);
  const Scalar first = excess_of(body, body.X_WB.q_WB, flight.axis).value;
  const Scalar last = excess_of(body, q_WB, flight.axis).value;
  const Scalar about_axis =
      body.momentum.angular_W.squaredNorm() * body.inverse_moments(flight.axis);
  const Scalar may_be = max_of(first, flight.excess);
  return last - may_be > detail::kOffFlight<Scalar> * (about_axis + may_be);
}

/// The angular velocity that joins both ends of a flight; NaN where that turns by half a turn or
/// more, or its energy is lost. The sign of the quaternion at the end tells: none of its factors
/// lost it.
template <class Scalar>
Vec3<Scalar> joining(const Body<Scalar>& body, const Splitting<Scalar>& split, Scalar duration) {
  const Scalar most = most_turn(body, split, duration);
  if (most < 2 * kHalfTurn<Scalar>) {
    const Pose<Scalar> end{body.X_WB.p_W, flown(body, split, duration, most)};
    const bool is_lost = split.tumbles && wins_energy(body, end.q_WB);
    if (!is_lost && end.q_WB.dot(body.X_WB.q_WB) > Scalar(0)) {
      return motion_between(body.X_WB, end, duration).twist.w_W;
    }
  }
  return Vec3<Scalar>::Constant(std::numeric_limits<Scalar>::quiet_NaN());
}

/// Whether a body turns so far on its planned motion that the energy on the way may be off its
/// flight's: by no more than most / least of its moments, times the square of the turn, over 4, to
/// second order (motion.md, "The energy on the chord").
template <class Scalar>
bool turns_far(const Body<Scalar>& body, const Motion<Scalar>& motion) {
  const Vec3<Scalar>& inverse = body.inverse_moments;
  Scalar least = std::numeric_limits<Scalar>::max();  // 0: it does not turn about that axis
  for (int i = 0; i < 3; ++i) {                       // Bound: 3
    if (inverse(i) > Scalar(0)) least = min_of(least, inverse(i));
  }
  const Scalar turn = motion.duration * length(motion.twist.w_W);
  return turn * turn * inverse.maxCoeff() > detail::kOffFlight<Scalar> * least;
}

/// Twice the energy of turning of the flight that the body is on, J; where none is remembered, of
/// the body as it is.
template <class Scalar>
Scalar flight_energy_twice(const Body<Scalar>& body) {
  const Vec3<Scalar>& angular_W = body.momentum.angular_W;
  if (!detail::tumbles(body)) return angular_W.dot(twist_of(body).w_W);
  const detail::FlightMemory<Scalar> flight = memory_of(body);
  return flight.excess + angular_W.squaredNorm() * body.inverse_moments(flight.axis);
}

}  // namespace

template <class Scalar>
Motion<Scalar> free_flight(const Body<Scalar>& body, Scalar duration) {
  const Splitting<Scalar> split = splitting_of(body.inverse_moments);
  Motion<Scalar> motion = steady_motion(body, split, duration);
  if (!is_steady(body, split) && duration > Scalar(0)) {
    motion.twist.w_W = joining(body, split, duration);
  }
  return motion;
}

template <class Scalar>
bool detail::flies_bent(const Body<Scalar>& body) {
  return !is_steady(body, splitting_of(body.inverse_moments)) &&
         !has_equal_moments(body.inverse_moments);
}

template <class Scalar>
Motion<Scalar> detail::steady_flight(const Body<Scalar>& body, Scalar duration) {
  return steady_motion(body, splitting_of(body.inverse_moments), duration);
}

template <class Scalar>
bool detail::hides_spin(const Body<Scalar>& body, const Capsule<Scalar>& capsule_B) {
  const Splitting<Scalar> split = splitting_of(body.inverse_moments);
  return is_revolution(split) && is_on_axis(capsule_B.axis.a, split.odd) &&
         is_on_axis(capsule_B.axis.b, split.odd);
}

template <class Scalar>
bool detail::tumbles(const Body<Scalar>& body) {
  return splitting_of(body.inverse_moments).tumbles;
}

template <class Scalar>
Scalar detail::off_flight_energy(const Body<Scalar>& body, const Motion<Scalar>& motion, Scalar t) {
  if (!turns_far(body, motion) || !flies_bent(body)) return Scalar(0);
  const Vec3<Scalar> b_B = in_body(pose_at(motion, t).q_WB, body.momentum.angular_W);
  return body.inverse_moments.dot(b_B.cwiseProduct(b_B)) / flight_energy_twice(body) - 1;
}

template <class Scalar>
void move_along(Body<Scalar>& body, const Motion<Scalar>& motion, Scalar t) {
  if (detail::tumbles(body)) {
    body.flight = memory_of(body);
    body.flight.is_on_chord = t < motion.duration;
  }
  body.X_WB = pose_at(motion, t);
}

#define BATUTA_INSTANTIATE(Scalar)                                                               \
  template Motion<Scalar> free_flight(const Body<Scalar>&, Scalar);                              \
  template bool detail::hides_spin(const Body<Scalar>&, const Capsule<Scalar>&);                 \
  template bool detail::tumbles(const Body<Scalar>&);                                            \
  template bool detail::flies_bent(const Body<Scalar>&);                                         \
  template Motion<Scalar> detail::steady_flight(const Body<Scalar>&, Scalar);                    \
  template Scalar detail::off_flight_energy(const Body<Scalar>&, const Motion<Scalar>&, Scalar); \
  template void move_along(Body<Scalar>&, const Motion<Scalar>&, Scalar);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE
#undef BATUTA_RARE

}  // namespace batuta
