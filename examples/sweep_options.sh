# What the sweeps of the examples share; they source it from the repository's root and then call
#   sweep_options "$@"
# It sets `abut` (the program) and `threads`, and makes the folder `results`, which goes away at the end. The script
# defines usage(), and option ARGUMENT for its own arguments, which fails for those it doesn't know.
abut=${ABUT:-build/release/abut}
threads=1

sweep_options() {
    while (($# > 0)); do
        case $1 in
            --threads)
                threads=${2:?sweep.sh: --threads needs a number}
                shift
                ;;
            -h | --help)
                usage
                exit 0
                ;;
            *)
                if ! option "$1"; then
                    echo "sweep.sh: unknown argument \"$1\"" >&2
                    usage >&2
                    exit 2
                fi
                ;;
        esac
        shift
    done
    results=$(mktemp -d)
    trap 'rm -rf "$results"' EXIT
}
