#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs the Debian packages that the work on batuta needs. May be repeated: only what is missing is fetched.
#   sh toolchains/setup.sh [host|target|all]     default: host
# Exit codes: 0 everything is there, 1 it could not be installed, 2 wrong use.
set -u

HOST_PACKAGES="g++ cmake ninja-build pkg-config libeigen3-dev libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev \
libevdev-dev libevemu-dev libsdl2-dev libcli11-dev gnuplot-nox libbullet-dev libfcl-dev libode-dev libccd-dev \
cppcheck clang clang-tidy clang-format libclang-rt-dev gcovr doxygen doxygen-awesome-css make python3 git"
TARGET_PACKAGES="gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib qemu-system-arm qemu-user \
g++-aarch64-linux-gnu g++-arm-linux-gnueabihf g++-riscv64-linux-gnu"

say() { printf '%s\n' "setup: $*"; }
fail() { printf '%s\n' "setup: $*" >&2; exit 1; }

usage() {
  cat <<'USAGE'
usage: sh toolchains/setup.sh [host|target|all]
  host    compiler, CMake, libraries, test and analysis tools (default)
  target  cross compilers and emulators: Cortex-M boards; AArch64, ARMv7 and RISC-V for the same bits
  all     both
USAGE
}

is_installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Runs a command as root: directly, or with sudo.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null 2>&1; then
    sudo "$@"
  else
    fail "needs root: run as root or install sudo"
  fi
}

install() {
  export DEBIAN_FRONTEND=noninteractive
  # Debian mirrors come and go for a moment; the list may also simply be fresh enough.
  as_root apt-get update -q || say "the package lists could not be renewed; trying with those at hand"
  # shellcheck disable=SC2086 # the list is meant to be split
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $1 ||
    fail "could not install:$1 (is there a network, and is this a Debian 12 or later?)"
}

[ $# -le 1 ] || { usage >&2; exit 2; }
case "${1-host}" in
  host) packages=$HOST_PACKAGES ;;
  target) packages=$TARGET_PACKAGES ;;
  all) packages="$HOST_PACKAGES $TARGET_PACKAGES" ;;
  -h | --help | help) usage; exit 0 ;;
  *) printf '%s\n' "setup: unknown word: $1" >&2; usage >&2; exit 2 ;;
esac

if ! command -v apt-get >/dev/null 2>&1 || ! command -v dpkg-query >/dev/null 2>&1; then
  fail "this is not a Debian system; install what corresponds to: $packages"
fi

missing=""
for package in $packages; do
  is_installed "$package" || missing="$missing $package"
done
if [ -z "$missing" ]; then
  say "everything for '${1-host}' is installed"
  exit 0
fi
say "installing:$missing"
install "$missing"
for package in $missing; do
  is_installed "$package" || fail "$package is still missing"
done
say "done"
