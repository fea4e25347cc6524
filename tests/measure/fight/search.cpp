// SPDX-License-Identifier: MIT
#include "search.hpp"

#include <cmath>

#include "fencers.hpp"

namespace fight {
namespace {

/// So many rounds play the same tries; then others come.
constexpr int kRoundsOfTries = 20;
/// What is worse on this part of the tries is not looked at twice.
constexpr int kGlance = 3;

double score_with(const Knobs& knobs, const Trials& trials) {
  const Keys keys = keys_from(knobs);
  const Choices chosen = choices();
  const auto cases = all_cases(chosen);
  return score_of(table_of(cases, play_all(pair_with(&keys), cases, chosen, trials)));
}

}  // namespace

Knobs moved(const Knobs& knobs, Random& random) {
  Knobs next = knobs;
  const int count = 1 + static_cast<int>(random.between(0, 3));
  // Mostly small, sometimes large.
  const double size = std::exp2(random.between(-2, 1.5));
  for (int moves = 0; moves < count;) {
    const auto i = static_cast<std::size_t>(random.next() % fight::knobs().size());
    const double step = fight::knobs()[i].step;
    if (step == 0) continue;
    next[i] += size * step * random.between(-1, 1);
    ++moves;
  }
  return next;
}

std::string search(const SearchOrder& order) {
  Knobs best;
  const std::string wrong = best.load(order.path);
  if (!wrong.empty()) return wrong;
  Random random(order.seed);
  Trials glance{(order.tries + kGlance - 1) / kGlance, 0};
  double seen = 0;
  for (int round = 0; round < order.rounds; ++round) {
    if (round % kRoundsOfTries == 0) {
      glance.seed = random.next();
      seen = score_with(best, glance);
    }
    const Knobs next = moved(best, random);
    const double found = score_with(next, glance);
    if (found >= seen) continue;
    const Trials others{order.tries, random.next()};
    const double before = score_with(best, others);
    const double after = score_with(next, others);
    const bool is_better = after < before;
    std::printf("round %d: %.1f -> %.1f, on others %.1f -> %.1f%s\n", round, seen, found, before,
                after, is_better ? ", kept" : "");
    std::fflush(stdout);
    if (!is_better) continue;
    best = next;
    seen = found;
    const std::string unwritten = best.save(order.path);
    if (!unwritten.empty()) return order.path + ": cannot be written: " + unwritten;
  }
  return {};
}

}  // namespace fight
