# bash completion for actio: its parts, their options, what can be listed and shown, the statements, scenes and folders.

# The lines of standard input that begin with the word, as the shell writes them.
_actio_reply() { # WORD
  local name
  while IFS= read -r name; do
    [[ $name == "${1//\\/}"* ]] && COMPREPLY+=("$(printf '%q' "$name")")
  done
}

_actio_options() { # PART
  case $1 in
    run) echo "--out --set --unset --quiet --dry-run --ranks --plots --force --help" ;;
    resume) echo "--until --step --jobs --plots --quiet --help" ;;
    export) echo "--formats --quiet --help" ;;
    plot) echo "--quiet --help" ;;
    sweep) echo "--over --out --set --unset --jobs --quiet --dry-run --plots --force --help" ;;
    new) echo "--body --out --help" ;;
    list) echo "--json --help" ;;
    show) echo "--help" ;;
    check) echo "--list --help" ;;
    *) echo "--help --version" ;;
  esac
}

_actio_names() { # PROGRAM LIST...
  local list
  for list in "${@:2}"; do
    "$1" list "$list" 2>/dev/null
  done | cut -d ' ' -f 1 | sort -u
}

_actio_files() { # WORD SUFFIX: files that end so, and folders
  local path
  compopt -o filenames 2>/dev/null
  while IFS= read -r path; do
    [[ -d $path || ($2 && $path == *"$2") ]] && COMPREPLY+=("$path")
  done < <(compgen -f -- "$1")
}

_actio() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} part=${COMP_WORDS[1]} program=${COMP_WORDS[0]}
  COMPREPLY=()
  # --out=DIR comes in three words.
  if [[ $word == "=" ]]; then before=${COMP_WORDS[COMP_CWORD - 1]} word=""
  elif [[ $before == "=" ]]; then before=${COMP_WORDS[COMP_CWORD - 2]}; fi

  if ((COMP_CWORD > 1)); then
    case $before in
      --out) _actio_files "$word" ""; return ;;
      --body) _actio_reply "$word" < <(_actio_names "$program" bodies); return ;;
      --formats) _actio_reply "$word" < <(printf '%s\n' hdf5 netcdf vtu); return ;;
      --set | --unset | --over | --jobs | --until | --step) return ;;
    esac
  fi
  if [[ $word == -* ]]; then
    ((COMP_CWORD > 1)) || part=
    _actio_reply "$word" < <(_actio_options "$part" | tr ' ' '\n')
    return
  fi
  if ((COMP_CWORD == 1)); then
    _actio_reply "$word" < <(printf '%s\n' run resume plot export sweep new list show check)
    return
  fi
  case $part in
    run | sweep)
      _actio_files "$word" .toml
      # A name alone may be that of a scene that comes with actio.
      [[ -z $word || $word == */* ]] || _actio_reply "$word" < <(_actio_names "$program" scenes)
      ;;
    new) _actio_reply "$word" < <(_actio_names "$program" systems scenes bodies) ;;
    resume | plot | export) _actio_files "$word" "" ;;
    list) _actio_reply "$word" < <(printf '%s\n' systems groups methods quantities bodies materials keys scenes) ;;
    show) _actio_reply "$word" < <(_actio_names "$program" systems groups methods quantities bodies materials keys scenes) ;;
    check) _actio_reply "$word" < <("$program" check --list 2>/dev/null | cut -d ' ' -f 1) ;;
  esac
}

complete -F _actio actio
