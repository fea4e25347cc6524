// SPDX-License-Identifier: MIT
// Energy over a sequence of contacts: rods that bounce about a room, elastic and with friction.
// What a law of contact invents, the next contact starts from; as nothing here has a scale of
// energy, gains count as shares of the energy before the contact, however much friction has taken.

#include <cmath>
#include <limits>

#include "parts.hpp"
#include "rod_in_room.hpp"

namespace batuta::report {
namespace {

constexpr std::array<double, 4> kFrictions = {0.05, 0.2, 0.5, 1};
/// After so many contacts a rod is looked at.
constexpr std::array<int, 12> kLooks = {0, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000};

constexpr double kBillion = 1e9;  ///< shares are added up in billionths, which merge exactly

/// Rods after a number of contacts.
struct Account {
  std::uint64_t rods = 0;
  std::uint64_t risen = 0;  ///< with more than they began with
  Histogram energy;         ///< over what the rod began with
  double most_energy = std::numeric_limits<double>::quiet_NaN();
  /// Sum of all gains, each over the energy before its contact.
  std::uint64_t invented_billionths = 0;
  double most_invented = std::numeric_limits<double>::quiet_NaN();

  void add(double energy_now, double invented_now) {
    ++rods;
    if (energy_now > 1 + test::kGain) ++risen;
    energy.add(energy_now);
    invented_billionths += static_cast<std::uint64_t>(std::llround(invented_now * kBillion));
    most_energy = std::fmax(most_energy, energy_now);
    most_invented = std::fmax(most_invented, invented_now);
  }
};

using Accounts = std::array<Account, kLooks.size()>;

/// Contacts of one rod, until the looks asked for are done.
void follow(std::uint64_t number, const Law& law, int most, Accounts& accounts) {
  RodInRoom rod(number);
  const double start = rod.energy();
  double invented = 0;
  int contacts = 0;
  for (std::size_t k = 0; k < kLooks.size() && kLooks[k] <= most; ++k) {
    for (; contacts < kLooks[k]; ++contacts) {
      const double before = rod.energy();
      if (!rod.meet(law)) return;
      const double gain = rod.energy() / before - 1;
      if (gain > test::kGain) invented += gain;
    }
    accounts[k].add(rod.energy() / start, invented);
  }
}

void write_rows(Table& table, const Law& law, int most, const Accounts& accounts) {
  for (std::size_t k = 0; k < kLooks.size() && kLooks[k] <= most; ++k) {
    const Account& account = accounts[k];
    table.key("way", name_of(law.rounds))
        .key("friction", law.friction.friction)
        .key("contacts", kLooks[k])
        .sum("rods", account.rods)
        .sum("risen", account.risen)
        .hist("energy", account.energy)
        .max("most_energy", account.most_energy)
        .sum("invented_billionths", account.invented_billionths)
        .max("most_invented", account.most_invented);
    table.end_row();
  }
}

}  // namespace

int report_chain(const Options& options) {
  const Range rods = share_of(options, pick(options, 4, 12, 100));
  const int most = static_cast<int>(pick(options, 20, 500, 2000));
  Table table(options, "friction_chain");
  Progress progress("friction, chains", kFrictions.size() * kRounds.size());
  for (const double friction : kFrictions) {
    for (const int rounds : kRounds) {
      const Law law{{1, friction, 0}, rounds};
      Accounts accounts;
      for (std::uint64_t i = rods.first; i < rods.last; ++i) follow(i, law, most, accounts);
      write_rows(table, law, most, accounts);
      progress.advance();
    }
  }
  return table.write();
}

}  // namespace batuta::report
