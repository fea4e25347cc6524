// SPDX-License-Identifier: MIT

#include "shared/usb_stick/descriptors.hpp"

namespace batuta::usb {
namespace {

const char* text_of(const Identity& identity, int index) {
  switch (index) {
    case kManufacturer:
      return identity.manufacturer;
    case kProductName:
      return identity.product;
    case kSerial:
      return identity.serial;
    default:
      return nullptr;
  }
}

std::uint16_t head_of(std::size_t letters) {
  return static_cast<std::uint16_t>((descriptor::kStringType << 8U) | (2U * letters + 2U));
}

}  // namespace

bool write_string(const Identity& identity, int index, StringDescriptor& descriptor) {
  if (index == kLanguages) {
    descriptor[1] = kEnglish;
    descriptor[0] = head_of(1);
    return true;
  }
  const char* const text = text_of(identity, index);
  if (text == nullptr) return false;
  std::size_t letters = 0;
  while (letters + 1 < descriptor.size() && text[letters] != '\0') {  // Bound: kLongestString
    descriptor[letters + 1] = static_cast<unsigned char>(text[letters]);
    ++letters;
  }
  descriptor[0] = head_of(letters);
  return true;
}

}  // namespace batuta::usb
