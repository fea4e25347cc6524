// SPDX-License-Identifier: MIT
// Report on the settings of the response and of the fencers: separation.csv and keyframes.csv.

#include "parts.hpp"

int main(int argc, char** argv) {
  using namespace batuta::report;
  const Options options = parse(argc, argv,
                                {"response",
                                 "Separation distance against penetration, jitter and cost; "
                                 "keyframe grids against their size.",
                                 "4 minutes", "separation.csv and keyframes.csv"});
  const int separation = report_separation(options);
  const int keyframes = report_keyframes(options);
  return separation != 0 ? separation : keyframes;
}
