// SPDX-License-Identifier: MIT
// Several bodies and several contacts in one step, held against a plain event loop.

#include <gtest/gtest.h>

#include <memory>

#include "batuta/world/world.hpp"
#include "draws.hpp"
#include "event_loop.hpp"

namespace batuta {
namespace {

constexpr int kBodies = 6;
constexpr double kDt = 0.1;
constexpr int kGrid = 4000;  ///< of a step: no graze that changes anything is shorter

/// Impulses only, with contact a thousand times nearer than by default: what is left between the
/// two is rounding and the contact tolerance.
template <int kParts>
constexpr SceneOptions impulses_options() {
  SceneOptions scene;
  scene.max_bodies = kBodies;
  scene.capsules_per_body = kParts;
  scene.max_pairs = kBodies * kBodies * kParts * kParts;
  scene.max_contacts = 64;
  scene.max_events = 128;
  scene.owners = false;
  scene.resting = RestingContact::kNone;
  scene.contact_tolerance = 1e-10F;
  return scene;
}
template <int kParts>
using Impulses = Scene<impulses_options<kParts>, Advancement<double>>;

/// A body about its centre of mass: a capsule, or three that stand out from the centre. These have
/// unequal moments, large enough that what they turn in a step is well below a radian: their course
/// is a secant of the true one (src/mechanics/motion.md), and so near it that no contact ends it
/// (src/world/world.md, "Bent turns"): the plain loop knows one course from contact to contact.
template <int kParts>
test::Rigid draw(test::Draws& draws, int i) {
  test::Rigid rigid;
  rigid.restitution = 1;
  const Vec3<double> out[] = {{0, 0, 0.15}, {0.12, 0, -0.09}, {-0.12, 0.04, -0.09}};
  for (int part = 0; part < kParts; ++part) {
    const Vec3<double> from = kParts == 1 ? Vec3<double>(-out[0]) : Vec3<double>::Zero();
    rigid.parts_B.push_back({{from, out[part]}, 0.04});
  }
  const Vec3<double> moments =
      kParts == 1 ? Vec3<double>(0.008, 0.008, 0.0004) : Vec3<double>(0.24, 0.28, 0.32);
  const Vec3<double> place(0.4 * (i % 2), 0.4 * (i / 2 % 2), 0.4 * (i / 4));
  const Quat<double> q_WB = draws.rotation();
  rigid.body = make_body<double>({place, q_WB}, 1, moments).value;
  const Vec3<double> inwards = Vec3<double>(0.2, 0.2, 0.2) - place;
  const Vec3<double> v = draws.in_ball(3) + 12 * inwards;
  const Vec3<double> w = draws.in_ball(kParts == 1 ? 8 : 4);
  rigid.body.momentum = momentum_of(rigid.body, {v, w});
  return rigid;
}

template <int kParts>
Actor<Impulses<kParts>> actor_of(const test::Rigid& rigid) {
  Actor<Impulses<kParts>> actor;
  actor.body = rigid.body;
  actor.restitution = rigid.restitution;
  if constexpr (kParts == 1) {
    actor.capsule_B = rigid.parts_B[0];
  } else {
    for (const auto& part_B : rigid.parts_B) EXPECT_TRUE(actor.capsules_B.push(part_B));
  }
  return actor;
}

template <class WorldT>
std::vector<test::Happening> contacts_of(const WorldT& world) {
  std::vector<test::Happening> contacts;
  for (const auto& event : world.events()) {
    if (event.kind == EventKind::kEnd) continue;
    contacts.push_back({event.time, event.body_A, event.body_B});
  }
  return contacts;
}

/// A contact is answered where the gap is within the contact tolerance, and the pair is then opened
/// by about as much. What that is worth in time and place grows with each contact that follows from
/// it; it is at most tenfold in these scenes, and there are up to five in a row.
constexpr double kNear = 1e-9 * 1e4;

template <int kParts>
int compare(std::uint64_t index) {
  test::Draws draws(2006, kParts, index);
  std::vector<test::Rigid> rigids;
  auto world = std::make_unique<World<Impulses<kParts>>>();
  for (int i = 0; i < kBodies; ++i) {
    rigids.push_back(draw<kParts>(draws, i));
    auto actor = actor_of<kParts>(rigids.back());
    EXPECT_TRUE(world->add(actor).ok());
    // As the world sees it: it works out for itself which spins show.
    rigids.back().body.spin_shows =
        world->get(world->id_at(static_cast<std::uint16_t>(i)))->body.spin_shows;
  }
  test::EventLoop loop(rigids);
  const auto expected = loop.step(kDt, kGrid, 64);
  EXPECT_EQ(world->step(kDt), Status::kOk);
  EXPECT_TRUE(world->report().complete());
  const auto contacts = contacts_of(*world);
  EXPECT_EQ(contacts.size(), expected.size()) << index;
  for (std::size_t i = 0; i < std::min(contacts.size(), expected.size()); ++i) {
    EXPECT_EQ(contacts[i].first, expected[i].first) << index << " contact " << i;
    EXPECT_EQ(contacts[i].second, expected[i].second) << index << " contact " << i;
    EXPECT_NEAR(contacts[i].time, expected[i].time, kNear) << index << " contact " << i;
  }
  for (std::uint16_t i = 0; i < kBodies; ++i) {
    const auto& body = world->get(world->id_at(i))->body;
    const auto& truth = loop.bodies()[i].body;
    EXPECT_LT((body.X_WB.p_W - truth.X_WB.p_W).norm(), kNear) << index;
    EXPECT_LT((body.momentum.linear_W - truth.momentum.linear_W).norm(), 100 * kNear) << index;
    EXPECT_LT((body.momentum.angular_W - truth.momentum.angular_W).norm(), 100 * kNear) << index;
  }
  return static_cast<int>(expected.size());
}

TEST(ManyEvents, StepWithSeveralContacts_IsThatOfAPlainEventLoop) {
  int contacts = 0;
  for (std::uint64_t index = 0; index < 40; ++index) contacts += compare<1>(index);
  EXPECT_GT(contacts, 80);  // or the scenes show nothing
}

TEST(ManyEvents, StepOfBodiesWithThreeCapsules_IsThatOfAPlainEventLoop) {
  int contacts = 0;
  for (std::uint64_t index = 0; index < 20; ++index) contacts += compare<3>(index);
  EXPECT_GT(contacts, 60);
}

}  // namespace
}  // namespace batuta
