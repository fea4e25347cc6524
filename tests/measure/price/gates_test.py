#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The gates find what is planted in small images of this tree, and name it. Usage: gates_test.py BUILD_TREE"""

import ctypes
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

import price
import readme_table
from tools import budgets, cycles, footprint, forbidden, instructions, scenes, stack, stack_graph
from tools.image import Section

TREE = pathlib.Path(sys.argv.pop())
MANIFEST, _ = price.read_manifest(TREE)
COLLECTOR = price.Collector(MANIFEST)


def plant(name):
    return COLLECTOR.image(MANIFEST["plants"][name])


def found(name):
    return {(kind, symbol) for kind, symbol, _ in forbidden.findings(plant(name))}


def stack_findings(name):
    worst = COLLECTOR.worst_case(plant(name))
    worst.of("main")
    return "\n".join(worst.findings.values())


def assembled(line):
    """The words of some instructions, each first half first."""
    with tempfile.TemporaryDirectory() as folder:
        code = pathlib.Path(folder) / "code"
        head = ".syntax unified\n.cpu cortex-m4\n.fpu fpv4-sp-d16\n.thumb\n"
        subprocess.run(["arm-none-eabi-as", "-o", code, "-"], input=head + line.replace(";", "\n") + "\n", text=True, check=True)
        subprocess.run(["arm-none-eabi-objcopy", "-O", "binary", "-j", ".text", code], check=True)
        halves = [half for half, in struct.iter_unpack("<H", code.read_bytes())]
    words = []
    while halves:
        first = halves.pop(0)
        words.append(first << 16 | halves.pop(0) if first >> 11 > 0b11100 else first)
    return words


class Tables:
    """An image with unwinding tables."""

    def __init__(self, words):
        self.words = words
        self.sections = [Section(".ARM.exidx", 0, 0, 4 * len(words), "ALLOC")]

    def contents(self, _):
        return self.words


