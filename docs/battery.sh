#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: docs/battery.sh BIN OUT FILES…
# Runs `BIN run FILE -o OUT --threads 1 --formats json` on each file alone, two at a time. For every
# FILE called NAME.* it leaves OUT/NAME.c1.json (if a result was written) and OUT/NAME.log: all that
# was printed, then "STATUS n" (the exit status) and "WALL seconds". OUT/machine.txt says where.
# The environment may hold RUN_OPTIONS (more options of run), FORMATS (json) and JOBS (2);
# TIMEOUT, the seconds after which a run is ended and counts as of status 124 (empty: never);
# RESUME=1 to leave out what OUT has a finished log of, provided that the program and the options are
# those OUT was begun with (OUT/machine.txt and OUT/program.sum are compared).
set -euo pipefail
(($# >= 3)) || { sed -n '3,10s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }

export BATTERY_BIN=$1 BATTERY_OUT=$2
export FORMATS=${FORMATS:-json} RUN_OPTIONS=${RUN_OPTIONS:-} TIMEOUT=${TIMEOUT:-} RESUME=${RESUME:-}
shift 2
mkdir -p "$BATTERY_OUT"
machine=$(
  "$BATTERY_BIN" --version
  sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo | sort -u
  echo "cores $(nproc), runs at a time ${JOBS:-2}${TIMEOUT:+, at most $TIMEOUT s each}"
  echo "options --threads 1 --formats $FORMATS $RUN_OPTIONS"
)
program=$(cksum <"$BATTERY_BIN")
if [[ $RESUME && -e $BATTERY_OUT/program.sum ]] &&
  [[ $machine != "$(<"$BATTERY_OUT/machine.txt")" || $program != "$(<"$BATTERY_OUT/program.sum")" ]]
then
  echo "battery: $BATTERY_OUT was begun with another program, machine or options" >&2
  exit 2
fi
printf '%s\n' "$machine" >"$BATTERY_OUT/machine.txt"
printf '%s\n' "$program" >"$BATTERY_OUT/program.sum"

one() {
  local name log start status=0
  name=$(basename "$1")
  name=${name%.*}
  log=$BATTERY_OUT/$name.log
  if [[ $RESUME ]] && grep -q '^STATUS ' "$log" 2>/dev/null && grep -q '^WALL ' "$log"; then
    return
  fi
  rm -f "$BATTERY_OUT/$name.c1.json" # a result of an earlier run must not pass for one of this
  # Whoever ends the battery ends the run: no STATUS then, and xargs stops at 255. For the same reason
  # the run stays in the foreground, where the signal reaches it.
  trap 'exit 255' INT TERM HUP
  start=$EPOCHREALTIME
  # RUN_OPTIONS is a list of words on purpose.
  # shellcheck disable=SC2086
  ${TIMEOUT:+timeout --foreground -k 10 "$TIMEOUT"} \
    "$BATTERY_BIN" run "$1" -o "$BATTERY_OUT" --threads 1 --formats "$FORMATS" $RUN_OPTIONS \
    >"$log" 2>&1 </dev/null || status=$?
  # A program that does not heed the first signal is killed: timeout then says 137.
  awk -v status="$status" -v start="$start" -v end="$EPOCHREALTIME" -v limit="${TIMEOUT:-0}" \
    'BEGIN { if (status == 137 && limit > 0 && end - start >= limit) status = 124
             printf "STATUS %d\nWALL %.2f\n", status, end - start }' >>"$log"
}
export -f one
printf '%s\0' "$@" | xargs -0 -n 1 -P "${JOBS:-2}" bash -c 'one "$1"' one
