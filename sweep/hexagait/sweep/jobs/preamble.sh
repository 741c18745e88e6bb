set -euo pipefail
hexagait=${HEXAGAIT:-@program@}
sweep=${HEXAGAIT_SWEEP:-@sweep@}
folder=${HEXAGAIT_FOLDER:-@folder@}
results=$PWD
shards=@shards@
# shard K: runs the K-th of them, or what an earlier run of it left to do.
shard() {
  (cd "$folder" && "$hexagait" sweep "$sweep" --shard "$1/$shards" --jobs @jobs@ \
    --out "$results/shard-$1" --quiet --yes@timeout@)
}
merge() {
  "$hexagait" merge $(seq -f 'shard-%.0f' "$shards") --out merged
}