class Cycles(unittest.TestCase):
    """Against the tables of the Technical Reference Manual, by hand."""

    # Instructions of which the second is priced, between its neighbours.
    PRICES = {
        "nop; add r0, r1, r2; nop": 1, "nop; mul r0, r1, r0; nop": 1, "nop; mla r0, r1, r2, r3; nop": 2,
        "nop; udiv r0, r1, r2; nop": 12, "nop; sdiv r8, r1, r2; nop": 12, "nop; ldr r0, [r1, #4]; nop": 2,
        "adds r1, #4; ldr r0, [r1, #4]; nop": 3, "add.w r9, r9, #4; ldr.w r0, [r9]; nop": 3,
        "adds r2, #4; ldr r0, [r1, r2]; nop": 3, "adds r3, #4; ldr r0, [r1, r2]; nop": 2,
        "nop; ldr r0, =0x12345678; nop": 3, "sub sp, #8; ldr r0, [sp, #4]; nop": 3, "nop; str.w r0, [r9, #40]; nop": 2,
        "nop; ldrd r0, r1, [r2]; nop": 3, "nop; push {r4, r5, lr}; nop": 4, "nop; pop {r4, r5, pc}; nop": 1 + 3 + 3,
        "nop; pop.w {r4, r8, pc}; nop": 1 + 3 + 3, "nop; ldmia r1!, {r2, r3}; nop": 3, "nop; stmdb sp!, {r4-r9}; nop": 7,
        "nop; b .; nop": 4, "nop; bl .; nop": 4, "nop; bx lr; nop": 4, "nop; beq .; nop": 1, "nop; cbz r0, .+8; nop": 1,
        "nop; beq.w .+3000; nop": 1, "nop; tbb [pc, r0]; nop": 7, "nop; ldr pc, [r0]; nop": 5, "nop; mov pc, r0; nop": 4,
        "nop; vadd.f32 s0, s1, s2; nop": 1, "nop; vadd.f32 s0, s1, s2; vmul.f32 s3, s0, s4": 2,
        "nop; vsub.f32 s1, s1, s2; vstr s1, [r0]": 2, "nop; vmul.f32 s0, s1, s2; vmul.f32 s3, s4, s5": 1,
        "nop; vdiv.f32 s0, s1, s2; nop": 14, "nop; vsqrt.f32 s0, s1; nop": 14, "nop; vdiv.f32 s5, s1, s2; vneg.f32 s6, s5": 15,
        "nop; vmla.f32 s0, s1, s2; nop": 3, "nop; vnmls.f32 s0, s1, s2; nop": 3, "nop; vfms.f32 s0, s1, s2; nop": 3,
        "nop; vfnma.f32 s0, s1, s2; nop": 3, "nop; vneg.f32 s0, s1; nop": 1, "nop; vcmpe.f32 s0, #0.0; vmrs APSR_nzcv, fpscr": 1,
        "nop; vmrs APSR_nzcv, fpscr; nop": 1, "nop; vmov s0, r0; nop": 1, "nop; vmov r0, r1, s2, s3; nop": 2,
        "nop; vldr s0, [r1]; nop": 2, "add.w r1, r2, r3; vldr s0, [r1]; nop": 3, "nop; vldr d0, [r1]; nop": 3,
        "nop; vpush {d8-d9}; nop": 5, "nop; vldmia r0!, {s0-s2}; nop": 4, "nop; vcvt.f32.s32 s0, s0; nop": 1,
        "nop; vcmpe.f32 s0, s1; vadd.f32 s0, s0, s1": 1, "nop; vmov.f32 s0, s1; vadd.f32 s0, s0, s1": 1,
        "nop; mrs r0, control; nop": 4, "nop; dsb; nop": 4,
    }

    def test_prices(self):
        with tempfile.TemporaryDirectory() as folder:
            plugin = cycles.build(pathlib.Path(folder))
            if plugin is None:
                self.skipTest("no compiler for this machine")
            price_of = ctypes.CDLL(str(plugin), mode=os.RTLD_LAZY).batuta_worst_cycles
            for line, expected in self.PRICES.items():
                with self.subTest(line):
                    self.assertEqual(price_of(*assembled(line)[:3]), expected)

    def test_a_neighbour_that_is_not_known_is_the_worst(self):
        with tempfile.TemporaryDirectory() as folder:
            plugin = cycles.build(pathlib.Path(folder))
            if plugin is None:
                self.skipTest("no compiler for this machine")
            price_of = ctypes.CDLL(str(plugin), mode=os.RTLD_LAZY).batuta_worst_cycles
            load, add = assembled("ldr r0, [r1, #4]; vadd.f32 s0, s1, s2")
            self.assertEqual(price_of(0, load, add), 3)
            self.assertEqual(price_of(load, add, 0), 2)


class ForbiddenSymbols(unittest.TestCase):
    def test_heap(self):
        self.assertIn(("heap", "malloc"), found("heap"))
        self.assertIn(("heap", "_sbrk"), found("heap"))

    def test_operator_new(self):
        self.assertIn(("operator new or delete", "_Znwj"), found("operator_new"))

    def test_exception(self):
        self.assertIn(("exceptions", "__cxa_throw"), found("throw"))
        self.assertEqual(forbidden.kind_of("__gxx_personality_v0"), "exceptions")

    def test_unwinding_tables(self):
        """The linker scripts drop them: another one might not."""
        cant_unwind = [0x7FFFFF00, forbidden.CANT_UNWIND]
        self.assertEqual(list(forbidden.unwind_tables(Tables(cant_unwind))), [])
        self.assertEqual(len(list(forbidden.unwind_tables(Tables(cant_unwind + [0x7FFFFE00, 0x80B0B0B0])))), 1)

    def test_guard(self):
        self.assertIn(("guard of a static", "__cxa_guard_acquire"), found("guard"))

    def test_libm(self):
        self.assertIn(("libm", "sinf"), found("libm"))

    def test_stdio(self):
        self.assertIn("stdio", {kind for kind, _ in found("stdio")})
        self.assertIn(("stdio", "printf"), found("stdio"))

    def test_double(self):
        if "fpv5-d16" in MANIFEST["flags"] or "auto" in MANIFEST["flags"]:
            self.skipTest("this part has double in hardware")
        self.assertIn(("double in software", "__aeabi_dmul"), found("double"))

    def test_square_root_and_copies_are_allowed(self):
        for name in "sqrt sqrtf __ieee754_sqrtf memcpy memset memmove __aeabi_fmul __aeabi_uldivmod".split():
            self.assertIsNone(forbidden.kind_of(name), name)


