#!/bin/sh
# Counts what reading costs in instructions, which, unlike times, are the same in each run. Needs
# valgrind and awk.
#
#     count_instructions.sh WORK figures         prints instructions per byte of source of each step
#     count_instructions.sh WORK check           compares these with instructions.txt
#     count_instructions.sh WORK growth [SHAPE]  compares texts of SMALL and LARGE bytes of each shape,
#                                                in what STEP (parse) takes
#     count_instructions.sh WORK edits           compares key strokes in texts of 1 and of 4 MB
#
# WORK is the program iecfront_work of a Release build. `check` counts only with the compiler that
# instructions.txt names. `growth` without names takes all shapes, in less than a minute on two cores.
set -eu

folder=$(dirname "$0")
recorded=$folder/instructions.txt
text_size=1000000
tolerance=5         # percent, of `check`
growth_tolerance=15 # percent, of `growth` and `edits`
SMALL=${SMALL:-25000}
LARGE=${LARGE:-250000}
STEP=${STEP:-parse}

# Instructions of one run: WORK STEP TEXT SIZE.
count() {
    valgrind --tool=cachegrind --cache-sim=no --cachegrind-out-file=/dev/null "$work" "$@" 2>&1 |
        awk '/I *refs:/ { gsub(",", "", $NF); print $NF; found = 1 }
             END { if (!found) { print "no count of instructions" > "/dev/stderr"; exit 1 } }'
}

figures() {
    text=$(count text generated $text_size)
    lex_cut=$(count lex_cut generated $text_size)
    parse=$(count parse generated $text_size)
    walk=$(count walk generated $text_size)
    nodes=$(count nodes generated $text_size)
    awk -v size=$text_size -v text="$text" -v lex="$lex_cut" -v parse="$parse" -v walk="$walk" \
        -v nodes="$nodes" '
        BEGIN {
            printf "lex_cut %.2f\n", (lex - text) / size
            printf "parse %.2f\n", (parse - text) / size
            printf "walk %.2f\n", (walk - parse) / size
            printf "nodes %.2f\n", (nodes - parse) / size
        }'
}

check() {
    compiler=$(awk '$1 == "g++" { print $2 }' "$recorded")
    here=$(g++ -dumpfullversion)
    if [ "$compiler" != "$here" ]; then
        echo "counted with g++ $compiler, not with $here: not compared"
        return 0
    fi
    now=$(figures)
    { cat "$recorded"; echo; echo "$now"; } | awk -v tolerance=$tolerance '
        /^#/ || $1 == "g++" || NF != 2 { next }
        !($1 in before) { before[$1] = $2; next }
        {
            change = ($2 / before[$1] - 1) * 100
            wrong = change > tolerance || change < -tolerance
            failed = failed || wrong
            printf "%-8s %7.2f instructions per byte, recorded %7.2f, %+.1f %%%s\n",
                   $1, $2, before[$1], change, wrong ? ": record it anew if it is meant" : ""
        }
        END { exit failed }'
}

# One line: growth in percent of what a byte costs, the shape, and what a byte costs in either size.
growth_of() {
    small=$(count "$STEP" "$1" "$SMALL")
    large=$(count "$STEP" "$1" "$LARGE")
    awk -v shape="$1" -v none="$none" -v small="$small" -v large="$large" \
        -v small_size="$SMALL" -v large_size="$LARGE" '
        BEGIN {
            a = (small - none) / small_size
            b = (large - none) / large_size
            printf "%+7.1f %% %-26s %8.1f %8.1f\n", (b / a - 1) * 100, shape, a, b
        }'
}

# The shapes are counted side by side, by this script itself.
growth() {
    [ $# -gt 0 ] || set -- $("$work" shapes)
    none=$(count text blanks 1)
    export none SMALL LARGE STEP
    printf '%s\n' "$@" | xargs -n 1 -P "$(nproc)" "$0" "$work" growth_of |
        sort -rn | awk -v tolerance=$growth_tolerance '
            { print }
            $1 + 0 > tolerance { failed = 1; print "more than in proportion to the text: " $3 }
            END { exit failed }'
}

# Of all key strokes that `edit` makes, in a text of $1 bytes.
key_strokes() {
    parse=$(count parse generated "$1")
    edit=$(count edit generated "$1")
    echo $((edit - parse))
}

# What grows with the text is the row of slots alone, which is short beside what a unit takes.
edits() {
    small=$(key_strokes $text_size)
    large=$(key_strokes $((4 * text_size)))
    awk -v small="$small" -v large="$large" -v tolerance=$growth_tolerance '
        BEGIN {
            growth = (large / small - 1) * 100
            printf "key strokes: %d instructions in 1 MB, %d in 4 MB, %+.1f %%\n", small, large, growth
            exit growth > tolerance
        }'
}

if [ $# -lt 2 ] || [ ! -x "$1" ]; then
    sed -n '2,/^set/p' "$0" | grep '^#' >&2
    exit 2
fi
work=$1
what=$2
shift 2
case $what in
figures) figures ;;
check) check ;;
growth) growth "$@" ;;
edits) edits ;;
growth_of) growth_of "$@" ;; # for itself
*) echo "count_instructions.sh: there is no $what" >&2; exit 2 ;;
esac
