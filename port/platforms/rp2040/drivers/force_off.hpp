// SPDX-License-Identifier: MIT
#pragma once
// The force's end, from whatever context: needs no object and no interrupt.

namespace batuta::rp2040 {

/// All force pins low. Bound: 4. ISR-safe: yes.
void force_off();

}  // namespace batuta::rp2040
