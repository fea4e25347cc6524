// SPDX-License-Identifier: MIT
#pragma once
// A duel that is ready to begin, of every kind that the library holds.

#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "batuta/fencing/duel.hpp"

namespace batuta::test {

/// Keys of a hand that goes straight forward with the stick, from 0.42 m on guard to 1.24 m, 0.25 m
/// to its right, with a blade that points in by 0.2 rad. Two of them thrust at each other's trunks
/// and never meet: blade and bell of either stay on its own side of the line between them.
template <class S>
inline constexpr std::array<fencing::MapKey<S>, 4> kThrustKeys = {{
    {{{S(-0.4), S(-0.25), S(1.15)}}, {{S(0), S(0), S(0.2)}}, S(0)},
    {{{S(-0.4), S(-0.25), S(1.15)}}, {{S(0), S(0), S(0.2)}}, S(0)},
    {{{S(1.24), S(-0.25), S(1.15)}}, {{S(0), S(0), S(0.2)}}, S(0)},
    {{{S(1.24), S(-0.25), S(1.15)}}, {{S(0), S(0), S(0.2)}}, S(0)},
}};
/// With such a hand.
template <class S>
fencing::Fencer<S> thruster(fencing::Fencer<S> fencer) {
  fencer.map = {kThrustKeys<S>.data(), 2, 2};
  return fencer;
}

template <class DuelT>
class ConfiguredDuel : public ::testing::Test {
 protected:
  using ScalarT = typename DuelT::SceneType::Scalar;
  std::unique_ptr<DuelT> duel = std::make_unique<DuelT>();
  typename DuelT::Settings settings = fresh_settings();

  static typename DuelT::Settings fresh_settings() {
    return fencing::duel_settings<typename DuelT::StatedScene>();
  }
  Status configure() {
    return duel->configure(settings, fencing::first_fencer<ScalarT>(),
                           fencing::second_fencer<ScalarT>());
  }
  /// Both fencers of the library, with hands that thrust past each other.
  Status configure_thrusters() {
    return duel->configure(settings, thruster(fencing::first_fencer<ScalarT>()),
                           thruster(fencing::second_fencer<ScalarT>()));
  }
  void SetUp() override { ASSERT_EQ(configure(), Status::kOk); }

  /// Whether settings so changed are not taken.
  template <class Change>
  bool refuses(const Change& change) {
    settings = fresh_settings();
    change(settings);
    return configure() == Status::kInvalidArgument;
  }
};

/// The standard duel with one search.
template <class SearchT>
using DuelWith = fencing::Duel<fencing::DuelScene<fencing::two_fencers, SearchT>>;
using PaperDuels = ::testing::Types<DuelWith<Stepping<float>>, DuelWith<Stepping<double>>>;
using CertifiedDuels = ::testing::Types<fencing::Duel<>, DuelWith<Advancement<double>>>;
using Duels = ::testing::Types<fencing::Duel<>, DuelWith<Advancement<double>>,
                               DuelWith<Stepping<float>>, DuelWith<Stepping<double>>>;

}  // namespace batuta::test
