// SPDX-License-Identifier: MIT
// Contacts that last, one at a time: whatever is visited in whatever order, no energy is added and
// no momentum; what has converged is what a dense solution in long double says.
#include "batuta/world/detail/lasting_contact.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace batuta {
namespace {

using Contact = detail::LastingContact<detail::ContactTraits<double, true, true, true>>;
using detail::impulse_at;
using detail::SolvedBody;

/// Bodies with inertia, and contacts between them.
struct Group {
  std::vector<SolvedBody<double>> bodies;
  std::vector<Contact> contacts;
  std::vector<std::pair<std::size_t, std::size_t>> sides;
};

class RandomGroup {
 public:
  explicit RandomGroup(unsigned seed) : random_(seed) {}

  double draw(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }
  Vec3<double> vector(double size) {
    const double x = draw(-size, size);
    const double y = draw(-size, size);
    return {x, y, draw(-size, size)};
  }
  std::size_t below(std::size_t count) { return random_() % count; }

  /// The last body cannot be pushed.
  Group make(std::size_t bodies, std::size_t contacts, double friction, double rolling) {
    Group group;
    for (std::size_t i = 0; i < bodies; ++i) {
      SolvedBody<double> body;
      if (i + 1 < bodies) {
        const Quat<double> q = Quat<double>(draw(-1, 1), draw(-1, 1), draw(-1, 1), 1).normalized();
        const Mat3<double> R = q.toRotationMatrix();
        const Vec3<double> inverse(draw(1, 40), draw(1, 40), draw(1, 40));
        body.inverse_mass = std::pow(10.0, draw(-1, 1));
        body.inverse_inertia_W =
            R * (body.inverse_mass * inverse).eval().asDiagonal() * R.transpose();
        body.v_W = vector(1);
        body.w_W = vector(3);
      }
      body.place_W = vector(0.3);
      group.bodies.push_back(body);
    }
    for (std::size_t i = 0; i < contacts; ++i) {
      const std::size_t a = below(bodies - 1);
      const std::size_t b = (a + 1 + below(bodies - 1)) % bodies;
      Contact contact;
      contact.count = 1;
      contact.friction = friction;
      contact.rolling = rolling;
      contact.rest_gap = 1e-4;
      auto& point = contact.points[0];
      point.normal_W = vector(1).normalized();
      const Vec3<double> middle = (group.bodies[a].place_W + group.bodies[b].place_W) / 2;
      point.arm_A_W = middle + vector(0.1) - group.bodies[a].place_W;
      point.gap = draw(0, 2e-4);
      prepare(contact, group.bodies[a], group.bodies[b], 1e-3);
      group.contacts.push_back(contact);
      group.sides.emplace_back(a, b);
    }
    return group;
  }
  /// Impulses that are within the limits, and given to the bodies.
  void press(Group& group) {
    for (std::size_t i = 0; i < group.contacts.size(); ++i) {
      auto& point = group.contacts[i].points[0];
      point.normal = draw(0, 0.2);
      const double angle = draw(0, 6.3);
      const double grip = group.contacts[i].friction * point.normal * draw(0, 1);
      point.along = grip * std::cos(angle);
      point.across = grip * std::sin(angle);
      auto& [a, b] = group.sides[i];
      point.rolling_W = vector(1).normalized() * (group.contacts[i].rolling * point.normal);
      push_share(group.contacts[i], group.bodies[a], group.bodies[b], 1.0);
    }
  }

 private:
  std::mt19937 random_;
};

/// Kinetic: what visits must not add to.
long double energy_of(const Group& group) {
  long double sum = 0;
  for (const auto& body : group.bodies) {
    if (!(body.inverse_mass > 0)) continue;
    const Vec3<double> b = body.inverse_inertia_W.inverse() * body.w_W;
    sum += static_cast<long double>(body.v_W.squaredNorm() / body.inverse_mass + b.dot(body.w_W));
  }
  return sum / 2;
}
Vec3<double> momentum_of(const Group& group) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (const auto& body : group.bodies) {
    if (body.inverse_mass > 0) sum += body.v_W / body.inverse_mass;
  }
  return sum;
}
/// About the origin.
Vec3<double> spin_of(const Group& group) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (std::size_t i = 0; i + 1 < group.bodies.size(); ++i) {
    const auto& body = group.bodies[i];
    sum += body.inverse_inertia_W.inverse() * body.w_W +
           body.place_W.cross(body.v_W / body.inverse_mass);
  }
  return sum;
}
/// The same of what the one that cannot be pushed gave.
Vec3<double> turn_of_ground(const Group& group) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const auto& [a, b] = group.sides[i];
    const auto& point = group.contacts[i].points[0];
    const Vec3<double> x = group.bodies[a].place_W + point.arm_A_W;
    const Vec3<double> turn = x.cross(impulse_at(point).J_W) + point.rolling_W;
    if (b + 1 == group.bodies.size()) sum += turn;
    if (a + 1 == group.bodies.size()) sum -= turn;
  }
  return sum;
}
/// From now on a body turns about an axle only. @returns its inertia about that, kg m^2
double put_on_axle(SolvedBody<double>& body, const Vec3<double>& axis_W) {
  const double inverse = axis_W.dot(body.inverse_inertia_W * axis_W);
  body.inverse_mass = 0;
  body.inverse_inertia_W = inverse * axis_W * axis_W.transpose();
  body.v_W.setZero();
  body.w_W = axis_W.dot(body.w_W) * axis_W;
  return 1 / inverse;
}

