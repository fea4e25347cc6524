// SPDX-License-Identifier: MIT
#include "batuta/response/line_contact.hpp"

#include "lever.hpp"

namespace batuta {

namespace {

/// The places point + x direction, x in [low, high].
template <class Scalar>
struct ContactLine {
  Vec3<Scalar> direction_W = Vec3<Scalar>::Zero();
  Scalar low = 0;
  Scalar high = 0;
};

/// Coordinates, along d, of the axis ends as seen from a point; ascending.
template <class Scalar>
struct Span {
  Scalar low;
  Scalar high;
};

template <class Scalar>
Span<Scalar> span_of(const Segment<Scalar>& axis, const Vec3<Scalar>& point, const Vec3<Scalar>& d,
                     Scalar square) {
  const Scalar a = d.dot(axis.a - point) / square;
  const Scalar b = d.dot(axis.b - point) / square;
  return {min_of(a, b), max_of(a, b)};
}

/// 1 where the gap is larger than at the nearest points by slack / 2 or less, 0 from slack on. With
/// D between the axes at the nearest points, and the axes parting by p per unit of x, the square of
/// their distance grows by x (2 D n.p + x p.p).
template <class Scalar>
Scalar weight_at(Scalar x, Scalar linear, Scalar quadratic, Scalar largest) {
  const Scalar growth = x * (linear + x * quadratic);
  return clamp(Scalar(2) - Scalar(2) * growth / largest, Scalar(0), Scalar(1));
}

/// Where both axes run along each other. All zero if nowhere.
template <class Scalar>
ContactLine<Scalar> contact_line(const Capsule<Scalar>& A, const Capsule<Scalar>& B,
                                 const Contact<Scalar>& nearest, Scalar slack) {
  const Vec3<Scalar> d_A = A.axis.direction();
  const Vec3<Scalar> d_B = B.axis.direction();
  const Scalar square = d_A.squaredNorm();
  const Scalar alike = d_A.dot(d_B);
  const Scalar distance = A.radius + B.radius + nearest.gap;
  const Scalar largest = slack * (Scalar(2) * distance + slack);
  if (square == Scalar(0) || alike == Scalar(0) || !(largest > Scalar(0))) return {};

  const Span<Scalar> on_A = span_of(A.axis, nearest.point_W, d_A, square);
  const Span<Scalar> on_B = span_of(B.axis, nearest.point_W, d_A, square);
  const Scalar low = max_of(on_A.low, on_B.low);
  const Scalar high = min_of(on_A.high, on_B.high);
  if (!(low < high)) return {};

  const Vec3<Scalar> parting = d_A - square / alike * d_B;
  const Scalar linear = Scalar(2) * distance * nearest.normal_BA_W.dot(parting);
  const Scalar quadratic = parting.squaredNorm();
  return {d_A - parting / 2, low * weight_at(low, linear, quadratic, largest),
          high * weight_at(high, linear, quadratic, largest)};
}

/// k(x, y) = k0 + k1 (x + y) + k2 x y: velocity along n at x for an impulse along n at y.
template <class Scalar>
struct LineGive {
  Scalar k0 = 0;
  Scalar k1 = 0;
  Scalar k2 = 0;
};

/// Adds one body's part.
/// @param m_W  direction of the line x n: change of the moment r x n with x
template <class Scalar>
void add_give(LineGive<Scalar>& give, const Collider<Scalar>& body, const Contact<Scalar>& nearest,
              const Vec3<Scalar>& m_W) {
  const Lever<Scalar> lever = lever_of(body, nearest);
  const Vec3<Scalar> moment_B = moment_of(lever, nearest.normal_BA_W);
  const Vec3<Scalar> change_B = lever.R_WB.transpose() * m_W;
  const Vec3<Scalar> turn_B = body.inverse_moments.cwiseProduct(change_B);
  give.k0 += body.inverse_mass + body.inverse_moments.cwiseProduct(moment_B).dot(moment_B);
  give.k1 += turn_B.dot(moment_B);
  give.k2 += turn_B.dot(change_B);
}

/// Velocity along n at x is v0 + v1 x.
template <class Scalar>
struct LineRate {
  Scalar v0 = 0;
  Scalar v1 = 0;

  Scalar at(Scalar x) const { return v0 + v1 * x; }
};

/// The complementarity of two impulses at the ends, solved for their centre (line_contact.md).
template <class Scalar>
Scalar centre_of_pressure(const ContactLine<Scalar>& line, const LineGive<Scalar>& give,
                          const LineRate<Scalar>& rate) {
  // An impulse that stops the place x leaves a velocity that rises with x as m(x) = m0 + m1 x does.
  const Scalar m0 = give.k0 * rate.v1 - give.k1 * rate.v0;
  const Scalar m1 = give.k1 * rate.v1 - give.k2 * rate.v0;
  const Scalar m_low = m0 + line.low * m1;
  const Scalar m_high = m0 + line.high * m1;
  if (m_low < Scalar(0) && m_high > Scalar(0)) return clamp(-m0 / m1, line.low, line.high);
  if (m0 == Scalar(0) && m1 == Scalar(0)) return 0;
  if (m_low >= Scalar(0) && rate.at(line.low) < Scalar(0)) return line.low;
  if (m_high <= Scalar(0) && rate.at(line.high) < Scalar(0)) return line.high;
  return 0;
}

}  // namespace

template <class Scalar>
Contact<Scalar> pressure_contact(const Collider<Scalar>& A, const Collider<Scalar>& B,
                                 const Capsule<Scalar>& A_W, const Capsule<Scalar>& B_W,
                                 const Contact<Scalar>& nearest, Scalar slack) {
  const ContactLine<Scalar> line = contact_line(A_W, B_W, nearest, slack);
  if (!(line.low < line.high)) return nearest;

  const Vec3<Scalar> m_W = line.direction_W.cross(nearest.normal_BA_W);
  LineGive<Scalar> give;
  add_give(give, A, nearest, m_W);
  add_give(give, B, nearest, m_W);
  const LineRate<Scalar> rate{relative_velocity(nearest, A.X_WB, A.twist, B.X_WB, B.twist),
                              m_W.dot(A.twist.w_W - B.twist.w_W)};
  const Scalar x = centre_of_pressure(line, give, rate);
  if (!(x < Scalar(0)) && !(x > Scalar(0))) return nearest;
  return {nearest.point_W + x * line.direction_W, nearest.normal_BA_W, nearest.gap};
}

#define BATUTA_INSTANTIATE(Scalar)                                                            \
  template Contact<Scalar> pressure_contact(const Collider<Scalar>&, const Collider<Scalar>&, \
                                            const Capsule<Scalar>&, const Capsule<Scalar>&,   \
                                            const Contact<Scalar>&, Scalar);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
