// SPDX-License-Identifier: MIT
// A duel saved in the middle of a bout and restored into another one goes on with the same bits.
#include <vector>

#include "batuta/fencing/duel_definitions.hpp"
#include "batuta/record/duel.hpp"
#include "batuta/record/snapshot.hpp"
#include "configured_duel.hpp"

namespace batuta {
using namespace fencing;
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A stick that attacks, parries and draws back, and now and then says nothing.
const InputSample* stick_at(std::uint32_t step, std::uint32_t phase, InputSample& sample) {
  const std::uint32_t k = step + phase;
  if (k % 7 == 3) return nullptr;
  constexpr std::array<float, 5> kX = {0, -1, 0.5F, 1, -0.25F};
  constexpr std::array<float, 4> kY = {0, -0.2F, -0.5F, 0.1F};
  sample.time = 1000 * step;
  sample.sequence = step;
  sample.x = kX[k / 90 % kX.size()];
  sample.y = step < 900 ? kY[k / 150 % kY.size()] : 1.0F;  // an attack at the end
  sample.buttons = k / 50;
  return &sample;
}

template <class DuelT>
Status advance(DuelT& duel) {
  InputSample left;
  InputSample right;
  return duel.step(stick_at(duel.steps(), 0, left), stick_at(duel.steps(), 333, right));
}

template <class DuelT>
Bytes saved(const DuelT& duel) {
  Bytes bytes(kSnapshotRoom<DuelT>);
  const Result<int> size = save(duel, bytes.data(), static_cast<int>(bytes.size()));
  EXPECT_EQ(size.status, Status::kOk);
  bytes.resize(static_cast<std::size_t>(size.value));
  return bytes;
}

template <class DuelT>
Restored restored(DuelT& duel, const Bytes& bytes) {
  return restore(duel, bytes.data(), static_cast<int>(bytes.size()));
}

/// What a user can see of a duel, without the archive.
template <class DuelT>
std::vector<double> seen(const DuelT& duel) {
  std::vector<double> all = {static_cast<double>(duel.steps()),
                             static_cast<double>(duel.dt()),
                             static_cast<double>(duel.bout().state),
                             static_cast<double>(duel.bout().touches.size()),
                             static_cast<double>(duel.bout().score[0]),
                             static_cast<double>(duel.bout().score[1]),
                             static_cast<double>(duel.bout().exchange),
                             static_cast<double>(duel.bout().halt_steps),
                             static_cast<double>(duel.report().evaluations),
                             static_cast<double>(duel.report().blows),
                             static_cast<double>(duel.world().report().evaluations),
                             static_cast<double>(duel.world().events().size())};
  const auto add = [&all](const auto& v) {
    for (int i = 0; i < v.size(); ++i) all.push_back(static_cast<double>(v.data()[i]));
  };
  for (const Side side : {Side::kLeft, Side::kRight}) {
    add(duel.stick(side).position());
    add(duel.stick(side).velocity());
    add(duel.hand(side).X_WH.p_W);
    add(duel.hand(side).jacobian);
    add(duel.blade_W(side).axis.a);
    add(duel.blade_W(side).axis.b);
    add(duel.grip(side).hand().p_W);
    all.push_back(static_cast<double>(duel.grip(side).control()));
    for (const auto& part : duel.body_W(side)) add(part.axis.b);
  }
  for (const auto& event : duel.world().events()) {
    add(event.contact.point_W);
    all.push_back(static_cast<double>(event.impulse));
  }
  for (const auto& touch : duel.bout().touches) {
    add(touch.contact.point_W);
    all.push_back(static_cast<double>(touch.when.in_step));
  }
  return all;
}

template <class DuelT>
using DuelArchive = test::ConfiguredDuel<DuelT>;
TYPED_TEST_SUITE(DuelArchive, test::Duels);

TYPED_TEST(DuelArchive, SavedAnywhereInABout_GoesOnWithTheSameBits) {
  this->settings.touches = 3;
  this->settings.halt_us = 120000;
  ASSERT_EQ(this->configure(), Status::kOk);
  std::vector<Bytes> snapshots;
  std::vector<std::vector<double>> course;
  int blows = 0;
  while (course.size() < 3000) {
    if (course.size() % 50 == 0) snapshots.push_back(saved(*this->duel));
    if (advance(*this->duel) != Status::kOk) break;
    course.push_back(seen(*this->duel));
    blows += this->duel->world().events().empty() ? 0 : 1;
  }
  ASSERT_GT(course.size(), 300U);
  EXPECT_GT(blows, 0) << "or nothing much is seen";
  for (std::size_t i = 0; i < snapshots.size(); i += 3) {
    auto other = std::make_unique<TypeParam>();
    ASSERT_EQ(restored(*other, snapshots[i]), Restored::kOk);
    const std::size_t last = std::min(course.size(), 50 * i + 400);
    for (std::size_t step = 50 * i; step < last; ++step) {
      ASSERT_EQ(advance(*other), Status::kOk);
      ASSERT_EQ(seen(*other), course[step]) << "saved at " << 50 * i << ", step " << step;
    }
  }
}

TYPED_TEST(DuelArchive, RestoredOverAnotherBout_ForgetsIt) {
  const Bytes start = saved(*this->duel);
  const std::uint64_t hash = hash_of(*this->duel);
  for (int i = 0; i < 500; ++i) (void)advance(*this->duel);
  EXPECT_NE(hash_of(*this->duel), hash);
  ASSERT_EQ(restored(*this->duel, start), Restored::kOk);
  EXPECT_EQ(hash_of(*this->duel), hash);
  EXPECT_EQ(saved(*this->duel), start);
}

/// A device may say anything finite: the stick stays at its rim, and the bout can be kept.
TYPED_TEST(DuelArchive, SampleFarOutside_IsNoStateThatIsRefused) {
  InputSample far;
  far.time = 1000;
  far.x = -2.5e14F;
  far.y = 3e38F;
  ASSERT_EQ(this->duel->step(&far, nullptr), Status::kOk);
  const std::uint64_t hash = hash_of(*this->duel);
  const Bytes kept = saved(*this->duel);
  for (int i = 0; i < 10; ++i) (void)advance(*this->duel);
  ASSERT_EQ(restored(*this->duel, kept), Restored::kOk);
  EXPECT_EQ(hash_of(*this->duel), hash);
}

TYPED_TEST(DuelArchive, NotConfigured_StaysSo) {
  const auto fresh = std::make_unique<TypeParam>();
  ASSERT_EQ(restored(*this->duel, saved(*fresh)), Restored::kOk);
  EXPECT_EQ(advance(*this->duel), Status::kInvalidArgument);
}

TEST(DuelArchive, OtherScalarOrSearch_IsRefusedAndNothingChanges) {
  const auto make = [](auto duel) {
    using DuelT = typename decltype(duel)::element_type;
    using Scalar = typename DuelT::SceneType::Scalar;
    EXPECT_EQ(duel->configure(duel_settings<typename DuelT::StatedScene>(), first_fencer<Scalar>(),
                              second_fencer<Scalar>()),
              Status::kOk);
    return duel;
  };
  const auto duel = make(std::make_unique<Duel<>>());
  const std::uint64_t before = hash_of(*duel);
  EXPECT_EQ(restored(*duel, saved(*make(std::make_unique<test::DuelWith<Advancement<double>>>()))),
            Restored::kOtherScalar);
  EXPECT_EQ(restored(*duel, saved(*make(std::make_unique<test::DuelWith<Stepping<float>>>()))),
            Restored::kOtherScene);
  EXPECT_EQ(hash_of(*duel), before);
  EXPECT_EQ(advance(*duel), Status::kOk);
}

/// Every byte wrong under a good check sum: refused, or a state that can go on.
void forge_every_byte(Duel<>& forged) {
  Duel<>* const duel = &forged;
  const Bytes good = saved(*duel);
  int refused = 0;
  for (std::size_t i = batuta::detail::kSnapshotHead; i + batuta::detail::kCheckSum < good.size();
       ++i) {
    for (const unsigned flip : {0xFFU, 0x01U, 0x40U}) {
      Bytes bytes = good;
      bytes[i] = static_cast<std::uint8_t>(bytes[i] ^ flip);
      batuta::detail::seal(bytes.data(),
                           static_cast<int>(bytes.size()) - batuta::detail::kCheckSum);
      if (restored(*duel, bytes) != Restored::kOk) {
        ++refused;
        EXPECT_EQ(advance(*duel), Status::kInvalidArgument) << "it is not configured";
        continue;
      }
      for (int k = 0; k < 3; ++k) (void)advance(*duel);
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(DuelArchive, EveryByteForged_IsRefusedOrGoesOn) {
  const auto duel = std::make_unique<Duel<>>();
  ASSERT_EQ(duel->configure(duel_settings(), first_fencer<float>(), second_fencer<float>()),
            Status::kOk);
  for (int i = 0; i < 600; ++i) (void)advance(*duel);
  forge_every_byte(*duel);
}

constexpr DuelOptions standing_options() {
  DuelOptions scene = two_fencers();
  scene.feet = false;
  return scene;
}

/// How many snapshots of a duel on guard, with one byte 0 set to `byte`, are taken as a bout that
/// `claims` what it says.
template <class DuelT>
int forgeries_taken(const typename DuelT::Settings& settings, std::uint8_t byte,
                    bool (*claims)(const Bout<float>&)) {
  const auto duel = std::make_unique<DuelT>();
  EXPECT_EQ(duel->configure(settings, first_fencer<float>(), second_fencer<float>()), Status::kOk);
  const Bytes good = saved(*duel);
  int taken = 0;
  for (std::size_t i = batuta::detail::kSnapshotHead; i + batuta::detail::kCheckSum < good.size();
       ++i) {
    if (good[i] != 0) continue;
    Bytes bytes = good;
    bytes[i] = byte;
    batuta::detail::seal(bytes.data(), static_cast<int>(bytes.size()) - batuta::detail::kCheckSum);
    if (restored(*duel, bytes) == Restored::kOk && claims(duel->bout())) ++taken;
  }
  return taken;
}

TEST(DuelArchive, HaltWithoutATouch_IsTakenOnlyWhereOneMayCome) {
  using Standing = Duel<DuelScene<standing_options, Advancement<float>>>;
  const auto claims = [](const Bout<float>& bout) { return bout.is_corps_a_corps(); };
  constexpr auto kHalt = static_cast<std::uint8_t>(BoutState::kHalt);
  DuelSettings<> never = duel_settings();
  never.strip.corps_a_corps_us = 0;
  EXPECT_EQ(forgeries_taken<Duel<>>(duel_settings(), kHalt, claims), 1);
  EXPECT_EQ(forgeries_taken<Duel<>>(never, kHalt, claims), 0);
  EXPECT_EQ(forgeries_taken<Standing>(duel_settings<Standing::StatedScene>(), kHalt, claims), 0);
}

TEST(DuelArchive, AnnulledTouches_AreTwo) {
  const auto claims = [](const Bout<float>& bout) { return bout.annulled; };
  EXPECT_EQ(forgeries_taken<Duel<>>(duel_settings(), 1, claims), 0);
}

/// Where the next step puts both on guard, from what was read.
TEST(DuelArchive, EveryByteForgedAtTheEndOfAHalt_IsRefusedOrGoesOn) {
  const auto duel = std::make_unique<Duel<>>();
  auto settings = duel_settings();
  settings.touches = 2;
  ASSERT_EQ(duel->configure(settings, first_fencer<float>(), second_fencer<float>()), Status::kOk);
  for (int i = 0; i < 5000 && !duel->bout().is_halt_over(); ++i) (void)advance(*duel);
  ASSERT_TRUE(duel->bout().is_halt_over());
  forge_every_byte(*duel);
}

}  // namespace
}  // namespace batuta
