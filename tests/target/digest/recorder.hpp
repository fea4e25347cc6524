// SPDX-License-Identifier: MIT
#pragma once
// Keeps the digests: one of each section, and the hash of every query in a file, so that two runs
// that differ can be told where.

#include "answer.hpp"
#include "options.hpp"

namespace batuta::digest {

/// A line of the file of hashes.
struct HashRecord {
  std::uint32_t section = 0;
  std::uint32_t index = 0;
  std::uint32_t low = 0;
  std::uint32_t high = 0;
};

class Recorder final : private AnswerListener {
 public:
  explicit Recorder(const Options& options) : options_(options) {}

  /// Opens the file of hashes, if one is wanted. @returns whether that went well
  bool open();
  /// @returns whether all hashes were written
  bool close();

  bool takes(Section section) const { return options_.takes(section); }
  /// Whether a query that does not depend on others is to be answered.
  bool wants(Section section, std::uint32_t index) const {
    if (options_.shown.any) return options_.shown.is(section, index);
    return takes(section) && index % options_.every == 0;
  }
  /// How many of a sequence are to be answered.
  std::uint32_t shortened(std::uint32_t length) const {
    return (length + options_.every - 1) / options_.every;
  }

  /// The answer to fill in for a query.
  Answer begin(Section section, std::uint32_t index) {
    return Answer(options_.shown.is(section, index) ? this : nullptr,
                  options_.doctored.is(section, index));
  }
  void end(Section section, std::uint32_t index, const Answer& answer);

  /// A line for every section with queries: name, queries, sample, digest.
  void print() const;

 private:
  struct Sum {
    Fingerprint digest;
    std::uint32_t queries = 0;
  };

  void on_word(const char* field, std::uint32_t word) override;
  void flush();

  static constexpr std::size_t kBlock = 128;
  Options options_;
  std::array<Sum, kSections> sums_{};
  std::array<HashRecord, kBlock> block_{};
  std::size_t filled_ = 0;
  File file_ = -1;
  bool written_ = true;
};

}  // namespace batuta::digest
