#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Linux's own driver plays effects on the stick: an emulator boots a kernel with batuta_kernel_guest as its program and
batuta_kernel_device as what is plugged in. Prints each check; exit status 0 where every check that there is was made and
held. Usage: boot.py KERNEL DEVICE GUEST [PROGRAM]; KERNEL is what `toolchains/setup.sh kernel` unpacks, PROGRAM is SDL's
haptic test, which GUEST starts."""

import collections
import lzma
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

# How many checks each group has: one that is not made is missed.
CHECKS = {"capabilities": 18, "position": 5, "constant": 29, "ramp": 12, "sine": 10, "square": 10, "triangle": 10, "saw up": 10,
          "saw down": 10, "envelope": 24, "times": 11, "change": 16, "spring": 43, "damper": 8, "friction": 8, "inertia": 8,
          "gain": 10, "rumble": 3, "together": 10, "pool": 18, "end of a program": 5, "plug": 11, "reports": 1}
# The same where SDL plays: nine effects, each looked at twice.
CHECKS_OF_SDL = {"SDL": 1 + 2 * 9 + 4}
MODULES = ["xhci_pci", "usbhid", "hid_generic", "evdev"]
WORDS = ["Force feedback for USB HID PID devices"]
TROUBLE = re.compile(r"\bBUG:|\bOops|Call Trace|Kernel panic|WARNING: CPU|UBSAN|KASAN")
# What SDL opens when it runs, beside what it is linked with.
OPENED = ["libudev.so.1"]
# Of the emulator's own processor time: it ends no run because the machine is busy.
PROCESSOR_SECONDS = 600
# For the emulator to notice that its device has gone, and the other way round: no more than a failing test waits for.
GRACE_SECONDS = 60
QEMU = ["qemu-system-x86_64", "-accel", "tcg", "-machine", "q35", "-cpu", "max", "-m", "256", "-nodefaults", "-no-user-config",
        "-display", "none", "-no-reboot", "-device", "qemu-xhci", "-device", "usb-redir,chardev=usb", "-serial", "stdio",
        "-serial", "chardev:line"]
WORDS_FOR_KERNEL = "console=ttyS0 loglevel=1 oops=panic panic=-1"


def fail(what):
    sys.exit(f"FAILED: {what}")


def module_bytes(path):
    return lzma.decompress(path.read_bytes()) if path.suffix == ".xz" else path.read_bytes()


def modules_of(kernel, names):
    """Files of these modules and of those that they need, each behind what it needs: [(name, bytes)]."""
    files = {path.name.split(".ko")[0].replace("-", "_"): path for path in kernel.glob("**/*.ko*")}
    found = {}

    def add(name):
        if name in found:
            return
        if name not in files:
            fail(f"the kernel has no module {name}")
        content = module_bytes(files[name])
        for needed in re.search(rb"\0depends=([^\0]*)\0", content).group(1).decode().split(","):
            if needed:
                add(needed.replace("-", "_"))
        found[name] = content

    for name in names:
        add(name)
    return found.items()


def libraries_of(program):
    """Files that a program and OPENED are linked with, the loader among them."""
    known = subprocess.run(["ldconfig", "-p"], stdout=subprocess.PIPE, text=True, check=True).stdout
    opened = [path for name in OPENED for path in re.findall(rf"^\t{re.escape(name)} \(.*x86-64.*\) => (\S+)$", known, re.M)[:1]]
    said = [subprocess.run(["ldd", file], stdout=subprocess.PIPE, text=True, check=True).stdout for file in (program, *opened)]
    return {pathlib.Path(path) for path in [*opened, *re.findall(r"(/\S+) \(0x", "".join(said))]}


def pack_program(program, root):
    shutil.copy(program, root / "program")
    for path in libraries_of(program):
        place = root / path.relative_to("/")
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, place)


def pack(kernel, guest, program, folder):
    """The first file system: busybox, the modules, the program, and what it starts."""
    root = folder / "root"
    for name in ("bin", "dev", "modules"):
        (root / name).mkdir(parents=True)
    shutil.copy(shutil.which("busybox"), root / "bin/busybox")
    shutil.copy(pathlib.Path(__file__).with_name("init"), root / "init")
    (root / "init").chmod(0o755)
    shutil.copy(guest, root / "guest")
    if program:
        pack_program(program, root)
    order = []
    for name, content in modules_of(kernel, MODULES):
        (root / "modules" / name).write_bytes(content)
        order.append(name)
    (root / "modules/order").write_text("\n".join(order), encoding="ascii")
    names = [str(path.relative_to(root)) for path in sorted(root.rglob("*"))]
    packed = subprocess.run(["cpio", "--create", "--format=newc", "--quiet"], cwd=root, input="\n".join(names).encode(),
                            stdout=subprocess.PIPE, check=True).stdout
    (folder / "initramfs").write_bytes(packed)


def limit_processor_time():
    resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_SECONDS, PROCESSOR_SECONDS))


def start(command, **more):
    return subprocess.Popen(command, stdin=subprocess.DEVNULL, preexec_fn=limit_processor_time, **more)


def boot(kernel, device, folder):
    """What the emulated machine says, and what is wrong with how emulator and device ended."""
    image = next(iter(sorted(kernel.glob("boot/vmlinuz-*"))), None) or fail(f"no kernel in {kernel}")
    sockets = [word for name in ("usb", "line") for word in ("-chardev", f"socket,id={name},path={folder}/{name}")]
    said = folder / "said"
    with start([device, folder], stdout=subprocess.PIPE, text=True) as stick, said.open("wb") as file:
        if stick.stdout.readline() != "ready\n":
            fail("the device did not start")
        with start([*QEMU, *sockets, "-kernel", image, "-initrd", folder / "initramfs", "-append", WORDS_FOR_KERNEL],
                   stdout=file) as machine:
            while machine.poll() is None and stick.poll() is None:
                time.sleep(0.1)
            # Where one ends, the other one has nothing to wait for.
            for process in (machine, stick):
                try:
                    process.wait(GRACE_SECONDS)
                except subprocess.TimeoutExpired:
                    process.kill()
    wrong = [f"the {name} ended with {process.wait()}" for name, process in (("emulator", machine), ("device", stick))
             if process.wait() != 0]
    return said.read_text(errors="replace").replace("\r", ""), wrong


def judge(text, wanted):
    """What is wrong with what the machine said: [sentence]."""
    checks = re.findall(r"^(ok|WRONG) ([^:]+): ", text, re.M)
    made = collections.Counter(group for _, group in checks)
    wrong = [f"{group}: {made[group]} checks were made, not {count}" for group, count in wanted.items() if made[group] != count]
    wrong += [f"{group}: not in the list of checks" for group in made if group not in wanted]
    wrong += re.findall(r"^(?:WRONG|gave up).*", text, re.M)
    wrong += [f"not said: {words}" for words in ["the end\n", "the guest ended with 0\n", "the kernel has said it\n", *WORDS]
              if words not in text]
    return wrong + [line for line in text.splitlines() if TROUBLE.search(line)]


def main():
    kernel, device, guest, *program = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="batuta-kernel-") as name:
        folder = pathlib.Path(name)
        pack(kernel, guest, next(iter(program), None), folder)
        text, wrong = boot(kernel, device, folder)
    print(text)
    wrong += judge(text, CHECKS_OF_SDL if program else CHECKS)
    for sentence in wrong:
        print(f"FAILED: {sentence}")
    print(f"{len(re.findall('^ok ', text, re.M))} checks held, {time.monotonic() - began:.0f} s")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
