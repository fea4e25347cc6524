# SPDX-License-Identifier: MIT
"""The call graph of a linked image. Frames and indirect calls are the compiler's own (-fcallgraph-info=su,da); what it
does not know (assembly, libc, libgcc) is read from the disassembly, and so are the calls of the linked code."""

import collections
import re

NODE = re.compile(r'^node: \{ title: "([^"]+)" label: "((?:[^"\\]|\\.)*)"')
EDGE = re.compile(r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"(?: label: "([^"]*)")?')
FRAME = re.compile(r"(\d+) bytes \(([^)]+)\)")
HEAD = re.compile(r"^([0-9a-f]+) <([^>]+)>:$")
INSTRUCTION = re.compile(r"^\s*([0-9a-f]+):\t(\S+)\s*([^@;]*)")
TARGET = re.compile(r"\b([0-9a-f]+) <([^>+]+)>")
INDIRECT = "__indirect_call"

Compiled = collections.namedtuple("Compiled", "frame kind readable calls indirect")


class Function:
    """One function of the image."""

    def __init__(self, name, address):
        self.name = name
        self.address = address
        self.readable = name
        self.frame = 0
        self.known = False  # by the compiler
        self.unbounded = ""  # why, if it is
        self.calls = set()  # addresses
        self.indirect = []  # where
        self.object = ""


def read_ci(path):
    """name -> Compiled of one .ci file; local functions by their own name."""
    nodes, calls, indirect = {}, collections.defaultdict(set), collections.defaultdict(list)
    for line in path.read_text(errors="replace").splitlines():
        node, edge = NODE.match(line), EDGE.match(line)
        if node:
            nodes[node.group(1)] = node.group(2)
        elif edge and edge.group(2) == INDIRECT:
            indirect[edge.group(1)].append((edge.group(3) or "?").rsplit("/", 1)[-1])
        elif edge:
            calls[edge.group(1)].add(local_name(edge.group(2)))
    found = {}
    for title, label in nodes.items():
        frame = FRAME.search(label)
        if frame:
            found[local_name(title)] = Compiled(int(frame.group(1)), frame.group(2), label.split("\\n")[0],
                                                calls[title], indirect[title])
    return found


def local_name(title):
    return title.rsplit(":", 1)[-1]


def registers(operands):
    """Bytes of a register list."""
    count = 0
    for part in re.search(r"\{([^}]*)\}", operands).group(1).split(","):
        ends = [re.sub(r"\D", "", word) for word in part.strip().split("-")]
        names = part.strip().split("-")
        span = int(ends[-1]) - int(ends[0]) + 1 if len(names) == 2 else 1
        count += span * (8 if names[0].startswith("d") else 4)
    return count


def grows_by(mnemonic, operands):
    """Bytes by which an instruction moves the stack pointer down; None: by a number that is not in it."""
    word = mnemonic.split(".")[0]
    if word in ("push", "vpush"):
        return registers(operands)
    if word in ("stmdb", "stmfd", "vstmdb") and operands.startswith("sp!"):
        return registers(operands)
    if word in ("sub", "subw", "subs") and re.match(r"sp\b", operands):
        amount = re.search(r"#(\d+)", operands)
        return int(amount.group(1)) if amount else None
    if word in ("add", "mov") and re.match(r"sp, (sp, )?(r\d+|ip|lr)", operands):
        return 0 if word == "mov" else None
    written_back = re.search(r"\[sp, #-(\d+)\]!", operands)
    return int(written_back.group(1)) if written_back else 0


class Disassembly:
    """Functions with what their instructions call and push."""

    def __init__(self, text):
        self.functions = {}  # address -> Function
        self.aliases = {}  # name -> address
        current, popped = None, ""
        for line in text.splitlines():
            head = HEAD.match(line)
            if head:
                address = int(head.group(1), 16)
                current = self.functions.setdefault(address, Function(head.group(2), address))
                self.aliases[head.group(2)] = address
                continue
            instruction = INSTRUCTION.match(line)
            if current and instruction:
                popped = self._step(current, instruction.group(2), instruction.group(3).strip(), popped)

    def _step(self, function, mnemonic, operands, popped):
        """@returns what a pop has just loaded, for "pop {r3}; bx r3" is a return"""
        word = mnemonic.split(".")[0]
        target = TARGET.search(operands)
        if word in ("bl", "blx", "b", "cbz", "cbnz") or re.fullmatch(r"b(eq|ne|cs|cc|mi|pl|hi|ls|ge|lt|gt|le)", word):
            if target and (word == "bl" or int(target.group(1), 16) != function.address):
                function.calls.add(int(target.group(1), 16))
            elif word == "blx":
                function.indirect.append(f"blx {operands}")
        if word == "bx" and operands not in ("lr", "pc") and operands not in popped:
            function.indirect.append(f"bx {operands}")
        growth = grows_by(mnemonic, operands)
        if growth is None:
            function.unbounded = f"{mnemonic} {operands}"
        function.frame += growth or 0
        return operands if word == "pop" else (popped if word in ("add", "mov") else "")


def object_key(path):
    """(CMake target, source file) of an object of the linker map, as its .ci file has it too."""
    member = re.search(r"lib([\w+-]+)\.a\(([^)]+)\)", path)
    if member:
        return member.group(1), re.sub(r"\.(obj|o)$", "", member.group(2))
    direct = re.search(r"([\w.+-]+)\.dir/(?:.*/)?([^/]+)\.(?:obj|o)$", path)
    return (direct.group(1), direct.group(2)) if direct else ("", path)


def compiled_files(tree):
    """(CMake target, source file) -> .ci files of a build tree: several where sources of a target share a name."""
    found = collections.defaultdict(list)
    for path in tree.rglob("*.ci"):
        match = re.search(r"([\w.+-]+)\.dir/", str(path))
        if match:
            name = re.sub(r"\.(obj|o)$", "", path.name[:-len(".ci")])
            found[match.group(1), name].append(path)
    return found


class CallGraph:
    """@param compiled  compiled_files() of the tree, and read so far"""

    def __init__(self, image, compiled):
        code = Disassembly(image.disassembly)
        self.functions = code.functions
        self.by_name = {symbol.name: symbol.address & ~1 for symbol in image.symbols if symbol.kind in "tTwWvV"}
        self.by_name.update(code.aliases)
        self.strong = {symbol.name for symbol in image.symbols if symbol.kind in "tT"}
        self.constants = {symbol.name: symbol.address for symbol in image.symbols if symbol.kind in "aA"}
        self._names_of_all(image)
        self._keep_calls_of_functions()
        self._join(image, compiled)

    def _names_of_all(self, image):
        readable = {symbol.name: symbol.demangled for symbol in image.symbols}
        self.names_at = collections.defaultdict(set)
        for name, address in self.by_name.items():
            self.names_at[address].add(name)
        for function in self.functions.values():
            function.readable = readable.get(function.name, function.name)

    def _keep_calls_of_functions(self):
        """Branches within a function are no calls."""
        for function in self.functions.values():
            function.calls &= set(self.functions)

    def _join(self, image, compiled):
        pieces = sorted((piece.address, piece.size, piece.object) for piece in image.pieces if piece.object)
        cache, index = {}, 0
        self.uncompiled = set()  # targets of this project whose objects came without a call graph
        for address in sorted(self.functions):
            while index + 1 < len(pieces) and pieces[index + 1][0] <= address:
                index += 1
            function = self.functions[address]
            function.object = pieces[index][2] if pieces else ""
            paths = compiled.get(object_key(function.object), [])
            if not paths:
                if ".dir/" in function.object or "libbatuta" in function.object:
                    self.uncompiled.add(object_key(function.object)[0])
                continue
            for path in paths:
                if path not in cache:
                    cache[path] = read_ci(path)
                self._adopt(function, cache[path])

    def _adopt(self, function, unit):
        """The compiler's word on a function replaces what was read from its instructions."""
        for name in self.names_at[function.address]:
            if name not in unit:
                continue
            compiled = unit[name]
            function.frame = max(function.frame, compiled.frame) if function.known else compiled.frame
            function.known = True
            function.indirect = list(compiled.indirect)
            bounded = compiled.kind in ("static", "dynamic,bounded")
            function.unbounded = "" if bounded else f"a frame that is {compiled.kind}"
            function.calls |= {self.by_name[callee] for callee in compiled.calls if callee in self.by_name} & set(
                self.functions)

    def callers_of(self, name):
        """Readable names of the functions that call a symbol."""
        address = self.by_name.get(name)
        return sorted(other.readable for other in self.functions.values() if address in other.calls)
