// SPDX-License-Identifier: MIT
#pragma once
// Records the bout into a file, so that it can be gone through again, here or on a target.

#include <vector>

#include "batuta/record/duel.hpp"
#include "batuta/record/recorder.hpp"
#include "programs/duel/observer.hpp"
#include "programs/recording/file_stream.hpp"

namespace batuta::host {

/// A replay names the very step in which it parts.
inline constexpr std::uint32_t kHashEvery = 1;

class RunRecord final : public Observer {
 public:
  /// @pre `file` is open, and outlives this
  explicit RunRecord(FileSink& file);

  void on_start(const DuelRunner& runner) override;
  void on_step(const DuelRunner& runner) override;
  void on_end(const DuelRunner& runner) override;

 private:
  std::vector<std::uint8_t> buffer_;
  Recorder recorder_;
};

}  // namespace batuta::host