class Stack(unittest.TestCase):
    def test_recursion(self):
        self.assertRegex(stack_findings("recursion"), r"recursion: .*(one_less|sum_up_to).* -> ")

    def test_indirect_call(self):
        self.assertIn("unknown indirect call: ", stack_findings("indirect_call"))

    def test_frame_without_a_bound(self):
        self.assertIn("unbounded frame: ", stack_findings("vla"))

    def test_objects_without_a_call_graph(self):
        graph = stack_graph.CallGraph(plant("libm"), {})
        self.assertIn("price_plant_libm", graph.uncompiled)

    def test_calls_read_from_instructions(self):
        """At addresses of any length."""
        for address in (0x400, 0x10000400):
            text = (f"{address:08x} <caller>:\n{address:8x}:\tpush\t{{r4, lr}}\n{address + 2:8x}:\tbl\t{address + 8:x} "
                    f"<callee>\n{address + 6:8x}:\tblx\tr3\n\n{address + 8:08x} <callee>:\n{address + 8:8x}:\tbx\tlr\n")
            caller = stack_graph.Disassembly(text).functions[address]
            self.assertEqual((caller.frame, caller.calls, caller.indirect), (8, {address + 8}, ["blx r3"]))

    def test_lost_calls(self):
        graph = stack_graph.CallGraph(plant("libm"), COLLECTOR.compiled)
        graph.functions[graph.by_name["batuta_reset"]].calls.clear()
        worst = stack.WorstCase(graph, [])
        worst.with_interrupts("batuta_reset", False)
        self.assertIn("lost calls", " ".join(worst.findings.values()))

    def test_less_stack_reserved_than_used(self):
        """Of the stack and of the faults' own: the linker script may say too little, or nothing."""
        image = plant("libm")
        for root, symbol in (("batuta_reset", "batuta_stack_size"), ("batuta_fault", "batuta_fault_stack_size")):
            worst = COLLECTOR.worst_case(image)
            depth = worst.of(root).bytes
            self.assertGreater(depth, 0)
            for reserved, is_found in ((depth, False), (depth - 1, True), (None, True)):
                worst.findings.clear()
                worst.graph.constants[symbol] = reserved
                worst.compare(root, depth, symbol)
                self.assertEqual(symbol in " ".join(worst.findings.values()), is_found, f"{root} {reserved}")

    def test_reserved_stack_is_read(self):
        constants = COLLECTOR.worst_case(plant("libm")).graph.constants
        for symbol in ("batuta_stack_size", "batuta_fault_stack_size"):
            self.assertIn(symbol, constants)
            self.assertEqual(constants[symbol] % 8, 0)

    def test_frames_read_from_instructions(self):
        cases = [("push", "{r4, r5, lr}", 12), ("push", "{r4-r7, lr}", 20), ("stmdb", "sp!, {r4, r5, r6, lr}", 16),
                 ("vpush", "{d8-d9}", 16), ("sub", "sp, #40", 40), ("sub.w", "sp, sp, #520", 520),
                 ("str.w", "lr, [sp, #-4]!", 4), ("sub", "sp, r3", None), ("add", "sp, #40", 0), ("mov", "r0, sp", 0)]
        for mnemonic, operands, bytes_ in cases:
            self.assertEqual(stack_graph.grows_by(mnemonic, operands), bytes_, f"{mnemonic} {operands}")


