#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/library/*.md, the reference of the library, out of the public headers' comments.

usage: docs/library.py          write the pages
       docs/library.py --check  write nothing; fail if a page is out of date

In docs/tutorial-library.md it puts the code behind each mark "from FILE: all" (a comment) anew; "from
FILE: 3" is what follows the comment "// 3. …", up to the next number.

Either way the exit status is 1, with a line per fault on standard error, if a type, function, constant
or enumerator that include/c1mesh declares has no comment (/// before it or ///< behind it), or a field
has none where its struct's comment does not say what it holds either, or a comment names an exception
type that the library does not throw.
"""

import argparse
import pathlib
import re
import sys

# What may stand after "Throws" in a comment.
EXCEPTIONS = {"InputError", "FileError", "Interrupted", "OutsideDomain", "std::invalid_argument",
              "std::out_of_range", "std::domain_error", "std::runtime_error"}
HEAD = "<!-- Made by docs/library.py from {}; do not edit. -->\n"


class Fault(Exception):
    pass


class Declaration:
    def __init__(self, kind, name, code, doc, members=()):
        self.kind, self.name, self.code, self.doc = kind, name, code, doc
        self.members = list(members)


def tokens_of(text):
    """The text as ('doc', …), ('behind', …) and ('code', …) pieces, other comments left out."""
    for line in text.split("\n"):
        match = re.match(r"([^\"]*?(?:\"[^\"]*\"[^\"]*?)*?)(///<|///|//)(.*)$", line)
        code, mark, comment = match.groups() if match else (line, None, "")
        if code.strip():
            yield "code", code.strip()
        if mark == "///<":
            yield "behind", comment.strip()
        elif mark == "///":
            yield ("behind" if code.strip() else "doc"), comment.strip()
        elif not code.strip():
            yield "gap", ""


class Reader:
    """Reads declarations at one level of braces."""

    def __init__(self, tokens, header):
        self.tokens, self.at, self.header = tokens, 0, header

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ("end", "")

    def declarations(self, inside=None, public=True):
        """Up to the closing brace of the surrounding scope (left for the caller)."""
        out, doc, code = [], [], ""
        last = None
        while True:
            kind, text = self.peek()
            if kind == "end":
                return out
            if kind == "code" and not code and text.startswith("}"):
                return out
            self.at += 1
            if kind == "gap":
                if not code:
                    last, doc = None, [] if not doc else doc
            elif kind == "doc":
                if last is not None and not code and not doc and last == "behind-open":
                    last = None
                doc.append(text)
            elif kind == "behind":
                target = out[-1] if out and not code else None
                if target is None:
                    doc.append(text)
                else:
                    self.append_behind(out, text)
            else:
                if text in ("public:", "private:", "protected:"):
                    public = text == "public:"
                    doc = []
                    continue
                code = (code + " " + text).strip()
                if not self.complete(code):
                    continue
                made = self.make(code, doc, inside)
                if public:
                    self.group = len(made)
                    out += made
                doc, code = [], ""

    def append_behind(self, out, text):
        # "a = 0, b = 0;  ///< …" is about both.
        for declaration in out[-self.group:]:
            declaration.doc = (declaration.doc + " " + text).strip()

    @staticmethod
    def complete(code):
        """Does the code end here, or open a scope that is read apart?"""
        if re.match(r"(struct|class|enum class|enum|namespace)\b[^;()]*\{$", code):
            return True
        if code.count("{") != code.count("}") or code.count("(") != code.count(")"):
            return False
        return code.endswith(";") or code.endswith("}")

    def make(self, code, doc, inside):
        text = "\n".join(doc).strip()
        scope = re.match(r"(struct|class|enum class|enum)\s+(\w+)[^{;]*\{(.*)$", code)
        if scope:
            kind, name, rest = scope.groups()
            if kind.startswith("enum"):
                return [Declaration("enum", name, code.split("{")[0].strip(), text,
                                    self.enumerators(rest))]
            if rest.strip():
                raise Fault(f"{self.header}: cannot read '{code}'")
            members = Reader(self.tokens, self.header)
            members.at = self.at
            inner = members.declarations(name, public=kind == "struct")
            self.at = members.at
            self.skip_end()
            return [Declaration(kind, name, code.rstrip("{ ").strip(), text, inner)]
        if re.match(r"(struct|class)\s+\w+;$", code) or code.startswith("friend "):
            return []
        signature = self.signature(code)
        return [Declaration(kind, name, signature, text)
                for kind, name in self.named(signature, inside)]

    def skip_end(self):
        kind, text = self.peek()
        if kind != "code" or not text.startswith("}"):
            raise Fault(f"{self.header}: a scope does not end")
        self.at += 1

    def enumerators(self, rest):
        """Of 'enum class X {' with what follows on the same line, or over several lines."""
        out, doc = [], []

        def take(code):
            for part in re.sub(r"\}.*", "", code).split(","):
                name = re.match(r"\s*(\w+)", part)
                if name:
                    out.append(Declaration("enumerator", name.group(1), part.strip(),
                                           " ".join(doc)))
                    doc.clear()

        if rest.strip():
            take(rest)
            return out
        while True:
            kind, text = self.peek()
            self.at += 1
            if kind == "end":
                raise Fault(f"{self.header}: an enum does not end")
            if kind == "doc":
                doc.append(text)
            elif kind == "behind":
                out[-1].doc = (out[-1].doc + " " + text).strip()
            elif kind == "code":
                take(text)
                if "}" in text:
                    return out

    @staticmethod
    def signature(code):
        """The declaration without body, initialisers and semicolon."""
        if re.search(r"\)[^{};]*\{.*\}$", code):
            depth = 0
            for k in range(len(code) - 1, -1, -1):
                depth += {"}": 1, "{": -1}.get(code[k], 0)
                if depth == 0:
                    code = code[:k]
                    break
        return re.sub(r"\s+", " ", code).rstrip("; ").strip()

    @staticmethod
    def named(code, inside):
        """(kind, name) of every name the declaration declares."""
        if code.startswith("using ") and "=" in code:
            return [("alias", re.match(r"using (\w+)", code).group(1))]
        if code.startswith("using "):
            return []
        if re.search(r"=\s*(delete|default)$", code) or re.match(r"~\w+\(", code):
            return []
        call = re.match(r"[^=]*?((?:operator\s*\S+?)|~?\w+)\s*\(", code)
        initialised = re.match(r"[^(]*=", code)
        if call and not initialised:
            return [("function", call.group(1))]
        if re.match(r"(inline |static )*constexpr ", code):
            return [("constant", re.search(r"(\w+)\s*(=|$)", code).group(1))]
        plain = re.sub(r"<[^<>]*(<[^<>]*(<[^<>]*>)?[^<>]*>)?[^<>]*>", "", code)
        plain = re.sub(r"\{[^{}]*\}|\[[^\[\]]*\]|=\s*[^,]*", "", plain)
        return [("field", re.search(r"(\w+)\s*$", part).group(1)) for part in plain.split(",")
                if re.search(r"(\w+)\s*$", part)]


class Header:
    def __init__(self, path):
        self.name = path.name
        text = path.read_text(encoding="utf-8")
        lines = text.split("\n")
        words = [line[2:].strip() for line in lines[1:] if line.startswith("//")]
        first = next((k for k, line in enumerate(lines) if line.startswith("#")), 0)
        self.about = " ".join(line[2:].strip() for line in lines[1:first] if line.startswith("//"))
        del words
        body = text.split("namespace c1mesh {", 1)
        self.declarations = []
        if len(body) == 2:
            inner = body[1].rsplit("}  // namespace c1mesh", 1)[0]
            self.declarations = Reader(list(tokens_of(inner)), path.name).declarations()


def faults_of(header):
    faults = []
    if not header.about and header.declarations:
        faults.append(f"{header.name}: no comment says what the header is for")

    def look(declaration, where, covered):
        name = f"{where}{declaration.name}"
        if not declaration.doc and not (declaration.kind in ("field", "enumerator") and covered):
            faults.append(f"{header.name}: {declaration.kind} {name} has no comment")
        for thrown in re.findall(r"[Tt]hrows ((?:std::)?\w+)", declaration.doc):
            if thrown not in EXCEPTIONS and thrown not in ("nothing", "as", "for", "if", "on", "the"):
                faults.append(f"{header.name}: {name} throws {thrown}, which is no exception")
        for member in declaration.members:
            look(member, name + "::", False)

    for declaration in header.declarations:
        look(declaration, "", False)
    return faults


def prose(doc):
    """A comment as Markdown: what would be read as mark-up is escaped, names of the code marked."""
    text = re.sub(r"\s+", " ", doc).strip()
    parts = re.split(r"(`[^`]*`)", text)
    return "".join(part if part.startswith("`") else
                   re.sub(r"([*_<>|])", r"\\\1", part) for part in parts)


def tidy(code):
    return code.replace("explicit ", "")


def member_rows(members):
    rows = ["| | |", "| --- | --- |"]
    for member in members:
        code = member.code.replace("|", "\\|")
        rows.append(f"| `{code}` | {prose(member.doc)} |")
    return rows


def grouped(members):
    """Members of one declaration ('double a = 0, b = 0;') in one row."""
    out = []
    for member in members:
        if out and out[-1].code == member.code and out[-1].doc == member.doc:
            continue
        out.append(member)
    return out


def section(declaration):
    lines = [f"## `{declaration.name}`", "", "```cpp", tidy(declaration.code) + (
        ";" if declaration.kind in ("function", "constant", "alias") else ""), "```", ""]
    if declaration.doc:
        lines += [prose(declaration.doc), ""]
    simple = [m for m in grouped(declaration.members) if m.kind not in ("struct", "class", "enum")]
    if simple:
        lines += member_rows(simple) + [""]
    for member in declaration.members:
        if member.kind in ("struct", "class", "enum"):
            lines += [f"### `{declaration.name}::{member.name}`", "", prose(member.doc), ""]
            lines += member_rows(grouped(member.members)) + [""]
    return lines


def page(header):
    lines = [HEAD.format("include/c1mesh/" + header.name), f"# `c1mesh/{header.name}`", "",
             prose(header.about), ""]
    last = None
    for declaration in header.declarations:
        new = section(declaration)
        if last == (declaration.kind, declaration.name):  # an overload: no second heading
            new = new[2:]
        lines += new
        last = (declaration.kind, declaration.name)
    return "\n".join(lines).rstrip() + "\n"


def index(headers):
    lines = [HEAD.format("include/c1mesh"), "# The library, header by header", "",
             "`#include <c1mesh/c1mesh.h>` includes all of them; everything is in the namespace "
             "`c1mesh`. [A tutorial](../tutorial-library.md) comes first; words and symbols are those "
             "of the [vocabulary](../vocabulary.md).", "", "| header | for | declares |",
             "| --- | --- | --- |"]
    for header in headers:
        names = []
        for declaration in header.declarations:
            if declaration.name not in names:
                names.append(declaration.name)
        listed = ", ".join(f"`{name}`" for name in names)
        lines.append(f"| [{header.name}]({header.name[:-2]}.md) | {prose(header.about)} | {listed} |")
    return "\n".join(lines) + "\n"


def pages_of(root):
    """Name of each page -> its text, and the faults."""
    headers = [Header(path) for path in sorted((root / "include" / "c1mesh").glob("*.h"))
               if path.name != "c1mesh.h"]
    faults = [fault for header in headers for fault in faults_of(header)]
    pages = {header.name[:-2] + ".md": page(header) for header in headers}
    pages["README.md"] = index(headers)
    return pages, faults


MARK = re.compile(r"<!-- from ([\w./-]+): (\w+) -->\n(?:\n```\w+\n.*?^```\n)?", re.MULTILINE | re.DOTALL)


def code_of(root, path, part):
    """A file without its licence line, or one of its numbered parts."""
    text = (root / path).read_text(encoding="utf-8")
    if part == "all":
        return re.sub(r"\A(//|#) SPDX.*\n", "", text)
    found = re.search(r"^// %s\. .*?(?=^// \d+\. |^}  // namespace$)" % part, text,
                      re.MULTILINE | re.DOTALL)
    if not found:
        raise Fault(f"{path} has no part {part}")
    return found.group(0).rstrip() + "\n"


def with_code(root, text):
    """The tutorial with the code that its marks ask for."""
    def block(match):
        path, part = match.groups()
        language = "cmake" if path.endswith(".txt") else "cpp"
        return f"<!-- from {path}: {part} -->\n\n```{language}\n{code_of(root, path, part)}```\n"
    return MARK.sub(block, text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="write nothing, fail if out of date")
    parser.add_argument("--root", type=pathlib.Path,
                        default=pathlib.Path(__file__).resolve().parent.parent)
    arguments = parser.parse_args()
    tutorial = arguments.root / "docs" / "tutorial-library.md"
    try:
        pages, faults = pages_of(arguments.root)
        if tutorial.exists():
            old = tutorial.read_text(encoding="utf-8")
            new = with_code(arguments.root, old)
            if not arguments.check:
                tutorial.write_text(new, encoding="utf-8")
            elif new != old:
                faults.append("docs/tutorial-library.md is out of date: run docs/library.py")
    except Fault as fault:
        pages, faults = {}, [str(fault)]
    folder = arguments.root / "docs" / "library"
    there = {path.name for path in folder.glob("*.md")}
    if not arguments.check:
        folder.mkdir(parents=True, exist_ok=True)
        for name in sorted(there - set(pages)):
            (folder / name).unlink()
        for name, text in pages.items():
            (folder / name).write_text(text, encoding="utf-8")
    else:
        for name in sorted(there | set(pages)):
            path = folder / name
            if name not in pages or name not in there or path.read_text(encoding="utf-8") != pages[name]:
                faults.append(f"docs/library/{name} is out of date: run docs/library.py")
    for fault in faults:
        print(f"library: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
