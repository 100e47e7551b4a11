#!/usr/bin/env bash
# Builds the fuzz targets and runs them one after another; ends with status 1 if one found something.
#
# usage: tests/fuzz/run.sh [EXECUTIONS [TARGET…]]
#   EXECUTIONS  of each reader's target (default 1000000); the road gets a fiftieth
#   TARGET…     these alone (default: all)
# Environment: OUT, a folder for the logs, what was found and the grown corpora (default
# build/fuzz/out); JOBS, processes of the build (default 2).
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."

executions=${1:-1000000}
shift || true
targets=("$@")
((${#targets[@]})) || targets=(path_data shape_json svg font_text font_bytes result result_use certificate trace
  batch_list road)
out=${OUT:-build/fuzz/out}

# What was freed is kept back for a while, to see its use. The usual 256 MB of it break the allocator's
# pages into pieces: after 300,000 results 2 GB are taken with 35 MB in use.
export ASAN_OPTIONS="quarantine_size_mb=16${ASAN_OPTIONS:+:$ASAN_OPTIONS}"

cmake --preset fuzz >&2
cmake --build --preset fuzz -j "${JOBS:-2}" --target "${targets[@]/#/fuzz_}" >&2

status=0
for target in "${targets[@]}"; do
  seeds=$target
  runs=$executions
  options=(-max_len=4096)
  case $target in
    result | result_use) seeds=result options=(-max_len=12000) ;;
    road) runs=$((executions / 50)) options=(-max_len=96) ;;
  esac
  dictionary=tests/fuzz/dictionaries/$seeds.dict
  [[ ! -e $dictionary ]] || options+=("-dict=$dictionary")
  mkdir -p "$out/$target"
  # The first folder takes what is new; the committed seeds stay as they are.
  if build/fuzz/bin/fuzz_"$target" "$out/$target" "tests/fuzz/corpus/$seeds" -runs="$runs" -seed=1 \
    -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 -verbosity=0 "${options[@]}" \
    -artifact_prefix="$out/$target-" >"$out/$target.log" 2>&1; then
    verdict=clean
  else
    verdict="FOUND SOMETHING: $out/$target-*"
    status=1
  fi
  awk -v name="$target" -v verdict="$verdict" '
    /number_of_executed_units/ { runs = $2 } /average_exec_per_sec/ { rate = $2 }
    END { printf "%-11s %9d executions, %6d a second, %s\n", name, runs, rate, verdict }' \
    "$out/$target.log"
done
exit "$status"
