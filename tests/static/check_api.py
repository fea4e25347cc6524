#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The names of the interface, and names that it has left behind. Usage:
  check_api.py list FOLDER            prints what the headers declare in the public namespaces: namespace, kind, name, header
  check_api.py listed FOLDER          holds that against tests/static/api.txt, so that a change of the API shows in a diff
  check_api.py listed FOLDER --update writes api.txt
  check_api.py left FOLDER            finds words that were replaced by the field's own (OLD_NAMES)
Prints one line a finding; exit code 1: there are some."""

import pathlib
import re
import sys

from check_source import code_only, sources

LIST = "tests/static/api.txt"
FLAT, MOST_FLAT = "batuta", 220  # names directly in the library's namespace
NAMESPACE = re.compile(r"(?:inline )?namespace\s*([\w:]*)\s*$")
TYPE = re.compile(r"(struct|class|enum class|enum|union)\s+(?:\[\[[^\]]*\]\]\s*)*(\w+)")
ALIAS = re.compile(r"using\s+(\w+)\s*=")


def without_template(head):
    """A declaration without the template lines in front of it."""
    while head.startswith("template"):
        depth = parentheses = 0  # "<" and ">" in parentheses compare
        for at, character in enumerate(head):
            parentheses += (character == "(") - (character == ")")
            depth += (character == "<" and not parentheses) - (character == ">" and not parentheses)
            if character == ">" and not parentheses and depth == 0:
                break
        head = head[at + 1:].strip()
    return head


def declared(head):
    """(kind, name) of a declaration at namespace scope, up to its body, its initialiser or its semicolon; None: it declares
    nothing new."""
    head = without_template(" ".join(head.split()))
    for pattern in (TYPE, ALIAS):
        match = pattern.match(head)
        if match:
            return ("alias", match.group(1)) if pattern is ALIAS else (match.group(1).split()[0], match.group(2))
    if not head or re.match(r"(?:template|using|static_assert|extern|friend|namespace|BATUTA_\w+)\b", head):
        return None
    if "operator" in head:
        return ("function", "operator" + re.match(r"\s*(\(\)|[^\s(]*)", head.split("operator", 1)[1]).group(1))
    if re.match(r"[^(]*\bstatic_cast\b", head):
        return None
    before, called, _ = head.partition("(")
    is_variable = "=" in before or not called
    name = re.search(r"([\w:]+)\s*(?:<[^<>]*>)?\s*(?:\[\w*\])?$", before.split("=")[0].strip())
    if not name or "::" in name.group(1):
        return None
    return ("variable" if is_variable else "function", name.group(1))


def declarations(text):
    """(namespace, kind, name) of what a header declares at the scope of a namespace."""
    code = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", "", code_only(text), flags=re.M)
    scopes, head, parentheses, initialised = [], "", 0, False
    for token in re.findall(r"[{}();]|[^{}();]+", code):
        at_namespace = all(scope is not None for scope in scopes)
        if initialised and at_namespace:  # behind the braces of a value
            initialised = token != ";"
            head = ""
        elif token in "()":
            parentheses += 1 if token == "(" else -1
            head += token
        elif parentheses:
            head += token
        elif token == "{":
            match = NAMESPACE.search(head)
            if match and at_namespace:
                scopes.append(match.group(1))
            else:
                if at_namespace and declared(head):
                    yield ("::".join(scopes), *declared(head))
                initialised = at_namespace and "=" in without_template(" ".join(head.split()))
                scopes.append(None)
            head = ""
        elif token == "}":
            scopes.pop()
            head = ""
        elif token == ";":
            if at_namespace and declared(head):
                yield ("::".join(scopes), *declared(head))
            head = ""
        else:
            head += token


def interface(root):
    """Lines of the list: each name once in a namespace, with the first header that declares it."""
    lines = {}
    base = root / "include" / "batuta"
    for path in sources(base):
        if "detail" in path.relative_to(base).parts:
            continue
        for namespace, kind, name in declarations(path.read_text()):
            if namespace.split("::")[0] == FLAT and "detail" not in namespace.split("::"):
                lines.setdefault((namespace, name), f"{namespace} {kind} {name} {path.relative_to(base)}")
    return [lines[key] for key in sorted(lines)]


def check_listed(root, update=False):
    """The list is what the headers declare, and the flat namespace is not too full."""
    lines, file = interface(root), root / LIST
    if update:
        file.write_text("\n".join(lines) + "\n")
    kept = [line for line in file.read_text().splitlines() if not line.startswith("//")] if file.is_file() else []
    findings = [f"{LIST} lacks: {line}" for line in lines if line not in kept]
    findings += [f"{LIST} has what is not declared: {line}" for line in kept if line not in lines]
    flat = sum(line.startswith(FLAT + " ") for line in lines)
    if flat > MOST_FLAT:
        findings.append(f"{flat} names directly in namespace {FLAT}; at most {MOST_FLAT}: what no user writes goes to detail")
    return findings


# The word that was left, where it is refused, and the field's word for it.
LIBRARY, CODE = ("include", "src"), ("include", "src", "port", "tests", "examples")
OLD_NAMES = [
    (r"[Ss]labs?|k\w*Slab|slab_\w+|\w+_slab", CODE, "contact tolerance"),
    (r"Drivers?|drivers?|\w+Driver|\w*driver_\w*", LIBRARY, "controller"),
    (r"AnyDriver|BladeDriver|Driven", CODE, "controller"),
    (r"Course\w*|courses?\w*", LIBRARY, "PlannedMotion, plan"),
    (r"courses_invalid", ("port", "tests", "examples"), "PlannedMotion, plans_invalid"),
    (r"Watch|WatchOrder|watches_?|EarliestSight|Sight", LIBRARY, "CandidatePair, PairQuery"),
    (r"Track|tracks_", LIBRARY, "BodyState"),
    (r"Matter|\w+Matter|MatterOf", CODE, "Kinematics"),
    (r"BodyPair", CODE, "ProxyPair"),
    (r"Party|parties|Encounter\w*|answer_contact|answers_invalid", LIBRARY, "ContactSide, Resolution, resolve_contact"),
    (r"Tally|Seat|seat_for", LIBRARY, "DuelReport, FencerSetup"),
    (r"Walk|WalkEnd|Glide|walk_on|glide_on", LIBRARY, "AdvancementSearch, TranslationSearch, Iterator"),
    (r"b_W", CODE, "angular_W"),
    (r"told_?", LIBRARY, "last_command"),
    (r"charge|bring|let_go|tell_driver", LIBRARY, "apply_separation_time, advance, search_thinner, notify_controller"),
    (r"answer_?|SphereAnswer", LIBRARY, "resolve, result"),
    (r"LeanWorld|kIsLean", CODE, "SmallWorld, Engine::kSmall"),
]
# p_W is a position: of a momentum it would be the linear part.
MOMENTUM_AS_POSITION = re.compile(r"\bmomentum\.p_W\b")
# Where a word that was left stands for something else.
ELSEWHERE = re.compile(r"tests/(?:port|static|target/stm32f405)/")


def check_left(root):
    """Code, not comments, that still has a word on the old list."""
    findings = []
    patterns = [(re.compile(rf"(?<![\w])(?:{words})(?![\w])"), folders, better) for words, folders, better in OLD_NAMES]
    for folder in CODE:
        for path in sources(root / folder):
            name = path.relative_to(root).as_posix()
            if ELSEWHERE.match(name):
                continue
            for number, line in enumerate(code_only(path.read_text()).splitlines(), 1):
                if line.lstrip().startswith("#"):
                    continue
                for pattern, folders, better in patterns:
                    match = folder in folders and pattern.search(line)
                    if match:
                        findings.append(f"{name}:{number}: '{match.group(0)}' was left; say {better}")
                if MOMENTUM_AS_POSITION.search(line):
                    findings.append(f"{name}:{number}: p_W is a position; a momentum has linear_W")
    return findings


def main(words):
    check, root = words[0], pathlib.Path(words[1])
    if check == "list":
        print("\n".join(interface(root)))
        return 0
    findings = check_left(root) if check == "left" else check_listed(root, "--update" in words)
    for finding in findings:
        print(finding)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
