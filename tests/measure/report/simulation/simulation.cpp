// SPDX-License-Identifier: MIT
// Report on the whole simulation: what is left of the error when search, impulse, hands and grips
// run together, against the length of the step, scalar and search.

#include "parts.hpp"

int main(int argc, char** argv) {
  using namespace batuta::report;
  const Options options = parse(
      argc, argv,
      {"simulation",
       "Error of one beat and of a whole phrase against step length, scalar and search.",
       "2 minutes",
       "simulation_beat.csv, simulation_phrase.csv, simulation_runs.csv and simulation_blows.csv"});
  const int beat = report_beat(options);
  const int phrase = report_phrase(options);
  return beat != 0 ? beat : phrase;
}
