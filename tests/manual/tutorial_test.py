# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command in docs/tutorial.md that is marked `sh` works, one after the other."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import program

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# What the text says there is afterwards.
FILES = ["out/letter.c1.json", "out/letter.svg", "out/letter.vtu", "out/letter.msh",
         "out/letter.mesh", "out/leaf.c1.json", "better/leaf.c1.json", "both.svg",
         "out/letter.lagrange.vtu", "out/letter.domain.vtu"]


class Tutorial(unittest.TestCase):
    def test_commands(self):
        text = (ROOT / "docs" / "tutorial.md").read_text(encoding="utf-8")
        blocks = re.findall(r"^```sh\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
        self.assertGreater(len(blocks), 5)
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder)
            shutil.copytree(ROOT / "examples", place / "examples")
            (place / "bin").mkdir()
            (place / "bin" / "c1mesh").symlink_to(pathlib.Path(program.PROGRAM).resolve())
            environment = dict(os.environ, PATH=f"{place / 'bin'}:{os.environ['PATH']}")
            for block in blocks:
                done = subprocess.run(["bash", "-e", "-c", block], cwd=place, env=environment,
                                      capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, f"{block}\n{done.stderr}")
            for name in FILES:
                self.assertTrue((place / name).is_file(), name)


if __name__ == "__main__":
    unittest.main()
