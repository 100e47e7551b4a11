#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: docs/battery.sh BIN OUT FILES…
# Runs `BIN run FILE -o OUT --threads 1 --formats json` on each file alone, two at a time. For every
# FILE called NAME.* it leaves OUT/NAME.c1.json (if a result was written) and OUT/NAME.log: all that
# was printed, then "STATUS n" (the exit status) and "WALL seconds". OUT/machine.txt says where.
# The environment may hold RUN_OPTIONS (more options of run), FORMATS (json) and JOBS (2).
set -euo pipefail
(($# >= 3)) || { sed -n '3,7s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }

export BATTERY_BIN=$1 BATTERY_OUT=$2
export FORMATS=${FORMATS:-json} RUN_OPTIONS=${RUN_OPTIONS:-}
shift 2
mkdir -p "$BATTERY_OUT"
{
  "$BATTERY_BIN" --version
  sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo | sort -u
  echo "cores $(nproc), runs at a time ${JOBS:-2}"
  echo "options --threads 1 --formats $FORMATS $RUN_OPTIONS"
} >"$BATTERY_OUT/machine.txt"

one() {
  local name log start status=0
  name=$(basename "$1")
  log=$BATTERY_OUT/${name%.*}.log
  start=$EPOCHREALTIME
  # RUN_OPTIONS is a list of words on purpose.
  # shellcheck disable=SC2086
  "$BATTERY_BIN" run "$1" -o "$BATTERY_OUT" --threads 1 --formats "$FORMATS" $RUN_OPTIONS \
    >"$log" 2>&1 </dev/null || status=$?
  awk -v status="$status" -v start="$start" -v end="$EPOCHREALTIME" \
    'BEGIN { printf "STATUS %d\nWALL %.2f\n", status, end - start }' >>"$log"
}
export -f one
printf '%s\0' "$@" | xargs -0 -n 1 -P "${JOBS:-2}" bash -c 'one "$1"' one
