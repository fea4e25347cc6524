// SPDX-License-Identifier: MIT
// Single contacts of two bodies whose masses are up to 1e9 apart: what rounding does to energy and
// momentum, in float and in double.

#include "parts.hpp"
#include "stiff_blow.hpp"

namespace batuta::report {
namespace {

constexpr int kDecades = 9;  ///< of the ratio, to either side

struct Seen {
  std::uint64_t contacts = 0;
  std::uint64_t not_finite = 0;
  test::StiffError worst;
};

template <class S>
Seen seen_at(double ratio, Range numbers) {
  Seen seen;
  for (std::uint64_t number = numbers.first; number < numbers.last; ++number) {
    const test::StiffError error = test::judge(test::stiff_blow<S>(number, ratio));
    seen.contacts += error.took_part ? 1 : 0;
    seen.not_finite += error.finite ? 0 : 1;
    if (error.finite && error.took_part) seen.worst.merge(error);
  }
  return seen;
}

template <class S>
void write_row(Table& table, const char* scalar, int decade, Range numbers) {
  const Seen seen = seen_at<S>(std::pow(10, decade), numbers);
  table.key("scalar", scalar)
      .key("decade", decade)
      .sum("contacts", seen.contacts)
      .sum("not_finite", seen.not_finite)
      .max("energy_u", seen.worst.energy)
      .max("energy_share", seen.worst.share)
      .max("linear_ulp", seen.worst.linear)
      .max("angular_ulp", seen.worst.angular);
  table.end_row();
}

}  // namespace

int report_stiff_blows(const Options& options) {
  Table table(options, "stiff_blows");
  const Range numbers = share_of(options, pick(options, 1000, 40000, 1000000));
  Progress progress("stiff blows", 2 * kDecades + 1);
  for (int decade = -kDecades; decade <= kDecades; ++decade) {
    write_row<float>(table, "float", decade, numbers);
    write_row<double>(table, "double", decade, numbers);
    progress.advance();
  }
  return table.write();
}

}  // namespace batuta::report
