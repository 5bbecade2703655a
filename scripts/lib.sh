# Shared by scripts/run, scripts/test and scripts/campaigns: packages, configure, build. Sourced, not run.

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

say() { printf 'kerf: %s\n' "$*" >&2; }

# Installs what is missing from scripts/packages.txt (and the packages named as arguments).
install_packages() {
    local wanted missing=() package
    mapfile -t wanted < <(grep -vE '^[[:space:]]*(#|$)' "$root/scripts/packages.txt")
    for package in "${wanted[@]}" "$@"; do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return 0
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { say "missing packages: ${missing[*]}; install them as root, or install sudo."; return 1; }
        as_root=(sudo)
    fi
    say "installing from Debian's packages: ${missing[*]}"
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# build_preset PRESET [TARGET …]: configures once, then builds the targets (all when none is given).
build_preset() {
    local preset="$1"
    shift
    [ -f "$root/build/$preset/build.ninja" ] || (cd "$root" && cmake --preset "$preset" >&2)
    local targets=()
    [ $# -gt 0 ] && targets=(--target "$@")
    (cd "$root" && cmake --build "build/$preset" "${targets[@]}" >&2)
}
