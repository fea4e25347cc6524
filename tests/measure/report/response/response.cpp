// SPDX-License-Identifier: MIT
// Report on the settings of the response and of the fencers: separation.csv, resting.csv
// and keyframes.csv.

#include "parts.hpp"

int main(int argc, char** argv) {
  using namespace batuta::report;
  const Options options = parse(argc, argv,
                                {"response",
                                 "Separation distance against penetration, jitter and cost; "
                                 "bodies at rest; keyframe grids against their size.",
                                 "5 minutes", "separation.csv, resting.csv and keyframes.csv"});
  const int separation = report_separation(options);
  const int resting = report_resting(options);
  const int keyframes = report_keyframes(options);
  return separation != 0 ? separation : resting != 0 ? resting : keyframes;
}
