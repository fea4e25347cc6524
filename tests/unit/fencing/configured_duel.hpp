// SPDX-License-Identifier: MIT
#pragma once
// A duel that is ready to begin, of every kind that the library holds.

#include <gtest/gtest.h>

#include <memory>

#include "batuta/fencing/duel.hpp"

namespace batuta::test {

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
