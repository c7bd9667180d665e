#!/usr/bin/env bash
# `fuzz.sh BUILD SECONDS [TARGET...]` fuzzes the targets built in BUILD for so long each, two at a
# time, from the cases. A build finds the same each time: SEED (1) in the environment makes other
# choices. Fails at the first finding, which lies in BUILD/fuzz/<target> then.
set -euo pipefail
build=$(cd "$1" && pwd)
seconds=$2
shift 2
targets=("$@")
if (($# == 0)); then
    targets=(lex parse edit literal format render build sentence)
fi
"$(dirname "$0")/write_seeds.sh" "$build/fuzz"

# The log is long, and of interest when something was found.
fuzz() {
    local folder="$build/fuzz/$1"
    mkdir -p "$folder/corpus"
    if ! "$build/tests/fuzz/iecfront_$1_fuzzer" -seed="${SEED:-1}" -max_total_time="$seconds" -max_len=2000 \
        -timeout=20 -rss_limit_mb=4096 -print_final_stats=1 -dict="$build/fuzz/dictionary" \
        -artifact_prefix="$folder/" "$folder/corpus" "$build/fuzz/seeds" > "$folder/log" 2>&1; then
        tail -n 60 "$folder/log"
        find "$folder" -maxdepth 1 -type f ! -name log -printf '%f\n' -exec base64 '{}' ';'
        return 1
    fi
    printf '%-9s %s, %s\n' "$1" "$(grep -o 'DONE.*' "$folder/log")" \
        "$(grep number_of_executed_units "$folder/log")"
}
export -f fuzz
export build seconds
printf '%s\n' "${targets[@]}" | xargs -P 2 -I '{}' bash -euc 'fuzz {}'
