#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws docs/pictures/architecture.svg from the sources and checks what it draws.

usage: docs/architecture.py          write the picture
       docs/architecture.py --check  write nothing; fail if the picture is out of date

Either way the exit status is 1, with a line per fault on standard error, if
  - modules need each other in a circle, or the headers of src/ and include/ include one another in one;
  - a file includes "module/..." where that module is not among what its own module NEEDS
    (directly or through what those need: the way CMake passes include folders on);
  - a module NEEDS one that the main CMakeLists.txt adds later;
  - a public header includes anything but public headers;
  - a module has no line in MODULES below or no section in docs/architecture.md.
"""

import argparse
import pathlib
import re
import sys
from xml.sax.saxutils import escape

# What goes in and what comes out, in the words of docs/architecture.md.
MODULES = {
    "base": ("tool", "", "frames, errors as text, loops over threads"),
    "bernstein": ("tool", "control points", "pieces of curves, Bernstein forms of det J and |J|²"),
    "read": ("road", "a JSON, SVG or font file", "Drawing: curves as they stand"),
    "check": ("road", "Drawing", "Shape: closed, oriented, nested loops; or every Defect"),
    "mesh": ("road", "MeshInput: one region", "CurvedMesh: the pair (T, T^), regular, conforming"),
    "linear": ("tool", "Objective", "its minimum: sparse Cholesky, damped Newton"),
    "domain": ("road", "CurvedMesh, Roles", "DomainState: flat chains, low distortion"),
    "optimise": ("road", "CurvedMesh, Roles", "Attempt: an exactly C1 map, or where it failed"),
    "paper": ("road", "CurvedMesh, Options", "PaperSolution: the paper's two phases; the C1 projection"),
    "result": ("road", "Result or text", "text or Result; files whole or not at all"),
    "map": ("side", "Result", "Map: values, derivatives, inverse"),
    "verify": ("road", "Result", "VerifyReport: proofs and metrics"),
    "evaluate": ("side", "folders of results", "Evaluation: tables, histograms"),
    "pipeline": ("road", "Shape, Options", "Outcome: Result, verified"),
    "raster": ("tool", "a picture as SVG", "its pixels as PNG"),
    "write": ("road", "Result", "SVG, PNG, VTU, MSH, MFEM, OBJ"),
    "generate": ("side", "set or family, count, seed", "Drawing: random and hard shapes"),
    "library": ("end", "every module above", "c1mesh::c1mesh: what include/c1mesh declares"),
    "app": ("end", "a command line", "the program c1mesh: files, summary, exit status"),
}
COLOURS = {"tool": "#e8ecf1", "road": "#d5e8d4", "side": "#f3e6c8", "end": "#dfd9ee"}
LEGEND = [("road", "the road"), ("tool", "tools it uses"), ("side", "beside it"),
          ("end", "what users get")]
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


class Sources:
    """What the tree says: modules in build order, what each needs, what each file includes."""

    def __init__(self, root):
        self.root = root
        listing = (root / "CMakeLists.txt").read_text(encoding="utf-8")
        self.order = re.findall(r"add_subdirectory\(src/(\w+)\)", listing)
        self.needs = {name: self._needs(name) for name in self.order}
        self.files = {name: sorted(p for p in (root / "src" / name).iterdir()
                                   if p.suffix in (".h", ".cpp")) for name in self.order}
        self.public = sorted((root / "include" / "c1mesh").glob("*.h"))

    def _needs(self, name):
        """The module names after NEEDS; None for what is not a c1mesh_module (library, app)."""
        text = (self.root / "src" / name / "CMakeLists.txt").read_text(encoding="utf-8")
        call = re.search(r"c1mesh_module\(\s*%s\b([^)]*)\)" % name, text)
        if not call:
            return None
        words = call.group(1).split()
        out, reading = [], False
        for word in words:
            if word.isupper() and not word.startswith("$"):
                reading = word == "NEEDS"
            elif reading:
                out.append(word)
        return out

    def all_needs(self, name):
        """What the module needs, and what those need."""
        found, pending = set(), list(self.needs[name] or [])
        while pending:
            need = pending.pop()
            if need not in found:
                found.add(need)
                pending += self.needs.get(need) or []
        return found

    def includes(self, file):
        return INCLUDE.findall(file.read_text(encoding="utf-8"))


def circle_in(graph):
    """A list of nodes that lead back to the first one, or None."""
    state, path = {}, []

    def visit(node):
        state[node] = "open"
        path.append(node)
        for next_node in sorted(graph.get(node, ())):
            if state.get(next_node) == "open":
                return path[path.index(next_node):] + [next_node]
            if next_node not in state:
                found = visit(next_node)
                if found:
                    return found
        path.pop()
        state[node] = "done"
        return None

    for node in sorted(graph):
        if node not in state:
            found = visit(node)
            if found:
                return found
    return None


def faults_of_needs(sources):
    faults = []
    graph = {name: set(needs or []) for name, needs in sources.needs.items()}
    circle = circle_in(graph)
    if circle:
        return ["modules need each other in a circle: " + " -> ".join(circle)]
    for name, needs in sources.needs.items():
        for need in needs or []:
            if need not in sources.order:
                faults.append(f"{name} NEEDS {need}, which is no module")
            elif sources.order.index(need) > sources.order.index(name):
                faults.append(f"{name} NEEDS {need}, which CMakeLists.txt adds later")
    return faults


def faults_of_includes(sources):
    faults = []
    graph = {}
    for name in sources.order:
        allowed = sources.all_needs(name) | {name, "c1mesh"}
        for file in sources.files[name]:
            for target in sources.includes(file):
                module = target.split("/")[0]
                if module not in allowed:
                    faults.append(f"src/{name}/{file.name} includes \"{target}\": "
                                  f"{name} does not need {module}")
            graph[f"{name}/{file.name}"] = set(sources.includes(file))
    for file in sources.public:
        for target in sources.includes(file):
            if not target.startswith("c1mesh/"):
                faults.append(f"include/c1mesh/{file.name} includes \"{target}\", not public")
        graph[f"c1mesh/{file.name}"] = set(sources.includes(file))
    circle = circle_in(graph)
    if circle:
        faults.append("includes in a circle: " + " -> ".join(circle))
    return faults


def faults_of_text(sources):
    faults = []
    text = (sources.root / "docs" / "architecture.md").read_text(encoding="utf-8")
    for name in sources.order:
        if name not in MODULES:
            faults.append(f"module {name} has no line in MODULES of docs/architecture.py")
        if not re.search(r"^### `?%s`?$" % name, text, re.MULTILINE):
            faults.append(f"module {name} has no section in docs/architecture.md")
    return faults


def drawn_edges(sources):
    """(user, needed), without those that follow from others; library and app: what they gather."""
    graph = {name: set(needs) for name, needs in sources.needs.items() if needs is not None}
    if "library" in sources.order:
        graph["library"] = set(graph)
    if "app" in sources.order:
        graph["app"] = {"library"}

    def reach(start):
        found, pending = set(), list(graph.get(start, ()))
        while pending:
            node = pending.pop()
            if node not in found:
                found.add(node)
                pending += graph.get(node, ())
        return found

    return [(user, need) for user in sources.order for need in sources.order
            if need in graph.get(user, ())
            and not any(need in reach(other) for other in graph[user] if other != need)]


def draw(sources):
    """Modules in build order from top to bottom; an arc on the left from each to those it needs."""
    row, top, box_width, box_height, width = 46, 66, 104, 30, 1000
    edges = drawn_edges(sources)
    at = {name: top + row * k + row / 2 for k, name in enumerate(sources.order)}
    longest = max((at[user] - at[need] for user, need in edges), default=row)
    reach = 210  # of the longest arc to the left
    left = reach + 40
    height = top + row * len(sources.order) + 20
    takes, gives = left + box_width + 22, left + box_width + 216
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
           f'font-family="Helvetica, Arial, sans-serif" font-size="14">',
           '<defs><marker id="head" markerWidth="7" markerHeight="7" refX="6.2" refY="3.5" '
           'orient="auto"><path d="M0,0.6 L6.6,3.5 L0,6.4 z" fill="#54657a"/></marker></defs>',
           f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
           f'<g fill="#54657a" font-size="13"><text x="{left}" y="48">module</text>'
           f'<text x="{takes}" y="48">takes</text><text x="{gives}" y="48">gives</text>'
           f'<text x="{left - 24}" y="48" text-anchor="end">includes</text></g>']
    x = left
    for kind, words in LEGEND:
        out.append(f'<rect x="{x}" y="12" width="16" height="14" rx="3" fill="{COLOURS[kind]}" '
                   f'stroke="#54657a"/><text x="{x + 22}" y="24" font-size="13">{words}</text>')
        x += 40 + 8 * len(words)
    for k, name in enumerate(sources.order):
        if k % 2 == 0:
            out.append(f'<rect x="{left - 8}" y="{top + row * k}" width="{width - left - 4}" '
                       f'height="{row}" fill="#f7f8fa"/>')
    # Arcs leave above the middle of the box and arrive below it.
    for user, need in edges:
        y0, y1 = at[user] - 5, at[need] + 5
        bow = reach * ((at[user] - at[need]) / longest) ** 0.6
        out.append(f'<path d="M{left - 1},{y0:g} C{left - 4 - 1.25 * bow:.1f},{y0:g} '
                   f'{left - 4 - 1.25 * bow:.1f},{y1:g} {left - 2},{y1:g}" fill="none" '
                   f'stroke="#54657a" stroke-width="1.3" marker-end="url(#head)"/>')
    for name in sources.order:
        kind, takes_words, gives_words = MODULES[name]
        y = at[name]
        out.append(f'<rect x="{left}" y="{y - box_height / 2:g}" width="{box_width}" '
                   f'height="{box_height}" rx="5" fill="{COLOURS[kind]}" stroke="#54657a"/>')
        out.append(f'<text x="{left + box_width / 2:g}" y="{y + 5:g}" text-anchor="middle" '
                   f'font-weight="bold">{name}</text>')
        out.append(f'<text x="{takes}" y="{y + 5:g}">{escape(takes_words)}</text>')
        out.append(f'<text x="{gives}" y="{y + 5:g}">{escape(gives_words)}</text>')
    out.append("</svg>")
    return "\n".join(out) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="write nothing, fail if out of date")
    parser.add_argument("--root", type=pathlib.Path,
                        default=pathlib.Path(__file__).resolve().parent.parent)
    arguments = parser.parse_args()
    sources = Sources(arguments.root)
    faults = faults_of_needs(sources) + faults_of_includes(sources) + faults_of_text(sources)
    if not faults:
        picture = arguments.root / "docs" / "pictures" / "architecture.svg"
        drawn = draw(sources)
        if not arguments.check:
            picture.parent.mkdir(parents=True, exist_ok=True)
            picture.write_text(drawn, encoding="utf-8")
        elif not picture.exists() or picture.read_text(encoding="utf-8") != drawn:
            faults.append("docs/pictures/architecture.svg is out of date: run docs/architecture.py")
    for fault in faults:
        print(f"architecture: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
