// SPDX-License-Identifier: MIT
#pragma once
// How far a long replay is, for somebody who waits.

#include <cstdio>

#include "programs/duel/observer.hpp"

namespace batuta::host {

/// Draws on a terminal; give it to the loop before any log that writes to the same terminal.
class ProgressBar final : public Observer {
 public:
  explicit ProgressBar(std::FILE* terminal) : out_(terminal) {}

  void on_start(const DuelRunner&) override {}
  void on_step(const DuelRunner& runner) override;
  void on_end(const DuelRunner&) override { erase(); }

 private:
  void draw(int percent);
  void erase();

  std::FILE* out_;
  int shown_ = -1;  ///< per cent; -1: nothing is drawn
};

}  // namespace batuta::host
