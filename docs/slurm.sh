#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A batch as a Slurm array job: every task does its shard, and may be ended and started again.
#   sbatch --array=1-16 docs/slurm.sh INPUTS OUT [options of c1mesh batch]
# INPUTS is a folder or a list of paths that does not change meanwhile. Sent in again, it goes on where
# it was. When all tasks are done, one index is made of the shards' (here, or as a job of its own):
#   docs/slurm.sh merge OUT 16
# C1MESH names the program (c1mesh).
#SBATCH --job-name=c1mesh
#SBATCH --cpus-per-task=4
#SBATCH --mem-per-cpu=2G
#SBATCH --requeue
#SBATCH --open-mode=append
set -euo pipefail

# merge OUT N: index.jsonl and times.jsonl appear whole, or not at all if a shard is not finished.
merge() {
  local name shard parts
  for name in index times; do
    parts=()
    for ((shard = 1; shard <= $2; ++shard)); do
      parts+=("$1/$name.$shard-of-$2.jsonl")
      [[ -e ${parts[-1]} ]] || { echo "shard $shard of $2 is not finished: no ${parts[-1]}" >&2; return 5; }
    done
    LC_ALL=C sort "${parts[@]}" >"$1/.$name.merged"
    mv "$1/.$name.merged" "$1/$name.jsonl"
  done
}

if [[ ${1:-} == merge && $# -eq 3 ]]; then
  merge "$2" "$3"
  exit
fi
(($# >= 2)) || { sed -n '4,8s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
[[ ${SLURM_ARRAY_TASK_MIN:-1} == 1 ]] || { echo "the array must begin with 1" >&2; exit 2; }
inputs=$1 out=$2
shift 2
# In the place of this shell, so that Slurm's signals reach the program.
exec "${C1MESH:-c1mesh}" batch "$inputs" -o "$out" --resume --jobs "${SLURM_CPUS_PER_TASK:-1}" \
  --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" "$@"
