#!/bin/sh
# What fuzzing begins with, made of what is there: `write_seeds.sh FOLDER` writes the source of each
# case and each example to FOLDER/seeds, and the words of the language to FOLDER/dictionary.
set -eu
top=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1/seeds"

find "$top/tests/cases" -name '*.txt' ! -name required_tags.txt -exec awk -v folder="$1/seeds" '
    FNR == 1 { inside = 0 }
    /^=== / { close(file); file = sprintf("%s/case%05d", folder, ++count); inside = 1; next }
    /^--- / { inside = 0 }
    inside && !/^: / { print > file }
' {} +
find "$top/examples" \( -name '*.st' -o -name '*.il' -o -name '*.iec' \) -exec cp {} "$1/seeds" \;

# The spelling of each keyword and delimiter is the quoted text of its row.
sed -n 's/^IECFRONT_\(KEYWORD\|DELIMITER\)([^"]*\("[^"]*"\)).*/\2/p' \
    "$top/include/iecfront/lexer/tokens.def" > "$1/dictionary"
cat >> "$1/dictionary" << 'END'
"(*"
"*)"
"//"
"/*"
"*/"
"$'"
"T#1s"
"D#2000-1-1"
"INT#16#FF"
"%IX1.0"
"'a'"
"\"b\""
"\x0A"
END
