#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""fill_page.py puts blocks where they belong, and says where a page and its frame have not the same ones."""

import pathlib
import subprocess
import sys
import tempfile

TOOL = pathlib.Path(__file__).with_name("fill_page.py")
PAGE = "# Title\n\n```cpp\nint a;\n```\n\n```sh\nls\n```\n\n```cpp\nint b;\n```\n"


def filled(folder, frame):
    """(exit code, what was written) for a frame."""
    page, outline, output = folder / "page.md", folder / "page.cpp.in", folder / "page.cpp"
    page.write_text(PAGE, encoding="utf-8")
    outline.write_text(frame, encoding="utf-8")
    output.unlink(missing_ok=True)
    words = [sys.executable, "-B", str(TOOL), str(page), str(outline), str(output)]
    done = subprocess.run(words, stderr=subprocess.DEVNULL, check=False)
    return done.returncode, output.read_text(encoding="utf-8") if output.exists() else ""


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        code, text = filled(folder, "int before;\n// block 2\n// block 1\nint after;\n")
        lines = [line.split(' "')[0] for line in text.splitlines()]
        assert code == 0 and lines == ["int before;", "#line 12", "int b;", "#line 3", "#line 4", "int a;", "#line 4",
                                       "int after;"], text
        for frame in ("// block 1\n", "// block 1\n// block 2\n// block 2\n", "// block 1\n// block 2\n// block 3\n", ""):
            assert filled(folder, frame) == (1, ""), frame
    return 0


if __name__ == "__main__":
    sys.exit(main())
