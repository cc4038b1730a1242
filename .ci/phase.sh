# shellcheck shell=bash
# Sourced by the scripts: phase "What it does" COMMAND... says what it does, does it, and says how long it took.
phase() {
    local what=$1 start=$SECONDS
    shift
    printf '\n== %s\n' "$what"
    "$@"
    printf -- '-- %s: %d s\n' "$what" $((SECONDS - start))
}
