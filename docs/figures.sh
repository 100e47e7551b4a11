#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: docs/figures.sh [BIN [OUT]]     (build/release/bin/c1mesh, docs/evaluation/figures)
# Draws figures like the paper's, and both methods side by side: OUT/NAME.svg, or OUT/NAME.png where
# the SVG is larger than 300 kB. Then the page OUT.md from docs/evaluation/figures.in.md, with the numbers
# and the commands of these very runs. Needs rsvg-convert for PNG.
# The results are kept in RUNS (build/figures), in a folder for each version of the program: call it
# again to go on where it was stopped, or to draw anew what was run with the same options.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
bin=$(readlink -f "${1:-$here/../build/release/bin/c1mesh}")
out=$(readlink -m "${2:-$here/evaluation/figures}")
runs=$(readlink -m "${RUNS:-$here/../build/figures}")/$(cksum <"$bin" | cut -d' ' -f1)
mkdir -p "$out" "$runs"
root=$(dirname "$here")
paper=(--method paper --extent 1 --lambda-reg "1e-5,1e-5" --lambda-hard "1,1" --rho 1e-6)
gentle=(--method paper --extent 1 --lambda-reg "1e-6,1e-6" --lambda-hard "1,1" --rho 1e-6)

# Runs one shape once. Status 4 is fine: an early end misses what is asked, on purpose.
run() { # NAME INPUT OPTIONS…
  local name=$1 input=$2 log=$runs/$1/log status=0
  local -a options=(--formats json --trace "$name/trace.jsonl" "${@:3}")
  local command="c1mesh run $input -o $name ${options[*]}"
  if [[ -e $log && $(head -n 1 "$log") == "$command" ]] && grep -q '^STATUS [04]$' "$log"; then
    return
  fi
  echo "run $name"
  rm -rf "${runs:?}/$name" && mkdir -p "$runs/$name"
  echo "$command" >"$log"
  [[ $input == shapes/* ]] || input=$root/$input
  (cd "$runs" && "$bin" run "$input" -o "$name" "${options[@]}") >>"$log" 2>&1 || status=$?
  echo "STATUS $status" >>"$log"
  ls "$runs/$name"/*.c1.json >/dev/null || { cat "$log" >&2; exit 1; }
}

picture() { # NAME OPTIONS…; @RUN stands for the result of a run, @RUN:trace for its trace
  local name=$1 argument written="c1mesh draw"
  local -a arguments=()
  cd "$runs"
  for argument in "${@:2}" -o "$name.svg"; do
    case $argument in
      @*:trace) argument=${argument#@} argument=${argument%:trace}/trace.jsonl ;;
      @*) argument=$(echo "${argument#@}"/*.c1.json) ;;
    esac
    arguments+=("$argument")
    [[ $argument != *[\ \(]* ]] || argument="'$argument'"
    written+=" $argument"
  done
  "$bin" draw "${arguments[@]}"
  rm -f "$out/$name.svg" "$out/$name.png"
  if (($(stat -c %s "$name.svg") > 300000)); then
    rsvg-convert -w 1000 "$name.svg" -o "$out/$name.png"
    rm "$name.svg"
  else
    mv "$name.svg" "$out/"
  fi
  echo "$written" >>pictures
}
: >"$runs/pictures"
"$bin" --quiet generate --set B --count 1 --seed 7 -o "$runs/shapes"

# Figure 1
run shape shapes/B-0001.json
picture 01-shape @shape --parts outline,mesh,shape,domain --grid 30 --width 1300
# Figures 4 and 14
run plate-initial docs/evaluation/shapes/plate.svg "${paper[@]}" --last-stage initial
run plate-paper docs/evaluation/shapes/plate.svg "${paper[@]}"
picture 04-kinks @plate-initial @plate-paper --parts shape --columns 2 --grid 50 --no-mesh \
  --zoom 12,0.3 --titles "C0: initial,C1: final" --width 1300
picture 14-plate @plate-paper --width 1100
# Figure 5
run blob-initial examples/blob.svg "${paper[@]}" --last-stage initial
run blob-one examples/blob.svg "${paper[@]}" --last-stage one
run blob-paper examples/blob.svg "${paper[@]}"
picture 05-overview @blob-initial @blob-one @blob-paper --parts mesh,domain --columns 3 --grid 0 \
  --titles "initial,after phase one,after phase two" --width 1300
# Figure 6
run puzzle-unbounded examples/puzzle.svg "${gentle[@]}" --last-stage one --alpha 1e6
run puzzle-unbounded-5 examples/puzzle.svg "${paper[@]}" --last-stage one --alpha 1e6
run puzzle-bounded examples/puzzle.svg "${gentle[@]}" --last-stage one --alpha 100
picture 06-bound @puzzle-unbounded @puzzle-bounded --zoom 29,0.1 --colour distortion --grid 36 \
  --titles "without a bound (alpha 1e6),with a bound (alpha 100)" --width 1400
# Figures 10 and 15
run spiral-initial examples/spiral.svg "${paper[@]}" --last-stage initial
run spiral-one examples/spiral.svg "${paper[@]}" --last-stage one
run spiral-paper examples/spiral.svg "${paper[@]}"
picture 10-straightened @spiral-paper --over @spiral-one --parts domain --zoom apart,0.02 --grid 0 \
  --titles "straightened (black) and after phase one (red)" --width 1000
picture 15-spiral @spiral-initial @spiral-paper --grid 0 --titles initial,final --width 1000
picture 15-spiral-trace @spiral-paper:trace --width 900
# Figure 12
run annulus-initial examples/annulus.svg "${paper[@]}" --last-stage initial
for alpha in 1 1.5 2 3 5 10 100; do
  run annulus-paper-$alpha examples/annulus.svg "${paper[@]}" --alpha $alpha
done
picture 12-alpha @annulus-initial @annulus-paper-{1,1.5,2,3,5,10,100} --parts domain --columns 4 \
  --grid 0 --width 1200 \
  --titles "initial,alpha 1,alpha 1.5,alpha 2,alpha 3,alpha 5,alpha 10,alpha 100"
# Figure 13
run puzzle-initial examples/puzzle.svg "${gentle[@]}" --last-stage initial
run puzzle-gentle examples/puzzle.svg "${gentle[@]}"
picture 13-puzzle @puzzle-initial @puzzle-gentle --width 900 --titles initial,final
# Figure 16
run interfaces-paper examples/interfaces.json "${paper[@]}"
picture 16-interfaces @interfaces-paper --width 1100
# Side by side
run puzzle-paper examples/puzzle.svg "${paper[@]}"
for name in puzzle spiral annulus; do run $name-exact examples/$name.svg; done
run interfaces-exact examples/interfaces.json
run annulus-exact-10 examples/annulus.svg --alpha 10
side_by_side() { # NAME EXACT PAPER OPTIONS…
  picture "both-$1" "@$2" "@$3" --titles "exact,paper" "${@:4}"
}
side_by_side puzzle puzzle-exact puzzle-paper --columns 2 --width 1400
side_by_side spiral spiral-exact spiral-paper --grid 60 --width 1000
side_by_side annulus-10 annulus-exact-10 annulus-paper-10 --columns 2 --width 1400
side_by_side annulus-100 annulus-exact annulus-paper-100 --columns 2 --width 1400
side_by_side interfaces interfaces-exact interfaces-paper --columns 2 --width 1400

python3 "$here/figures.py" "$runs" "$out" "$here/evaluation/figures.in.md" >"$runs/page.md"
cp "$runs/page.md" "$out.md"
