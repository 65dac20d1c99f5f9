#!/bin/sh
# Doxygen filter for headers: the plain comment at the head of a file becomes the description of the file. Line numbers stay.
exec awk -v name="${1##*/}" '
  function plain(t) { gsub(/&/, "\\&amp;", t); gsub(/</, "\\&lt;", t); gsub(/>/, "\\&gt;", t); gsub(/[@#%*]/, "\\\\&", t); return t }
  NR == 1 { head = /^\/\/($|[^\/!])/ }
  !/^\/\// { head = 0 }
  head { sub(/^\/\/ ?/, ""); if (NR == 1) print "/// \\file " name " \\brief " plain($0); else print "/// " plain($0); next }
  { print }' "$1"