// What a visit says that it adds to the energy is no less than what it adds, also where the contact
// slips on somebody who turns about an axle.
TEST(LastingContact, VisitsOfWheels_TellTheirEnergy) {
  int slipped = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    RandomGroup draws(seed);
    const double friction = draws.draw(0.05, 0.6);
    Group group = draws.make(3, 1, friction, 0);  // the third one may take part, and is still
    const double inertia = put_on_axle(group.bodies[0], draws.vector(1).normalized());
    auto& [a, b] = group.sides[0];
    auto& contact = group.contacts[0];
    prepare(contact, group.bodies[a], group.bodies[b], 1e-3);
    const auto total = [&group, inertia] {
      const SolvedBody<double>& other = group.bodies[1];
      const Vec3<double> spin = other.inverse_inertia_W.inverse() * other.w_W;
      return (inertia * group.bodies[0].w_W.squaredNorm() +
              other.v_W.squaredNorm() / other.inverse_mass + spin.dot(other.w_W)) /
             2;
    };
    const double before = total();
    double energy = 0;
    for (int visit = 0; visit < 20; ++visit) {
      relax(contact, group.bodies[a], group.bodies[b], energy);
      const auto& point = contact.points[0];
      const double pull = std::hypot(point.along, point.across);
      slipped += point.normal > 0 && pull > 0.999 * friction * point.normal ? 1 : 0;
      ASSERT_LE(total(), before + energy + 1e-12) << "seed " << seed << ", visit " << visit;
    }
  }
  EXPECT_GT(slipped, 300);
}

/// Summed impulse on all that can be pushed, by the one that cannot.
Vec3<double> push_of_ground(const Group& group) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const auto& [a, b] = group.sides[i];
    const Vec3<double> J = impulse_at(group.contacts[i].points[0]).J_W;
    if (b + 1 == group.bodies.size()) sum += J;
    if (a + 1 == group.bodies.size()) sum -= J;
  }
  return sum;
}

TEST(LastingContact, AnyVisitsInAnyOrder_AddNoEnergyAndNoMomentum) {
  int shrunk = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    RandomGroup draws(seed);
    const double friction = draws.draw(0, 2);
    const double rolling = seed % 2 == 0 ? 0.05 : 0;
    Group group = draws.make(2 + seed % 6, 1 + seed % 9, friction, rolling);
    draws.press(group);
    const long double before = energy_of(group);
    const Vec3<double> p = momentum_of(group) - push_of_ground(group);
    const Vec3<double> L = spin_of(group) - turn_of_ground(group);
    double energy = 0;
    for (int visit = 0; visit < 60; ++visit) {
      const std::size_t i = draws.below(group.contacts.size());
      const auto& [a, b] = group.sides[i];
      const double normal = group.contacts[i].points[0].normal;
      relax(group.contacts[i], group.bodies[a], group.bodies[b], energy);
      const auto& point = group.contacts[i].points[0];
      shrunk += point.normal < normal ? 1 : 0;
      ASSERT_GE(point.normal, 0);
      ASSERT_LE(std::hypot(point.along, point.across), friction * point.normal + 1e-12);
      ASSERT_LE(point.rolling_W.norm(), rolling * point.normal + 1e-12);
      ASSERT_LE(energy, 0);
      ASSERT_LE(energy_of(group), before + static_cast<long double>(energy) + 1e-11L)
          << "seed " << seed << ", visit " << visit;
    }
    EXPECT_LE((momentum_of(group) - push_of_ground(group) - p).norm(), 1e-12);
    EXPECT_LE((spin_of(group) - turn_of_ground(group) - L).norm(), 1e-11);
  }
  EXPECT_GT(shrunk, 1000) << "or the cone never shrinks";
}

