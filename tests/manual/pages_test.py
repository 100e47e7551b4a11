# SPDX-License-Identifier: GPL-3.0-or-later
"""Manual pages: one for each command, every option in it, and roff without faults."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import program


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        program.output("manual", "-o", cls.folder.name)
        cls.pages = {file.name: file.read_text(encoding="utf-8")
                     for file in pathlib.Path(cls.folder.name).iterdir()}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def options_in(self, page):
        """Those of the lines after .TP, in bold."""
        found = set()
        for line in re.findall(r"^\.TP\n(.*)$", page, re.MULTILINE):
            found.update(re.findall(r"\\fB(-[^\\]*)\\fR", line.replace("\\-", "-")))
        return found

    def test_a_page_for_every_command(self):
        expected = {"c1mesh.1"} | {f"c1mesh-{name}.1" for name in program.commands()}
        self.assertGreater(len(expected), 9)
        self.assertEqual(set(self.pages), expected)

    def test_options_are_those_of_the_help(self):
        self.assertEqual(self.options_in(self.pages["c1mesh.1"]), program.options())
        for name in program.commands():
            listed = program.options(name)
            self.assertIn("--help", listed)
            self.assertEqual(self.options_in(self.pages[f"c1mesh-{name}.1"]), listed, name)

    def test_examples_and_statuses(self):
        for name, page in self.pages.items():
            for section in ("NAME", "SYNOPSIS", "OPTIONS", "EXIT STATUS", "EXAMPLES", "SEE ALSO"):
                self.assertIn(f".SH {section}\n", page, name)
            self.assertIn("c1mesh", page.split(".SH EXAMPLES")[1], name)

    def test_one_page_is_that_of_the_folder(self):
        self.assertEqual(program.output("manual", "run"), self.pages["c1mesh-run.1"])
        self.assertEqual(program.output("manual"), self.pages["c1mesh.1"])

    @unittest.skipUnless(shutil.which("groff"), "no groff")
    def test_groff_has_no_complaint(self):
        for name, page in self.pages.items():
            done = subprocess.run(["groff", "-ww", "-man", "-Tutf8", "-P-cbou"], input=page, text=True,
                                  capture_output=True, check=True)
            self.assertEqual(done.stderr, "", name)
            self.assertIn("EXAMPLES", done.stdout)
        # What was escaped comes out as it is in the help.
        done = subprocess.run(["groff", "-man", "-Tutf8", "-P-cbou"], text=True, capture_output=True,
                              input=self.pages["c1mesh-run.1"], check=True)
        self.assertIn("--corner-angle", done.stdout.replace("\u2010", "-").replace("\u2212", "-"))


if __name__ == "__main__":
    unittest.main()
