// SPDX-License-Identifier: MIT
// Report on haptics: a simulated stick shakes where the gain advisor says, and what the passivity
// controller does about it.

#include "parts.hpp"

int main(int argc, char** argv) {
  using namespace batuta::report;
  const Options options =
      parse(argc, argv,
            {"haptics",
             "A sampled spring on a simulated stick: onset of shaking against the advisor's bound, "
             "energy with and without the passivity controller.",
             "20 seconds",
             "haptics_onset.csv, haptics_hands.csv, haptics_encoder.csv and haptics_energy.csv"});
  int code = 0;
  for (const auto& part : {report_onsets, report_hands, report_encoder, report_energy}) {
    const int own = part(options);
    if (own != 0) code = own;
  }
  return code;
}
