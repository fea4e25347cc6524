// SPDX-License-Identifier: MIT
#pragma once
// Hill climbing towards the queries that cost search_advancement<double> the most: a query is
// changed a little, and the change is kept unless the search takes fewer evaluations.

#include <cstdint>

#include "ensemble.hpp"

namespace batuta::report {

/// A gap of so much counts as contact, m; bodies are about a metre long.
inline constexpr double kTau = 1e-6;

/// Where a climb sets out.
enum class Start : std::uint8_t {
  kGeneric,  ///< as the generic family: axes of 0.2 ... 2 m, radii of 2 ... 30 cm, in flight
  kSliding,  ///< an axis goes round another at a gap that hardly changes, as sliding blades do;
             ///< radii up to 95 cm, for what turns about the other's centre
};

/// What a climb must not leave.
struct Ground {
  Start start = Start::kGeneric;
  double most_turn = 0;  ///< of each body, rad
};

struct Summit {
  test::Query query;  ///< numbers exact in float: what is kept in a file is what was climbed
  std::uint32_t evaluations = 0;
};

/// Distance evaluations of the search in double, contact tolerance kTau, ample budget. 0: not a
/// query.
std::uint32_t evaluations_of(const test::Query& query);

/// The worst query that the `index`-th climb on this ground comes to, a function of its arguments.
/// Bound: kFirst + mutations searches.
Summit climb(const Ground& ground, std::uint64_t index, std::uint64_t mutations);

/// Random queries of which the worst is where a climb sets out.
inline constexpr std::uint64_t kFirst = 20;

}  // namespace batuta::report
