#!/usr/bin/env bash
# layering.sh ROOT: every #include of src/ and chapters/ follows the arrows, and every import of src/python.
#
# The arrows are read from where they are declared: `actio_module(NAME USES ...)` in CMakeLists.txt,
# `actio_room(NAME USES ...)` in src/program/CMakeLists.txt and `actio_chapter(chNN USES ...)` in
# chapters/CMakeLists.txt. A file may include its own module and whatever that reaches; a room of the program
# its own, whatever that reaches, all of the library and src/book, which draws the pictures of runs; src/app,
# the command, and src/python, the module for Python, every room and all of the library; src/book no module;
# src/program/loaded, modules that the program loads, what files of arrays are and all of the library;
# src/witness, for checks, tests and programs, numbers, groups and rods. Includes that run in a circle are
# reported as well; so are imports of the package for Python from one another, and those that do not stand at the top,
# where they would hide a circle. At the end a violation is planted in a copy, and must be found.
set -euo pipefail
root=$1

# Prints one line per violation.
violations() (
  cd "$1"
  {
    sed -nE 's/^actio_module\(([a-z_]+)(.*)\)$/module \1\2/p' CMakeLists.txt
    # All of the library, for the rooms of the program; these; and the command and the module, which use them.
    printf 'module library USES %s\n' "$(sed -nE 's/^actio_module\(([a-z_]+).*/\1/p' CMakeLists.txt | paste -sd' ')"
    sed -nE 's/^actio_room\(([a-z_\/]+) *(USES)?(.*)\)$/\1\3/p' src/program/CMakeLists.txt | awk '{
      all = all " program/" $1
      printf "module program/%s USES library", $1
      for (i = 2; i <= NF; ++i) printf " program/%s", $i
      print ""
    } END { print "module app USES library" all; print "module python USES library" all }'
    printf 'module program/loaded USES library program/output\n'
    printf 'module witness USES groups rods\n'
    sed -nE 's/^actio_chapter\(([a-z0-9]+)(.*)\)$/chapter \1\2/p' chapters/CMakeLists.txt
    find src chapters -name '*.[hc]pp' | LC_ALL=C sort | xargs -r grep -noE '^ *# *include *"[^"]+"' /dev/null |
      sed -E 's/^([^:]+):([0-9]+):.*"([^"]+)"/include \1 \2 \3/'
    find src/python -name '*.py' | LC_ALL=C sort | xargs -r grep -noE '^ *from actio\._[a-z_]+ import' /dev/null |
      sed -E 's/^([^:]+):([0-9]+):from actio\.([a-z_]+) .*/import \1 \2 \3/
        s/^([^:]+):([0-9]+): +from actio\.([a-z_]+) .*/import \1 \2 \3 late/'
  } | awk '
    function room(file) { sub(/\/[^\/]*$/, "", file); return file }
    $1 == "module" || $1 == "chapter" {
      name = $2; reach[name, name] = 1; known[name] = 1
      if ($1 == "chapter" && !first_chapter) first_chapter = name
      for (i = 3; i <= NF && $i != "LINKS"; i++) {
        if ($i == "USES") continue
        # Modules are declared in order, so what the used one reaches is complete.
        if (!($i in known)) { print name " uses " $i ", which is not declared before it"; continue }
        for (pair in reach) { split(pair, p, SUBSEP); if (p[1] == $i) reach[name, p[2]] = 1 }
      }
    }
    $1 == "include" {
      split($2, path, "/")
      # What all chapters share may include what the first of them may.
      if (path[1] == "chapters") owner = path[2] ~ /\.hpp$/ ? first_chapter : substr(path[2], 1, 4)
      else if (path[2] == "program") owner = room(substr($2, 5))
      else owner = path[2] == "actio" ? path[3] : path[2]
      if (owner != "book" && !(owner in known)) { print $2 ": belongs to no declared module or chapter (" owner ")"; next }
      split($4, target, "/")
      if (target[1] == "actio" && !((owner, target[2]) in reach) ||
          target[1] == "program" && !((owner, room($4)) in reach))
        print $2 ":" $3 ": " owner " may not include " $4
      else if (target[1] == "book" && owner != "book" && path[2] != "program" && path[1] != "chapters")
        print $2 ":" $3 ": the library may not include " $4
      else if (target[1] ~ /^(app|python|witness)$/ && owner != target[1] && !(target[1] == "witness" && path[1] == "chapters"))
        print $2 ":" $3 ": " owner " may not include " $4
      else if (target[1] !~ /^(actio|book|program|app|python|witness)$/ && path[1] == "src")
        print $2 ":" $3 ": write the path from src/, not " $4
      edges[$2] = edges[$2] " src/" $4
    }
    $1 == "import" {
      if (NF > 4) print $2 ":" $3 ": the import of " $4 " has to stand at the top"
      edges[$2] = edges[$2] " src/python/actio/" $4 ".py"
    }
    function visit(file,   list, n, i) {
      state[file] = 1
      n = split(edges[file], list, " ")
      for (i = 1; i <= n; i++) {
        if (state[list[i]] == 1) print file ": includes or imports run in a circle through " list[i]
        else if (!state[list[i]]) visit(list[i])
      }
      state[file] = 2
    }
    END { for (file in edges) if (!state[file]) visit(file) }'
)

