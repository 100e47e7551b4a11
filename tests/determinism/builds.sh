#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Two builds of the program write the same bytes: builds.sh PROGRAM PROGRAM INPUT…
# OPTIONS: further options of `c1mesh batch`. Exit status 77, "skipped", if one is not built.
set -u
first=$1 second=$2
shift 2
for program in "$first" "$second"; do
  [ -x "$program" ] || { echo "skipped: $program is not built"; exit 77; }
done
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
printf '%s\n' "$@" > "$out/list"
for build in first second; do
  # Worst statuses differ by input, not by build: the indices are compared.
  "${!build}" batch "$out/list" -o "$out/$build" --formats json,svg,vtu,msh,mesh,obj ${OPTIONS:-}
  [ -f "$out/$build/index.jsonl" ] || { echo "${!build} did not finish"; exit 1; }
  rm "$out/$build/journal.jsonl" "$out/$build/times.jsonl"
done
echo "$(wc -l < "$out/first/index.jsonl") results," \
  "$(find "$out/first" -type f | wc -l) files compared"
diff -rq "$out/first" "$out/second"
