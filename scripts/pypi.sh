# For the scripts that take files out of packages on PyPI into a folder below build/; to be sourced
# after folder.sh.
# What is downloaded is pinned by its hash, which pip checks, and nothing of it enters the system.

# pypi_begin SCRIPT FOLDER VERSION: ends the script if FOLDER has this version already. Else makes an
# empty folder, $work, to be filled.
pypi_begin() {
    script=$1 target=$2 version=$3
    if [ "$(cat "$target/version" 2>/dev/null)" = "$version" ]; then
        echo "$script: $target is there"
        exit 0
    fi
    if ! python3 -m pip --version >/dev/null 2>&1; then
        echo "$script: python3 with pip is needed (Debian: python3-pip)" >&2
        exit 1
    fi
    folder_begin "$target"
}

# pypi_pip COMMAND ARGUMENT...: pip with the requirements, one a line with its hash, on its input.
pypi_pip() {
    cat >"$work/requirements.txt"
    python3 -m pip "$1" --quiet --disable-pip-version-check --no-deps --require-hashes \
        -r "$work/requirements.txt" "${@:2}"
    rm "$work/requirements.txt"
}

# Puts $work in the folder's place.
pypi_end() {
    echo "$version" >"$work/version"
    folder_end "$target"
}