found=$(violations "$root")
if [[ -n $found ]]; then
  printf '%s\n' "Includes or imports against the arrows:" "$found"
  exit 1
fi

# Each kind of violation, planted one at a time.
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp -r "$root/src" "$root/chapters" "$root/CMakeLists.txt" "$copy/"
planted=0
plant() { # FILE LINE EXPECTED
  planted=$((planted + 1))
  mkdir -p "$(dirname "$copy/$1")"
  printf '%s\n' "$2" >"$copy/$1"
  violations "$copy" | grep -qF -- "$3" || { echo "planted, and not found: $2 in $1"; exit 1; }
  rm "$copy/$1"
}
plant src/actio/numbers/planted.hpp '#include "actio/reduction/x.hpp"' "numbers may not include actio/reduction/x.hpp"
plant src/actio/variational/planted.hpp '  #  include "actio/rigid_body/x.hpp"' "variational may not include actio/rigid_body/x.hpp"
plant src/actio/reduction/planted.hpp '#include "book/plot.hpp"' "the library may not include book/plot.hpp"
plant src/program/sweep/planted.hpp '#include "app/commands.hpp"' "program/sweep may not include app/commands.hpp"
plant src/program/base/planted.hpp '#include "program/run/x.hpp"' "program/base may not include program/run/x.hpp"
plant src/program/pictures/planted.hpp '#include "program/systems/sphere/x.hpp"' "program/pictures may not include program/systems/sphere/x.hpp"
plant src/program/systems/media/planted.hpp '#include "program/systems/sphere/x.hpp"' "program/systems/media may not include program/systems/sphere/x.hpp"
plant src/actio/vorticity/planted.hpp '#include "program/base/x.hpp"' "vorticity may not include program/base/x.hpp"
plant src/program/planted/planted.hpp '#include "program/base/x.hpp"' "belongs to no declared module"
plant src/actio/numbers/planted.hpp '#include "witness/number.hpp"' "numbers may not include witness/number.hpp"
plant src/actio/jets/planted.hpp '#include "actio/groups/x.hpp"' "jets may not include actio/groups/x.hpp"
plant src/actio/constraints/planted.hpp '#include "actio/continuum/x.hpp"' "constraints may not include actio/continuum/x.hpp"
plant src/actio/multisymplectic/planted.hpp '#include "actio/reduction/x.hpp"' "multisymplectic may not include actio/reduction/x.hpp"
plant src/python/planted.hpp '#include "app/commands.hpp"' "python may not include app/commands.hpp"
plant src/actio/nowhere/planted.hpp '#include "actio/numbers/x.hpp"' "belongs to no declared module"
plant src/book/planted.hpp '#include "actio/numbers/x.hpp"' "book may not include actio/numbers/x.hpp"
plant chapters/planted.hpp '#include "actio/reduction/x.hpp"' "ch02 may not include actio/reduction/x.hpp"
plant chapters/ch02_planted/planted.cpp '#include "actio/reduction/x.hpp"' "ch02 may not include actio/reduction/x.hpp"
plant src/actio/numbers/planted.hpp '#include "actio/numbers/planted.hpp"' "in a circle"
plant src/python/actio/_planted.py 'from actio._planted import planted' "in a circle"
plant src/python/actio/_planted.py '    from actio._run import Run' "has to stand at the top"

echo "$(find "$root/src" "$root/chapters" -name '*.[hc]pp' -o -name '*.py' | wc -l) files follow the arrows; $planted planted violations were found."
