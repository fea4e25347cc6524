// SPDX-License-Identifier: MIT
#pragma once
// The bout for people, a line for each thing that a fencer would notice.

#include <cstdio>

#include "programs/duel/bout_words.hpp"
#include "programs/duel/observer.hpp"

namespace batuta::host {

class BoutLog final : public Observer {
 public:
  explicit BoutLog(std::FILE* out) : out_(out) {}

  void on_start(const DuelRunner& runner) override;
  void on_step(const DuelRunner& runner) override;
  void on_end(const DuelRunner& runner) override;

 private:
  void print_contact(double time, const ContactEvent<float>& event);
  void print_parting(double time);
  void print_device(const DuelRunner& runner, fencing::Side side);
  void print_holds(const DuelRunner& runner);

  /// From the moment when the weapons meet until no blade and no guard of them touches another.
  struct Engagement {
    double since = 0;    ///< s
    double impulse = 0;  ///< sum, N s
    int pairs = 0;       ///< of blades and guards that touch
  };

  std::FILE* out_;
  Engagement engagement_;
  TouchCursor touches_;
};

}  // namespace batuta::host
