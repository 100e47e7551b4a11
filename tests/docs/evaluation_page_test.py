# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/evaluation_page.py on a small made-up evaluation."""

import json
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def spread(median, largest):
    return {"count": 4, "min": 0, "median": median, "p99": largest, "max": largest}


def series(label, seconds, surplus):
    measures = {name: {"all": spread(1e-9, 2e-7), "largest_of_shape": spread(3e-8, 2e-7)}
                for name in ("d_ei", "gradient_angle_deg", "gradient_magnitude", "conformance")}
    return {"label": label, "shapes": [], "summary": {
        "shapes": 4, "regular": 4, "statuses": [[0, 3], [4, 1]], "exceptional": [[3, 4]],
        "surplus": surplus, "surplus_paper": [[0, 2], [1, 2]], "flatness_ratio": spread(0.9, 1),
        "g": spread(50, 60), "seconds": spread(seconds, 9), **measures}}


class Page(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "docs").mkdir()
        self.page = self.root / "docs" / "README.md"
        self.page.write_text("before\n<!-- tables -->\nold\n<!-- end -->\nafter\n", encoding="utf-8")

    def add(self, name, *all_series):
        folder = self.root / "out" / "tables" / name
        folder.mkdir(parents=True)
        (folder / "evaluation.json").write_text(json.dumps({"series": list(all_series)}),
                                                encoding="utf-8")
        for file in ("evaluation.txt", "histograms.svg", "projection.svg"):
            (folder / file).write_text(file, encoding="utf-8")

    def write(self):
        subprocess.run([str(ROOT / "docs" / "evaluation_page.py"), str(self.root / "out"),
                        str(self.root / "docs")], check=True)
        return self.page.read_text(encoding="utf-8")

    def test_rows_by_set_then_variant_with_the_ratio_of_seconds(self):
        self.add("paper-100", series("A", 3.0, [[0, 3], [4, 1]]), series("B", 8.0, [[1, 4]]))
        self.add("exact-100", series("A", 1.5, [[0, 4]]), series("B", 2.0, [[0, 4]]))
        text = self.write()
        rows = [[cell.strip() for cell in line.strip("|").split("|")]
                for line in text.splitlines() if line.startswith("| ")][2:]
        self.assertEqual([row[:3] for row in rows],
                         [["paper", "A", "3 of 4"], ["exact", "A", "3 of 4"],
                          ["paper", "B", "3 of 4"], ["exact", "B", "3 of 4"]])
        self.assertEqual([row[-1] for row in rows], ["2.0", "1.0", "4.0", "1.0"])
        self.assertEqual(rows[0][12:14], ["0, 1 (0.50)", "0 (1.00)"])
        self.assertTrue(text.startswith("before\n<!-- tables -->\n"))
        self.assertTrue(text.endswith("<!-- end -->\nafter\n"))
        self.assertNotIn("old", text)

    def test_pictures_are_copied_those_of_projections_where_something_was_projected(self):
        self.add("paper-10", series("A", 3.0, [[0, 4]]))
        self.add("paper-projected-10", series("A", 3.0, [[0, 4]]))
        self.write()
        names = {path.name: sorted(file.name for file in path.iterdir())
                 for path in (self.root / "docs").iterdir() if path.is_dir()}
        self.assertEqual(names, {"paper-10": ["evaluation.txt", "histograms.svg"],
                                 "paper-projected-10": ["evaluation.txt", "histograms.svg",
                                                        "projection.svg"]})
        self.assertEqual(self.page.read_text(encoding="utf-8").count("### α"), 1)

    def test_again_changes_nothing(self):
        self.add("paper-100", series("A", 3.0, [[0, 4]]))
        self.assertEqual(self.write(), self.write())


if __name__ == "__main__":
    unittest.main()
