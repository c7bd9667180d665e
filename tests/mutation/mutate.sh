#!/usr/bin/env bash
# `mutate.sh BUILD [COUNT [SEED]]` shows how many of COUNT (400) small faults in lexer, parser and
# diagnostics the tests notice; SEED (1) chooses other ones. Prints those that no test notices, and
# the rate; BUILD/report has all of them. Needs a quarter of an hour to build, and a few seconds for
# each fault.
#
# mutate.cpp writes a copy of the sources that holds all of these mutations, each behind a question
# for its number; it is built once in BUILD, and the environment says which one is in force. What
# the compiler refuses does not count. The test programs run in the order below, those that reach the
# mutation, until one fails; a crash is a failure, and so is a run that takes more than LIMIT (10)
# seconds of processor time.
#
# NUMBERS="12 345" in the environment runs only these of a build that is there. By hand:
#     IECFRONT_MUTANT=12 BUILD/build/tests/iecfront_cases_tests --gtest_brief=1
set -euo pipefail

folders=(src/lexer src/parser src/diagnostics)
programs=(diagnostics lexer cases parser grammar source ast compliance builder docs fuzz format cli)
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
mkdir -p "$1"
build=$(cd "$1" && pwd)
count=${2:-400}
seed=${3:-1}
limit=${LIMIT:-10}
tree=$build/tree
tests=$build/build/tests

write_mutated() {
    "$build/mutate" "$root" "$tree" "$build/chosen" "${folders[@]}" > "$build/mutations"
}

# Each so-manieth of them, of each kind and file alike.
choose() {
    : > "$build/chosen"
    write_mutated
    sort -s -t $'\t' -k 3,3 "$build/mutations" | awk -v count="$count" -v seed="$seed" '
        { numbers[NR] = $1 }
        END {
            for (i = 0; i < count && i < NR; ++i)
                print numbers[1 + int((i + seed / 7 % 1) * NR / count) % NR]
        }' | sort -nu > "$build/chosen"
}

# Leaves out what the compiler refuses; there may be more behind it.
build_library() {
    local refused=$build/refused
    while
        write_mutated
        ! cmake --build "$build/build" --target iecfront -- -k 0 > "$build/log" 2>&1
    do
        sed -n 's/.*\bmutant:\([0-9]*\):.*/\1/p' "$build/log" | sort -u > "$refused"
        if [[ ! -s $refused ]]; then
            grep -F -m 20 error: "$build/log" || tail -n 30 "$build/log" >&2
            return 1
        fi
        grep -vxFf "$refused" "$build/chosen" > "$build/kept"
        mv "$build/kept" "$build/chosen"
    done
}

configure() {
    cmake -S "$tree" -B "$build/build" -G Ninja -D CMAKE_BUILD_TYPE=Release \
        -D CMAKE_CXX_FLAGS_RELEASE="-O1 -w -include $here/mutant.hpp" \
        -D IECFRONT_BUILD_EXAMPLES=OFF -D IECFRONT_UNITY_BUILD=OFF > "$build/log"
}

# Some tests read the sources, which then have to be as they are.
build_tests() {
    cmake --build "$build/build" --target iecfront_command \
        $(printf 'iecfront_%s_tests ' "${programs[@]}") > "$build/log"
    cp -a "$root/src" "$tree"
}

prepare() {
    rm -rf "$tree"
    mkdir "$tree"
    (cd "$root" && cp -a .ci CMakeLists.txt LICENSE README.md docs examples include src tests "$tree")
    "${CXX:-g++}" -std=c++20 -O1 "$here/mutate.cpp" -o "$build/mutate"
    choose
    configure
    build_library
    build_tests
}

# A part of the tests: a program, or one test of it.
run() { # PROGRAM[:TEST]
    local filter='*'
    [[ $1 != *:* ]] || filter=${1#*:}
    "$tests/iecfront_${1%%:*}_tests" --gtest_brief=1 --gtest_fail_fast --gtest_filter="$filter"
}

# In the order in which they are run: what must hold of any case takes most of the time, and most
# mutations are reached by few of these tests.
parts() {
    printf '%s\n' "${programs[@]}" | sed 's/^cases$/cases:-*MustAlwaysHold*/'
    "$tests/iecfront_cases_tests" --gtest_list_tests |
        awk '/^[^ ]/ { suite = $1 } /^ / { print "cases:" suite $1 }' | grep MustAlwaysHold
}

# Without a mutation all pass. In BUILD/reached is a file for each part with the mutations that it
# reaches, called by its place in that order and its name.
run_unchanged() {
    local part place=100 reached=$build/reached
    rm -rf "$reached"
    mkdir "$reached"
    for part in $(parts); do
        if ! IECFRONT_REACHED=$reached/now run "$part" > "$build/log" 2>&1; then
            tail -n 30 "$build/log"
            echo "mutate.sh: the tests of $part fail without a mutation"
            return 1
        fi
        [[ ! -e $reached/now ]] ||
            mv "$reached/now" "$reached/$((++place)) ${part//\//,}"
    done
}

# A line: number, and what caught it, and how that ended when it was killed.
run_mutation() { # NUMBER
    local part scratch status by=SURVIVED
    scratch=$(mktemp -d)
    cd "$scratch"
    ulimit -v 3000000
    ulimit -t "$limit"
    ulimit -c 0
    while read -r part; do
        part=${part#* }
        part=${part//,/\/}
        status=0
        IECFRONT_MUTANT=$1 TMPDIR=$scratch run "$part" < /dev/null > /dev/null 2>&1 || status=$?
        if ((status != 0)); then
            by=$part
            ((status < 128)) || by+=", $(kill -l "$status")"
            break
        fi
    done < <(cd "$build/reached" && grep -lx "$1" -- *)
    rm -rf "$scratch"
    printf '%s\t%s\n' "$1" "$by" >> "$build/results"
}

report() {
    sort -n "$build/results" | awk -F '\t' -v OFS='\t' '
        NR == FNR { by[$1] = $2; next }
        $1 in by { print $1, by[$1], $2, $3, $4, $5 }' - "$build/mutations" > "$build/report"
    grep SURVIVED "$build/report" || true
    awk -F '\t' '
        { ++all[$4]; ++total }
        $2 != "SURVIVED" { ++caught[$4]; ++sum }
        END {
            for (kind in all)
                printf "%4d of %4d  %s\n", caught[kind], all[kind], kind | "sort -k 4"
            close("sort -k 4")
            printf "%4d of %4d  caught: %.1f %%\n", sum, total, 100 * sum / total
        }' "$build/report"
}

if [[ -z ${NUMBERS:-} ]]; then
    prepare
    NUMBERS=$(cat "$build/chosen")
fi
run_unchanged
rm -f "$build/results"
export -f run run_mutation
export build tests limit
printf '%s\n' $NUMBERS | shuf | xargs -P "$(nproc)" -I '{}' bash -euc 'run_mutation {}'
report
