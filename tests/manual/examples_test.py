# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples at the end of every --help work as they are written, one after the other."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import program

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# In this order each finds what it uses. Every command must be among them.
ORDER = ["check", "run", "verify", "draw", "convert", "project", "generate", "batch", "evaluate",
         "manual", "completion"]
FONTS = pathlib.Path("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")


def shell_part(line):
    """Without the remark, which stands three or more spaces (or none but two) behind."""
    return re.split(r"\s{2,}", line)[0]


class Examples(unittest.TestCase):
    def test_every_help_ends_with_examples(self):
        self.assertEqual(sorted(program.commands()), sorted(ORDER))
        for command in ((), *((name,) for name in ORDER)):
            lines = program.examples(*command)
            self.assertTrue(lines, command)
            for line in lines:
                self.assertRegex(line, r"^(LC_ALL=C )?(c1mesh|sort) ")

    def test_they_work(self):
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder)
            # The smallest shape that is one: examples must not take long.
            shape = ('<svg xmlns="http://www.w3.org/2000/svg"><path d="M0,0 C30,-10 60,10 90,0 '
                     'L90,60 C60,80 30,50 0,60 Z"/></svg>')
            for name in ("shape.svg", "drawing.svg"):
                (place / name).write_text(shape, encoding="utf-8")
            (place / "list.txt").write_text("shape.svg\n", encoding="utf-8")
            if FONTS.exists():
                shutil.copy(FONTS, place)
            (place / "bin").mkdir()
            (place / "bin" / "c1mesh").symlink_to(pathlib.Path(program.PROGRAM).resolve())
            environment = dict(os.environ, PATH=f"{place / 'bin'}:{os.environ['PATH']}")
            for name in ORDER:
                for line in program.examples(name):
                    command = shell_part(line)
                    if "--font" in command and not FONTS.exists():
                        continue
                    if "man -l" in command and not shutil.which("man"):
                        continue
                    done = subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=place,
                                          env=environment, capture_output=True, text=True, check=False)
                    # 4: valid, but not within the bound: the reference method promises no more.
                    allowed = (0, 4) if "--method paper" in command else (0,)
                    self.assertIn(done.returncode, allowed, f"{command}\n{done.stderr}")


if __name__ == "__main__":
    unittest.main()
