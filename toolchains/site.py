#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the site: pages, derivation notes and the reference of the interface in one tree, by Doxygen.
Usage: site.py SOURCE_FOLDER OUTPUT_FOLDER [VERSION]
An undocumented public member, a broken link and a broken reference are errors: exit code 1, each with its place.
77: Doxygen or its style sheet is not installed (toolchains/setup.sh)."""

import html.parser
import pathlib
import shutil
import subprocess
import sys
import urllib.parse
import xml.etree.ElementTree as ElementTree

import site_stage

SKIPPED = 77
KINDS = ["class", "struct", "namespace", "file"]  # what public things stand in
AWESOME = pathlib.Path("/usr/share/doxygen-awesome-css")


def run_doxygen(source, stage, out, version):
    """Doxygen's messages about the copy in `stage`, with the places of the repository."""
    text = (source / "docs/Doxyfile.in").read_text(encoding="utf-8")
    for name, value in {"SOURCE": stage, "OUT": out, "VERSION": version, "AWESOME": AWESOME}.items():
        text = text.replace(f"@{name}@", str(value))
    done = subprocess.run(["doxygen", "-"], input=text, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          cwd=source, check=False)
    lines = dict.fromkeys(done.stdout.replace(f"{stage}/", "").splitlines())  # it says some things twice
    return done.returncode, "".join(f"{line}\n" for line in lines)


def is_described(node):
    return any("".join(node.find(kind).itertext()).strip() for kind in ("briefdescription", "detaileddescription"))


def undescribed(xml):
    """(how many public things there are, those without a word): Doxygen 1.9.4 says nothing of enum values."""
    count, bare = 0, []
    for file in sorted(xml.glob("*.xml")):
        for compound in ElementTree.parse(file).getroot().iter("compounddef"):
            machinery = compound.findtext("compoundname").startswith("batuta::detail")
            if compound.get("kind") not in KINDS or compound.get("prot") == "private" or machinery:
                continue
            for node, name, where in public_things(compound):
                count += 1
                if not is_described(node):
                    bare.append(f"{place(where)}: error: {name} is public and not documented")
    return count, sorted(set(bare))


def public_things(compound):
    """(node, name, node that tells the place) of a compound and of all in it that a user can name."""
    scope = compound.findtext("compoundname")
    if compound.get("kind") in ("class", "struct"):
        yield compound, scope, compound
    for member in compound.iter("memberdef"):
        if member.get("prot") != "public" or is_said_elsewhere(member):
            continue
        name = f"{scope}::{member.findtext('name')}"
        yield member, name, member
        for value in member.iter("enumvalue"):
            yield value, f"{name}::{value.findtext('name')}", member


def is_said_elsewhere(member):
    """What the compiler is only told not to make, or makes as always; a class that may look inside."""
    arguments = member.findtext("argsstring") or ""
    return arguments.endswith(("=delete", "=default")) or (member.findtext("type") or "").endswith("class")


def place(node):
    location = node.find("location")
    return "?" if location is None else f"{location.get('file')}:{location.get('line')}"


class Links(html.parser.HTMLParser):
    """Targets and anchors of a page."""

    def __init__(self):
        super().__init__()
        self.targets, self.anchors = set(), set()

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name in ("href", "src") and value:
                self.targets.add(value)
            elif name in ("id", "name") and value:
                self.anchors.add(value)


def mend(folder):
    """Doxygen 1.9.4 links to a list of nested classes also where these are private, and so not listed."""
    dead = '<a href="#nested-classes">Classes</a> &#124;'
    for page in folder.glob("*.html"):
        text = page.read_text(encoding="utf-8")
        if dead in text and 'name="nested-classes"' not in text:
            page.write_text(text.replace(dead, ""), encoding="utf-8")


def broken_links(folder):
    """Links of the site's pages to files or anchors that are not there."""
    pages = {}
    for page in folder.rglob("*.html"):
        pages[page.resolve()] = Links()
        pages[page.resolve()].feed(page.read_text(encoding="utf-8", errors="replace"))
    for page, links in sorted(pages.items()):
        for target in sorted(links.targets):
            parts = urllib.parse.urlsplit(target)
            if parts.scheme or parts.netloc:
                continue
            file = (page.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else page
            anchor = urllib.parse.unquote(parts.fragment)
            if not file.exists() or (anchor and file in pages and anchor not in pages[file].anchors):
                yield f"{page.name}: error: broken link: {target}"


def main():
    if shutil.which("doxygen") is None or not AWESOME.is_dir():
        print("site: doxygen or doxygen-awesome-css is not installed; sh toolchains/setup.sh host installs both")
        return SKIPPED
    source, out = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    version = sys.argv[3] if len(sys.argv) > 3 else ""
    stage, xml = out.with_name(out.name + "-source"), out.with_name(out.name + "-xml")
    for folder in (stage, xml, out):
        shutil.rmtree(folder, ignore_errors=True)
    out.mkdir(parents=True)
    copy = site_stage.Stage(source, stage, out)
    copy.fill()
    code, messages = run_doxygen(source, stage, out, version)
    mend(out)
    count, bare = undescribed(xml)
    faults = copy.faults + bare + list(broken_links(out))
    sys.stdout.write(messages + "".join(fault + "\n" for fault in faults))
    if code != 0 or faults or count == 0:
        print(f"site: not made: {len(faults) + len(messages.splitlines())} faults", file=sys.stderr)
        return 1
    print(f"site: {len(list(out.glob('*.html')))} pages, {count} of {count} public things documented: {out}/index.html")
    return 0


if __name__ == "__main__":
    sys.exit(main())
