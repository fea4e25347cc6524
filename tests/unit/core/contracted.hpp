// SPDX-License-Identifier: MIT
#pragma once
// The probe as files compiled with -ffp-contract=fast see it: one that says that it is off, and one
// that does not.

namespace batuta::test {

/// Whether this processor has the instructions of that file.
bool can_run_contracted();

bool contracted_rounds_products(float scalar);
bool contracted_rounds_products(double scalar);
bool contracted_rounds_each_operation(float scalar);
bool contracted_rounds_each_operation(double scalar);

/// The same in a file that leaves it to the library's headers, and in a sum of products by Eigen.
bool unflagged_rounds_each_operation();
bool unflagged_rounds_dot_products();

}  // namespace batuta::test
