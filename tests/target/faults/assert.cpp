// SPDX-License-Identifier: MIT
// A caller's mistake, found by the library's assert or by Eigen's: assert own|eigen
#include "batuta/core/types.hpp"
#include "push.hpp"

namespace {

volatile int three = 3;

void trip_own() {
  announce(batuta::file_id(__FILE__));
  announce(__LINE__ + 1);
  BATUTA_ASSERT(three == 4);
}

float trip_eigen() {
  const batuta::Vec3<float> vector(1, 2, 3);
  return vector(three);
}

}  // namespace

int main() {
  push();
  if (first_argument() == 'o') trip_own();
  batuta::semihosting::exit(trip_eigen() > 0 ? 0 : 1);
}
