// SPDX-License-Identifier: MIT
// A query is built around an instant at which two points of the axes are a chosen distance apart,
// and then taken back to the start of the step.
#include "ensemble.hpp"

#include "batuta/geometry/direction.hpp"
#include "batuta/mechanics/rotation.hpp"
#include "draws.hpp"

namespace batuta::test {

namespace {

using Vector = Vec3<double>;

constexpr double kPi = 3.14159265358979324;
constexpr double kFarFromOrigin = 1000;  // m
constexpr double kCommonSpeed = 300;     // m/s

struct Range {
  double low = 0;
  double high = 0;
};

/// How the two come together.
enum class Meeting : std::uint8_t { kAnyhow, kParallel, kUnfolding, kGraze, kSwing };

/// What sets a family apart.
struct Recipe {
  const char* name = "";
  double duration = 1;      ///< s
  Range length{0.2, 2};     ///< of an axis, m
  Range radius{0.02, 0.3};  ///< m
  Range hilt{0, 1};         ///< centre of mass on the axis: 0 end a, 1 end b
  double turn = kPi;        ///< the largest, rad
  Range travel{1, 4};       ///< of B seen from A, m
  Meeting meeting = Meeting::kAnyhow;
};

constexpr Range kWeapon{0.9, 1.1};
constexpr Range kBladeRadius{0.005, 0.005};
constexpr Range kGrip{0.05, 0.3};

Recipe recipe_of(Family family) {
  switch (family) {
    case Family::kGeneric:
      return {"generic"};
    case Family::kBlade:
      return {"blade", 1, {1, 1}, {0.01, 0.01}, kGrip, 2, {1, 4}};
    case Family::kFence60:
      return {"fence60", 1.0 / 60, kWeapon, kBladeRadius, kGrip, 0.8, {0.02, 0.3}};
    case Family::kFence1ms:
      return {"fence1ms", 1e-3, kWeapon, kBladeRadius, kGrip, 0.05, {0.01, 0.04}};
    case Family::kSpin:
      return {"spin", 1, {0.2, 2}, {0.02, 0.3}, {0, 1}, 8 * kPi, {1, 4}};
    case Family::kNearParallel:
      return {"near_parallel", 1, {0.2, 2}, {0.02, 0.1}, {0, 1}, 1.5, {1, 4}, Meeting::kParallel};
    case Family::kGraze:
      return {"graze", 1, {0.2, 2}, {0.02, 0.3}, {0, 1}, kPi, {1, 4}, Meeting::kGraze};
    case Family::kPendulum:
      return {"pendulum", 1, {0.5, 2}, {0.01, 0.1}, {0, 0.3}, 2, {0, 0}, Meeting::kSwing};
    case Family::kBrief:
      return {"brief", 1, {0.2, 1}, {0.01, 0.03}, {0, 1}, 2, {30, 100}};
    case Family::kThin:
      return {"thin", 1, {0.2, 2}, {1e-6, 1e-3}, {0, 1}, kPi, {1, 4}};
    case Family::kScaled:
      return {"scaled"};
    case Family::kFar:
      return {"far"};
    case Family::kTranslation:
      return {"translation", 1, {0.2, 2}, {0.02, 0.3}, {0, 1}, 0, {1, 4}};
    case Family::kSphere:
      return {"sphere", 1, {0, 0}, {0.02, 0.3}, {0, 0}, 0, {1, 4}};
    case Family::kUnfolding:
      return {"unfolding", 1, {0.2, 2}, {0.02, 0.3}, {0, 1}, kPi, {1, 4}, Meeting::kUnfolding};
  }
  return {};
}

/// A capsule at the meeting instant; vectors in W.
struct Rod {
  double length = 0;
  double radius = 0;
  double hilt = 0;
  Vector along = Vector::UnitX();  ///< unit, from end a to end b
  double meets = 0;                ///< parameter of the meeting point on the axis
  Vector v = Vector::Zero();
  Vector w = Vector::Zero();