class Budgets(unittest.TestCase):
    LIMITS = {("a", "flash"): budgets.Limits(100.0, 50.0, None), ("a", "stack"): budgets.Limits(100.0, None, 60.0),
              ("b", "flash"): budgets.Limits(1.0, None, None)}

    def over(self, **figures):
        return {row.figure for row in budgets.compare(self.LIMITS, "a", figures) if row.is_over}

    def test_what_is_exceeded(self):
        self.assertEqual(self.over(flash=100, stack=60, ram=1000), set())
        self.assertEqual(self.over(flash=101, stack=60), {"flash"})
        self.assertEqual(self.over(flash=100, stack=61), {"stack"}, "what was reached before is lost")

    def test_a_bound_that_is_missed_is_said_and_grows_no_worse(self):
        limits = {("a", "flash"): budgets.Limits(100.0, 50.0, 150.0)}
        row, = budgets.compare(limits, "a", {"flash": 140})
        self.assertFalse(row.is_over)
        self.assertIn("MISSES ITS BOUND", budgets.mark(row))
        row, = budgets.compare(limits, "a", {"flash": 151})
        self.assertTrue(row.is_over)
        self.assertEqual(budgets.kept_of(99, 100.0), 100, "a bound that is met stays one")
        self.assertEqual(budgets.kept_of(200, 100.0), 204)

    def test_opponents_have_more_room(self):
        self.assertEqual([budgets.kept_of(200, None, budgets.room_of(figure)) for figure in
                          ("firmware.flash", "opponent.flash", "opponent.step.99.9%")], [204, 230, 230])

    def test_what_nobody_measured(self):
        self.assertEqual(self.over(flash=100), {"stack"})

    def test_what_is_kept_depends_on_the_part(self):
        self.assertIn("search.worst", budgets.kept_figures("cortex-m4f"))
        self.assertEqual([name for name in budgets.kept_figures("cortex-m7") if name.startswith(("duel", "search"))],
                         ["duel.flash", "duel.stack", "duel.step.99.9%"])
        self.assertEqual(budgets.kept_figures("cortex-m3"), [])
        promised = {figure for part, figure in budgets.read(price.BUDGETS) if part == "cortex-m4f"}
        missing = promised - set(budgets.kept_figures("cortex-m4f"))
        self.assertEqual(missing, {"firmware.ram_without_buffers"}, "a bound that is missed has to be kept from growing")

    def test_the_file(self):
        limits = budgets.read(price.BUDGETS)
        self.assertEqual(limits["cortex-m4f", "segment_segment.median"][:2], (250, 200))


class Instructions(unittest.TestCase):
    """Of a calibration of 200,000 instructions in 640,060 ticks, 60 of them for the reading."""

    def samples(self, *rows):
        head = [(1, 200_000, 640_060, 0, 0, 0), (2, 0, 60, 0, 0, 0)]
        return instructions.Samples(b"".join(struct.pack("<6I", *row) for row in [*head, *rows]))

    def test_ticks_become_instructions(self):
        samples = self.samples(*((instructions.SEGMENT, 0, ticks, 0, 0, 0) for ticks in (60 + 320, 61 + 320)))
        self.assertEqual(samples.counts(instructions.SEGMENT), [100, 100])

    def test_deepest_stack_of_a_root(self):
        samples = self.samples(*((instructions.STACK, 1, depth, 0, 0, 0) for depth in (40, 80, 60)))
        self.assertEqual(samples.stacks(), {"price_search": 80})

    def test_the_first_steps_of_each_recording(self):
        row = [(instructions.STEP, i, 60 + 320 * (i + 1), 0, 0, 0) for i in range(3)]
        end = (instructions.STACK, 4, 40, 0, 0, 0)
        samples = self.samples(*row, end, *row, end)
        self.assertEqual(instructions.step_figures("a", samples, 2)["a.step.max"], 200)
        self.assertEqual(instructions.step_figures("a", samples)["a.step.max"], 300)

    def test_quantiles(self):
        self.assertEqual([instructions.quantile(range(1, 1001), share) for share in (0.5, 0.999, 1)], [500, 999, 1000])
        self.assertEqual(instructions.quantile([7], 0.001), 7)

    def test_numbers_of_a_query_file(self):
        self.assertEqual([instructions.bits(text) for text in ("3f8", "0", "8")], [0x3F800000, 0, 0x80000000])


