#!/usr/bin/env bash
# A sweep of short curves: throughput of two workers against one, and the same bytes after SIGKILL
# half-way and --resume.  five_hundred_runs.sh PHS [RUNS (500) [REPEATS (1)]]
# The throughput is printed, not judged: it is the machine's.
set -euo pipefail
phs="$(realpath "$1")"
runs="${2:-500}"
repeats="${3:-1}"
dir="$(mktemp -d)"
trap 'rm -rf "$dir"' EXIT
cd "$dir"

cat >short_track.yaml <<TRACK
name: short_curve
description: a short curve of 550 m
gauge_m: 1.067
gauge_height_m: 0.014
cant_pivot: low_rail
friction: 0.35
segments:
  - {kind: tangent, length_m: 20}
  - {kind: transition, length_m: 60}
  - {kind: curve, hand: left, radius_m: 550, length_m: 60, cant_m: 0.06}
  - {kind: transition, length_m: 30}
  - {kind: tangent, length_m: 1}
TRACK
cat >short.yaml <<SCENARIO
track: $dir/short_track.yaml
bogie: phs
speed_km_h: 70
SCENARIO
cat >curves.yaml <<STUDY
scenario: short.yaml
design: latin_hypercube
samples: $runs
seed: 3
axes:
  - {key: track.segments.*.radius_m, min: 400, max: 900}
  - {key: scenario.speed_km_h, min: 60, max: 80}
  - {key: scenario.friction, min: 0.2, max: 0.45}
STUDY

# sweep NAME WORKERS: seconds of wall clock and of processor into $wall, $cpu.
sweep() {
  local TIMEFORMAT='%R %U %S'
  local spent
  spent="$({ time "$phs" sweep curves.yaml --quiet --force --out "$1" --workers "$2" >/dev/null; } 2>&1)"
  read -r wall user system <<<"$spent"
  cpu="$(awk "BEGIN {print $user + $system}")"
}

echo "$runs runs, $(nproc) processors, load before: $(cut -d ' ' -f 1 /proc/loadavg)"
for _ in $(seq "$repeats"); do
  sweep one 1
  wall_1="$wall" cpu_1="$cpu"
  sweep two 2
  awk -v n="$runs" -v w1="$wall_1" -v c1="$cpu_1" -v w2="$wall" -v c2="$cpu" 'BEGIN {
    printf "1 worker: %.1f s, %.2f runs/s, %.0f ms processor per run (%.0f %% of a core)\n", \
      w1, n / w1, 1e3 * c1 / n, 100 * c1 / w1
    printf "2 workers: %.1f s, %.2f runs/s, %.0f ms processor per run (%.0f %% of two cores)\n", \
      w2, n / w2, 1e3 * c2 / n, 50 * c2 / w2
    printf "throughput %.2f times; per processor second that the machine gave: %.2f of one worker\n", \
      w1 / w2, c1 / c2}'
done
cmp one/sweep.csv two/sweep.csv

# Killed half-way: the whole process group at once, then resumed.
setsid "$phs" sweep curves.yaml --quiet --out killed --workers 2 >/dev/null 2>&1 &
sweep_pid=$!
until [ "$(find killed.unfinished/runs -name '*.json' 2>/dev/null | wc -l)" -ge $((runs / 2)) ]; do
  sleep 0.05
done
kill -KILL -- "-$sweep_pid"
wait "$sweep_pid" 2>/dev/null || true
kept="$(find killed.unfinished/runs -name '*.json' | wc -l)"
[ ! -e killed ] && [ "$kept" -lt "$runs" ]
"$phs" sweep curves.yaml --quiet --out killed --workers 2 --resume >/dev/null
cmp one/sweep.csv killed/sweep.csv
echo "killed with $kept of $runs runs done, resumed: the table has the same bytes"
