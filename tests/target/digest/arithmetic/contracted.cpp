// SPDX-License-Identifier: MIT
// Compiled with -ffp-contract=fast, after the project's own flags.
#include "contracted.hpp"

#include "batuta/core/arithmetic.hpp"

namespace batuta::digest {

bool contracted_rounds_each_operation() {
  return rounds_each_operation<float>();
}

}  // namespace batuta::digest
