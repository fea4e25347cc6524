// SPDX-License-Identifier: MIT
// The campaign of misses: every claim of the certified searches on the families of ensemble.hpp,
// held against the reference. Row: family, scalar, search, share of the inflation that was left.

#include <cstdio>

#include "batuta/detection/translation.hpp"
#include "detection/advancement_search.hpp"
#include "ensemble.hpp"
#include "own_options.hpp"
#include "tally.hpp"

namespace batuta::report {
namespace {

using test::Family;

constexpr std::uint64_t kProbeEvery = 64;

template <class Scalar>
constexpr const char* kScalarName = std::is_same_v<Scalar, float> ? "float" : "double";

/// Both searches of one scalar on one family.
template <class Scalar>
class Entrant {
 public:
  explicit Entrant(double inflation)
      : inflation_(inflation),
        advancement_(static_cast<double>(kRoundOff<Scalar>)),
        translation_(static_cast<double>(kRoundOff<Scalar>)) {}

  void answer(const test::Query& query, const test::Truth& truth, Family family, bool probed) {
    const auto made = make_moving_pair(test::cast<Scalar>(query.A), test::cast<Scalar>(query.B));
    const MovingPair<Scalar>& pair = made.value;
    const AdvancementOptions<Scalar> options;
    const Scalar eps = static_cast<Scalar>(inflation_) * detail::kInflation<Scalar>;
    note(advancement_, pair, search_inflated(pair, options, kNoSeed, eps), truth, probed);
    if (test::turns(family) || inflation_ != 1) return;
    note(translation_, pair, search_translation(pair, options), truth, probed);
  }

  void write(Table& table, Family family) const {
    const char* const scalar = kScalarName<Scalar>;
    advancement_.write(table, {test::name(family), scalar, "advancement", inflation_});
    if (test::turns(family) || inflation_ != 1) return;
    translation_.write(table, {test::name(family), scalar, "translation", inflation_});
  }

  std::uint64_t untrue() const { return advancement_.untrue() + translation_.untrue(); }

 private:
  inline static const Vec3<Scalar> kNoSeed = Vec3<Scalar>::Zero();

  static void note(Tally& tally, const MovingPair<Scalar>& pair, const SearchResult<Scalar>& found,
                   const test::Truth& truth, bool probed) {
    const test::Claim claim = test::claim_of(pair, AdvancementOptions<Scalar>{}, found);
    tally.add(claim, found.evaluations, truth);
    if (probed) tally.probe(claim, truth);
  }

  double inflation_;
  Tally advancement_;
  Tally translation_;
};

struct Sweep {
  const CampaignOptions& options;
  Table& table;
  Progress& progress;
};

/// @param inflations  for each, everything is searched again
/// @returns claims of freedom that are not true, with the whole inflation
std::uint64_t run_family(const Sweep& sweep, Family family, std::uint64_t queries,
                         const std::vector<double>& inflations) {
  std::vector<Entrant<float>> floats(inflations.begin(), inflations.end());
  std::vector<Entrant<double>> doubles(inflations.begin(), inflations.end());
  const Range range = share_of(sweep.options.common, queries);
  for (std::uint64_t i = range.first; i < range.last; ++i) {  // Bound: queries
    const test::Query query = test::make_query(family, sweep.options.seed, i);
    const test::Truth truth(query.A, query.B);
    const bool probed = i % kProbeEvery == 0;
    for (auto& entrant : floats) entrant.answer(query, truth, family, probed);
    for (auto& entrant : doubles) entrant.answer(query, truth, family, probed);
    sweep.progress.advance();
  }
  std::uint64_t untrue = 0;
  for (std::size_t k = 0; k < inflations.size(); ++k) {  // Bound: inflations
    floats[k].write(sweep.table, family);
    doubles[k].write(sweep.table, family);
    if (inflations[k] >= 1) untrue += floats[k].untrue() + doubles[k].untrue();
  }
  return untrue;
}

int run(const CampaignOptions& options) {
  constexpr std::uint64_t kFamilies = test::kFamilyCount;
  const std::uint64_t queries = pick(options.common, 50, 10'000, 10'000'000 / kFamilies + 1);
  Table table(options.common, "misses");
  const Range share = share_of(options.common, queries);
  Progress progress("misses", kFamilies * (share.last - share.first));
  const Sweep sweep{options, table, progress};
  std::uint64_t untrue = 0;
  for (const Family family : test::kFamilies) {
    // Grazes are where the inflation is needed: they show how much of it.
    const bool sweeps = options.sweeps && family == Family::kGraze;
    const std::vector<double> all = {1, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0};
    const std::vector<double> one = {options.inflation};
    untrue += run_family(sweep, family, queries, sweeps ? all : one);
  }
  if (untrue > 0) {
    std::fprintf(stderr, "misses: %llu claims of freedom are not true\n",
                 static_cast<unsigned long long>(untrue));
  }
  return table.write() != 0 || untrue > 0 ? 1 : 0;
}

}  // namespace
}  // namespace batuta::report

int main(int argc, char** argv) {
  using namespace batuta::report;
  const About about{
      "misses", "Tries to prove false what the certified searches claim; exit code 1 if it does.",
      "10 to 20 minutes", nullptr,
      "  --seed N      other queries (default: 1)\n"
      "  --inflation-factor X\n"
      "                this share of the inflation (default: all of it; grazes with less as "
      "well)\n"};
  return run(parse_campaign(argc, argv, about));
}
