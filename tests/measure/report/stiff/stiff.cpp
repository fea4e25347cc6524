// SPDX-License-Identifier: MIT
// Report on stiff pairs: error and energy against the ratio of the masses and the step.

#include "parts.hpp"

int main(int argc, char** argv) {
  using namespace batuta::report;
  const Options options =
      parse(argc, argv,
            {"stiff", "Stiff pairs: error and energy against mass ratio and step.", "2 minutes",
             "stiff_blows.csv and stiff_steps.csv"});
  const int blows = report_stiff_blows(options);
  const int steps = report_stiff_steps(options);
  return blows != 0 ? blows : steps;
}
