# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/architecture.py finds what it must find, in small trees made for it."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCRIPT = ROOT / "docs" / "architecture.py"


class Architecture(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        self.write("CMakeLists.txt", "add_subdirectory(src/base)\nadd_subdirectory(src/mesh)\n"
                                     "add_subdirectory(src/domain)\n")
        self.write("src/base/CMakeLists.txt", "c1mesh_module(base\n  SOURCES a.cpp)\n")
        self.write("src/base/a.h", '#include "c1mesh/types.h"\n')
        self.write("src/mesh/CMakeLists.txt",
                   "c1mesh_module(mesh\n  SOURCES m.cpp\n  NEEDS base\n  LIBRARIES ${SOME} x::y)\n")
        self.write("src/mesh/m.h", '#include <vector>\n#include "base/a.h"\n')
        self.write("src/domain/CMakeLists.txt",
                   "c1mesh_module(domain SOURCES d.cpp NEEDS mesh)\n")
        self.write("src/domain/d.cpp", '#include "mesh/m.h"\n#include "base/a.h"\n')
        self.write("include/c1mesh/types.h", "")
        self.write("docs/architecture.md", "### `base`\n\n### `mesh`\n\n### `domain`\n")

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def run_script(self, *arguments):
        done = subprocess.run([sys.executable, "-B", str(SCRIPT), "--root", str(self.root),
                               *arguments], capture_output=True, text=True, check=False)
        return done.returncode, done.stderr

    def expect_fault(self, words):
        status, said = self.run_script()
        self.assertEqual(status, 1)
        self.assertIn(words, said)

    def test_a_sound_tree_is_drawn_and_then_up_to_date(self):
        self.assertEqual(self.run_script(), (0, ""))
        self.assertEqual(self.run_script("--check"), (0, ""))
        picture = (self.root / "docs/pictures/architecture.svg").read_text(encoding="utf-8")
        for name in ("base", "mesh", "domain"):
            self.assertIn(f">{name}</text>", picture)
        # domain -> base follows from the other two arrows.
        self.assertEqual(picture.count("marker-end"), 2)

    def test_a_missing_or_old_picture(self):
        self.assertEqual(self.run_script("--check")[0], 1)
        self.run_script()
        self.write("src/domain/CMakeLists.txt", "c1mesh_module(domain SOURCES d.cpp NEEDS base)\n")
        self.write("src/domain/d.cpp", "")
        status, said = self.run_script("--check")
        self.assertEqual(status, 1)
        self.assertIn("out of date", said)

    def test_an_include_that_is_not_needed(self):
        self.write("src/mesh/n.cpp", '#include "domain/d.h"\n')
        self.expect_fault("mesh does not need domain")

    def test_a_circle_of_modules(self):
        self.write("src/base/CMakeLists.txt", "c1mesh_module(base SOURCES a.cpp NEEDS domain)\n")
        self.expect_fault("in a circle: base -> domain -> mesh -> base")

    def test_a_circle_of_headers(self):
        self.write("src/base/b.h", '#include "base/c.h"\n')
        self.write("src/base/c.h", '#include "base/b.h"\n')
        self.expect_fault("includes in a circle: base/b.h -> base/c.h -> base/b.h")

    def test_a_need_that_comes_later(self):
        self.write("CMakeLists.txt", "add_subdirectory(src/mesh)\nadd_subdirectory(src/base)\n"
                                     "add_subdirectory(src/domain)\n")
        self.expect_fault("mesh NEEDS base, which CMakeLists.txt adds later")

    def test_a_public_header_that_includes_the_inside(self):
        self.write("include/c1mesh/types.h", '#include "base/a.h"\n')
        self.expect_fault("not public")

    def test_a_module_without_a_section(self):
        self.write("docs/architecture.md", "### `base`\n\n### `mesh`\n")
        self.expect_fault("module domain has no section")


if __name__ == "__main__":
    unittest.main()
