// SPDX-License-Identifier: MIT
// Compiled with -ffp-contract=fast and the processor's fused multiply-add.
#include "contracted.hpp"

#include "batuta/core/arithmetic.hpp"

namespace batuta::test {

bool can_run_contracted() {
#if defined(__x86_64__) || defined(__i386__)
  return __builtin_cpu_supports("fma") != 0;
#else
  return true;  // part of the base instruction set
#endif
}

bool contracted_rounds_products(float /*scalar*/) {
  return detail::rounds_products<float>();
}
bool contracted_rounds_products(double /*scalar*/) {
  return detail::rounds_products<double>();
}
bool contracted_rounds_each_operation(float /*scalar*/) {
  return rounds_each_operation<float>();
}
bool contracted_rounds_each_operation(double /*scalar*/) {
  return rounds_each_operation<double>();
}

}  // namespace batuta::test
