#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs the Debian packages that the work on batuta needs. May be repeated: only what is missing is fetched.
#   sh toolchains/setup.sh [duel|host|target|packages|all|web|kernel]     default: host
# Exit codes: 0 everything is there, 1 it could not be installed, 2 wrong use.
set -u

# What batuta-duel is built with; with the window of --view, which is SDL's.
DUEL_PACKAGES="g++ cmake ninja-build pkg-config libeigen3-dev libevdev-dev libevemu-dev libsdl2-dev libcli11-dev nlohmann-json3-dev"
HOST_PACKAGES="$DUEL_PACKAGES libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev \
xvfb gnuplot-nox valgrind libbullet-dev libfcl-dev libode-dev libccd-dev \
cppcheck clang clang-tidy clang-format libclang-rt-dev gcovr doxygen doxygen-awesome-css make python3 git"
TARGET_PACKAGES="gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib qemu-system-arm qemu-user \
g++-aarch64-linux-gnu g++-arm-linux-gnueabihf g++-riscv64-linux-gnu"
# What archives for registries are made with and tested by; a cross compiler for Windows with its emulator, and Python's numbers.
PACKAGES_PACKAGES="g++ cmake ninja-build libeigen3-dev make dpkg-dev lintian arduino-builder arduino-ctags \
gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib python3 python3-yaml python3-kconfiglib \
python3-numpy python3-pip python3-setuptools python3-wheel g++-mingw-w64-x86-64-posix wine wine64"
# What the page in the browser is built with, and the browser of its tests. Debian's npm comes only where there is no other.
WEB_PACKAGES="g++ cmake ninja-build libeigen3-dev python3 emscripten nodejs chromium"
WEB_MODULES="port/platforms/web"  # holds package.json and its lock; the modules go to build/node
# What Linux's own driver is booted with, and the stick plugged into it.
KERNEL_PACKAGES="g++ cmake ninja-build pkg-config libeigen3-dev libgtest-dev libgmock-dev librapidcheck-dev python3 \
qemu-system-x86 busybox-static cpio libusbredirparser-dev libsdl2-2.0-0"

say() { printf '%s\n' "setup: $*"; }
fail() { printf '%s\n' "setup: $*" >&2; exit 1; }

usage() {
  cat <<'USAGE'
usage: sh toolchains/setup.sh [duel|host|target|packages|all|web|kernel]
  duel    what the preset duel needs: compiler, CMake, Eigen, libraries for devices and the window; no tests
  host    compiler, CMake, libraries, test and analysis tools (default)
  target  cross compilers and emulators: Cortex-M boards; AArch64, ARMv7 and RISC-V for the same bits
  packages  what makes and tests archives for registries: lintian, Arduino's builder, Kconfig, Python, a compiler for Windows
  all     host and target
  web     emscripten, Chromium, and the modules of port/platforms/web/package-lock.json from npm into build/node
  kernel  an emulator of a PC; Debian's kernel with its modules for USB, and SDL's haptic test, into build/kernel: neither is installed
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

# The modules that the lock file names, with their check sums; no script of theirs is run.
install_modules() {
  root=$(cd "$(dirname "$0")/.." && pwd) || fail "where is this script?"
  if cmp -s "$root/$WEB_MODULES/package-lock.json" "$root/build/node/package-lock.json" &&
    [ -d "$root/build/node/node_modules" ]; then
    say "the modules for 'web' are in build/node"
    return
  fi
  mkdir -p "$root/build/node" && cp "$root/$WEB_MODULES/package.json" "$root/build/node/" || fail "build/node cannot be written"
  cp "$root/$WEB_MODULES/package-lock.json" "$root/build/node/lock" || fail "build/node cannot be written"
  mv "$root/build/node/lock" "$root/build/node/package-lock.json"
  npm ci --prefix "$root/build/node" --ignore-scripts --no-audit --no-fund ||
    { rm -f "$root/build/node/package-lock.json"; fail "npm could not install the modules (is there a network?)"; }
}

download_kernel() {
  name=$(apt-cache depends linux-image-amd64 | sed -n 's/^ *Depends: \(linux-image-[0-9].*\)/\1/p' | head -n 1)
  rm -f linux-image-*.deb
  [ -n "$name" ] && apt-get download -q "$name"
}

# Debian's present kernel: what an emulator boots, and of its modules those that USB and its sticks may need.
unpack_kernel() {
  root=$(cd "$(dirname "$0")/.." && pwd) || fail "where is this script?"
  if [ -f "$root/build/kernel/package" ]; then
    say "the kernel is in build/kernel: $(cat "$root/build/kernel/package")"
    return
  fi
  mkdir -p "$root/build/kernel" && cd "$root/build/kernel" || fail "build/kernel cannot be written"
  if ! download_kernel; then  # the list may name what the mirror has replaced
    as_root apt-get update -q
    download_kernel || fail "could not fetch the kernel that linux-image-amd64 names (is there a network, and is this Debian for amd64?)"
  fi
  dpkg-deb --fsys-tarfile linux-image-*.deb | tar -x --wildcards '*/boot/vmlinuz-*' '*/drivers/usb/*' '*/drivers/hid/*' '*/drivers/input/*' ||
    fail "could not unpack the kernel"
  ls linux-image-*.deb >package && rm -f linux-image-*.deb
}

# A program of SDL's that plays effects. The package asks for a window's libraries, which this program has no use for.
unpack_haptic_test() {
  cd "$root/build/kernel" || fail "build/kernel is missing"
  [ ! -d usr ] || return 0
  apt-get download -q libsdl2-tests || fail "could not fetch SDL's haptic test (is there a network?)"
  dpkg-deb --fsys-tarfile libsdl2-tests_*.deb | tar -x --wildcards '*/testhaptic' || fail "could not unpack SDL's haptic test"
  rm -f libsdl2-tests_*.deb
}

[ $# -le 1 ] || { usage >&2; exit 2; }
case "${1-host}" in
  duel) packages=$DUEL_PACKAGES ;;
  host) packages=$HOST_PACKAGES ;;
  target) packages=$TARGET_PACKAGES ;;
  packages) packages=$PACKAGES_PACKAGES ;;
  all) packages="$HOST_PACKAGES $TARGET_PACKAGES" ;;
  web)
    packages=$WEB_PACKAGES
    command -v npm >/dev/null 2>&1 || packages="$packages npm"
    ;;
  kernel) packages=$KERNEL_PACKAGES ;;
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
else
  say "installing:$missing"
  install "$missing"
  for package in $missing; do
    is_installed "$package" || fail "$package is still missing"
  done
fi
[ "${1-host}" != web ] || install_modules
if [ "${1-host}" = kernel ]; then
  unpack_kernel
  unpack_haptic_test
fi
say "done"
