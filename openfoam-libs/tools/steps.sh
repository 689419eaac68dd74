# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# For the build scripts (bash, sourced): steps with their time, failures in words, the cache.

if [ -t 1 ]; then live=yes; else live=; fi

# fail <text>...: the last words of a script
fail()
{
    printf '\n%s\n' "${0##*/}: $1" >&2
    shift
    [ $# -eq 0 ] || printf '    %s\n' "$@" >&2
    exit 1
}

# step <what> <log> <what is wrong if it fails> <command>...: runs the command quietly;
# if it fails, shows what matters of its log
step()
{
    local what=$1 log=$2 wrong=$3 start=$SECONDS
    shift 3
    mkdir -p "$(dirname "$log")"
    [ -z "$live" ] || printf '  %-44s ...\r' "$what"
    if ( "$@" ) > "$log" 2>&1 < /dev/null
    then
        printf '  %-44s %4d s\n' "$what" $((SECONDS - start))
    else
        printf '  %-44s failed\n' "$what"
        { grep -n -m 12 -E '(error: |Error [0-9]|CMake Error|ERROR|E: |cannot find|No such file|undefined reference|not set|Could NOT)' "$log" ||
            tail -n 12 "$log"; } | cut -c 1-300 | sed 's/^/    | /' >&2
        fail "$wrong" "The whole log: $log"
    fi
}

# Where fetched source trees are kept, for all checkouts of one user
cache=${XDG_CACHE_HOME:-$HOME/.cache}/grainjet
