// SPDX-License-Identifier: MIT
#pragma once
// Queries that cost much, with what is true of them, as a query file
// (port/programs/query_file.hpp): T, A..., B... by the bits of their floats; then, in decimal, what
// they cost and the truth:
//   degrees          no body turns further
//   contact tolerance             tau, m
//   evaluations      that the search took in double when the file was last written
//   kind             0 no contact, 1 contact at t, 2 overlap at the start (t = 0)
//   t                s; kind 1: free up to here by proof, and overlapping right after; by samples
//                    where the proof would take too long; kind 0: -1; kind 2: 0
//   gmin, tgmin      least gap that sampling finds, m, and when
// `batuta_report_climb --mode full --keep FILE` lets tests/vectors/worst_queries.csv grow: what was
// the worst before a search learned better stays in the file, with what it costs now.

#include <string>
#include <vector>

#include "climber.hpp"

namespace batuta::report {

struct CostlyQuery {
  std::string family;
  double degrees = 0;
  Summit summit;
};

/// Adds those of `found` that the file lacks, with the truth, to those that it has, whose truth
/// stays and whose evaluations are counted anew. A file that is not there is begun.
/// @returns false: the file could not be read or written, which was said on standard error
bool keep_queries(const std::string& path, const std::vector<CostlyQuery>& found);

}  // namespace batuta::report
