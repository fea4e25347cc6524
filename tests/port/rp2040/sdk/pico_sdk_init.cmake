# SPDX-License-Identifier: MIT
# Stands for the Pico SDK as far as its beginning: tells where TinyUSB would be taken from, and ends there.
macro(pico_sdk_init)
  message(FATAL_ERROR "TinyUSB of the SDK is <${PICO_TINYUSB_PATH}>")
endmacro()
