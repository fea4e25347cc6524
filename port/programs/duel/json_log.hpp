// SPDX-License-Identifier: MIT
#pragma once
// The bout for programs: one JSON object a line. Types: "start", "contact", "touch", "halt", and at
// the end "summary". SI units; contacts that merely persist without a blow are counted in the
// summary, not listed.

#include "programs/duel/bout_words.hpp"
#include "programs/duel/json_line.hpp"
#include "programs/duel/observer.hpp"

namespace batuta::host {

class JsonLog final : public Observer {
 public:
  explicit JsonLog(std::FILE* out) : out_(out) {}

  void on_start(const DuelRunner& runner) override;
  void on_step(const DuelRunner& runner) override;
  void on_end(const DuelRunner& runner) override;

 private:
  void write_contact(double time, const ContactEvent<float>& event);
  void write_halt(const DuelRunner& runner);

  std::FILE* out_;
  TouchCursor touches_;
  fencing::Touch<float> last_;       ///< the first one of the last exchange that had one
  std::uint32_t last_exchange_ = 0;  ///< 0: nobody was touched yet
};

}  // namespace batuta::host
