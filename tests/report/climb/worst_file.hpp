// SPDX-License-Identifier: MIT
#pragma once
// Queries that cost much, with what is true of them, as a query file (port/host/query_file.hpp):
// T, A..., B... by the bits of their floats; then, in decimal, what they cost and the truth:
//   degrees          no body turns further
//   slab             tau, m
//   evaluations      when it was found, in double
//   kind             0 no contact, 1 contact at t, 2 overlap at the start (t = 0)
//   t                s; kind 1: free up to here by proof, and overlapping right after; by samples
//                    where the proof would take too long; kind 0: -1; kind 2: 0
//   gmin, tgmin      least gap that sampling finds, m, and when
// The file tests/vectors/worst_queries.csv is written by `batuta_report_climb --mode full --keep`.

#include <string>
#include <vector>

#include "climber.hpp"

namespace batuta::report {

struct CostlyQuery {
  std::string family;
  double degrees = 0;
  Summit summit;
};

/// @returns false: the file could not be written, which was said on standard error
bool write_queries(const std::string& path, const std::vector<CostlyQuery>& queries);

}  // namespace batuta::report
