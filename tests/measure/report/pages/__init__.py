# SPDX-License-Identifier: MIT
"""Pages of the report: a module for each section, with TITLE, FILES (what it reads) and page(tables, folder), which draws
into the folder and returns Markdown."""
