#!/bin/sh
# Doxygen filter for checks and programs: the file's opening comment as its description, and nothing to parse.
# The source browser still shows the file as it is.
awk 'NR == 1, !/^\/\// { if (/^\/\//) { sub(/^\/\/[\/!]? ?/, ""); if ($0 == "") exit; gsub(/[\\@<>&#%"`*_~$|]/, " "); text = text " " $0 } }
     END { print "/** @file"; print text; print "*/" }' "$1"
