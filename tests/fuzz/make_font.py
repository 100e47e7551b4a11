#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the smallest TrueType font that the fuzz targets can use: A is a triangle, B a blob of
implied points with a hole, space is empty; A and B are kerned.

usage: tests/fuzz/make_font.py FILE
"""

import struct
import sys

LINE, CURVE = 1, 0  # on-curve flag of a point


def glyph(contours):
    """A simple glyph with 16-bit deltas; contours of (x, y, flag)."""
    if not contours:
        return b""
    points = [p for contour in contours for p in contour]
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    data = struct.pack(">hhhhh", len(contours), min(xs), min(ys), max(xs), max(ys))
    ends, last = [], -1
    for contour in contours:
        last += len(contour)
        ends.append(last)
    data += struct.pack(f">{len(ends)}H", *ends) + struct.pack(">H", 0)
    data += bytes(p[2] for p in points)
    for axis in (0, 1):
        before = 0
        for p in points:
            data += struct.pack(">h", p[axis] - before)
            before = p[axis]
    return data + b"\0" * (-len(data) % 4)


def main():
    square = [(100, 100, CURVE), (600, 100, CURVE), (600, 600, CURVE), (100, 600, CURVE)]
    hole = [(300, 300, LINE), (300, 400, LINE), (400, 400, LINE), (400, 300, LINE)]
    glyphs = [glyph([[(0, 0, LINE), (0, 500, LINE), (500, 500, LINE), (500, 0, LINE)]]),
              b"",
              glyph([[(0, 0, LINE), (300, 700, LINE), (600, 0, LINE)]]),
              glyph([square, hole])]
    offsets = [0]
    for one in glyphs:
        offsets.append(offsets[-1] + len(one))
    # cmap format 4: the space (32), then A and B (65, 66), then the end.
    ends, starts, deltas = [32, 66, 0xffff], [32, 65, 0xffff], [1 - 32, 2 - 65, 1]
    segments = struct.pack(">3H", *ends) + b"\0\0" + struct.pack(">3H", *starts)
    segments += struct.pack(">3H", *(d & 0xffff for d in deltas)) + struct.pack(">3H", 0, 0, 0)
    subtable = struct.pack(">7H", 4, 14 + len(segments), 0, 6, 4, 1, 2) + segments
    kern = struct.pack(">HH", 0, 1) + struct.pack(">HHH", 0, 20, 1)
    kern += struct.pack(">HHHH", 1, 6, 0, 0) + struct.pack(">HHh", 2, 3, -50)
    tables = {
        b"cmap": struct.pack(">HHHHL", 0, 1, 3, 1, 12) + subtable,
        b"glyf": b"".join(glyphs),
        b"head": struct.pack(">LLLLHHQQhhhhHHhhh", 0x10000, 0x10000, 0, 0x5f0f3cf5, 0, 1000, 0, 0,
                             0, 0, 700, 700, 0, 8, 2, 1, 0),
        b"hhea": struct.pack(">LhhhHhhhhhhhhhhhH", 0x10000, 800, -200, 0, 700, 0, 0, 700, 1, 0, 0,
                             0, 0, 0, 0, 0, len(glyphs)),
        b"hmtx": b"".join(struct.pack(">Hh", 700, 0) for _ in glyphs),
        b"kern": kern,
        b"loca": struct.pack(f">{len(offsets)}L", *offsets),
        b"maxp": struct.pack(">LHHHHHHHHHHHHHH", 0x10000, len(glyphs), 8, 2, 0, 0, 1, 0, 0, 0, 0,
                             0, 0, 0, 0),
    }
    head = struct.pack(">LHHHH", 0x10000, len(tables), 128, 3, len(tables) * 16 - 128)
    at, body = 12 + 16 * len(tables), b""
    for tag, data in sorted(tables.items()):
        head += struct.pack(">4sLLL", tag, 0, at + len(body), len(data))
        body += data + b"\0" * (-len(data) % 4)
    with open(sys.argv[1], "wb") as file:
        file.write(head + body)


main()
