# SPDX-License-Identifier: MIT
"""Measures the scenes of a tree."""

import pathlib

from . import budgets, forbidden, rooms, scenes


class SceneCollector:
    """Adds to a Collector's figures and findings.
    @param collector  has image(), worst_case(), names, manifest, figures, findings"""

    def __init__(self, collector):
        self.collector = collector
        self.scenes = collector.manifest["scenes"]
        self.figures = collector.figures
        self.findings = collector.findings

    def take_images(self):
        empty = self._sizes(self.collector.image(self.scenes[scenes.EMPTY]["image"]))
        for name, paths in self.scenes.items():
            if name != scenes.EMPTY and pathlib.Path(paths["image"]).is_file():
                self._take_image(name, self.collector.image(paths["image"]), empty)
        for name in budgets.BY_HAND:
            of_both = [self.figures.get(f"{name}{end}.flash") for end in ("", scenes.BY_HAND)]
            if all(of_both):
                self.figures[f"{name}.flash_of_by_hand"] = round(100 * of_both[0] / of_both[1])
        if "duel.flash" in self.figures:
            for kind, at_start in zip(("flash", "ram"), empty):
                self.figures[f"Duel.{kind}"] = self.figures[f"duel.{kind}"] - at_start

    def _sizes(self, image):
        return rooms.by_room(image, self.collector.names)["total"]

    def _take_image(self, name, image, empty):
        for kind, size, at_start in zip(("flash", "ram"), self._sizes(image), empty):
            self.figures[f"{name}.{kind}"] = size - at_start
        worst = self.collector.worst_case(image)
        self.figures[f"{name}.stack"] = worst.of(scenes.STEP).bytes
        texts = [*forbidden.texts(image, worst.graph), *worst.findings.values(), *scenes.linked_in_vain(name, image)]
        self.findings += [f"{name}: {text}" for text in texts]

    def take_runs(self, folder):
        bouncy = {}
        for name in self._to_run():
            for restitution in (scenes.BOUNCY, scenes.DULL) if name in scenes.RUN_DULL else (scenes.BOUNCY,):
                samples = scenes.run(name, self.collector.manifest, folder, restitution)
                end = scenes.suffix(restitution)
                self.figures.update((f"{name}{end}.{step}", n) for step, n in scenes.step_figures(samples).items())
                if restitution == scenes.BOUNCY:
                    bouncy[name] = samples
        self.findings += [f"scenes: {text}" for text in scenes.unlike_runs(bouncy)]

    def _to_run(self):
        too_long = () if self.collector.manifest["has_fpu"] else scenes.LONG
        return [name for name, paths in self.scenes.items()
                if name != scenes.EMPTY and name not in too_long and pathlib.Path(paths["run"]).is_file()]