def scene(name):
    return COLLECTOR.image(MANIFEST["scenes"][name]["image"])


class Scenes(unittest.TestCase):
    """What a scene must not have, asked of another one that has it."""

    def left_out_of(self, rules, image):
        return "\n".join(scenes.linked_in_vain(rules, scene(image)))

    def test_response_in_a_scene_without(self):
        self.assertIn("batuta::collision_impulse<float>", self.left_out_of("DetectionOnly", "TwoBlades"))
        self.assertEqual(self.left_out_of("DetectionOnly", "DetectionOnly"), "")

    def test_turning_in_a_scene_without(self):
        found = self.left_out_of("StraightSpheres", "TwoBlades")
        for name in ("pose_at<float>", "steady_flight<float>", "swept_aabb<float>", "search_advancement<float>"):
            self.assertIn(name, found)

    def test_another_search(self):
        self.assertIn("search_spheres<float>", self.left_out_of("TwoBlades", "StraightSpheres"))

    def test_friction_and_line_contact(self):
        found = self.left_out_of("TwoBlades", "Rack")
        self.assertIn("friction_impulse<float>", found)
        self.assertIn("pressure_contact<float>", found)

    def test_an_opponent_and_another_search_in_a_duel_without(self):
        if "firmware_opponent" not in MANIFEST["images"]:
            self.skipTest("this part has neither")
        found = "\n".join(scenes.linked_in_vain("firmware", COLLECTOR.image(MANIFEST["images"]["firmware_opponent"])))
        for name in ("fencing::Opponent::step", "SeeingRival::play", "fencing::DelayedObservation::"):
            self.assertIn(name, found)
        found = "\n".join(scenes.linked_in_vain("duel", COLLECTOR.image(MANIFEST["images"]["duel_stepping"])))
        self.assertIn("search_stepping<float>", found)
        found = "\n".join(scenes.linked_in_vain("duel_stepping", COLLECTOR.image(MANIFEST["images"]["duel"])))
        self.assertIn("search_advancement<float>", found)

    def test_every_rule_is_of_a_scene(self):
        known = {name for feature in scenes.FEATURES for name in feature[1:3]}
        known |= {*budgets.SCENES, *budgets.IMAGES, *budgets.CHOICES}
        self.assertLessEqual(set(scenes.NEVER), known)

    def test_a_feature_that_costs_less_than_nothing(self):
        figures = {"TwoBlades.flash": 1000, "NoEvents.flash": 1064, "TwoBlades.step.free": 500, "NoEvents.step.free": 505}
        self.assertEqual(scenes.savings_not_meant(figures), [])
        figures["NoEvents.flash"] += 1
        self.assertEqual(scenes.savings_not_meant(figures), ["NoEvents takes 65 more than TwoBlades: flash"])
        figures.update({"NoEvents.flash": 900, "NoEvents.step.free": 506})
        self.assertEqual(scenes.savings_not_meant(figures), ["NoEvents takes 6 more than TwoBlades: step.free"])

    def test_an_alternative_may_take_either(self):
        self.assertEqual(scenes.savings_not_meant({"TwoBlades.flash": 1000, "WithCoarseBox.flash": 2000}), [])

    def test_what_is_meant_is_said(self):
        figures = {"StraightSpheres.step.free": 2000, "SpheresWithEvents.step.free": 1000}
        self.assertEqual(scenes.savings_not_meant(figures), [])
        self.assertIn("StraightSpheres takes 1,000 more", scenes.table(figures))
        self.assertLessEqual({name for name, _ in scenes.MEANT}, {feature.leaner for feature in scenes.FEATURES})

    def run_of(self, *steps, state=7):
        """Samples of steps of (ticks, contacts)."""
        head = [(1, 100, 100, 0, 0, 0), (2, 0, 0, 0, 0, 0)]
        rows = [(scenes.SCENE_STEP, i, ticks, contacts, 0, 0) for i, (ticks, contacts) in enumerate(steps)]
        state_row = (scenes.SCENE_STATE, state, 0, 0, 0, 0)
        return instructions.Samples(b"".join(struct.pack("<6I", *row) for row in [*head, *rows, state_row]))

    def test_a_run_tells_when_it_met(self):
        figures = scenes.step_figures(self.run_of((10, 0), (12, 0), (11, 0), (90, 1), (95, 1), (11, 0)))
        self.assertEqual(figures, {"step.free": 11, "step.hit": 90, "step.median": 11, "step.max": 95})
        for run in (self.run_of((10, 0)), self.run_of((10, 1))):
            self.assertRaises(ValueError, scenes.step_figures, run)

    def test_runs_that_differ(self):
        one = self.run_of((10, 0), (20, 1))
        self.assertEqual(scenes.unlike_runs({"TwoBlades": one, "NoEvents": self.run_of((9, 0), (8, 1))}), [])
        self.assertEqual(scenes.unlike_runs({"TwoBlades": one, "NoEvents": self.run_of((10, 0), (20, 1), state=8)}),
                         ["TwoBlades and NoEvents do not end in the same bits"])
        late = self.run_of((10, 0), (10, 0), (20, 1), state=8)
        self.assertEqual(scenes.unlike_runs({"StraightSpheres": one, "StraightSpheres_by_hand": late}),
                         ["StraightSpheres and StraightSpheres_by_hand do not have the same contacts"])

    def test_footprint(self):
        price_ = {"cpu": "a", "figures": {"Rack.flash": 5, "Rack.ram": 6, "Duel.flash": 7, "duel.stack": 8}}
        self.assertEqual(list(footprint.lines_of(price_)),
                         [["Rack", "a", 5, 6, "", "", ""], ["Duel", "a", 7, "", 8, "", ""]])