/// The same without friction: projected Gauss-Seidel on the dense matrix, to the end.
std::vector<long double> dense_solution(const Group& group) {
  const std::size_t n = group.contacts.size();
  std::vector<std::vector<long double>> K(n, std::vector<long double>(n, 0));
  std::vector<long double> u(n);
  std::vector<long double> lambda(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const auto& own = group.contacts[i].points[0];
    const auto& [a, b] = group.sides[i];
    u[i] = static_cast<long double>(
        own.normal_W.dot(velocity_across(own, group.bodies[a], group.bodies[b])) + own.room);
    for (std::size_t k = 0; k < n; ++k) {
      const auto& other = group.contacts[k].points[0];
      const auto& [c, d] = group.sides[k];
      const auto share = [&](std::size_t body, const Vec3<double>& arm, double sign) {
        double sum = 0;
        for (const bool first : {true, false}) {
          if ((first ? c : d) != body) continue;
          const auto& B = group.bodies[body];
          const Vec3<double> from =
              first ? other.arm_A_W : arm_B(other, group.bodies[c], group.bodies[d]);
          const Vec3<double> spin = B.inverse_inertia_W * from.cross(other.normal_W);
          sum += (first ? 1 : -1) *
                 (B.inverse_mass * other.normal_W + spin.cross(arm)).dot(own.normal_W);
        }
        return static_cast<long double>(sign * sum);
      };
      K[i][k] =
          share(a, own.arm_A_W, 1) + share(b, arm_B(own, group.bodies[a], group.bodies[b]), -1);
    }
  }
  for (int sweep = 0; sweep < 20000; ++sweep) {
    for (std::size_t i = 0; i < n; ++i) {
      long double rate = u[i];
      for (std::size_t k = 0; k < n; ++k) rate += K[i][k] * lambda[k];
      lambda[i] = std::max(0.0L, lambda[i] - rate / K[i][i]);
    }
  }
  return lambda;
}

/// What contacts are given at the start is an impulse and a torque for both bodies.
TEST(LastingContact, WhatIsGivenAtTheStart_KeepsAngularMomentum) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    RandomGroup draws(seed);
    Group group = draws.make(5, 5, 0.5, 0.02);
    const Vec3<double> before = spin_of(group);
    draws.press(group);
    const Vec3<double> given = spin_of(group) - before;
    EXPECT_LE((given - turn_of_ground(group)).norm(), 1e-13) << seed;
  }
}

TEST(LastingContact, ManyVisits_BecomeTheDenseSolution) {
  int pressed = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    RandomGroup draws(seed);
    Group group = draws.make(5, 5, 0, 0);
    const auto want = dense_solution(group);
    double energy = 0;
    for (int visit = 0; visit < 20000; ++visit) {
      for (std::size_t i = 0; i < group.contacts.size(); ++i) {
        const auto& [a, b] = group.sides[i];
        relax(group.contacts[i], group.bodies[a], group.bodies[b], energy);
      }
    }
    for (std::size_t i = 0; i < want.size(); ++i) {
      pressed += want[i] > 0 ? 1 : 0;
      EXPECT_NEAR(group.contacts[i].points[0].normal, static_cast<double>(want[i]), 1e-9) << seed;
    }
  }
  EXPECT_GT(pressed, 40);
}

/// A rod of half length 1 along x, of two points that see each other mirrored, on ground.
struct Rod {
  std::array<SolvedBody<double>, 2> bodies;
  Contact contact;
};
Rod lying_rod(RandomGroup& draws) {
  Rod rod;
  rod.bodies[0].inverse_mass = draws.draw(0.5, 2);
  rod.bodies[0].inverse_inertia_W =
      Vec3<double>(draws.draw(50, 200), draws.draw(0.5, 4), draws.draw(0.5, 4)).asDiagonal();
  rod.bodies[0].place_W = {0.3, -0.2, 0.7};
  rod.contact.count = 2;
  rod.contact.rest_gap = 1e-4;
  for (int i = 0; i < 2; ++i) {
    auto& point = rod.contact.points[static_cast<std::size_t>(i)];
    point.normal_W = Vec3<double>::UnitZ();
    point.arm_A_W = {2.0 * i - 1, 0, -0.02};
  }
  prepare(rod.contact, rod.bodies[0], rod.bodies[1], 1e-3);
  return rod;
}

