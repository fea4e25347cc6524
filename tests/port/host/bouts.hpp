// SPDX-License-Identifier: MIT
#pragma once
// Bouts for the tests of the program.

#include <gtest/gtest.h>

#include <memory>

#include "programs/duel/observer.hpp"

namespace batuta::host {

/// Two opened sources and their runner, on guard.
struct BoutRig {
  BoutRig(const std::string& left_words, const std::string& right_words,
          double limit = std::numeric_limits<double>::infinity(), const BoutRules& rules = {})
      : left(open_source(left_words).source),
        right(open_source(right_words).source),
        runner(std::make_unique<DuelRunner>(*left, *right, limit, rules)) {
    EXPECT_EQ(runner->start(), Status::kOk);
  }

  /// To the end, with or without somebody who watches.
  void run(Observer* observer = nullptr) {
    if (observer != nullptr) observer->on_start(*runner);
    bool going_on = true;
    while (going_on) {  // Bound: the limit of the bout
      going_on = runner->step();
      if (observer != nullptr) observer->on_step(*runner);
    }
    if (observer != nullptr) observer->on_end(*runner);
  }

  std::unique_ptr<Source> left;
  std::unique_ptr<Source> right;
  std::unique_ptr<DuelRunner> runner;
};

}  // namespace batuta::host