  /// From the centre of mass to the point of the axis with this parameter.
  Vector lever(double s) const { return (length * (s - hilt)) * along; }
  Vector velocity() const { return v + w.cross(lever(meets)); }
};

Rod draw_rod(Draws& draws, const Recipe& recipe) {
  Rod rod;
  rod.length = draws.between(recipe.length.low, recipe.length.high);
  rod.radius = draws.between(recipe.radius.low, recipe.radius.high);
  rod.hilt = draws.between(recipe.hilt.low, recipe.hilt.high);
  rod.along = draws.direction();
  rod.meets = draws.unit();
  rod.w = draws.in_ball(recipe.turn / recipe.duration);
  return rod;
}

/// A unit vector at right angles to `axis`, any such alike.
Vector square_to(const Vector& axis, Draws& draws) {
  const Vector across = axis.cross(draws.direction());
  return across.norm() > 0x1p-20 ? unit<double>(across) : detail::perpendicular(axis);
}

/// Unit normal of two axes; any normal of A's where they are parallel.
Vector edge_normal(const Rod& A, const Rod& B, Draws& draws) {
  const Vector across = A.along.cross(B.along);
  const double side = draws.chance(0.5) ? 1 : -1;
  return across.norm() > 0x1p-20 ? Vector(side * unit<double>(across)) : square_to(A.along, draws);
}

/// Turns B's axis so that it does not lead from its meeting point back towards A.
void lead_away(Rod& B, const Vector& normal) {
  const double inward = B.along.dot(normal) * (0.5 - B.meets);
  if (inward < 0) B.along = -B.along;
}

/// Half of the time B comes in along the normal and overlaps; else it passes at some distance.
/// @returns from A's meeting point to B's
Vector meet_anyhow(Rod& A, Rod& B, const Recipe& recipe, Draws& draws) {
  const bool edges = draws.chance(0.5);
  if (!edges) B.meets = draws.chance(0.5) ? 0 : 1;
  const Vector normal = edges ? edge_normal(A, B, draws) : square_to(A.along, draws);
  if (!edges) lead_away(B, normal);
  const bool hits = draws.chance(0.5);
  const double speed = draws.between(recipe.travel.low, recipe.travel.high) / recipe.duration;
  const Vector aside = draws.direction();
  A.v = 0.3 * speed * draws.direction();
  const double R = A.radius + B.radius;
  const double far = draws.unit();
  if (hits) {
    B.v = A.v - speed * unit<double>(normal + 0.7 * aside);
    return (R * far) * normal;
  }
  const Vector past = unit<double>(aside - 0.8 * aside.dot(normal) * normal);
  B.v = A.v + speed * past;
  return (R + (0.5 * (A.length + B.length) + R) * far) * normal;
}

Vector meet_parallel(Rod& A, Rod& B, const Recipe& recipe, Draws& draws) {
  const Vector tilt = square_to(A.along, draws);
  const double angle = draws.power_of_two(-24, -3);
  const double sense = draws.chance(0.5) ? 1 : -1;
  B.along = sense * unit<double>(A.along + angle * tilt);
  return meet_anyhow(A, B, recipe, draws);
}

/// @param since  time since the start, when the axes were parallel, s
Vector meet_unfolding(Rod& A, Rod& B, const Recipe& recipe, double since, Draws& draws) {
  const Vector back = -since * A.w;
  const Vector forth = since * B.w;
  B.along = exp_map<double>(forth) * (exp_map<double>(back) * A.along);
  return meet_anyhow(A, B, recipe, draws);
}

/// At the meeting instant the gap is a small part of the radii and does not change.
Vector meet_grazing(Rod& A, Rod& B, const Recipe& recipe, Draws& draws) {
  const double speed = draws.between(recipe.travel.low, recipe.travel.high) / recipe.duration;
  B.v = speed * draws.direction();
  const bool edges = draws.chance(0.5);
  Vector normal = edge_normal(A, B, draws);
  if (!edges) {
    B.meets = draws.chance(0.5) ? 0 : 1;
    const Vector across = A.along.cross(B.velocity() - A.velocity());
    if (across.norm() > 0) normal = unit<double>(across);
    lead_away(B, normal);
  }
  B.v -= normal.dot(B.velocity() - A.velocity()) * normal;
  const double R = A.radius + B.radius;
  const double sign = draws.chance(0.5) ? 1 : -1;
  return (R + sign * R * draws.power_of_two(-24, -1)) * normal;
}

/// B hangs towards A and swings past it; half of the time it only just reaches it.
Vector meet_swinging(Rod& A, Rod& B, const Recipe& recipe, Draws& draws) {
  const Vector down = square_to(A.along, draws);
  A.meets = draws.between(0.2, 0.8);
  B.meets = 1;
  B.along = unit<double>(down + 0.1 * draws.direction());
  A.w = draws.in_ball(0.05 * recipe.turn / recipe.duration);
  const double turn = draws.between(0.2, 1) * recipe.turn;
  B.w = (turn / recipe.duration) * square_to(down, draws);
  const double R = A.radius + B.radius;
  const double dip = B.length * (1 - B.hilt) * turn * turn / 8;  // of the end, against the ends
  const double deep = draws.between(-0.9, 0.6) * dip;
  const double slight = draws.power_of_two(-20, -3) * R;
  const bool grazes = draws.chance(0.5);
  const double sign = draws.chance(0.5) ? 1 : -1;
  return -(R + (grazes ? sign * slight : deep)) * down;
}

/// @param since  time since the start, s
Vector meet(Rod& A, Rod& B, const Recipe& recipe, double since, Draws& draws) {
  switch (recipe.meeting) {
    case Meeting::kUnfolding:
      return meet_unfolding(A, B, recipe, since, draws);
    case Meeting::kParallel:
      return meet_parallel(A, B, recipe, draws);
    case Meeting::kGraze:
      return meet_grazing(A, B, recipe, draws);
    case Meeting::kSwing:
      return meet_swinging(A, B, recipe, draws);
    default:
      return meet_anyhow(A, B, recipe, draws);
  }
}

/// What a family does to the whole query after the two have met.
struct Frame {
  double scale = 1;
  Vector origin_W = Vector::Zero();
  Vector v_W = Vector::Zero();
};

Frame draw_frame(Family family, Draws& draws) {
  Frame frame;
  if (family == Family::kScaled) {
    frame.scale = draws.power_of_two(-20, 20);
  } else if (family == Family::kFar) {
    frame.origin_W = kFarFromOrigin * draws.direction();
    frame.v_W = kCommonSpeed * draws.direction();
  }
  return frame;
}

struct Instant {
  double t = 0;
  double duration = 1;
};

/// The rod as it was `now.t` earlier, in numbers of float.
/// @param center_W  its centre of mass at the meeting instant
MovingCapsule<float> at_start(const Rod& rod, const Vector& center_W, const Frame& frame,
                              const Instant& now, const Quat<double>& q_meeting) {
  const Quat<double> back = q_meeting.conjugate();
  const Vector v_W = frame.scale * rod.v + frame.v_W;
  const Vector p_W = frame.origin_W + frame.scale * (center_W - rod.v * now.t);
  const Vector turned = -now.t * rod.w;
  MovingCapsule<float> m;
  m.capsule_B.axis.a = (back * Vector(frame.scale * rod.lever(0))).cast<float>();
  m.capsule_B.axis.b = (back * Vector(frame.scale * rod.lever(1))).cast<float>();
  m.capsule_B.radius = static_cast<float>(frame.scale * rod.radius);
  m.motion.X_WB.p_W = p_W.cast<float>();
  m.motion.X_WB.q_WB = renewed<double>(exp_map<double>(turned) * q_meeting).cast<float>();
  m.motion.twist.v_W = v_W.cast<float>();
  m.motion.twist.w_W = rod.w.cast<float>();
  m.motion.duration = static_cast<float>(now.duration);
  return m;
}

}  // namespace

const char* name(Family family) {
  return recipe_of(family).name;
}

bool turns(Family family) {
  return recipe_of(family).turn > 0;
}

Query make_query(Family family, std::uint64_t seed, std::uint64_t index) {
  Draws draws(seed, static_cast<std::uint64_t>(family), index);
  const Recipe recipe = recipe_of(family);
  Rod A = draw_rod(draws, recipe);
  Rod B = draw_rod(draws, recipe);
  const double share = recipe.meeting == Meeting::kSwing ? 0.5 : draws.between(0.3, 1);
  const Instant now{share * recipe.duration, recipe.duration};
  const Vector apart = meet(A, B, recipe, now.t, draws);
  const Frame frame = draw_frame(family, draws);
  const Quat<double> q_A = draws.rotation();
  const Quat<double> q_B = draws.rotation();
  const Vector center_A = -A.lever(A.meets);
  const Vector center_B = apart - B.lever(B.meets);
  return {at_start(A, center_A, frame, now, q_A), at_start(B, center_B, frame, now, q_B)};
}

}  // namespace batuta::test
