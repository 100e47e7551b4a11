#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: docs/evaluation.sh BIN OUT
# The methods compared on the random shapes of sets A, B and C (seed 1). Runs each variant with each
# alpha (OUT/VARIANT-ALPHA/SET/NAME.c1.json and NAME.log), then `BIN evaluate` over the sets of each:
# OUT/tables/VARIANT-ALPHA/evaluation.json and the rest. The variants:
#   exact            the default method
#   paper            --method paper
#   repeated         --method paper --repeat 2
#   paper-printed    --method paper with the options in PRINTED; left out where that is empty
#   projected        `BIN project` on the results of paper and of repeated that OUT has:
#                    OUT/paper-projected-ALPHA/SET, OUT/repeated-projected-ALPHA/SET
# A table is drawn over that of what it is compared with, if OUT has that: a projected variant with the
# one it is made from, every other with paper.
# The environment may choose a part: VARIANTS ("paper repeated paper-printed exact projected"), ALPHAS
# ("10 100"), SETS ("A B C"), COUNT (100, of each set); TABLES= leaves the tables out; PRINTED (empty);
# TIMEOUT (600), the seconds after which a run is ended, and JOBS (2), as in docs/battery.sh.
# Call it again, with the same or another part, to go on where it was stopped: what is finished is not
# run again, and a changed program or options are refused. Tables are of all that OUT has of SETS.
set -euo pipefail
(($# == 2)) || { sed -n '3,20s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
export EVALUATION_BIN=$1
out=$2
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
read -ra variants <<<"${VARIANTS:-paper repeated paper-printed exact projected}"
read -ra alphas <<<"${ALPHAS:-10 100}"
read -ra sets <<<"${SETS:-A B C}"
count=${COUNT:-100}
tables=${TABLES-1}
printed=${PRINTED:-}
declare -A options=([exact]="" [paper]="--method paper" [repeated]="--method paper --repeat 2"
  [paper-printed]="--method paper $printed" [projected]="")

commands=$("$EVALUATION_BIN" --help)
# What would only be found out after hours is looked at first.
needs() { # a command of the program
  grep -qE "^ +$1( |$)" <<<"$commands" || {
    echo "evaluation: $EVALUATION_BIN has no command '$1'" >&2
    exit 2
  }
}
for variant in "${variants[@]}"; do
  [[ -v options[$variant] ]] || { echo "evaluation: no variant is called '$variant'" >&2; exit 2; }
  [[ $variant != projected ]] || needs project
done
[[ -z $tables ]] || needs evaluate

# Projects one result into a folder, with a log as docs/battery.sh leaves it.
project_one() {
  local source=$1 folder=$2 name log start status=0
  name=$(basename "$source" .c1.json)
  log=$folder/$name.log
  if grep -q '^STATUS ' "$log" 2>/dev/null && grep -q '^WALL ' "$log" && [[ ! $source -nt $log ]]; then
    return
  fi
  rm -f "$folder/$name.c1.json" "$log"
  trap 'exit 255' INT TERM HUP # whoever ends this ends all: no STATUS then, and xargs stops
  start=$EPOCHREALTIME
  "$EVALUATION_BIN" project "$source" -o "$folder" >"$log" 2>&1 </dev/null || status=$?
  awk -v status="$status" -v start="$start" -v end="$EPOCHREALTIME" \
    'BEGIN { printf "STATUS %d\nWALL %.2f\n", status, end - start }' >>"$log"
}
export -f project_one

project_all() { # FROM TO: folders of results
  local from=$1 to=$2 program log name
  mkdir -p "$to"
  program=$(cksum <"$EVALUATION_BIN")
  if [[ -e $to/program.sum && $program != "$(<"$to/program.sum")" ]]; then
    echo "evaluation: $to was begun with another program" >&2
    exit 2
  fi
  printf '%s\n' "$program" >"$to/program.sum"
  # A run that left nothing to project has failed here too.
  for log in "$from"/*.log; do
    name=$(basename "$log" .log)
    [[ -e $from/$name.c1.json || ! -e $log ]] || cp "$log" "$to/"
  done
  find "$from" -maxdepth 1 -name '*.c1.json' -print0 | sort -z |
    xargs -0 -r -P "${JOBS:-2}" -I '{}' bash -c 'project_one "$@"' project_one '{}' "$to"
}

# Folders of a variant that there are, of the chosen sets, in their order.
folders_of() { # VARIANT-ALPHA
  local set
  for set in "${sets[@]}"; do
    [[ ! -d $out/$1/$set ]] || printf '%s\n' "$out/$1/$set"
  done
}

tabulate() { # VARIANT-ALPHA OTHER-ALPHA
  local -a folders others compare=()
  mapfile -t folders < <(folders_of "$1")
  mapfile -t others < <(folders_of "$2")
  ((${#folders[@]})) || return 0
  [[ $1 == "$2" || ${#others[@]} -ne ${#folders[@]} ]] || compare=(--compare "${others[@]}")
  local labels
  labels=$(printf '%s\n' "${folders[@]##*/}" | paste -sd,)
  echo "table $1${compare[0]:+ over $2}: sets $labels"
  # A result that cannot be read is in the table as one; the others still count.
  "$EVALUATION_BIN" evaluate "${folders[@]}" "${compare[@]}" --labels "$labels" -o "$out/tables/$1" ||
    echo "evaluation: evaluate ended with status $?" >&2
}

run_variant() { # VARIANT ALPHA
  local set name
  local -a files
  for set in "${sets[@]}"; do
    # By name: the folder may hold more, of an earlier call with a larger COUNT.
    files=()
    for name in $(seq -f "$set-%04.0f.json" "$count"); do
      files+=("$out/in/$set/$name")
    done
    echo "$1, alpha $2, set $set: $count shapes"
    RESUME=1 TIMEOUT=${TIMEOUT:-600} RUN_OPTIONS="${options[$1]:+${options[$1]} }--alpha $2" \
      "$here/battery.sh" "$EVALUATION_BIN" "$out/$1-$2/$set" "${files[@]}"
  done
}

project_variants() { # ALPHA
  local source set found=
  for source in paper repeated; do
    for set in "${sets[@]}"; do
      [[ -d $out/$source-$1/$set ]] || continue
      found=1
      echo "$source projected, alpha $1, set $set"
      project_all "$out/$source-$1/$set" "$out/$source-projected-$1/$set"
    done
  done
  [[ $found ]] || echo "evaluation: alpha $1: no results of paper or repeated to project" >&2
}

for set in "${sets[@]}"; do
  "$EVALUATION_BIN" generate --set "$set" --count "$count" --seed 1 -o "$out/in/$set"
done
for alpha in "${alphas[@]}"; do
  for variant in "${variants[@]}"; do
    case $variant in
    projected) project_variants "$alpha" ;;
    paper-printed)
      if [[ $printed ]]; then
        run_variant "$variant" "$alpha"
      else
        echo "paper-printed: left out, PRINTED is empty"
      fi
      ;;
    *) run_variant "$variant" "$alpha" ;;
    esac
  done
  [[ $tables ]] || continue
  for variant in "${variants[@]}"; do
    if [[ $variant == projected ]]; then
      for source in paper repeated; do
        tabulate "$source-projected-$alpha" "$source-$alpha"
      done
    else
      tabulate "$variant-$alpha" "paper-$alpha"
    fi
  done
done
