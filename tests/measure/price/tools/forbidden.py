# SPDX-License-Identifier: MIT
"""What a firmware image must not hold. The linked image is asked, not the sources: what the linker left out is not
there, and what a library brought along is."""

import re

# Names of <math.h> without their suffix; sqrt is an instruction, or a function of known cost.
LIBM = ("acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh erf erfc exp exp2 exp10 expm1 fabs fdim "
        "floor fma fmax fmin fmod frexp hypot ilogb ldexp lgamma gamma log log10 log1p log2 logb modf nan nearbyint "
        "nextafter pow pow10 remainder remquo rint round scalb scalbn scalbln sin sincos sinh tan tanh tgamma trunc "
        "lrint lround j0 j1 jn y0 y1 yn").split()

DOUBLE_GCC = ("adddf3 subdf3 muldf3 divdf3 negdf2 cmpdf2 eqdf2 nedf2 ltdf2 ledf2 gtdf2 gedf2 unorddf2 fixdfsi "
              "fixdfdi fixunsdfsi fixunsdfdi floatsidf floatdidf floatunsidf floatundidf extendsfdf2 truncdfsf2 "
              "powidf2").split()

RULES = {
    "heap": r"_?(malloc|calloc|realloc|reallocf|free|memalign|valloc|aligned_alloc|posix_memalign|strdup)(_r)?"
            r"|_?sbrk(_r)?|__malloc_\w+",
    "operator new or delete": r"_Zn[wa]\w*|_Zd[la]\w*",
    "exceptions": r"__cxa_(throw|rethrow|begin_catch|end_catch|end_cleanup|\w*exception\w*|call_unexpected|get_globals)"
                  r"|__gxx_personality\w*|__gcc_personality\w*|_Unwind_\w+|__gnu_unwind\w*|__aeabi_unwind_cpp_pr\d"
                  r"|_ZSt9terminatev|_ZSt\d+__throw_\w+|_ZN10__cxxabiv1\w+",
    "guard of a static": r"__cxa_guard_\w+|_ZGV\w+",
    "double in software": r"__aeabi_(d(add|sub|mul|div|rsub|neg|cmp\w*|2\w+)|cd\w+|(f|i|ui|l|ul|h)2d)"
                          r"|__(" + "|".join(DOUBLE_GCC) + r")"
                          r"|__aeabi_f2ulz|__fixunssfdi",  # of float, but libgcc computes it in double
    "libm": r"(__)?(" + "|".join(LIBM) + r")[fl]?|__ieee754_(?!sqrt)\w+|__kernel_\w+|__math_\w+|matherr",
    "stdio": r"_?(v?[sdf]?n?i?printf|v?f?s?i?scanf|puts|fputs|putchar|fputc|putc|getchar|fgets|fopen|fclose|fread"
             r"|fwrite|fflush|perror)(_r)?|_(v?fi?printf|printf_\w+|fflush|fwalk\w*|puts)\w*|__sinit\w*|__sf"
             r"|__sfp\w*|__swrite|__swsetup_r|_ZNSt\d*8ios_base\w*|_ZSt4c(out|err|in|log)|_ZNS[oi]\w+|_ZNSt6locale\w*"
             r"|_ZNKSt6locale\w*",
}

# A word of an .ARM.exidx entry that says: nothing is unwound through here.
CANT_UNWIND = 1


def kind_of(name):
    """Which rule forbids a symbol of this name, or None."""
    for kind, pattern in RULES.items():
        if re.fullmatch(pattern, name):
            return kind
    return None


def unwind_tables(image):
    """What is there for an unwinder to walk by."""
    for section in image.sections:
        if section.name == ".ARM.extab" and section.size:
            yield "exceptions", ".ARM.extab", f"{section.size} B of exception tables"
        if section.name == ".ARM.exidx" and section.size:
            live = sum(1 for word in image.contents(section.name)[1::2] if word != CANT_UNWIND)
            if live:
                yield "exceptions", ".ARM.exidx", f"{live} functions that can be unwound"


def findings(image):
    """(kind, name, text) of everything forbidden in an image; undefined weak symbols are not in it."""
    for symbol in sorted(set(symbol for symbol in image.symbols if symbol.kind not in "Uw")):
        rule = kind_of(symbol.name)
        if rule:
            yield rule, symbol.name, symbol.demangled
    yield from unwind_tables(image)


def texts(image, graph):
    """A line for each finding, with who asks for it; what only other findings ask for is left to them."""
    for kind, name, readable in findings(image):
        callers = graph.callers_of(name)
        asking = [caller for caller in callers if not kind_of(caller)]
        if asking or not callers:
            yield f"{kind}: {readable}" + (f", called by {'; '.join(asking)}" if asking else "")
