# SPDX-License-Identifier: MIT
"""Worst-case stack: the longest path through the call graph, interrupts on top. Recursion, an indirect call whose
targets nobody stated, and a frame without a bound are findings, each with its place."""

import collections
import fnmatch

Path = collections.namedtuple("Path", "bytes steps")  # steps: (readable name, frame), from the root
Rule = collections.namedtuple("Rule", "kind pattern targets")

NOWHERE = "-"

# What an exception pushes: 8 words, 18 more where there is an FPU, and up to 4 bytes to align.
EXCEPTION_FRAME = {False: 36, True: 108}


def read_rules(path):
    """Lines "call CALLER_GLOB -> TARGET_GLOB | TARGET_GLOB" and "interrupt NAME LEVEL"; see call_rules.txt."""
    rules = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.split("#")[0].strip()
        if not line:
            continue
        kind, _, rest = line.partition(" ")
        if kind == "call" and " -> " in rest:
            caller, targets = rest.split(" -> ")
            rules.append(Rule(kind, caller.strip(), [target.strip() for target in targets.split("|")]))
        elif kind == "interrupt" and len(rest.split()) == 2:
            rules.append(Rule(kind, rest.split()[0], int(rest.split()[1])))
        else:
            raise ValueError(f"{path.name}:{number}: '{line}' is neither 'call A -> B' nor 'interrupt NAME LEVEL'")
    return rules


class WorstCase:
    """Longest paths of one graph under some rules; findings collects what makes them worthless."""

    def __init__(self, graph, rules):
        self.graph = graph
        self.rules = rules
        self.findings = {(target, "call graph"): f"no call graph: {target}: compile it with -fcallgraph-info=su,da"
                         for target in sorted(graph.uncompiled)}
        self._paths = {}
        self._open = []

    def of(self, name):
        """The longest path from a function by its linker name."""
        return self._longest(self.graph.by_name[name])

    def has(self, name):
        return self.graph.by_name.get(name) in self.graph.functions

    def is_handled(self, name):
        """Whether the program itself defines a handler: the ports' own are weak, and end it."""
        return self.has(name) and name in self.graph.strong

    def with_interrupts(self, name, has_fpu):
        """The same with one handler of every level on top, and what makes up the sum."""
        parts = [("thread", self.of(name))]
        if self.graph.by_name["main"] not in self._paths:
            self.findings[name, "main"] = f"lost calls: no way from {name} to main is seen"
        levels = collections.defaultdict(list)
        for rule in self.rules:
            if rule.kind == "interrupt" and self.is_handled(rule.pattern):
                levels[rule.targets].append((rule.pattern, self.of(rule.pattern)))
        for level in sorted(levels):
            handler, path = max(levels[level], key=lambda pair: pair[1].bytes)
            parts.append((handler, Path(path.bytes + EXCEPTION_FRAME[has_fpu], path.steps)))
        return sum(path.bytes for _, path in parts), parts

    def compare(self, what, depth, symbol):
        """A finding where the linker script reserves less than this depth; the size is an absolute symbol of it."""
        reserved = self.graph.constants.get(symbol)
        if reserved is None:
            self.findings[what, symbol] = f"reserved stack: {what}: the image has no {symbol}"
        elif depth > reserved:
            self.findings[what, symbol] = f"reserved stack: {what}: {depth:,} B deep, {symbol} is {reserved:,} B"

    def _longest(self, address):
        if address in self._paths:
            return self._paths[address]
        function = self.graph.functions[address]
        if address in self._open:
            self._report(function, "recursion", " -> ".join(
                self.graph.functions[a].readable for a in self._open[self._open.index(address):] + [address]))
            return Path(0, ())
        self._open.append(address)
        if function.unbounded:
            self._report(function, "unbounded frame", function.unbounded)
        below = [self._longest(callee) for callee in sorted(function.calls | self._targets(function))]
        deepest = max(below, key=lambda path: path.bytes, default=Path(0, ()))
        self._open.pop()
        path = Path(function.frame + deepest.bytes, ((function.readable, function.frame),) + deepest.steps)
        self._paths[address] = path
        return path

    def _targets(self, function):
        """Where the indirect calls of a function may go, by the rules."""
        if not function.indirect:
            return set()
        rules = [rule for rule in self.rules if rule.kind == "call"]
        globs = [glob for rule in rules for glob in rule.targets
                 if fnmatch.fnmatchcase(function.readable, rule.pattern)]
        found = {address for address, other in self.graph.functions.items()
                 if any(fnmatch.fnmatchcase(other.readable, glob) for glob in globs)}
        if not found and NOWHERE not in globs:
            self._report(function, "unknown indirect call", ", ".join(function.indirect))
        return found

    def _report(self, function, kind, detail):
        self.findings[function.readable, kind] = f"{kind}: {function.readable}: {detail}"
