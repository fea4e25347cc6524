# SPDX-License-Identifier: MIT
"""The mutations that a C++ source of the house's style has room for. The style is what makes text enough: clang-format
puts spaces around binary operators and none inside the brackets of templates."""
import re
from collections import namedtuple

# One change of one place: text[start:end] becomes `after`.
Mutation = namedtuple("Mutation", "file line kind start end before after")

HIDDEN = "\x01"  # stands for what must not be read as code, one for one, so that places stay what they are
COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'', re.S)
# Neither what only the compiler reads is mutated, nor what only a caller's mistake reaches: a weaker or stronger trap
# changes no answer to a call that keeps its preconditions.
UNREAD = [
    re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.M),           # preprocessor
    re.compile(r"\b(?:using|typedef|friend)\b[^;{]*;"),
    re.compile(r"\benum\b[^{;]*\{[^}]*\}"),
    re.compile(r"\[\[.*?\]\]", re.S),
    re.compile(r"\)(?: const)?(?: noexcept)?(?: override)? = 0;"),  # pure virtual
]
CALLS_UNREAD = re.compile(r"\b(?:static_assert|BATUTA_\w+|noexcept|decltype|sizeof|alignas|if constexpr) ?\(")
ARGUMENTS_OF_TEMPLATE = re.compile(r"(?:(?<=\w)|(?<=\btemplate ))<[^<>;{}]*>")

BINARY = {
    "+": "-", "-": "+", "*": "/", "/": "*", "%": "*", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=",
    "&&": "||", "||": "&&", "==": "!=", "!=": "==", "&": "|", "|": "&", "^": "&", "<<": ">>", ">>": "<<",
}
BOUNDARY = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
OPPOSITE = {"<": ">=", "<=": ">", ">": "<=", ">=": "<"}
OPERATOR = re.compile(r"(?<=\s)(?:[-+*/]=|&&|\|\||[=!<>]=|<<|>>|[-+*/%<>&|^])(?=\s)")
UNARY_MINUS = re.compile(r"(?:(?<=[(\[{,=?:] )|(?<=[(\[{])|(?<=return )|(?<=[-+*/<>] )|(?<=&& ))-(?=[\w(])")
NOT = re.compile(r"(?<=[\s(])!(?=[\w(])")
EXTREME = re.compile(r"\b(min|max)(_of\b|(?=\())|\b(minCoeff|maxCoeff)\b|\bstd::(min|max)\b")
CONSTANT = re.compile(r"(?<![\w.\x01])(?:0[xX][0-9a-fA-F]+|\d+(?:\.\d*)?(?:[eE][-+]?\d+)?)(?=[uUlLfF]*(?![\w.']))")
TRUTH = re.compile(r"\b(?:true|false)\b")
CONDITION = re.compile(r"\b(?:if|while) \(")
PLACE = r"[\w:.\->\[\]()*\x01]+"
STATEMENT = re.compile(
    r"(?:(?<=\n)[ \t]+|(?<=\) )|(?<=else ))"
    rf"((?!return\b|case\b|default\b)(?:{PLACE} (?:[-+*/|&^]|<<|>>)?= [^;{{}}]*|[a-z][\w:.\->\[\]\x01]*\([^;{{}}]*\)|"
    r"(?:\+\+|--)[\w.\->\[\]()]+|break|continue));")


def hide(text, start, end):
    return text[:start] + re.sub(r"[^\n]", HIDDEN, text[start:end]) + text[end:]


def hidden(match):
    return re.sub(r"[^\n]", HIDDEN, match.group(0))


def without_comment_or_string(match):
    return re.sub(r"[^\n]", " ", match.group(0)) if match.group(0)[0] == "/" else hidden(match)


def closing(text, opening):
    """The place after the parenthesis that closes the one at `opening`."""
    depth = 0
    for place in range(opening, len(text)):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if depth == 0:
            return place + 1
    return len(text)


def code_only(text):
    """The text with everything hidden that no mutation is for; as long as before."""
    text = COMMENT_OR_STRING.sub(without_comment_or_string, text)
    for pattern in UNREAD:
        text = pattern.sub(hidden, text)
    for match in CALLS_UNREAD.finditer(text):
        text = hide(text, match.start(), closing(text, match.end() - 1))
    found = ARGUMENTS_OF_TEMPLATE.search(text)
    while found:  # the innermost first
        text = hide(text, found.start(), found.end())
        found = ARGUMENTS_OF_TEMPLATE.search(text)
    return text


def operators(code):
    for match in OPERATOR.finditer(code):
        sign = match.group(0)
        for after in ([BINARY[sign]] if sign in BINARY else [BOUNDARY[sign], OPPOSITE[sign]]):
            yield "operator", match.start(), match.end(), after
    for match in UNARY_MINUS.finditer(code):
        yield "operator", match.start(), match.end(), ""


def next_constant(text):
    """Another constant of the same type: one more of a whole number, twice a real one."""
    if text[:2] in ("0x", "0X"):
        return hex(int(text, 16) + 1)
    if text.isdigit():
        return str(int(text) + 1)
    return repr(2 * float(text) or 1.0)


def constants(code):
    for match in CONSTANT.finditer(code):
        yield "constant", match.start(), match.end(), next_constant(match.group(0))
    for match in TRUTH.finditer(code):
        yield "constant", match.start(), match.end(), "false" if match.group(0) == "true" else "true"


def extremes(code):
    for match in EXTREME.finditer(code):
        word = match.group(0)
        other = word.replace("min", "max") if "min" in word else word.replace("max", "min")
        yield "extreme", match.start(), match.end(), other


def conditions(code):
    """Negated, unless one comparison is all there is: its opposite stands among the operators."""
    for match in CONDITION.finditer(code):
        start, end = match.end(), closing(code, match.end() - 1) - 1
        start += code[start:end].rfind("; ") + len("; ") if "; " in code[start:end] else 0
        condition = code[start:end]
        if len(OPERATOR.findall(condition)) != 1 or re.search(r"&&|\|\|", condition):
            yield "branch", start, end, None
    for match in NOT.finditer(code):
        yield "branch", match.start(), match.end(), ""


def statements(code):
    for match in STATEMENT.finditer(code):
        yield "statement", match.start(1), match.end(1), ""


def mutations_of(file, text):
    """All of them, in the order of the text; `file` is only a name."""
    code = code_only(text)
    found = []
    for rule in (operators, constants, extremes, conditions, statements):
        for kind, start, end, after in rule(code):
            before = text[start:end]
            after = f"!({before.strip()})" if after is None else after
            found.append(Mutation(file, text.count("\n", 0, start) + 1, kind, start, end, before, after))
    return sorted(found, key=lambda m: (m.start, m.end, m.after))


def apply(text, mutation):
    return text[:mutation.start] + mutation.after + text[mutation.end:]


def line_at(text, place):
    """The whole line, without its ends, and where in it the place is."""
    start = text.rfind("\n", 0, place) + 1
    end = text.find("\n", place)
    line = text[start:end if end >= 0 else len(text)]
    return line.strip(), place - start - (len(line) - len(line.lstrip()))


def name_of(text, mutation):
    """What a mutation is called in files: the same wherever its line has moved to, unlike its line's number."""
    line, column = line_at(text, mutation.start)
    before = " ".join(mutation.before.split())
    return f"{mutation.file}: {line} @{column}: {before} -> {' '.join(mutation.after.split()) or '(nothing)'}"
