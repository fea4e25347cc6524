// SPDX-License-Identifier: MIT
#pragma once
// The probe as a file compiled with -ffp-contract=fast sees it.

namespace batuta::test {

/// Whether this processor has the instructions of that file.
bool can_run_contracted();

bool contracted_rounds_products(float scalar);
bool contracted_rounds_products(double scalar);
bool contracted_rounds_each_operation(float scalar);
bool contracted_rounds_each_operation(double scalar);

}  // namespace batuta::test
