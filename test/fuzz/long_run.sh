#!/usr/bin/env bash
# Runs every fuzzer for RUNS executions, in rounds, one fuzzer after the other.
#   long_run.sh run BUILD STATE     continues where the last call stopped; BUILD: of preset fuzz,
#                                   or fuzz_plain, which is faster and has no sanitizers
#   long_run.sh table STATE         prints the results in the logs as a table
#   long_run.sh page STATE PAGE.md  replaces the table in the page
# Environment: RUNS (10000000), ROUND (seconds, 300), ONLY (names of fuzzers).
# Two calls for different ONLY may run at once. All results are in the logs of STATE, so if
# the machine stops, only the work of a round since its last line is lost.
set -euo pipefail

runs=${RUNS:-10000000}
round=${ROUND:-300}

# Executions according to a fuzzer's log; with a second argument, its row of the table.
# The coverage is that of rounds with sanitizers, because builds have different numbers
# of edges.
summarize() {
  awk -v row="${2:-}" '
    function close_round() {
      total += last
      if (!plain) sanitized += last
      if (cpu) { seconds += cpu; timed += last }
      last = cpu = 0
    }
    function grouped(number, text, groups) {
      for (text = sprintf("%d", number); length(text) > 3; text = substr(text, 1, length(text) - 3))
        groups = "," substr(text, length(text) - 2) groups
      return text groups
    }
    /^round / { close_round(); plain = $3 == "fuzz_plain" }
    /^#[0-9]+\t/ && substr($1, 2) + 0 > last { last = substr($1, 2) + 0 }
    /^stat::number_of_executed_units:/ && $2 + 0 > last { last = $2 + 0 }
    /^cpu / { cpu = $2 + $3 }
    /^#[0-9]+\t.* cov: / && !plain {
      for (i = 1; i < NF; ++i) {
        if ($i == "cov:" && $(i + 1) > edges) edges = $(i + 1)
        if ($i == "ft:" && $(i + 1) > features) features = $(i + 1)
        if ($i == "corp:") inputs = $(i + 1) + 0
      }
    }
    END {
      close_round()
      if (!row) { printf "%d\n", total; exit }
      printf "| `%s` | %s | %s | %s | %s | %s | %s |\n", row, grouped(total), grouped(sanitized),
        seconds ? grouped(timed / seconds) : "-", grouped(edges), grouped(features),
        grouped(inputs)
    }' "$1"
}

# Copies the programs that exist, their options and their seeds, so that a build during
# the run has no effect on it.
takeBuild() {
  local bin name options option
  bin="$2/bin/$(basename "$1")"
  mkdir -p "$bin"
  exec 9> "$2/lock"
  flock 9
  find "$1/modules" -name 'lib*.so.*' -exec cp -P --remove-destination -t "$bin" {} +
  cp "$1/test/fuzz/fuzzers.txt" "$2/fuzzers.txt"
  while read -r name options; do
    mkdir -p "$2/$name/corpus" "$2/$name/found"
    touch "$2/$name/log"
    [ -x "$1/bin/$name" ] || continue
    cp --remove-destination "$1/bin/$name" "$bin/$name"
    for option in $options; do
      if [ -d "$option" ]; then find "$option" -type f -exec cp -t "$2/$name/corpus" {} +; fi
    done
  done < "$2/fuzzers.txt"
  exec 9>&-
}

# Runs one round of a fuzzer; fails if it found something. The timeout of an input is
# more than ten seconds, because the machine may be busy. AddressSanitizer would reuse
# memory only after 256 MB more, and page faults would take a third of the time.
runRound() {
  local state=$1 kind=$2 name=$3 remaining=$4 flags=() log code=0
  shift 4
  for option in "$@"; do [[ $option != -* ]] || flags+=("$option"); done
  log="$state/$name/log"
  printf '\nround %s %s\n' "$(date -u +%FT%TZ)" "$kind" >> "$log"
  TIMEFORMAT='cpu %U %S'
  flags+=(-runs="$remaining" -max_total_time="$round" -timeout=120 -print_final_stats=1
    -artifact_prefix="$state/$name/found/")
  {
    time ASAN_OPTIONS=quarantine_size_mb=16:malloc_context_size=3 \
      LD_LIBRARY_PATH="$state/bin/$kind" "$state/bin/$kind/$name" "${flags[@]}" \
      "$state/$name/corpus" \
      > /dev/null 2>> "$log" || code=$?
  } 2>> "$log"
  return $code
}

runAll() {
  local state=$1 kind=$2 left=1 failed=() name options counted
  while [ $left = 1 ]; do
    left=0
    while read -r -u 3 name options; do
      [ -x "$state/bin/$kind/$name" ] || continue
      [ -z "${ONLY:-}" ] || [[ " $ONLY " == *" $name "* ]] || continue
      [[ " ${failed[*]} " != *" $name "* ]] || continue
      counted=$(summarize "$state/$name/log")
      [ "$counted" -lt "$runs" ] || continue
      left=1
      # shellcheck disable=SC2086
      runRound "$state" "$kind" "$name" $((runs - counted)) $options || {
        [ $? != 72 ] || exit 130 # interrupted
        failed+=("$name")
        echo "$name found something: see $state/$name/found" >&2
      }
    done 3< "$state/fuzzers.txt"
  done
  [ ${#failed[@]} = 0 ]
}

table() {
  local name options
  echo "| fuzzer | executions | with sanitizers | per second on one core | edges | features | inputs kept |"
  echo "|---|---|---|---|---|---|---|"
  while read -r name options; do
    summarize "$1/$name/log" "$name"
  done < "$1/fuzzers.txt"
}

page() {
  table "$1" > "$2.table"
  awk -v table="$2.table" '
    /^\| fuzzer \| executions / { while ((getline line < table) > 0) print line; inside = 1; next }
    inside && /^\|/ { next }
    { inside = 0; print }' "$2" > "$2.new"
  rm "$2.table"
  mv "$2.new" "$2"
}

case ${1:-} in
  run) takeBuild "$2" "$3"; runAll "$3" "$(basename "$2")" ;;
  table) table "$2" ;;
  page) page "$2" "$3" ;;
  *) sed -n '2,10s/^# \{0,1\}//p' "$0"; exit 2 ;;
esac
