#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""docs/c.md shows the program that is compiled, and what it prints. Usage: page_test.py SOURCE PROGRAM"""

import pathlib
import re
import subprocess
import sys

source, program = pathlib.Path(sys.argv[1]), sys.argv[2]
page = (source / "docs/c.md").read_text(encoding="utf-8")
shown = re.search(r"<!-- begin example (\S+) -->\n```c\n(.*?)```\n<!-- end -->", page, re.S)
if not shown or shown.group(2) != (source / shown.group(1)).read_text(encoding="utf-8"):
    sys.exit("docs/c.md: the program is not that of its file")
printed = subprocess.run([program], capture_output=True, text=True, check=True).stdout
if f"```text\n{printed}```\n" not in page:
    sys.exit(f"docs/c.md: the program prints something else:\n{printed}")
