# SPDX-License-Identifier: GPL-3.0-or-later
"""The program under test, named by the command line, and what its help says."""

import re
import subprocess
import sys

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 else "c1mesh"


def output(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=True).stdout


def commands():
    """The names of the commands, from the program's help."""
    text = output("--help").split("Subcommands:")[1].split("\n\n")[0]
    return re.findall(r"^  (\w+)", text, re.MULTILINE)


def options(*command):
    """Every option of a command (or of the program), from its help: '-o', '--output', …"""
    text = output(*command, "--help").split("\nExit status:")[0]
    found = set()
    for line in text.split("\n"):
        match = re.match(r"\s{2,4}(-[\w,-]+)", line)
        if match:
            found.update(match.group(1).split(","))
    return found


def examples(*command):
    """The lines after 'Examples:' at the end of the help."""
    head, _, tail = output(*command, "--help").rpartition("\nExamples:\n")
    return [line.strip() for line in tail.rstrip().split("\n")] if head else []
