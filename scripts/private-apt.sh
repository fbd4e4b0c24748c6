# Sourced by scripts that take packages from another suite of Debian than the running one. Nothing
# enters the system: apt works on lists and a cache of its own, checks Debian's signatures as ever,
# downloads, and dpkg only unpacks.
#
#   private_apt_setup NAME FOLDER SUITE...   NAME speaks in messages; FOLDER takes lists and packages
#   private_apt ARGUMENTS                    apt-get on those suites alone
#   private_apt_unpack FOLDER                unpacks what was downloaded

private_apt_setup() {
    local name=$1 keyring=/usr/share/keyrings/debian-archive-keyring.gpg mirror suite
    private_apt_folder=$2
    shift 2
    # The mirror that this machine already uses.
    mirror=$(apt-get update --print-uris |
        sed -n "s,^'\(.*\)/dists/bookworm/InRelease'.*,\1,p" | head -n 1)
    if [ -z "$mirror" ]; then
        echo "$name: apt knows no mirror of Debian bookworm" >&2
        return 1
    fi
    mkdir -p "$private_apt_folder"/lists/partial "$private_apt_folder"/cache/archives/partial \
        "$private_apt_folder"/parts
    for suite in "$@"; do
        echo "deb [signed-by=$keyring] $mirror $suite main"
    done >"$private_apt_folder/sources.list"
}

private_apt() {
    local folder=$private_apt_folder
    apt-get -qq \
        -o Dir::Etc::sourcelist="$folder/sources.list" -o Dir::Etc::sourceparts="$folder/parts" \
        -o Dir::Etc::preferencesparts="$folder/parts" -o Dir::Etc::preferences="$folder/none" \
        -o Dir::State::lists="$folder/lists" -o Dir::Cache="$folder/cache" \
        -o APT::Sandbox::User="$(id -un)" -o Debug::NoLocking=1 "$@"
}

private_apt_unpack() {
    local package
    for package in "$private_apt_folder"/cache/archives/*.deb; do
        dpkg-deb -x "$package" "$1"
    done
}
