#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: docs/sets.sh BIN OUT [COUNT]      (COUNT: 100)
# The three experiments on the random shapes of sets A, B and C (seed 1, COUNT of each): with the
# default bound on the distortion (OUT/A-100 …), with --alpha 10 (OUT/A-10 …) and with none
# (OUT/A-min …). Every run is ended after TIMEOUT (300) seconds. Call it again to go on where it was
# stopped. Then `docs/tables.py sets OUT` makes the page of them.
set -euo pipefail
(($# == 2 || $# == 3)) || { sed -n '3,7s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
bin=$1 out=$2 count=${3:-100}
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
declare -A options=([100]="--alpha 100" [10]="--alpha 10" [min]="--exceptional min --alpha 1e9")

for set in A B C; do
  "$bin" generate --set "$set" --count "$count" --seed 1 -o "$out/in/$set"
done
for experiment in 100 10 min; do
  for set in A B C; do
    # By name: the folder may hold more, of an earlier call with a larger COUNT.
    files=()
    for name in $(seq -f "$set-%04.0f.json" "$count"); do
      files+=("$out/in/$set/$name")
    done
    echo "set $set, ${options[$experiment]}: $count shapes"
    RESUME=1 TIMEOUT=${TIMEOUT:-300} RUN_OPTIONS=${options[$experiment]} \
      "$here/battery.sh" "$bin" "$out/$set-$experiment" "${files[@]}"
  done
done
