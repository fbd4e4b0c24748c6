# For the scripts that fill a folder below build/; to be sourced. Several may run at once: each fills a
# folder of its own, which then takes the target's place in one step.

# folder_begin TARGET: makes an empty folder, $work, which is removed when the script ends early.
folder_begin() {
    mkdir -p "$(dirname "$1")"
    work=$(mktemp -d "$1.XXXXXX")
    trap 'rm -rf "$work"' EXIT
    chmod 755 "$work"
}

# folder_end TARGET: renames $work to TARGET, whose old contents are removed. When another run has
# renamed its folder in between, that one stays: both hold the same.
folder_end() {
    local old
    old=$(mktemp -d "$1.XXXXXX")
    mv -T "$1" "$old/old" 2>/dev/null || true
    mv -T "$work" "$1" 2>/dev/null || [ -d "$1" ]
    rm -rf "$old"
}
