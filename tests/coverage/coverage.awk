# Reads what `gcov --stdout --branch-counts` prints, and merges it: a line counts as run when any
# instantiation or translation unit runs it, and so does each branch of it.
#
# A line is printed once for each function that it is in. The branches of the line in one function
# are taken for the same as those in another when they are as many. Where the line is run in any
# function, those functions in which none of its branches is reached say nothing; gcov does not tell
# which of their branches are exceptions only.

# ---- one line in one function --------------------------------------------------------------------

# Branches stand behind their line. An exception leaves a call, which then has a pair of branches:
# that pair is none of the source.
function end_line(   at, key, count) {
    count = shape_of(number)
    if (reached && !(number in reached_once)) {
        reached_once[number] = 1
        delete shapes[number]
    }
    if (count > 0 && (reached || !(number in reached_once))) {
        if (!index(shapes[number] " ", " " count " "))
            shapes[number] = shapes[number] " " count
        for (at = 0; at < branches; ++at) {
            key = number SUBSEP count SUBSEP at % count
            taken[key] = taken[key] || branch_taken[at]
        }
    }
    branches = 0
    reached = 0
}

# How many branches there are to tell apart. gcov does not take apart what the instantiations of a
# generic lambda have in its second line and below: there it stands one behind the other, and is
# folded to what the words of the line make of it. Only a switch has so many branches else.
function shape_of(number,   code, ways) {
    code = text[number]
    ways = 2 + 2 * gsub(/&& [^.]|\|\| [^.]/, "", code)
    return branches >= 10 * ways && branches % ways == 0 && code !~ /^switch/ ? ways : branches
}

/^ *-: *0:Source:/ {
    end_line()
    file = $0
    sub(/^ *-: *0:Source:/, "", file)
    wanted = file ~ /^(src|include)\//
    next
}
!wanted { next }
/^ *([0-9]+\*?|#####|=====|-): *[0-9]+:/ {
    end_line()
    split($0, parts, ":")
    count = parts[1]
    number = file ":" (parts[2] + 0)
    gsub(/ /, "", count)
    if (count == "-")
        next
    if (!(number in runs)) {
        runs[number] = 0
        order[++lines] = number
        code = $0
        sub(/^[^:]*:[^:]*: */, "", code)
        text[number] = code
    }
    if (count ~ /^[0-9]/)
        runs[number] = 1
    next
}
/^branch .* \(throw\)$/ {
    reached = 1
    if (branches > 0)
        --branches # the other one of the pair, which is the way on
    next
}
/^branch / {
    if ($3 == "taken")
        reached = 1
    branch_taken[branches++] = $3 == "taken" && $4 > 0
    next
}

# ---- the report ----------------------------------------------------------------------------------

function part_of(number) {
    return number ~ /^src\/cli\// ? "the command" : "the library"
}

function add(name, line_runs, all_branches, taken_branches) {
    ++line_count[name]
    run_count[name] += line_runs
    branch_count[name] += all_branches
    taken_count[name] += taken_branches
}

function percent(some, all) {
    return all == 0 ? 100 : 100 * some / all
}

function figures(name) {
    return sprintf("%6.1f %% %5d/%-5d  %6.1f %% %5d/%-5d  %s",
        percent(run_count[name], line_count[name]), run_count[name], line_count[name],
        percent(taken_count[name], branch_count[name]), taken_count[name], branch_count[name], name)
}

function count_line(number,   name, count, shape, i, j, all, some) {
    count = split(shapes[number], shape, " ")
    for (i = 1; i <= count; ++i) {
        for (j = 0; j < shape[i]; ++j) {
            ++all
            some += taken[number SUBSEP shape[i] SUBSEP j]
        }
    }
    name = number
    sub(/:[0-9]+$/, "", name)
    if (!(name in line_count))
        files[++file_count] = name
    add(name, runs[number], all, some)
    add(part_of(number), runs[number], all, some)
    if (!runs[number])
        print number ": not run: " text[number] | sorted
    else if (some < all)
        print number ": " all - some " of " all + 0 " branches: " text[number] | sorted
}

END {
    end_line()
    sorted = "sort -t : -k 1,1 -k 2,2n > \"" uncovered "\""
    for (i = 1; i <= lines; ++i)
        count_line(order[i])
    close(sorted)
    print "          lines               branches"
    by_name = "sort -k 7"
    for (i = 1; i <= file_count; ++i)
        print figures(files[i]) | by_name
    close(by_name)
    print figures("the library")
    print figures("the command")
    exit percent(run_count["the library"], line_count["the library"]) < least_lines ||
        percent(taken_count["the library"], branch_count["the library"]) < least_branches
}