class ReadmeTable(unittest.TestCase):
    def test_a_column_is_kept_as_it_was_written(self):
        columns = {"cortex-m3": [str(i) for i in range(len(readme_table.ROWS))]}
        text = readme_table.table(columns, budgets.read(price.BUDGETS), readme_table.ROWS)
        read = readme_table.read_columns(text, readme_table.ROWS)
        self.assertEqual(read["cortex-m3"], columns["cortex-m3"])
        self.assertEqual(read["cortex-m7"], [""] * len(readme_table.ROWS))
        self.assertIn("| 250 / 450 | 200 / 350 |", text)

    def test_choices_of_a_duel(self):
        figures = {"duel.flash": 7, "duel_stepping.step.median": 1000, "opponent.ram": 3000, "opponent.step.max": 30}
        text = readme_table.choice_table(figures)
        self.assertIn("| full duel, certified search | 7 |  |  |  |", text)
        self.assertIn("stepping and bisection |  |  |  | 1,000 / - / - |", text)
        self.assertIn("| of that the opponent |  | 3,000 |  | - / - / 30 |", text)

    def test_a_cell(self):
        self.assertEqual(readme_table.cell(["a", "b"], {"a": 1234, "b": 5}.get), "1,234 / 5")
        self.assertEqual(readme_table.cell(["a"], {}.get), "")


if __name__ == "__main__":
    unittest.main()