TEST(LastingContact, RodThatLandsFlat_GetsNoSpinAtAll) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    RandomGroup draws(seed);
    Rod rod = lying_rod(draws);
    rod.bodies[0].v_W = {draws.draw(-1, 1), draws.draw(-1, 1), -draws.draw(0.1, 1)};
    double energy = 0;
    EXPECT_GT(relax(rod.contact, rod.bodies[0], rod.bodies[1], energy), 0);
    EXPECT_EQ(rod.bodies[0].w_W, (Vec3<double>::Zero()));
    EXPECT_EQ(rod.contact.points[0].normal, rod.contact.points[1].normal);
    EXPECT_NEAR(rod.bodies[0].v_W.z(), 0, 1e-15);
    auto& opened = rod.bodies;  // with the velocities that open the gap
    for (auto& body : opened) body.v_W.setZero();
    EXPECT_GT(relax_opening(rod.contact, opened[0], opened[1], 1e-3, 0.5), 0);
    EXPECT_GT(opened[0].v_W.z(), 0);
    EXPECT_EQ(opened[0].w_W, (Vec3<double>::Zero()));
  }
}

/// A line of two random points, with impulses of before.
Rod random_line(RandomGroup& draws) {
  Group group = draws.make(3, 1, 0, 0);
  const auto [a, b] = group.sides[0];
  Rod line = {{group.bodies[a], group.bodies[b]}, group.contacts[0]};
  line.contact.count = 2;
  auto& [first, second] = line.contact.points;
  second = first;
  second.arm_A_W += draws.vector(0.2);
  second.normal_W = (first.normal_W + draws.vector(0.2)).normalized();
  second.gap = draws.draw(0, 2e-4);
  prepare(line.contact, line.bodies[0], line.bodies[1], 1e-3);
  for (auto& point : line.contact.points) point.normal = max_of(0.0, draws.draw(-0.1, 0.1));
  push_share(line.contact, line.bodies[0], line.bodies[1], 1.0);
  return line;
}

/// What one visit leaves is the least of the energy over both impulses: neither point approaches by
/// more than its room, and one that parts faster does not press.
TEST(LastingContact, BothPointsOfALine_AreSolvedTogether) {
  std::array<int, 3> pressed{};
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    RandomGroup draws(seed);
    Rod line = random_line(draws);
    double energy = -100;  // taken before: no visit is left out
    relax(line.contact, line.bodies[0], line.bodies[1], energy);
    int on = 0;
    for (const auto& point : line.contact.points) {
      const double left =
          point.room + point.normal_W.dot(velocity_across(point, line.bodies[0], line.bodies[1]));
      on += point.normal > 0 ? 1 : 0;
      EXPECT_GE(point.normal, 0);
      EXPECT_GE(left, -1e-11) << seed;
      EXPECT_LE(point.normal * std::abs(left), 1e-12) << seed;
    }
    ++pressed[static_cast<std::size_t>(on)];
  }
  for (const int count : pressed) EXPECT_GT(count, 100);
}

/// A rod that turns easily, so that a push at one end presses the other one down: each end by
/// itself would have to hold on. It parts from the ground at both ends by less than 1 m/s, once
/// neither pushes it.
TEST(LastingContact, LineThatPartsSlowly_IsLetGoAtBothEnds) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    RandomGroup draws(seed);
    Rod rod = lying_rod(draws);
    auto& body = rod.bodies[0];
    body.inverse_inertia_W = (4 * body.inverse_mass * Vec3<double>(1, 1, 1)).eval().asDiagonal();
    prepare(rod.contact, body, rod.bodies[1], 1e-3);
    const double rise = draws.draw(0.3, 0.8);
    const double turn = draws.draw(-0.2, 0.2);
    body.v_W = {0, 0, rise};
    body.w_W = {0, turn, 0};
    for (auto& point : rod.contact.points) point.normal = draws.draw(0.1, 1);
    push_share(rod.contact, body, rod.bodies[1], 1.0);
    double energy = -100;  // taken before: no visit is left out
    relax(rod.contact, body, rod.bodies[1], energy);
    EXPECT_EQ(rod.contact.points[0].normal, 0) << seed;
    EXPECT_EQ(rod.contact.points[1].normal, 0) << seed;
    EXPECT_NEAR(body.v_W.z(), rise, 1e-14);
    EXPECT_NEAR(body.w_W.y(), turn, 1e-14);
  }
}

