#!/bin/sh
# Doxygen filter for headers. Line numbers stay.
# The plain comment at the head of a file becomes the description of the file, and a declaration that has no
# comment of its own, but a name from docs/vocabulary.txt, gets the sentence that stands there.
# All that a header declares belongs to the group of its folder: module_groups for src/actio/groups. The group
# begins and ends with each namespace, so that no header mentions it.
folder=${1%/*}
folder=/${folder#/}/
case $folder in
  */src/actio/*) group=module_${folder#*/src/actio/} ;;
  */src/*) group=part_${folder#*/src/} ;;
  *) group= ;;
esac
group=${group%/}
exec awk -v name="${1##*/}" -v group="$(printf %s "$group" | tr / _)" '
  function plain(t) { gsub(/&/, "\\&amp;", t); gsub(/</, "\\&lt;", t); gsub(/>/, "\\&gt;", t); gsub(/[@#%*]/, "\\\\&", t); return t }
  # The name that the declaration starting at line i declares: what stands before its first parenthesis, or
  # after "using", or before = { ;
  function declared(i,   j, text, head) {
    text = ""
    for (j = i; j <= n && j < i + 5; ++j) {
      head = line[j]
      sub(/\/\/.*/, "", head)
      if (head ~ /^ *(template *<.*>|requires.*)$/) continue
      text = text " " head
      if (text ~ /[({;=]/) break
    }
    sub(/^ *template *<[^;{]*> +/, " ", text)
    if (text ~ /(^| )(struct|class|concept|enum) /) return ""
    if (text ~ /operator *\( *\) *\(/) return "operator()"
    if (text ~ /^ *[A-Z][A-Za-z0-9]*\([^;{]*\) *-> /) return "deduction"
    if (match(text, /operator *[-+*\/<>=]+ *\(/)) { text = substr(text, RSTART, RLENGTH - 1); gsub(/ /, "", text); return text }
    if (match(text, /using +[A-Za-z_0-9]+ *=/)) { text = substr(text, RSTART + 6, RLENGTH - 7); gsub(/ /, "", text); return text }
    sub(/[({;=].*/, "", text)
    sub(/<[^(){}]*> *$/, "", text)
    sub(/ +$/, "", text)
    if (text ~ /^ *(explicit +)?[A-Z][A-Za-z0-9]*$/) { sub(/.* /, "", text); return text }
    if (text !~ /[A-Za-z0-9_>&*] +[A-Za-z_0-9]+$/) return ""
    sub(/.*[ &*]/, "", text)
    return text
  }
  # Whether the namespace that begins at line i declares names of structs and functions alone.
  function only_names(i,   j) {
    for (j = i + 1; line[j] !~ /^}/; ++j) if (line[j] ~ /\{$/ || j == n) return 0
    return line[j] == "}"
  }
  FILENAME == words { if ($0 !~ /^#/) { tab = index($0, "\t"); meaning[substr($0, 1, tab - 1)] = substr($0, tab + 1) } next }
  { line[++n] = $0 }
  END {
    begin = " /** \\addtogroup " group " */ /** @{ */"
    head = line[1] ~ /^\/\/($|[^\/!])/
    for (i = 1; i <= n; ++i) {
      text = line[i]
      if (text !~ /^\/\//) head = 0
      if (head) {
        sub(/^\/\/ ?/, "", text)
        print (i == 1 ? "/// \\file " name " \\brief " : "/// ") plain(text)
        continue
      }
      # A group holds what stands in one namespace: it is closed before another one begins within, or ends.
      if (group != "" && text ~ /^namespace [a-zA-Z_:]+ \{$/ && !only_names(i)) {
        if (depth && open_at[depth]) text = "/** @} */ " text
        open_at[++depth] = text !~ /detail/
        if (open_at[depth]) text = text begin
        print text
        continue
      }
      if (group != "" && text ~ /^\}  \/\/ namespace /) {
        if (open_at[depth]) text = "/** @} */ }"
        if (--depth && open_at[depth]) text = "} " begin
        print text
        continue
      }
      # What is compiled once elsewhere declares nothing new.
      if (text ~ /^extern template/) elsewhere = 1
      if (elsewhere) { print ""; if (text ~ /;/) elsewhere = 0; continue }
      # The body of a free function is indented like the members of a struct, and declares nothing.
      if (text ~ /^[a-zA-Z\[]/) within = text ~ /(^|> )(struct|class) / ? "type" : text ~ /^namespace/ ? "" : "function"
      if (text ~ /\\ref [A-Za-z_]+:/) { match(text, /\\ref [A-Za-z_]+:/); word = substr(text, RSTART + 5, RLENGTH - 6); text = substr(text, 1, RSTART + RLENGTH - 2) " \"" word "\"" substr(text, RSTART + RLENGTH - 1) }
      # A declaration starts where the indent is that of a namespace or of a struct, after anything but a
      # comment or its own template head.
      if ((text ~ /^[^ ]/ || within == "type") && text ~ /^(  )?(template|static|friend|inline|constexpr|using|auto|explicit|\[\[|[A-Z][A-Za-z0-9_]*[<& (]|int|double|bool|std::)/ && text !~ /\/\/\/</ && text !~ /using [A-Za-z_0-9:<>, ]*;/ &&
          line[i-1] !~ /^ *(\/\/\/|template|requires|\*\/)/ && text !~ /^ *(template *<.*> *)?(struct|class|concept|namespace) /) {
        word = declared(i)
        if (word in meaning) { match(text, /^ */); text = substr(text, 1, RLENGTH) "/** " meaning[word] " */ " substr(text, RLENGTH + 1) }
      }
      print text
    }
  }' words=docs/vocabulary.txt docs/vocabulary.txt "$1"
