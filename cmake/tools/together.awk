# awk -f together.awk TEST.cpp...: one source that compiles several tests at once, each in a namespace of its
# own.
#
# Templates that several of them use are instantiated once, and the precompiled headers are read once. All that
# they include is included first, outside the namespaces, so that the same lines inside them do nothing: this is
# for sources whose headers have guards, and that add nothing to a namespace of others.
/^#include/ && !($0 in seen) { seen[$0]; print }
END {
  for (i = 1; i < ARGC; ++i) {
    name = ARGV[i]
    sub(/.*\//, "", name)
    sub(/\.cpp$/, "", name)
    print "namespace together_" name " {\n#include \"" ARGV[i] "\"\n}"
  }
}
