// SPDX-License-Identifier: MIT
#pragma once

namespace batuta::digest {

/// The probe as a file compiled with -ffp-contract=fast sees it.
bool contracted_rounds_each_operation();

}  // namespace batuta::digest
