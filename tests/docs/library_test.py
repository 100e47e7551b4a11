# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/library.py finds what has no comment, and pages that are out of date, in small trees."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCRIPT = ROOT / "docs" / "library.py"

HEADER = """// SPDX-License-Identifier: GPL-3.0-or-later
// What it is for.
#pragma once

#include <string>

namespace c1mesh {

/// A kind.
enum class Kind { one };  // replaced below

/// A thing.
struct Thing {
  int size = 0, more = 0;  ///< of both
  std::vector<std::pair<std::string, double>> list;  ///< pairs
  /// Says how large.
  int total() const { return size + more; }
};

/// A worker.
class Worker {
 public:
  /// Begins.
  explicit Worker(int count);
  ~Worker();
  Worker(const Worker&) = delete;
  /// The count.
  const int& count() const { return count_; }

 private:
  int count_;
};

/// Does it. Throws InputError.
Thing make(const std::string& name,
           int count = 3);

}  // namespace c1mesh
""".replace("enum class Kind { one };  // replaced below", "enum class Kind {\n  one,  ///< the first\n"
            "  two   ///< the second\n};")


class Library(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        (self.root / "include" / "c1mesh").mkdir(parents=True)
        self.write(HEADER)

    def write(self, text):
        (self.root / "include" / "c1mesh" / "thing.h").write_text(text, encoding="utf-8")

    def run_script(self, *arguments):
        done = subprocess.run([sys.executable, "-B", str(SCRIPT), "--root", str(self.root),
                               *arguments], capture_output=True, text=True, check=False)
        return done.returncode, done.stderr

    def test_a_header_with_comments_makes_a_page(self):
        self.assertEqual(self.run_script(), (0, ""))
        self.assertEqual(self.run_script("--check"), (0, ""))
        page = (self.root / "docs" / "library" / "thing.md").read_text(encoding="utf-8")
        for part in ("What it is for.", "| `int size = 0, more = 0` | of both |", "| `two` | the second |",
                     "| `int total() const` | Says how large. |", "explicit Worker(int count)",
                     "Thing make(const std::string& name, int count = 3);", "Throws InputError."):
            self.assertIn(part, page)
        self.assertNotIn("count_", page)
        self.assertNotIn("delete", page)

    def test_what_has_no_comment_is_found(self):
        for comment, name in (("/// A thing.\n", "struct Thing"), ("  ///< of both", "field Thing::size"),
                              ("  ///< pairs", "field Thing::list"), ("/// A kind.\n", "enum Kind"),
                              ("  ///< the first", "enumerator Kind::one"),
                              ("  /// Says how large.\n", "function Thing::total"),
                              ("  /// Begins.\n", "function Worker::Worker"),
                              ("  /// The count.\n", "function Worker::count"),
                              ("/// Does it. Throws InputError.\n", "function make")):
            self.assertIn(comment, HEADER)
            self.write(HEADER.replace(comment, "" if comment.endswith("\n") else " "))
            status, text = self.run_script()
            self.assertEqual((status, text), (1, f"library: thing.h: {name} has no comment\n"
                                              + ("library: thing.h: field Thing::more has no comment\n"
                                                 if name == "field Thing::size" else "")))
        self.write(HEADER.replace("// What it is for.\n", ""))
        self.assertIn("no comment says what the header is for", self.run_script()[1])

    def test_an_exception_that_there_is_not(self):
        self.write(HEADER.replace("Throws InputError", "Throws ImputError"))
        self.assertIn("make throws ImputError", self.run_script()[1])

    def test_pages_out_of_date(self):
        self.run_script()
        self.write(HEADER.replace("Does it.", "Does that."))
        status, text = self.run_script("--check")
        self.assertEqual(status, 1)
        self.assertIn("docs/library/thing.md is out of date", text)
        stray = self.root / "docs" / "library" / "gone.md"
        self.run_script()
        stray.write_text("old", encoding="utf-8")
        self.assertEqual(self.run_script("--check")[0], 1)
        self.run_script()
        self.assertFalse(stray.exists())

    def test_code_in_the_tutorial(self):
        (self.root / "x.cpp").write_text("// 1. One.\nint a;\n\n// 2. Two.\nint b;\n\n}  // namespace\n",
                                         encoding="utf-8")
        (self.root / "docs").mkdir()
        tutorial = self.root / "docs" / "tutorial-library.md"
        tutorial.write_text("A\n\n<!-- from x.cpp: 1 -->\n\nB\n\n<!-- from x.cpp: 2 -->\n\nC\n",
                            encoding="utf-8")
        self.assertEqual(self.run_script()[0], 0)
        text = tutorial.read_text(encoding="utf-8")
        self.assertIn("```cpp\n// 1. One.\nint a;\n```\n\nB\n", text)
        self.assertIn("```cpp\n// 2. Two.\nint b;\n```\n\nC\n", text)
        self.assertEqual(self.run_script("--check")[0], 0)
        tutorial.write_text(text.replace("int a;", "int c;"), encoding="utf-8")
        self.assertEqual(self.run_script("--check")[0], 1)
        self.run_script()
        self.assertEqual(tutorial.read_text(encoding="utf-8"), text)


if __name__ == "__main__":
    unittest.main()
