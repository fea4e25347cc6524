// SPDX-License-Identifier: MIT
// R07: without gravity, energy never grows, in a million contacts. By default fewer;
// BATUTA_CONTACTS=1000000 in the environment takes all.
#include <gtest/gtest.h>

#include <cstdlib>

#include "draws.hpp"
#include "resting.hpp"

namespace batuta {
namespace {

template <bool kRubs>
constexpr SceneOptions gas_options() {
  SceneOptions scene = test::rest_scene_options();
  scene.max_bodies = 10;
  scene.max_pairs = 45;
  scene.max_separations = 32;  // what spins in a corner may come back often
  scene.gravity = false;
  scene.friction = kRubs;
  return scene;
}
template <class S, bool kRubs>
using Gas = Scene<gas_options<kRubs>, Advancement<S>, test::FreeOrHand<S>>;

constexpr int kRods = 4;
constexpr double kSpeed = 3;

long contacts_to_take() {
#ifdef BATUTA_CONTACTS
  constexpr long kContacts = BATUTA_CONTACTS;
#else
  constexpr long kContacts = 5000;
#endif
  const char* contacts = std::getenv("BATUTA_CONTACTS");
  return contacts != nullptr ? std::atol(contacts) : kContacts;
}

/// A closed box of 1 m: six balls so large that they overlap at its edges.
template <class SceneT>
void add_walls(World<SceneT>& world, double restitution, double friction) {
  using S = typename SceneT::Scalar;
  constexpr double kRadius = 4;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vec3<double> place = Vec3<double>::Zero();
      place(axis) = side * (kRadius + 0.5);
      Actor<SceneT> wall = test::ball_at<SceneT>(place, kRadius);
      wall.body.inverse_mass = 0;
      wall.body.inverse_moments.setZero();
      wall.restitution = static_cast<S>(restitution);
      if constexpr (SceneT::kFriction) wall.friction = static_cast<S>(friction);
      (void)world.add(wall);
    }
  }
}

/// Short rods that fly and turn.
template <class SceneT>
void add_rods(World<SceneT>& world, double restitution, double friction) {
  using S = typename SceneT::Scalar;
  for (int k = 0; k < kRods; ++k) {
    auto rod = test::rod_at<SceneT>({0.2 * k - 0.3, 0, 0}, Vec3<double>::UnitZ());
    rod.capsule_B = {{test::vector<S>(0, 0, -0.1), test::vector<S>(0, 0, 0.1)}, S(0.04)};
    const auto mass = solid_capsule(rod.capsule_B, S(1)).value;
    const Vec3<S> moments = mass.inertia_S.diagonal() / mass.mass;
    rod.body = make_body<S>(rod.body.X_WB, S(1), moments).value;
    rod.restitution = static_cast<S>(restitution);
    if constexpr (SceneT::kFriction) rod.friction = static_cast<S>(friction);
    (void)world.add(rod);
  }
}

template <class SceneT>
double energy_of(const World<SceneT>& world) {
  double sum = 0;
  for (int k = 0; k < kRods; ++k) {
    const auto& body = test::body_in(world, k).body;
    // In double: what rounding of the sum itself does must not be taken for a gain.
    const auto v = (body.inverse_mass * body.momentum.linear_W).template cast<double>().eval();
    const auto w = twist_of(body).w_W.template cast<double>().eval();
    sum += 0.5 * (v.dot(body.momentum.linear_W.template cast<double>()) +
                  w.dot(body.momentum.angular_W.template cast<double>()));
  }
  return sum;
}

/// Momenta anew, the `number`-th ones.
template <class SceneT>
void stir(World<SceneT>& world, std::uint64_t number) {
  using S = typename SceneT::Scalar;
  test::Draws draws(7, 0, number);
  for (int k = 0; k < kRods; ++k) {
    auto& body = world.get(world.id_at(static_cast<std::uint16_t>(k)))->body;
    body.momentum.linear_W = (kSpeed * draws.direction()).template cast<S>();
    body.momentum.angular_W = (0.05 * draws.direction()).template cast<S>();
  }
}

/// A blow rounds momenta and velocities some tens of times.
template <class S>
const double kGainOfARounding = 64 * static_cast<double>(kRoundOff<S>);

template <class SceneT>
void never_grows(double restitution, double friction) {
  using S = typename SceneT::Scalar;
  World<SceneT> world;
  add_rods(world, restitution, friction);
  add_walls(world, restitution, friction);
  const long wanted = contacts_to_take();
  std::uint64_t stirred = 0;
  double before = 0;
  double most_gain = 0;  // in a step, share
  double all_gains = 0;
  long contacts = 0;
  std::uint64_t overlaps = 0;
  long frozen = 0;
  for (long steps = 0; contacts < wanted; ++steps) {
    ASSERT_LT(steps, 100 * wanted);
    if (steps % 500 == 0) {  // some have lost nearly everything by then
      stir(world, stirred++);
      before = energy_of(world);
    }
    ASSERT_EQ(world.step(S(5e-3)), Status::kOk);
    if (!world.report().complete()) {  // between two walls: no room to be moved apart, or no end
      ++frozen;
      ASSERT_GT(world.report().frozen + world.report().contacts_dropped, 0U) << steps;
    }
    contacts += world.report().collisions;
    const double energy = energy_of(world);
    const double gain = before > 0 ? energy / before - 1 : energy;  // all may have stopped
    ASSERT_LE(gain, kGainOfARounding<S> * (1 + world.report().collisions)) << steps;
    // Beside walls of 4 m, lengths add up to less than 10 m.
    ASSERT_LE(static_cast<double>(world.report().deepest_overlap), test::margin<S>(10)) << steps;
    overlaps += world.report().overlaps_at_start;
    most_gain = std::max(most_gain, gain);
    all_gains += gain > 0 ? gain : 0;
    before = energy;
  }
  EXPECT_LE(frozen, contacts / 1000) << "hardly ever";
  // Within the margin, as above; told where the two came to be so deep by their last parting.
  EXPECT_LE(overlaps, static_cast<std::uint64_t>(frozen + contacts / 1000)) << "hardly ever";
  std::printf("  %ld contacts: gains of %.1e in all, %.1e at most in a step\n", contacts, all_gains,
              most_gain);
}

template <class S>
class EnergyWithoutGravity : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(EnergyWithoutGravity, Scalars);

TYPED_TEST(EnergyWithoutGravity, Elastic_NeverGrows) {
  never_grows<Gas<TypeParam, false>>(1, 0);
}
TYPED_TEST(EnergyWithoutGravity, Lossy_NeverGrows) {
  never_grows<Gas<TypeParam, false>>(0.8, 0);
}
TYPED_TEST(EnergyWithoutGravity, Rough_NeverGrows) {
  for (const double restitution : {0.0, 0.5, 0.999}) {
    never_grows<Gas<TypeParam, true>>(restitution, 0.3);
  }
}

}  // namespace
}  // namespace batuta
