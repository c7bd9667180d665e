#!/usr/bin/env bash
# Says how much of src/ and include/ the tests run. The target `coverage` calls it:
#
#     coverage.sh BUILD GCOV             runs the tests of a build with IECFRONT_COVERAGE first
#     coverage.sh --report BUILD GCOV    reports on the tests that were run there
#
# What is left over goes to BUILD/uncovered.txt. It fails when a test does, or when the library is
# covered less than `docs/testing.md` says.
set -euo pipefail

least_lines=97
least_branches=92

run=1
[[ ${1-} != --report ]] || { run=0; shift; }
build=$(cd "$1" && pwd)
gcov=$2
folder=$(cd "$(dirname "$0")" && pwd)
sources=$(cd "$folder/../.." && pwd)
status=0

if ((run)); then
    find "$build" -name '*.gcda' -delete
    ctest --test-dir "$build" --output-on-failure -LE package -j "$(nproc)" || status=$?
fi

# Relative names only are those below the sources.
find "$build" -name '*.gcda' -print0 | (cd "$build" && xargs -0 "$gcov" --stdout \
    --branch-probabilities --branch-counts --source-prefix "$sources" --relative-only) |
    awk -v uncovered="$build/uncovered.txt" -v least_lines=$least_lines \
        -v least_branches=$least_branches -f "$folder/coverage.awk" || status=$?
echo "what is left over: $build/uncovered.txt"
exit $status
