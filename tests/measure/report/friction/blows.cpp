// SPDX-License-Identifier: MIT
// Single contacts of two random capsules: how often a law gains energy, how much, whether it keeps
// the restitution that was asked for, and what it costs.

#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "law.hpp"
#include "parts.hpp"

namespace batuta::report {
namespace {

constexpr std::uint64_t kSeed = 514;
constexpr std::array<double, 4> kRestitutions = {0, 0.5, 0.9, 1};
constexpr std::array<double, 5> kFrictions = {0, 0.2, 0.5, 1, 10};

/// Shares of energy are added up in billionths, which merge exactly.
constexpr double kBillion = 1e9;

struct Account {
  std::uint64_t contacts = 0;
  std::uint64_t gains = 0;
  std::uint64_t gain_billionths = 0;
  std::uint64_t kept_billionths = 0;
  double worst_gain = std::numeric_limits<double>::quiet_NaN();
  Histogram rebound_error;
  double worst_rebound_error = std::numeric_limits<double>::quiet_NaN();

  void add(const Effect& effect) {
    ++contacts;
    kept_billionths += static_cast<std::uint64_t>(std::llround((1 + effect.gain) * kBillion));
    worst_gain = std::fmax(worst_gain, effect.gain);
    rebound_error.add(effect.rebound_error);
    worst_rebound_error = std::fmax(worst_rebound_error, effect.rebound_error);
    if (effect.gain <= test::kGain) return;
    ++gains;
    gain_billionths += static_cast<std::uint64_t>(std::llround(effect.gain * kBillion));
  }
};

/// The draws in a range that collide; the others are the receding half.
std::vector<test::Strike> collisions(Range range) {
  std::vector<test::Strike> found;
  for (std::uint64_t i = range.first; i < range.last; ++i) {  // Bound: the range
    const test::Strike strike = test::random_strike(kSeed, i);
    if (normal_velocity(strike, {strike.A.twist, strike.B.twist}) < 0) found.push_back(strike);
  }
  return found;
}

double time_ns(const std::vector<test::Strike>& strikes, const Law& law, const Options& options) {
  std::size_t next = 0;
  return median_ns(static_cast<int>(pick(options, 20, 500, 10000)), [&] {
    next = next + 1 < strikes.size() ? next + 1 : 0;
    keep(answer(strikes[next], law));
  });
}

void write_row(Table& table, const Law& law, const Account& account, double time, double plain) {
  table.key("way", name_of(law.rounds))
      .key("restitution", law.friction.restitution)
      .key("friction", law.friction.friction)
      .sum("contacts", account.contacts)
      .sum("gains", account.gains)
      .sum("gain_billionths", account.gain_billionths)
      .sum("kept_billionths", account.kept_billionths)
      .max("worst_gain", account.worst_gain)
      .hist("rebound_error", account.rebound_error)
      .max("worst_rebound_error", account.worst_rebound_error)
      .min("time_ns", time)
      .min("time_in_plain", time / plain);
  table.end_row();
}

/// The closed form's claim. @returns exit code of the program
int judge(std::uint64_t gains) {
  if (gains == 0) return 0;
  std::fprintf(stderr, "friction: the closed form gained energy in %llu contacts\n",
               static_cast<unsigned long long>(gains));
  return 1;
}

}  // namespace

int report_blows(const Options& options) {
  constexpr std::uint64_t kTimed = 2048;  // more than a branch predictor learns by heart
  Table table(options, "friction_blows");
  const auto strikes = collisions(share_of(options, pick(options, 200, 10'000, 400'000)));
  const auto timed = collisions({0, kTimed});
  std::uint64_t gains = 0;  // of the closed form
  Progress progress("friction, blows", kRestitutions.size() * kFrictions.size());
  for (const double restitution : kRestitutions) {
    for (const double friction : kFrictions) {
      const double plain = plain_ns();
      for (const int rounds : kRounds) {
        const Law law{{restitution, friction, 0}, rounds};
        Account account;
        for (const auto& strike : strikes) {
          account.add(effect_of(strike, law, answer(strike, law)));
        }
        if (rounds == 0) gains += account.gains;
        write_row(table, law, account, time_ns(timed, law, options), plain);
      }
      progress.advance();
    }
  }
  const int written = table.write();
  return written != 0 ? written : judge(gains);
}

}  // namespace batuta::report
