// SPDX-License-Identifier: MIT
#pragma once
// The normals that parted pairs when they were last searched: a search that begins with one often
// needs no other evaluation. Part of a world's saved state, because what a search costs and the
// last bits of what it answers depend on it; what it proves does not.

#include "batuta/world/detail/proxy_pair.hpp"
#include "batuta/world/scene.hpp"

namespace batuta::detail {

/// One place for each pair that may meet at the same time. Two pairs that share a place push each
/// other out, which costs evaluations and nothing else; none do where N is all pairs of the bodies.
template <class Scalar, int N>
class SeedMemory {
 public:
  /// The normal of the last search, out of the first body towards the second; zero: none known.
  Vec3<Scalar> recall(ProxyPair pair) const {
    const Entry& entry = entries_[place_of(pair)];
    const bool same = entry.pair.first == pair.first && entry.pair.second == pair.second;
    return same ? entry.normal : zero<Scalar>();
  }
  void remember(ProxyPair pair, const Vec3<Scalar>& normal) {
    entries_[place_of(pair)] = {pair, normal};
  }
  /// Forgets what a body left in a slot: the next one there begins as if it were the first.
  /// Bound: N entries.
  void forget(std::uint16_t slot) {
    for (Entry& entry : entries_) {  // Bound: N
      if (entry.pair.first == slot || entry.pair.second == slot) entry = {};
    }
  }
  void copy_seeds(const SeedMemory& other) { *this = other; }
  template <class Archive>
  void archive_seeds(Archive& ar) {
    for (Entry& entry : entries_) ar(entry.pair, entry.normal);  // Bound: N
  }

 private:
  struct Entry {
    ProxyPair pair;  ///< first == second: empty
    Vec3<Scalar> normal = zero<Scalar>();
  };

  /// Pairs are numbered (0, 1), (0, 2), (1, 2), (0, 3) ...
  static std::size_t place_of(ProxyPair pair) {
    const std::size_t second = pair.second;
    return (second * (second - 1) / 2 + pair.first) % static_cast<std::size_t>(N);
  }

  std::array<Entry, static_cast<std::size_t>(N)> entries_{};
};

/// For searches that take no seed: nothing is kept.
struct NoSeeds {
  void forget(std::uint16_t /*slot*/) {}
  void copy_seeds(const NoSeeds& /*other*/) {}
  template <class Archive>
  void archive_seeds(Archive& /*ar*/) {}
};

template <class SceneT>
using SeedsOf = std::conditional_t<SceneT::Search::kUsesSeed,
                                   SeedMemory<typename SceneT::Scalar, SceneT::kMaxPairs>, NoSeeds>;

}  // namespace batuta::detail
