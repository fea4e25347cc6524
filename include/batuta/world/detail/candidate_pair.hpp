// SPDX-License-Identifier: MIT
#pragma once
// A pair of capsules that may meet in the rest of a step, and what its search answered.

#include "batuta/core/fixed_list.hpp"
#include "batuta/world/detail/proxy_pair.hpp"
#include "batuta/world/scene.hpp"

namespace batuta::detail {

template <class Scalar>
struct CandidatePair {
  ProxyPair pair;  ///< proxies: body x kCapsulesPerBody + part
  Outcome outcome = Outcome::kInvalid;
  bool asked = false;     ///< the members below are known
  Scalar since = 0;       ///< in the step, s: when the search began
  Scalar free_for = 0;    ///< from then on, s
  Scalar near_after = 0;  ///< from then on, s: a contact is within twice its gap

  Scalar free_until() const { return since + free_for; }
  Scalar near_from() const { return since + near_after; }
  bool is_contact() const { return outcome == Outcome::kContact || outcome == Outcome::kTouching; }
};

/// Whether the pair P comes first: by its lower number, then by the other.
constexpr bool precedes(ProxyPair P, ProxyPair Q) {
  return P.first < Q.first || (P.first == Q.first && P.second < Q.second);
}
constexpr bool is_same(ProxyPair P, ProxyPair Q) {
  return P.first == Q.first && P.second == Q.second;
}

/// Which candidate ends a round (src/world/world.md, "Order").
struct CandidateOrder {
  static constexpr int kNone = -1;

  /// The index of the one proven free for the shortest time; kNone where there is none.
  template <class Candidates>
  static int earliest(const Candidates& candidates) {
    int first = kNone;
    for (int i = 0; i < candidates.size(); ++i) {  // Bound: kMaxPairs
      if (first == kNone || is_earlier(candidates[i], candidates[first])) first = i;
    }
    return first;
  }
  /// Contacts that are near already when the first one happens tie with it: their order is below
  /// what a search resolves. The lowest pair of them is then first: rounding does not decide.
  /// @param has_had  whether a pair was answered at this time already: it does not tie again, or
  /// one that has nothing to answer yet would come before those that have
  template <class Candidates, class HasHad>
  static int among_ties(const Candidates& candidates, int earliest, const HasHad& has_had) {
    int chosen = earliest;
    if (!candidates[earliest].is_contact()) return chosen;
    const auto time = candidates[earliest].free_until();
    for (int i = 0; i < candidates.size(); ++i) {  // Bound: kMaxPairs
      const auto& candidate = candidates[i];
      const bool ties = candidate.is_contact() && !(time < candidate.near_from());
      if (ties && precedes(candidate.pair, candidates[chosen].pair) && !has_had(candidate.pair)) {
        chosen = i;
      }
    }
    return chosen;
  }
  /// The lowest pair behind `last` that comes to contact in the step; kNone where there is none.
  template <class Candidates, class HasHad>
  static int next_contact(const Candidates& candidates, ProxyPair last, const HasHad& has_had) {
    int next = kNone;
    for (int i = 0; i < candidates.size(); ++i) {  // Bound: kMaxPairs
      const auto& candidate = candidates[i];
      if (!candidate.is_contact() || !precedes(last, candidate.pair)) continue;
      if (next != kNone && !precedes(candidate.pair, candidates[next].pair)) continue;
      if (!has_had(candidate.pair)) next = i;
    }
    return next;
  }

 private:
  template <class CandidateT>
  static bool is_earlier(const CandidateT& P, const CandidateT& Q) {
    return P.free_until() < Q.free_until() ||
           (!(Q.free_until() < P.free_until()) && precedes(P.pair, Q.pair));
  }
};

/// What the search of the earliest candidate saw, as long as that candidate stands. Two places, so
/// that a search writes into one while the other is kept, and nothing is copied; one where there is
/// but one pair.
template <class PairQuery, class Scalar, bool kMany>
class EarliestQuery {
 public:
  [[gnu::noinline]] EarliestQuery() {}
  /// first == second: unknown.
  ProxyPair pair() const { return pair_; }
  PairQuery& earliest() { return queries_[kept_]; }
  /// Where the next search may write.
  PairQuery& spare() { return queries_[kMany ? 1 - kept_ : 0]; }
  /// The spare one is kept instead if its pair is free for a shorter time.
  void offer(ProxyPair pair, Scalar until) {
    if (pair_.first != pair_.second && !(until < until_)) return;
    pair_ = pair;
    until_ = until;
    if constexpr (kMany) kept_ = 1 - kept_;
  }
  void forget() { pair_ = {}; }

 private:
  std::array<PairQuery, kMany ? 2 : 1> queries_{};
  std::size_t kept_ = 0;
  ProxyPair pair_;
  Scalar until_ = 0;
};

/// How many contacts of each pair were resolved in this step in quick succession.
template <class Scalar, int N>
class RepeatBook {
 protected:
  void clear_repeats() { repeats_.clear(); }
  /// Counts a contact that comes within `soon` of the last one of its pair, and the first one.
  /// @returns how many there were with it. Bound: N. Never full: N contacts are resolved in a step.
  int repeat(ProxyPair pair, Scalar now, Scalar soon) {
    for (int i = 0; i < repeats_.size(); ++i) {  // Bound: kMaxContacts
      Repeat& repeat = repeats_[i];
      if (!is_same(repeat.pair, pair)) continue;
      if (now - repeat.last < soon) ++repeat.count;
      repeat.last = now;
      return repeat.count;
    }
    repeats_.push({pair, 1, now});
    return 1;
  }
  /// How many of those there were so far.
  int answers_of(ProxyPair pair) const {
    for (const Repeat& repeat : repeats_) {  // Bound: kMaxContacts
      if (is_same(repeat.pair, pair)) return repeat.count;
    }
    return 0;
  }
  bool was_answered(ProxyPair pair, Scalar at) const {
    for (const Repeat& repeat : repeats_) {  // Bound: kMaxContacts
      if (is_same(repeat.pair, pair)) return repeat.last == at;
    }
    return false;
  }

 private:
  struct Repeat {
    ProxyPair pair;
    int count = 0;
    Scalar last = 0;  ///< in the step, s
  };
  FixedList<Repeat, N> repeats_;
};
struct NoRepeats {
  void clear_repeats() {}
};

/// Two bodies alone always find room to part, and are held after a separation: nothing repeats.
template <class SceneT>
inline constexpr bool kCountsRepeats = SceneT::kRotation&& SceneT::kResponse &&
                                       (SceneT::kMaxBodies > 2 ||
                                        SceneT::kResting == RestingContact::kSettling);
template <class SceneT>
using RepeatsOf =
    std::conditional_t<kCountsRepeats<SceneT>,
                       RepeatBook<typename SceneT::Scalar, SceneT::kMaxContacts>, NoRepeats>;

}  // namespace batuta::detail
