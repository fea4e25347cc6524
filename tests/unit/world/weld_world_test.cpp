// SPDX-License-Identifier: MIT
// Worlds in which answers are not to be had: without a budget, without room for contacts or pairs.
// Whoever is concerned goes on together: momenta are kept, no energy comes, a common velocity
// changes nothing, and complete() tells.

#include "batuta/world/world.hpp"
#include "weld_rig.hpp"

namespace batuta {
namespace {

using namespace test;

enum class Lacks { kBudget, kContacts, kPairs };
template <RestingContact kRests, Lacks kLacks, int kBodies>
constexpr SceneOptions poor_options() {
  SceneOptions scene;
  scene.max_bodies = kBodies;
  scene.max_pairs = kLacks == Lacks::kPairs ? 2 : kBodies * (kBodies - 1) / 2;
  scene.max_contacts = kLacks == Lacks::kContacts ? 1 : 64;
  if (kLacks == Lacks::kBudget) scene.budget = 1;
  scene.resting = kRests;
  return scene;
}
template <class S, RestingContact kRests, Lacks kLacks, int kBodies>
using PoorScene = Scene<poor_options<kRests, kLacks, kBodies>, Advancement<S>>;

/// Crossed rods that close on each other, and spin; all at `speed` besides.
template <class SceneT>
void add_rods(World<SceneT>& world, double speed) {
  using S = typename SceneT::Scalar;
  for (int i = 0; i < SceneT::kMaxBodies; ++i) {
    Actor<SceneT> rod;
    const Quat<S> q = exp_map(Vec3<S>(0, 0, S(1.3 * i)));
    const Vec3<S> moments(S(0.001), S(0.01), S(0.012));
    rod.body = make_body<S>({Vec3<S>(S(0.001 * i), 0, S(0.05 * i)), q}, S(1 + i), moments).value;
    rod.capsule_B = {{Vec3<S>(S(-0.15), 0, 0), Vec3<S>(S(0.15), 0, 0)}, S(0.02)};
    rod.restitution = S(0.5);
    const Vec3<S> v(S(speed), S(0.01 * i), S(0.4 - 0.3 * i)), w(S(1), S(-0.5 * i), S(4));
    rod.body.momentum = momentum_of(rod.body, Twist<S>{v, w});
    ASSERT_TRUE(world.add(rod).ok());
  }
}

template <class SceneT>
std::vector<Body<typename SceneT::Scalar>> bodies_of(const World<SceneT>& world) {
  std::vector<Body<typename SceneT::Scalar>> list;
  for (std::uint16_t i = 0; i < SceneT::kMaxBodies; ++i) {
    list.push_back(world.get(world.id_at(i))->body);
  }
  return list;
}

/// @returns how many answers were not to be had
template <class SceneT>
unsigned lacking(const World<SceneT>& world) {
  const auto& report = world.report();
  return report.searches_cut + report.contacts_dropped + report.pairs_dropped + report.frozen +
         report.plans_invalid;
}

/// Whether a gap may have been opened: a shift along its line changes the sum of x x p.
template <class SceneT>
bool opens(const World<SceneT>& world) {
  return SceneT::kResting == RestingContact::kSettling || world.report().collisions > 0 ||
         world.report().separations > 0;
}

constexpr int kSteps = 60;
/// What the flight of a body with three unlike moments may change of its energy, relative to it.
constexpr Exact kFlight = 1e-9L;
/// A search of 0.1 s takes more than one evaluation.
template <class SceneT>
constexpr double kStep = SceneT::kBudget == 1 ? 0.1 : 0.01;

/// A run, and what has to hold after each step. @returns where the bodies are, as seen from their
/// common centre, after the first step in which something was lacking
template <class SceneT>
std::vector<ExactVec> run(double speed) {
  using S = typename SceneT::Scalar;
  const Exact u = kRoundOff<S>;
  World<SceneT> world;
  add_rods(world, speed);
  const Whole first = whole_of(bodies_of(world));
  Exact energy = first.energy;
  ExactVec spin = first.spin;
  std::vector<ExactVec> places;
  for (int i = 1; i <= kSteps && !::testing::Test::HasFailure(); ++i) {
    EXPECT_EQ(world.step(S(kStep<SceneT>)), Status::kOk);
    const bool lacks = lacking(world) > 0;
    EXPECT_EQ(world.report().complete(), !lacks) << i;
    EXPECT_TRUE(!lacks || world.report().time_held > S(0)) << i;
    const Whole now = whole_of(bodies_of(world));
    const Exact pushes = 1 + (now.mass * std::abs(Exact(speed))) + now.size;
    EXPECT_LE((now.momentum - first.momentum).norm(), 64 * u * i * pushes) << i;
    EXPECT_LE((now.spin - spin).norm(), (opens(world) ? 1e-5L : 64 * u) * pushes) << i;
    spin = now.spin;
    const ExactVec way = Exact(S(kStep<SceneT>)) * i * first.momentum / first.mass;
    EXPECT_LE((now.center - first.center - way).norm(), 16 * u * i * (1 + way.norm())) << i;
    const Exact flight = lacks ? 0 : kFlight;
    EXPECT_LE(now.energy, energy * (1 + flight + 64 * u)) << i;
    energy = now.energy;
    for (const auto& body : bodies_of(world)) {
      if (lacks && places.size() < SceneT::kMaxBodies) {
        places.push_back(exact(body.X_WB.p_W) - now.center);
      }
    }
  }
  EXPECT_FALSE(places.empty()) << "or nothing is seen";
  return places;
}

template <class SceneT>
void expect_laws() {
  const auto at_rest = run<SceneT>(0);
  const auto in_flight = run<SceneT>(25);
  ASSERT_EQ(at_rest.size(), in_flight.size());
  const bool is_float = std::is_same_v<typename SceneT::Scalar, float>;
  for (std::size_t i = 0; i < at_rest.size(); ++i) {
    EXPECT_LE((at_rest[i] - in_flight[i]).norm(), is_float ? 1e-4L : 1e-9L) << i;
  }
}

template <class S>
class WeldWorld : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WeldWorld, Scalars);

template <class S, Lacks kLacks, int kBodies>
void expect_laws_of_all_rules() {
  expect_laws<PoorScene<S, RestingContact::kNone, kLacks, kBodies>>();
  expect_laws<PoorScene<S, RestingContact::kSeparation, kLacks, kBodies>>();
  expect_laws<PoorScene<S, RestingContact::kSettling, kLacks, kBodies>>();
}

TYPED_TEST(WeldWorld, WithoutBudget_KeepsTheLaws) {
  expect_laws_of_all_rules<TypeParam, Lacks::kBudget, 2>();
  expect_laws_of_all_rules<TypeParam, Lacks::kBudget, 5>();
}

TYPED_TEST(WeldWorld, WithoutRoomForContacts_KeepsTheLaws) {
  expect_laws_of_all_rules<TypeParam, Lacks::kContacts, 5>();
}

TYPED_TEST(WeldWorld, WithoutRoomForPairs_KeepsTheLaws) {
  expect_laws_of_all_rules<TypeParam, Lacks::kPairs, 5>();
}

}  // namespace
}  // namespace batuta