/// The account of a visit is what it does to the energy.
TEST(LastingContact, EnergyOfALine_IsAccounted) {
  for (const double friction : {0.0, 0.7}) {
    for (unsigned seed = 1; seed <= 300; ++seed) {
      RandomGroup draws(seed);
      Rod line = random_line(draws);
      line.contact.friction = friction;
      const auto total = [&line] {
        Group group;
        group.bodies = {line.bodies[0], line.bodies[1]};
        return energy_of(group);
      };
      const long double before = total();
      double energy = 0;
      for (int visit = 0; visit < 20; ++visit) {
        relax(line.contact, line.bodies[0], line.bodies[1], energy);
        ASSERT_LE(energy, 0);
        ASSERT_LE(total(), before + static_cast<long double>(energy) + 1e-12L) << seed;
      }
      // Friction states the most that it adds.
      const auto added = static_cast<double>(total() - before);
      EXPECT_NEAR(friction > 0 ? min_of(added, energy) : energy, added, 1e-12) << seed;
    }
  }
}

/// Capsules along x that cross at a small angle: held at both points of their line, they are held
/// where they are nearest to each other.
TEST(LastingContact, LineOfAxesThatCrossALittle_GoesThroughTheNearestPoint) {
  for (const double angle : {0.0, 0.01, 0.02}) {
    for (const double tilt : {0.0, 1e-4}) {
      const double gap = 3e-5;
      const Capsule<double> A = {
          {{-0.15, 0, 0.04 + gap - 0.15 * tilt}, {0.15, 0, 0.04 + gap + 0.15 * tilt}}, 0.02};
      const Vec3<double> half = 0.2 * Vec3<double>(std::cos(angle), std::sin(angle), 0);
      const Capsule<double> B = {{-half, half}, 0.02};
      Contact contact;
      contact.rest_gap = 3e-4;
      find_points(contact, A, B, closest_points(A.axis, B.axis), {0, 0, 0}, 0.0);
      ASSERT_EQ(contact.count, 2);
      const auto& first = contact.points[0];
      const auto& second = contact.points[1];
      const auto nearest = closest_points(A.axis, B.axis);
      const double least = nearest.distance - 0.04;
      const Vec3<double> x = (nearest.p_A + nearest.p_B) / 2;
      const Vec3<double> way = second.arm_A_W - first.arm_A_W;
      EXPECT_GT(way.norm(), 0.29);
      const double share = way.dot(x - first.arm_A_W) / way.squaredNorm();
      EXPECT_NEAR((first.arm_A_W + share * way - x).norm(), 0, 1e-4) << angle << ' ' << tilt;
      EXPECT_LE(first.gap + share * (second.gap - first.gap), least + 1e-12)
          << angle << ' ' << tilt;
      EXPECT_GE(min_of(first.gap, second.gap), least - 1e-12);
    }
  }
}

// Half of it is spent in the step; at its end everything is what was solved, rolling resistance
// too, of which what was spent is not kept. Halves are exact.
TEST(LastingContact, SpentAndTakenTogether_IsWhatItWas) {
  Contact contact;
  contact.count = 1;
  auto& point = contact.points[0];
  point.normal = 2;
  point.along = 0.25;
  point.across = -1;
  point.rolling_W = {3, -5, 7};
  detail::spend(contact, 0.5);
  EXPECT_EQ(point.normal, 1);
  EXPECT_EQ(point.spent_normal, 1);
  EXPECT_EQ(point.rolling_W, Vec3<double>(1.5, -2.5, 3.5));
  detail::take_together(contact);
  EXPECT_EQ(point.normal, 2);
  EXPECT_EQ(point.spent_normal, 0);
  EXPECT_EQ(point.along, 0.25);
  EXPECT_EQ(point.across, -1);
  EXPECT_EQ(point.rolling_W, Vec3<double>(3, -5, 7));
}

// Pressed hard enough, a body that spins on what is led is stopped by one visit; the impulsive
// torque is the angular momentum that it had, the other way.
TEST(LastingContact, RollingResistance_StopsASpin) {
  Contact contact;
  contact.count = 1;
  contact.rolling = 10;
  auto& point = contact.points[0];
  point.normal_W = Vec3<double>::UnitZ();
  point.softness = 1;
  point.normal = 1;
  SolvedBody<double> A, B;
  A.inverse_mass = 1;
  A.inverse_inertia_W = Vec3<double>(2, 4, 8).asDiagonal();
  A.w_W = {0.5, -1, 2};
  double energy = 0;
  relax(contact, A, B, energy);
  EXPECT_LE(A.w_W.norm(), 1e-12);
  EXPECT_LE((point.rolling_W - Vec3<double>(-0.25, 0.25, -0.25)).norm(), 1e-12);
  EXPECT_NEAR(energy, -(0.125 + 0.25 + 0.5) / 2, 1e-12);
}

}  // namespace
}  // namespace batuta
