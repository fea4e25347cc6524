// SPDX-License-Identifier: MIT
#pragma once
// The probe as two files see it: one with -ffp-contract=fast, and one that no flag was given to.

namespace batuta::test {

/// Whether this processor has the instructions of that file.
bool can_run_contracted();

bool contracted_rounds_products(float scalar);
bool contracted_rounds_products(double scalar);
bool contracted_rounds_each_operation(float scalar);
bool contracted_rounds_each_operation(double scalar);

/// In the file that leaves it to the library's headers; and a sum of products by Eigen there.
bool unflagged_rounds_each_operation();
bool unflagged_rounds_dot_products();

}  // namespace batuta::test
