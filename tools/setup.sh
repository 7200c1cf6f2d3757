# Sourced by ./run and ./check, from the root of the project: packages, configuration and build.

# install_packages LIST...: installs what is missing of the Debian packages named in the files.
install_packages() {
    local wanted missing as_root=()
    wanted=$(sed 's/#.*//' "$@")
    # dpkg-query fails where a package is unknown to it, which is an answer here, not an error.
    missing=$({
        dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null | sed -n 's/^installed //p'
        printf '%s\n' $wanted $wanted
    } | sort | uniq -c | awk '$1 == 2 { print $2 }')
    [ -z "$missing" ] && return
    echo "Installing Debian packages:" $missing >&2
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { echo "error: run as root, or install these packages first" >&2; exit 1; }
        as_root=(sudo)
    fi
    local install=(apt-get install -y -qq --no-install-recommends $missing)
    # The lists may be empty or old: fetch them only where the first try fails.
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "${install[@]}" >&2 2>/dev/null && return
    "${as_root[@]}" apt-get update -qq >&2
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "${install[@]}" >&2
}

# build_jobs: one compiler per core, but no more than memory allows (1 GiB each).
build_jobs() {
    local cores memory
    cores=$(nproc)
    memory=$(awk '/^MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo)
    [ "$memory" -lt 1 ] && memory=1
    echo $((cores < memory ? cores : memory))
}

# build PRESET TARGET...: builds with progress on stderr and says nothing where there is nothing to do.
build() {
    cmake --build "build/$1" --target "${@:2}" -j "$(build_jobs)" |
        sed -u -e '/no work to do/d' -e '/^\[0\/[0-9]*\] Re-checking/d' >&2
}

# build_with_tests PRESET TARGET...: the same, after installing and configuring what ./check needs.
build_with_tests() {
    install_packages tools/packages/build.txt tools/packages/test.txt
    local batches=()
    [ -e "build/$1/CMakeCache.txt" ] || batches=(-DCSGSCOPE_BATCHES=ON)
    cmake --preset "$1" -DCSGSCOPE_TESTS=ON "${batches[@]}" >&2
    build "$@"
}
