#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs a Cortex-M program in QEMU; its exit status is the program's. Used as CMAKE_CROSSCOMPILING_EMULATOR.
#   emulate.sh MACHINE PROGRAM [ARGUMENT...]
# The program gets its path and ARGUMENTs as one line, blanks between them (semihosting SYS_GET_CMDLINE).
# BATUTA_QEMU_OPTIONS: further options of QEMU, for instance "-icount shift=10" or "-serial pty".
set -eu

machine=$1
program=$2
shift 2

# QEMU's option parser ends a value at a comma; two commas are one.
escape() { printf '%s' "$1" | sed 's/,/,,/g'; }

config="enable=on,target=native,arg=$(escape "$program")"
for argument in "$@"; do
  config="$config,arg=$(escape "$argument")"
done

# shellcheck disable=SC2086 # the options are meant to be split
exec qemu-system-arm -machine "$machine" -display none -monitor none \
  -semihosting-config "$config" ${BATUTA_QEMU_OPTIONS-} -kernel "$program" </dev/null
