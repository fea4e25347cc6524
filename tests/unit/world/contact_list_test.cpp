// SPDX-License-Identifier: MIT
// The list of contacts and the chains of them through bodies, against a plain list of pairs that is
// searched from end to end. Bodies of two parts: pairs and bodies have names of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "batuta/record/world.hpp"
#include "batuta/world/detail/contact_list.hpp"
#include "batuta/world/scene.hpp"

namespace batuta {
namespace {

constexpr int kRoom = 20;
constexpr std::uint16_t kProxies = 16;
constexpr SceneOptions pairs_options() {
  SceneOptions scene;
  scene.max_bodies = kProxies / 2;
  scene.capsules_per_body = 2;
  scene.max_pairs = 64;
  scene.max_contacts = kRoom;
  scene.resting = RestingContact::kSettling;
  return scene;
}
using Chained = Scene<pairs_options>;
using List = detail::ContactList<Chained>;
using Contact = List::Contact;

/// A pair of parts of two bodies, the lower one first.
detail::ProxyPair random_pair(std::mt19937& random) {
  const auto first = static_cast<std::uint16_t>(random() % kProxies);
  auto second = static_cast<std::uint16_t>(random() % kProxies);
  while (second / 2 == first / 2) second = static_cast<std::uint16_t>(random() % kProxies);
  return {std::min(first, second), std::max(first, second)};
}

std::vector<std::size_t> neighbours(const List& list, std::size_t slot) {
  std::vector<std::size_t> found;
  list.for_each_neighbour(slot, [&found](std::size_t other) { found.push_back(other); });
  std::sort(found.begin(), found.end());
  return found;
}

/// The same, from the pairs alone.
std::vector<std::size_t> neighbours(const std::vector<detail::ProxyPair>& pairs, std::size_t slot) {
  std::vector<std::size_t> found;
  for (const auto& pair : pairs) {
    const std::size_t a = pair.first / 2, b = pair.second / 2;
    if (a == slot) found.push_back(b);
    if (b == slot) found.push_back(a);
  }
  std::sort(found.begin(), found.end());
  return found;
}

void expect_same(const List& list, const std::vector<detail::ProxyPair>& pairs) {
  ASSERT_EQ(list.size(), static_cast<int>(pairs.size()));
  for (const auto& pair : pairs) {
    const int i = list.find(pair);
    ASSERT_NE(i, List::kNone);
    EXPECT_TRUE(is_same(list[i].pair, pair));
  }
  for (std::size_t slot = 0; slot < kProxies / 2; ++slot) {
    EXPECT_EQ(neighbours(list, slot), neighbours(pairs, slot));
  }
}

TEST(ContactList, ComesAndGoes_AsAPlainListDoes) {
  std::mt19937 random(1);
  List list;
  std::vector<detail::ProxyPair> pairs;
  int known = 0, removed = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto pair = random_pair(random);
    const auto is_pair = [&pair](const auto& other) { return is_same(other, pair); };
    const bool is_known = std::any_of(pairs.begin(), pairs.end(), is_pair);
    ASSERT_EQ(list.find(pair) != List::kNone, is_known);
    const bool is_in = list.find_or_add(pair) != List::kNone;
    ASSERT_EQ(is_in, is_known || pairs.size() < kRoom);
    if (is_in && !is_known) pairs.push_back(pair);
    known += is_known ? 1 : 0;
    if (!is_in) {
      const std::size_t slot = random() % (kProxies / 2);
      const auto is_out = [slot](const detail::ProxyPair& p) {
        return p.first / 2u == slot || p.second / 2u == slot;
      };
      list.remove_if([&](const Contact& contact) { return is_out(contact.pair); });
      pairs.erase(std::remove_if(pairs.begin(), pairs.end(), is_out), pairs.end());
      ++removed;
    }
    expect_same(list, pairs);
  }
  EXPECT_GT(known, 100);
  EXPECT_GT(removed, 100);
}

/// Contacts kept from a reading of one, beside bodies of which the first three of eight are there.
int kept_of(detail::ProxyPair pair, std::uint8_t points, Status wanted) {
  detail::Bodies<Chained> bodies{1};
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(bodies.actors.make(Actor<Chained>{}).ok());
  FixedList<Contact, kRoom> written;
  Contact contact;
  contact.pair = pair;
  contact.count = points;
  EXPECT_TRUE(written.push(contact));
  std::array<std::uint8_t, sizeof(List)> bytes{};
  ArchiveWriter writer(bytes.data(), static_cast<int>(bytes.size()));
  writer(written);
  List list;
  ArchiveReader reader(bytes.data(), static_cast<int>(bytes.size()));
  list.archive(reader, bodies);
  EXPECT_EQ(reader.status(), wanted) << pair.first << ' ' << pair.second << ' ' << int{points};
  return list.size();
}

TEST(ContactList, ReadFromBytes_HoldsTwoBodiesThatAreThere) {
  for (const detail::ProxyPair good : {detail::ProxyPair{0, 2}, {1, 5}, {2, 4}}) {
    EXPECT_EQ(kept_of(good, Contact::kPoints, Status::kOk), 1);
    EXPECT_EQ(kept_of(good, Contact::kPoints + 1, Status::kInvalidArgument), 0);
  }
  // Of one body; in the other order; of bodies that are not there, in the scene or beyond it.
  for (const detail::ProxyPair bad :
       {detail::ProxyPair{0, 1}, {2, 2}, {3, 2}, {4, 0}, {0, 6}, {5, 15}, {0, 16}, {0, 65535}}) {
    EXPECT_EQ(kept_of(bad, 1, Status::kInvalidArgument), 0);
  }
}

/// Whether widest_rest_gap() and is_held_up() are those of a search from end to end.
void expect_own(const List& list, std::size_t slot) {
  float widest = 0;
  bool is_held = false;
  for (int i = 0; i < list.size(); ++i) {
    const auto& pair = list[i].pair;
    if (pair.first / 2u != slot && pair.second / 2u != slot) continue;
    widest = std::max(widest, list[i].rest_gap);
    is_held = is_held || (list[i].is_solved && list[i].is_held);
  }
  EXPECT_EQ(list.widest_rest_gap(slot), widest);
  EXPECT_EQ(list.is_held_up(slot), is_held);
}

TEST(ContactList, LoadedContact_IsOneOfWhichAPointPresses) {
  detail::LastingContact<detail::ContactTraits<float, false, false, true>> contact;
  for (const float first : {0.0F, 1e-30F}) {
    for (const float second : {0.0F, 1e-30F}) {
      contact.points = {};
      contact.points[0].normal = first;
      contact.points[1].normal = second;
      contact.count = 1;
      EXPECT_EQ(is_loaded(contact), first > 0) << "the second one is none of its points";
      contact.count = 2;
      EXPECT_EQ(is_loaded(contact), first > 0 || second > 0);
    }
  }
}

TEST(ContactList, WidestGapAndWhoHolds_AreThoseOfTheBodyAlone) {
  std::mt19937 random(2);
  for (int run = 0; run < 50; ++run) {
    List list;
    while (list.size() < kRoom / 2) {
      const int i = list.find_or_add(random_pair(random));
      list[i].rest_gap = static_cast<float>(1 + random() % 100);
      list[i].is_solved = random() % 2 == 0;
      list[i].is_held = random() % 2 == 0;
    }
    list.remove_if([](const Contact& contact) { return contact.pair.first / 2 == 0; });
    for (std::size_t slot = 0; slot < kProxies / 2; ++slot) expect_own(list, slot);
    EXPECT_EQ(list.widest_rest_gap(0), 0);
  }
}

}  // namespace
}  // namespace batuta
