#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: docs/pictures.sh [BIN]      (BIN: build/release/bin/c1mesh)
# Draws every example anew: docs/pictures/NAME.svg is what `c1mesh run examples/NAME.* -o FOLDER`
# writes as FOLDER/NAME.svg. Then one trade-off (NAME.tradeoff.svg, with --trade-off), the plot of one
# trace (NAME.trace.svg, with --trace), the pictures of docs/pictures.md, the table of examples, docs/examples.md, and the picture of
# the modules.
set -euo pipefail
bin=$(readlink -f "${1:-$(dirname "${BASH_SOURCE[0]}")/../build/release/bin/c1mesh}")
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

FORMATS=json,svg docs/battery.sh "$bin" "$out" examples/*.svg examples/*.json
mkdir -p docs/pictures
for picture in "$out"/*.svg; do
  cp "$picture" docs/pictures/
done
"$bin" --quiet run examples/puzzle.svg -o "$out/trade-off" --trade-off --trace "$out/trace.jsonl"
cp "$out/trade-off/puzzle.tradeoff.svg" docs/pictures/
"$bin" draw "$out/trace.jsonl" --width 720 -o docs/pictures/puzzle.trace.svg
for colour in distortion checkerboard; do
  "$bin" draw "$out/puzzle.c1.json" --width 600 --colour "$colour" -o "docs/pictures/puzzle.$colour.png"
done
"$bin" draw "$out"/*.c1.json --contact-sheet --width 600 -o docs/pictures/examples.sheet.png
python3 docs/tables.py examples "$out" >"$out/examples.md"
cp "$out/examples.md" docs/examples.md
python3 docs/architecture.py
