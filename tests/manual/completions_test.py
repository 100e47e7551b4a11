# SPDX-License-Identifier: GPL-3.0-or-later
"""Completions: the options of the help, no others, and bash completes with them."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import program

COMMON = {"-q", "--quiet", "-v", "--verbose"}  # the program's, which commands take too


class Completions(unittest.TestCase):
    def test_bash_lists_the_options_of_the_help(self):
        script = program.output("completion", "bash")
        listed = {name: set(words.split()) for name, words in
                  re.findall(r'^ *"(\w*)"\) options="(.*)" ;;$', script, re.MULTILINE)}
        self.assertEqual(listed.pop(""), program.options())
        self.assertEqual(set(listed), set(program.commands()))
        for name, options in listed.items():
            self.assertEqual(options, program.options(name) | COMMON, name)

    def test_zsh_lists_the_options_of_the_help(self):
        script = program.output("completion", "zsh")
        for name in program.commands():
            part = re.search(r"^    %s\)\n(.*?);;$" % name, script, re.MULTILINE | re.DOTALL).group(1)
            listed = set(re.findall(r"^ +'\*(--?[\w-]+?)[+=]?\[", part, re.MULTILINE))
            self.assertEqual(listed, program.options(name) | COMMON, name)

    def test_fish_lists_the_options_of_the_help(self):
        script = program.output("completion", "fish")
        for name in program.commands():
            lines = re.findall(r"^complete -c c1mesh -n '__fish_seen_subcommand_from %s'(.*)$" % name,
                               script, re.MULTILINE)
            listed = set()
            for line in lines:
                head = line.split(" -d '")[0].split(" -f ")[0]
                listed.update("-" + word for word in re.findall(r" -s (\S+)", head))
                listed.update("--" + word for word in re.findall(r" -l (\S+)", head))
            self.assertEqual(listed, program.options(name) - {"-h", "--help"}, name)

    def complete(self, *words):
        """What bash offers for the last of the words."""
        with tempfile.TemporaryDirectory() as folder:
            script = pathlib.Path(folder) / "completion"
            script.write_text(program.output("completion", "bash"), encoding="utf-8")
            done = subprocess.run(
                ["bash", "-c", 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '
                 '_c1mesh; printf "%s\\n" "${COMPREPLY[@]}"', "bash", str(script), *words],
                capture_output=True, text=True, check=True)
            self.assertEqual(done.stderr, "")
            return set(done.stdout.split())

    def test_bash_completes(self):
        self.assertEqual(self.complete("c1mesh", ""), set(program.commands()))
        self.assertEqual(self.complete("c1mesh", "ver"), {"verify"})
        self.assertEqual(self.complete("c1mesh", "--ver"), {"--version", "--verbose"})
        self.assertEqual(self.complete("c1mesh", "run", "a.svg", "--alpha-"), {"--alpha-lift"})
        self.assertEqual(self.complete("c1mesh", "run", "--method", ""), {"exact", "paper"})
        self.assertEqual(self.complete("c1mesh", "run", "--method", "=", "p"), {"paper"})
        self.assertEqual(self.complete("c1mesh", "-q", "generate", "--set", ""), {"A", "B", "C"})
        self.assertEqual(self.complete("c1mesh", "completion", ""), {"bash", "fish", "zsh"})
        self.assertEqual(self.complete("c1mesh", "run", "sha"), set())  # files, by bash itself

    @unittest.skipUnless(shutil.which("zsh"), "no zsh")
    def test_zsh_reads_its_script(self):
        subprocess.run(["zsh", "-n"], input=program.output("completion", "zsh"), text=True, check=True)

    @unittest.skipUnless(shutil.which("fish"), "no fish")
    def test_fish_reads_its_script(self):
        subprocess.run(["fish", "--no-execute"], input=program.output("completion", "fish"), text=True,
                       check=True)


if __name__ == "__main__":
    unittest.main()
