# SPDX-License-Identifier: GPL-3.0-or-later
"""What the documents point to exists: relative links, pictures, and paths in code marks."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGES = ([ROOT / "README.md", ROOT / "CHANGELOG.md"] + sorted((ROOT / "docs").glob("*.md")) +
         sorted((ROOT / "docs" / "library").glob("*.md")))
LINK = re.compile(r"\]\(([^)#\s]+)\)|src=\"([^\"]+)\"")
PATH = re.compile(r"`((?:src|include|tests|docs|examples|cmake)/[\w./-]+)`")
MADE_LATER = {"docs/corpus.md", "docs/sets.md", "docs/sets.csv"}  # by docs/tables.py


class Links(unittest.TestCase):
    def test_links(self):
        for page in PAGES:
            # Code has brackets of its own.
            prose = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"),
                           flags=re.MULTILINE | re.DOTALL)
            for pair in LINK.findall(prose):
                target = pair[0] or pair[1]
                if "://" not in target:
                    self.assertTrue((page.parent / target).exists(), f"{page.name}: {target}")

    def test_paths_in_code_marks(self):
        seen = 0
        for page in PAGES:
            for target in PATH.findall(page.read_text(encoding="utf-8")):
                seen += 1
                # A header and its source may be named without their endings.
                found = (ROOT / target).exists() or (ROOT / (target + ".h")).exists()
                self.assertTrue(found or target in MADE_LATER, f"{page.name}: {target}")
        self.assertGreater(seen, 50)

    def test_names_in_the_vocabulary(self):
        """Every identifier in a code mark of the vocabulary occurs in the sources."""
        sources = "".join(file.read_text(encoding="utf-8") for folder in ("src", "include")
                          for file in sorted((ROOT / folder).rglob("*")) if file.suffix in (".h", ".cpp"))
        text = (ROOT / "docs" / "vocabulary.md").read_text(encoding="utf-8")
        names = {part for mark in re.findall(r"`([A-Za-z_]\w*(?:::\w+)?)`", text)
                 for part in mark.split("::")}
        self.assertGreater(len(names), 40)
        for name in sorted(names):
            self.assertRegex(sources, r"\b%s\b" % name)


if __name__ == "__main__":
    unittest.main()
