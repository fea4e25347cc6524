// SPDX-License-Identifier: MIT
// Report on friction: the closed form against the iterated Newton restitution of engines.

#include "parts.hpp"

int main(int argc, char** argv) {
  using namespace batuta::report;
  const Options options =
      parse(argc, argv,
            {"friction",
             "Coulomb friction in closed form and as engines iterate it: energy, rebound and time.",
             "5 minutes",
             "friction_blows.csv, friction_map.csv, friction_cases.csv and friction_chain.csv"});
  int code = 0;
  for (const auto& part : {report_blows, report_slip_map, report_cases, report_chain}) {
    const int own = part(options);
    if (own != 0) code = own;
  }
  return code;
}
