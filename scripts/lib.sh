# Shared by scripts/run, scripts/test and scripts/campaigns: packages, configure, build. Sourced, not run.

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

say() { printf 'kerf: %s\n' "$*" >&2; }

installed() { dpkg-query -W -f='${Status}' "$1" 2>/dev/null | grep -q 'install ok installed'; }

# Installs what is missing from scripts/packages.txt (and the packages named as arguments).
install_packages() {
    local wanted missing=() optional=() package
    mapfile -t wanted < <(grep -vE '^[[:space:]]*(#|$)' "$root/scripts/packages.txt")
    for package in "${wanted[@]}" "$@"; do
        installed "${package#\?}" && continue
        case "$package" in
            \?*) optional+=("${package#\?}") ;;
            *) missing+=("$package") ;;
        esac
    done
    [ $((${#missing[@]} + ${#optional[@]})) -eq 0 ] && return 0
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || {
            [ ${#missing[@]} -eq 0 ] && { say "skipped: ${optional[*]} (no sudo); what needs them is skipped too."; return 0; }
            say "missing packages: ${missing[*]}; install them as root, or install sudo."
            return 1
        }
        as_root=(sudo)
    fi
    local install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends)
    say "installing from Debian's packages: ${missing[*]} ${optional[*]}"
    "${as_root[@]}" apt-get update -qq
    [ ${#missing[@]} -eq 0 ] || "${install[@]}" "${missing[@]}" >&2
    for package in "${optional[@]}"; do
        "${install[@]}" "$package" >&2 || say "skipped: $package cannot be installed here; what needs it is skipped too."
    done
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
