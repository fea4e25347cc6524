// SPDX-License-Identifier: MIT
// The application whose other side an opponent plays: a file of its own, which nobody links who
// does not name it.
#include "shared/firmware/application_definitions.hpp"
#include "shared/firmware/seeing_rival.hpp"

namespace batuta::firmware {

template class ApplicationOf<SeeingRival>;

}  // namespace batuta::firmware
