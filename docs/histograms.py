# SPDX-License-Identifier: GPL-3.0-or-later
"""Histograms as SVG, many small ones on one sheet: rows and columns of panels share their bins."""

import math
from xml.sax.saxutils import escape

WIDTH, HEIGHT = 290, 110  # of a panel's plot, in pixels
LEFT, RIGHT, TOP, BOTTOM = 34, 14, 38, 30  # around each plot
TITLE = 34
BAR, MISSING, INK, PALE = "#4477aa", "#cc6677", "#222222", "#dddddd"
SURPLUS_BINS = [(-math.inf, 0), (1, 1), (2, 2), (3, 3), (4, 7), (8, 15), (16, 31),
                (32, math.inf)]


class ClassBins:
    """Classes of whole numbers, each as wide as the next, named under its middle."""

    def __init__(self, classes):
        self.classes, self.count = classes, len(classes)
        names = []
        for low, high in classes:
            if low == -math.inf:
                names.append(f"≤{high}")
            elif high == math.inf:
                names.append(f"≥{low}")
            else:
                names.append(str(low) if low == high else f"{low}–{high}")
        self.ticks = [(k + 0.5, name) for k, name in enumerate(names)]

    def index(self, value):
        return next(k for k, (low, high) in enumerate(self.classes) if low <= value <= high)


class LogBins:
    """Bins of equal width in the logarithm, named at the powers of ten; from the decade of the least
    value to that of the largest."""

    def __init__(self, values):
        finite = [value for value in values if 0 < value < math.inf] or [1]
        self.low = math.floor(math.log10(min(finite)) + 1e-9)
        decades = max(1, math.ceil(math.log10(max(finite)) - 1e-9) - self.low)
        self.steps = min(5, max(1, 21 // decades))  # narrower bars have no room for numbers
        self.count = decades * self.steps
        self.ticks = [(k * self.steps, self.name(self.low + k)) for k in range(decades + 1)]

    @staticmethod
    def name(power):
        if -3 <= power <= 4:
            return f"{10.0 ** power:g}"
        return f"1e{power}"

    def position(self, value):
        return self.steps * (math.log10(value) - self.low)

    def index(self, value):
        """The upper end of the axis belongs to the last bin."""
        if value <= 0:
            return 0
        return min(max(math.floor(self.position(value)), 0), self.count - 1)


def text(x, y, words, size=11, anchor="middle", colour=INK):
    return (f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" '
            f'fill="{colour}">{escape(words)}</text>')


def rectangle(x, y, width, height, colour):
    return (f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" '
            f'fill="{colour}"/>')


def line(x1, y1, x2, y2, colour=INK, more=""):
    return f'<path d="M{x1:.1f} {y1:.1f}L{x2:.1f} {y2:.1f}" stroke="{colour}"{more}/>'


def bins_of(values, bins, missing):
    """Counts by bin; what is infinite or no number (None) counts in a bin apart, if there is one."""
    result = [0] * (bins.count + (2 if missing else 0))
    for value in values:
        plain = value is not None and value < math.inf
        result[bins.index(value) if plain else bins.count + 1] += 1
    return result


def panel(x, y, title, numbers, bins, missing, top, mark):
    """One plot with its lower left corner at (x, y); `missing` names the bin apart, or is empty."""
    step = WIDTH / len(numbers)
    parts = [text(x + WIDTH / 2, y - HEIGHT - 18, title, 12)]
    if mark is not None and 0 < bins.position(mark) <= bins.count:
        at = x + step * bins.position(mark)
        parts.append(line(at, y, at, y - HEIGHT, INK, ' stroke-dasharray="4 3"'))
    for k, number in enumerate(numbers):
        height = HEIGHT * number / top
        if number:
            parts.append(rectangle(x + step * k + 0.5, y - height, step - 1, height,
                                   BAR if k < bins.count else MISSING))
            if step > 12:
                parts.append(text(x + step * (k + 0.5), y - height - 3, str(number), 9))
    parts.append(line(x, y, x + WIDTH, y))
    for at, name in bins.ticks:
        if isinstance(at, int):  # between bins, not under one
            parts.append(line(x + step * at, y, x + step * at, y + 4))
        parts.append(text(x + step * at, y + 15, name, 9))
    if missing:
        parts.append(text(x + step * (bins.count + 1.5), y + 15, missing, 9))
    return parts


def sheet(title, axis, rows, bins, missing="none", marks=None):
    """SVG text. `rows` is a list of rows of (title, values); a value is a number, or None for what
    has none; `marks`, in the same order, numbers at which to draw a broken line, or None."""
    apart = any(value is None or value == math.inf
                for row in rows for _, values in row for value in values)
    missing = missing if apart else ""
    numbers = [[bins_of(values, bins, missing) for _, values in row] for row in rows]
    top = max(1, max(max(panel_numbers) for row in numbers for panel_numbers in row))
    columns = max(len(row) for row in rows)
    across, down = LEFT + WIDTH + RIGHT, TOP + HEIGHT + BOTTOM
    width, height = columns * across, TITLE + len(rows) * down
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
             f'width="{width}" height="{height}" font-family="sans-serif" fill="none">',
             f"<title>{escape(title)}</title>", rectangle(0, 0, width, height, "#ffffff"),
             text(width / 2, 22, f"{title} ({axis})", 14)]
    for r, row in enumerate(rows):
        for c, (name, _) in enumerate(row):
            x, y = c * across + LEFT, TITLE + r * down + TOP + HEIGHT
            parts.append(line(x, y - HEIGHT, x + WIDTH, y - HEIGHT, PALE))
            parts.append(line(x, y - HEIGHT / 2, x + WIDTH, y - HEIGHT / 2, PALE))
            parts.append(text(x - 4, y + 3, "0", 9, "end"))
            parts.append(text(x - 4, y - HEIGHT + 3, str(top), 9, "end"))
            parts += panel(x, y, name, numbers[r][c], bins, missing, top,
                           marks[r][c] if marks else None)
    return "\n".join(parts + ["</svg>"]) + "\n"
