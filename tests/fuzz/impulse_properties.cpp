// SPDX-License-Identifier: MIT
// What must hold of a blow and of a separation for any numbers whatever, as a libFuzzer target:
// impulse, friction, contact along a line, separation to D. Every bound is the one that the notes
// in src/response state.

#include "batuta/geometry/direction.hpp"
#include "batuta/response/line_contact.hpp"
#include "batuta/response/separation.hpp"
#include "blow.hpp"
#include "bytes.hpp"

namespace batuta::fuzz {
using namespace detail;
namespace {

struct Blow {
  Collider<float> A;
  Collider<float> B;
  Contact<float> contact;
  FrictionLaw<float> law;
};

/// Held, ordinary, needle, plate or any; a hand has a velocity that nothing can change.
Vec3<float> draw_moments(Bytes& bytes, Numbers from) {
  switch (bytes.choice(4)) {
    case 0:
      return Vec3<float>::Zero();
    case 1:
      return Vec3<float>::Constant(std::abs(bytes.number(from)));
    default:
      return bytes.vector(from).cwiseAbs();
  }
}

Collider<float> draw_collider(Bytes& bytes, Numbers from) {
  Collider<float> body;
  body.X_WB = {bytes.vector(from), bytes.turn()};
  body.twist.v_W = bytes.vector(from);
  body.twist.w_W = bytes.vector(from);
  body.inverse_mass = std::abs(bytes.number(from));
  body.inverse_moments = draw_moments(bytes, from);
  return body;
}

Vec3<float> draw_normal(Bytes& bytes, Numbers from) {
  const Vec3<float> along = bytes.vector(from == Numbers::kAny ? Numbers::kScaled : from);
  return along.isZero(0) ? Vec3<float>::UnitX() : unit(along);
}

Blow draw_blow(Bytes& bytes, Numbers from) {
  Blow blow;
  blow.A = draw_collider(bytes, from);
  blow.B = draw_collider(bytes, from);
  blow.contact.point_W = bytes.vector(from);
  blow.contact.normal_BA_W = draw_normal(bytes, from);
  blow.law.restitution = from == Numbers::kAny ? bytes.bits() : bytes.share();
  blow.law.friction = std::abs(bytes.number(from));
  blow.law.tangential = from == Numbers::kAny ? bytes.bits() : 2 * bytes.share() - 1;
  return blow;
}

Blow swapped(const Blow& blow) {
  Blow other = blow;
  std::swap(other.A, other.B);
  other.contact.normal_BA_W = -blow.contact.normal_BA_W;
  return other;
}

/// A unit of length 2^3 times as large, one of mass 2^5, one of time 2^-2.
Blow in_other_units(const Blow& blow) {
  Blow other = blow;
  for (Collider<float>* body : {&other.A, &other.B}) {
    body->X_WB.p_W *= 0x1p3F;
    body->twist.v_W *= 0x1p5F;
    body->twist.w_W *= 0x1p2F;
    body->inverse_mass *= 0x1p-5F;
    body->inverse_moments *= 0x1p-11F;
  }
  other.contact.point_W *= 0x1p3F;
  return other;
}
constexpr float kOtherImpulse = 0x1p10F;

bool is_same(const Twist<float>& a, const Twist<float>& b) {
  return a.v_W == b.v_W && a.w_W == b.w_W;
}

/// Of any answer: what is not moved keeps its twist, and one impulse serves both bodies.
/// @param hits  whether the impulse without friction is above zero
void check_answer(const Blow& blow, const Impulse<float>& hit, bool hits) {
  require(is_finite(hit.magnitude) && hit.magnitude >= 0, "nothing is pulled");
  require(hit.on_B.linear_W == -hit.on_A.linear_W, "B gets the opposite");
  if (!hits) {
    require(is_same(hit.twist_A, blow.A.twist) && is_same(hit.twist_B, blow.B.twist),
            "no impulse, no change");
  }
  if (blow.A.inverse_mass == 0) require(hit.twist_A.v_W == blow.A.twist.v_W, "A's place is held");
  if (blow.B.inverse_mass == 0) require(hit.twist_B.v_W == blow.B.twist.v_W, "B's place is held");
  if (blow.B.inverse_moments.isZero(0)) {
    require(hit.twist_B.w_W == blow.B.twist.w_W, "what does not turn does not turn");
  }
}

/// c x J + r x J is the same for both bodies, to 4 ulp of its largest term; below the normal
/// numbers each of the two products in a component of r x J is off by half of the least one.
void check_momentum(const Blow& blow, const Weighed& A, const Weighed& B) {
  const Real3 c_A = blow.A.X_WB.p_W.cast<double>();
  const Real3 c_B = blow.B.X_WB.p_W.cast<double>();
  const Real3 sum = c_A.cross(A.J) + A.b + c_B.cross(B.J) + B.b;
  const double J = A.J.norm();
  const double largest = J * std::max({c_A.norm(), c_B.norm(), A.r.norm(), B.r.norm()});
  require(sum.norm() <= 8 * kU * largest + 4 * kLeast, "angular momentum is kept to 4 ulp");
}

/// A moving body of infinite mass works on the other one: then energy says nothing.
bool does_work(const Collider<float>& body) {
  const bool moves = body.inverse_mass == 0 && !body.twist.v_W.isZero(0);
  const bool turns = (body.inverse_moments.array() == 0).any() && !body.twist.w_W.isZero(0);
  return moves || turns;
}

void check_frictionless(const Blow& blow, const Impulse<float>& hit) {
  const Vec3<float>& point = blow.contact.point_W;
  const Weighed A = weighed(blow.A, hit.twist_A, hit.on_A, point);
  const Weighed B = weighed(blow.B, hit.twist_B, hit.on_B, point);
  check_momentum(blow, A, B);
  if (hit.magnitude == 0) return;
  const Real3 n = blow.contact.normal_BA_W.cast<double>();
  const double C = blow.law.restitution;
  const BlowErrors e = errors_of(A, B, n, C);
  const auto rate = [&](const Real3& v_A, const Real3& w_A, const Real3& v_B, const Real3& w_B) {
    return n.dot(v_A + w_A.cross(A.r) - v_B - w_B.cross(B.r));
  };
  const double before = rate(A.v, A.w, B.v, B.w);
  const double after = rate(A.v1, A.w1, B.v1, B.w1);
  const double slack = e.v_A + e.v_B + A.r.norm() * e.w_A + B.r.norm() * e.w_B;
  require(std::abs(after + C * before) <= 8 * kU * slack, "the approach is turned round by C");
  if (does_work(blow.A) || does_work(blow.B)) return;
  require(A.gain() + B.gain() <= frictionless_gain(A, B, e), "a blow brings no energy");
}

/// Whether all that the blow comes to is far below the largest number. Where a place is held and
/// the lever has next to no length, no impulse that is a number turns the approach round.
bool fits(const Blow& blow) {
  const Vec3<float>& point = blow.contact.point_W;
  const Weighed A = weighed(blow.A, blow.A.twist, {}, point);
  const Weighed B = weighed(blow.B, blow.B.twist, {}, point);
  const Real3 n = blow.contact.normal_BA_W.cast<double>();
  const double v_rel = n.dot(A.v + A.w.cross(A.r) - B.v - B.w.cross(B.r));
  const double j = 2 * std::abs(v_rel) / (yield_of(A, n) + yield_of(B, n));
  const auto most = [](const Weighed& it) {
    return std::max({1.0, it.r.norm(), it.inverse_mass, it.inverses.maxCoeff() * it.r.norm()});
  };
  return !(j * std::max(most(A), most(B)) >= 0x1p120);  // 0 / 0: nothing happens
}

void check_impulse(const Blow& blow, Numbers from) {
  const float C = blow.law.restitution;
  const Result<Impulse<float>> answer = collision_impulse(blow.A, blow.B, blow.contact, C);
  const Blow other = swapped(blow);
  const Result<Impulse<float>> back = collision_impulse(other.A, other.B, other.contact, C);
  require(answer.ok() == back.ok(), "answered or refused, whichever is called A");
  require(answer.ok() || from == Numbers::kAny || !fits(blow), "ordinary numbers have an answer");
  if (!answer.ok()) return;
  const Impulse<float>& hit = answer.value;
  check_answer(blow, hit, hit.magnitude > 0);
  require(hit.magnitude == back.value.magnitude && hit.on_A.linear_W == back.value.on_B.linear_W &&
              is_same(hit.twist_A, back.value.twist_B) && is_same(hit.twist_B, back.value.twist_A),
          "the same blow from the other side, to the last bit");
  const Impulse<float> dull = collision_impulse(blow.A, blow.B, blow.contact, C / 2).value;
  require(dull.magnitude <= hit.magnitude, "bouncier is stronger");
  if (from == Numbers::kAny) return;
  check_frictionless(blow, hit);
  if (from != Numbers::kGrid) return;
  const Blow same = in_other_units(blow);
  const Impulse<float> scaled = collision_impulse(same.A, same.B, same.contact, C).value;
  require(scaled.magnitude == kOtherImpulse * hit.magnitude &&
              scaled.twist_A.v_W == 0x1p5F * hit.twist_A.v_W &&
              scaled.twist_B.w_W == 0x1p2F * hit.twist_B.w_W,
          "the same blow in other units, to the last bit");
}

/// |P_t| <= mu n.P, to what friction.md says of its rounding.
/// @param A  and B: with the velocities after the blow without friction, whose impulse is j
void check_cone(const Blow& blow, const Weighed& A, const Weighed& B, double j) {
  const Real3 given = blow.contact.normal_BA_W.cast<double>();
  const Real3 n = given.normalized();
  const double mu = blow.law.friction;
  const double along = A.J.dot(n);
  const double across = (A.J - along * n).norm();
  const double nu = std::abs(given.norm() - 1);
  require(across - mu * along <= cone_excess(A, B, mu, nu, j), "the cone is kept");
}

void check_friction(const Blow& blow, Numbers from) {
  const Result<Impulse<float>> answer = friction_impulse(blow.A, blow.B, blow.contact, blow.law);
  const Result<Impulse<float>> plain =
      collision_impulse(blow.A, blow.B, blow.contact, blow.law.restitution);
  const bool ordinary = from == Numbers::kGrid || from == Numbers::kNudged;
  const bool has_square = plain.ok() && plain.value.magnitude < 0x1p56F;  // of it and some more
  require(answer.ok() || !ordinary || !has_square, "ordinary bodies rub");
  if (!answer.ok()) return;
  const Impulse<float>& hit = answer.value;
  require(plain.ok(), "what can rub can collide");
  check_answer(blow, hit, plain.value.magnitude > 0);
  FrictionLaw<float> smooth = blow.law;
  smooth.friction = 0;
  const Impulse<float> bare = friction_impulse(blow.A, blow.B, blow.contact, smooth).value;
  require(is_same(bare.twist_A, plain.value.twist_A) && is_same(bare.twist_B, plain.value.twist_B),
          "without friction it is the impulse, to the last bit");
  if (from == Numbers::kAny || plain.value.magnitude == 0) return;
  Blow smooth_blow = blow;  // with the velocities that friction finds
  smooth_blow.A.twist = plain.value.twist_A;
  smooth_blow.B.twist = plain.value.twist_B;
  const Weighed A = weighed(smooth_blow.A, hit.twist_A, hit.on_A, blow.contact.point_W);
  const Weighed B = weighed(smooth_blow.B, hit.twist_B, hit.on_B, blow.contact.point_W);
  check_momentum(blow, A, B);
  check_cone(blow, A, B, static_cast<double>(plain.value.magnitude));
  if (does_work(blow.A) || does_work(blow.B)) return;
  require(A.gain() + B.gain() <= rough_gain(A, B), "friction brings no energy");
}

void check_line(Blow blow, Bytes& bytes, Numbers from) {
  const Capsule<float> A_W{bytes.segment(from), std::abs(bytes.share())};
  const Capsule<float> B_W{bytes.segment(from), std::abs(bytes.share())};
  const CapsuleGap<float> gap = capsule_gap(A_W, B_W);
  if (gap.proximity == Proximity::kInvalid) return;
  blow.contact = contact_from(gap, Vec3<float>(0, 0, 0));
  const Contact<float> nearest = blow.contact;
  blow.contact = pressure_contact(blow.A, blow.B, A_W, B_W, nearest, bytes.share());
  require(blow.contact.normal_BA_W == nearest.normal_BA_W && blow.contact.gap == nearest.gap,
          "pressure moves the point alone");
  if (A_W.axis.direction().isZero(0) || B_W.axis.direction().isZero(0)) {
    require(blow.contact.point_W == nearest.point_W, "a ball touches at a point");
  }
  require(from == Numbers::kAny || is_finite(blow.contact.point_W), "pressure has a place");
  check_friction(blow, from);
}

void check_separation(Bytes& bytes, Numbers from) {
  Contact<float> contact;
  contact.normal_BA_W = draw_normal(bytes, from);
  contact.gap = bytes.number(from);
  SeparationOptions<float> options;
  options.distance = std::abs(bytes.number(from));
  options.rest_speed = std::abs(bytes.number(from));
  options.min_duration = std::abs(bytes.number(from));
  if (bytes.flag()) options.limit_A = std::abs(bytes.number(from));
  if (bytes.flag()) options.limit_B = std::abs(bytes.number(from));
  const float v_rel = bytes.number(from);
  const float mass_A = bytes.flag() ? 0 : bytes.radius(from);
  const float mass_B = bytes.flag() ? 0 : bytes.radius(from);
  const Result<Separation<float>> answer = separate(contact, v_rel, mass_A, mass_B, options);
  if (!answer.ok()) return;
  require(answer.value.duration >= options.min_duration, "a separation takes its time");
  if (from == Numbers::kAny) return;
  const double on_A = answer.value.shift_A_W.cast<double>().norm();
  const double on_B = answer.value.shift_B_W.cast<double>().norm();
  const double missing =
      std::max(0.0, static_cast<double>(options.distance) - static_cast<double>(contact.gap));
  require(on_A + on_B <= missing * (1 + 16 * kU) + 2 * kLeast, "to D, and no further");
  require(on_A <= static_cast<double>(options.limit_A) * (1 + 8 * kU) + kLeast &&
              on_B <= static_cast<double>(options.limit_B) * (1 + 8 * kU) + kLeast,
          "no neighbour is reached");
  require((mass_A > 0 || on_A == 0) && (mass_B > 0 || on_B == 0), "what is fixed stays");
  const float asked = options.distance - contact.gap;
  const bool has_room = (mass_A == 0 || options.limit_A >= asked) &&
                        (mass_B == 0 || options.limit_B >= asked) && mass_A + mass_B > 0;
  if (has_room)
    require(on_A + on_B >= missing * (1 - 16 * kU) - 2 * kLeast, "where there is room, to D");
}

void check(Bytes bytes) {
  const Numbers from = bytes.numbers();
  const int which = bytes.choice(4);
  if (which == 0) return check_separation(bytes, from);
  const Blow blow = draw_blow(bytes, from);
  if (which == 1) check_impulse(blow, from);
  if (which == 2) check_friction(blow, from);
  if (which == 3) check_line(blow, bytes, from);
}

}  // namespace
}  // namespace batuta::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  batuta::fuzz::check({data, size});
  return 0;
}
