// SPDX-License-Identifier: MIT
#include "shared/firmware/application_definitions.hpp"

namespace batuta::firmware {

template class ApplicationOf<NoRival>;

}  // namespace batuta::firmware
