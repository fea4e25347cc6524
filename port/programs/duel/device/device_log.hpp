// SPDX-License-Identifier: MIT
#pragma once
// What a session with a device came to: for people and for programs.

#include <cstdio>

#include "programs/duel/device/device_partner.hpp"

namespace batuta::host {

/// Some lines that begin with "device" and "link".
void print_device(std::FILE* out, const DevicePartner& partner);

/// One JSON object of the type "link".
void print_device_json(std::FILE* out, const DevicePartner& partner);

}  // namespace batuta::host
