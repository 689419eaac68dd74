# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The stages of a job, for the folder of a case as cases/quickJet is one. Sourced by
# quickJet/Allrun, waterJet/Allrun and cases/Allrun, in the folder of the case, with $root and `set -eu -o pipefail`.
#   mesh_stage, steady_stage, coupled_stage: each starts from what the one before left

fail() { echo "Allrun: $*" >&2; exit 1; }

# what a log says about the error that ended the program
ending() { grep -A 30 "FOAM FATAL" "$1" | head -n 30 | grep . || tail -n 25 "$1"; }

# run <log> <words> <command>...: stop with the end of the log if the command fails
run()
{
    local log=$1 words=$2
    shift 2
    echo "$words"
    "$@" > "$log" 2>&1 || { ending "$log"; fail "$1 failed, see $PWD/$log"; }
}

# following <log> <end> <what> [begin]: a line of progress every 10 s (GRAINJET_PROGRESS, for short
# jobs) while the process $! works
following()
{
    local job=$! log=$1 end=$2 what=$3 begin=${4:-0} first=$SECONDS last=$SECONDS
    trap 'kill '$job' 2> /dev/null || true' EXIT    # also when interrupted
    while kill -0 "$job" 2> /dev/null
    do
        sleep 1
        if [ $((SECONDS - last)) -ge "${GRAINJET_PROGRESS:-10}" ]
        then
            last=$SECONDS
            progress "$log" "$end" $((SECONDS - first)) "$begin"
        fi
    done
    trap - EXIT
    wait "$job" || { ending "$log"; fail "$what stopped with an error, see $PWD/$log"; }
}

# progress <log> <end> <seconds so far> <begin>: one line from the end of the log of a solver
progress()
{
    tail -n 200 "$1" | awk -v end="$2" -v elapsed="$3" -v begin="$4" '
        /^Time = / { time = $3 }
        /^liggghtsCoupling: grains/ {
            grains = $0
            sub(/^liggghtsCoupling:/, ",", grains)
            sub(/\).*/, ")", grains)
        }
        END {
            if (time > begin)
                printf "  %3d %% done, %d s left%s\n", 100*time/end, elapsed*(end - time)/(time - begin), grains
        }'
}

# absent: the first part of Grainjet that is not there, if any
absent()
{
    local name
    for name in liggghtsloader hertzcgplugin collisionstatsplugin fluidforceplugin fluidheatplugin grainmotionplugin platestatsplugin surfacestatsplugin wallroughnessplugin
    do
        [ -f "$root/lib/$name.so" ] || { echo "$root/lib/$name.so"; return; }
    done
    for name in libjetTurbulenceModels libliggghtsCoupling libparticleSamplingPlanes
    do
        [ -f "$root/lib/$name.so" ] || [ -f "${FOAM_USER_LIBBIN:-none}/$name.so" ] || { echo "$root/lib/$name.so"; return; }
    done
}

# fits: stop if the packed Grainjet is not complete, or for another OpenFOAM than the one that would run
fits()
{
    local wanted found
    found=$(absent)
    [ -n "$found" ] || [ -f "$root/built-for" ] || found=$root/built-for
    [ -z "$found" ] || fail "the Grainjet in $root is not complete, there is no $found: install it again"
    wanted=$(sed -n 's/^OpenFOAM v//p' "$root/built-for")
    found=$(blockMesh -help 2>&1 | sed -n 's/^Using: .*(\([0-9]*\)).*/\1/p') || true
    [ -n "$found" ] || fail "there is no OpenFOAM that works: install the package openfoam, or source one of v$wanted"
    [ "$found" = "$wanted" ] ||
        fail "the Grainjet in $root is for OpenFOAM v$wanted, but v$found is the one that runs ($(command -v blockMesh)):" \
            "use a shell without it, or build Grainjet for it (Allwmake of the source)"
}

# plain <folder>: stop if OpenFOAM would leave out characters of its path
plain()
{
    [[ "$1" != *[[:space:]\'\"]* ]] || fail "the path '$1' holds blanks or quotes, which OpenFOAM cannot handle: move it"
}

# Builds Grainjet first if that was not done; afterwards its programs and libraries work.
# A packed Grainjet is complete.
prepare()
{
    # in the folder of a case; cases/Allrun has its runs elsewhere
    [ ! -d system ] || plain "$PWD"
    [ ! -d system ] || [ -w . ] || fail "the folder $PWD cannot be written to: copy it to one of your own and run ./Allrun there"
    if [ -x "$root/Allwmake" ]
    then
        [ -z "$(absent)" ] || { echo "Grainjet is not built yet: building"; "$root/Allwmake"; }
        . "$root/environment"
    else
        . "$root/environment"
        fits
    fi
}

# a plain number of system/parameters
parameter() { awk -v name="$1" '$1 == name { sub(/;.*/, "", $2); print $2 }' system/parameters; }

# set the command in front of a solver: none for one rank
launcher()
{
    ranks=$(parameter ranks)
    mpi=()
    parallel=
    [ "$ranks" -gt 1 ] || return 0
    parallel=-parallel
    if [ -n "${GRAINJET_LAUNCHER:-}" ]
    then
        read -ra mpi <<< "$GRAINJET_LAUNCHER"       # on a cluster: srun
        return 0
    fi
    # A waiting rank gives way to other work on the machine: much faster where cores are shared
    mpi=(mpirun -np "$ranks" --bind-to none --mca mpi_yield_when_idle 1)
    [ "$(id -u)" -ne 0 ] || mpi+=(--allow-run-as-root)
    [ "$(nproc)" -ge "$ranks" ] || mpi+=(--oversubscribe)
}

mesh_stage()
{
    run log.particleInput "Numbers and surfaces for LIGGGHTS" ./particleInput
    run log.blockMesh "Mesh" blockMesh
    run log.checkMesh "Mesh quality" checkMesh -allGeometry
    grep -q "Mesh OK" log.checkMesh || fail "the mesh is not good, see $PWD/log.checkMesh"
    grep -E "^ +(hexahedra|Mesh non-orthogonality|Max skewness)" log.checkMesh
    awk -v d="$(parameter dParticle)" -v cg="$(parameter cg)" '
        /Min\/max edge length/ {
            printf "    Smallest cell side: %.3g mm, %.1f particle and %.1f grain diameters%s\n", \
                1e3*$5, $5/d, $5/(cg*d), $5 < 1.86*d ? " (WARNING: below 1.86 particles)" : ""
        }' log.checkMesh
}

# steady_stage [solver field ...]: the flow without grains, in a case of its own on the same mesh. Its fields are the start of the
# coupled run. A case that has a function start_stage makes the fields to begin from by it
steady_stage()
{
    local iterations steady field solver=${1:-simpleFoam} log continuity
    local fields=("${@:2}")
    [ ${#fields[@]} -gt 0 ] || fields=(U p k epsilon nut phi)
    launcher
    log=log.$solver
    [ "$solver" = simpleFoam ] || log+=.spinUp      # beside that of the coupled run
    iterations=$(parameter spinUpIterations)
    rm -rf 0 processor* spinUp/processor* spinUp/[1-9]* spinUp/postProcessing
    cp -r 0.orig 0
    if declare -F start_stage > /dev/null
    then
        start_stage
    fi
    ln -sfn ../0 spinUp/0
    ln -sfn ../constant spinUp/constant
    [ -z "$parallel" ] || run log.decomposePar.spinUp "Cutting the mesh for $ranks ranks" decomposePar -case spinUp
    echo "Steady flow without grains: up to $iterations iterations of $solver on $ranks ranks"
    "${mpi[@]}" "$solver" -case spinUp $parallel > "$log" 2>&1 &
    following "$log" "$iterations" "steady flow"
    # A flow that has diverged may end as a converged one: residuals are relative. 1e5/s in the mean is a hundred m/s too many over
    # each mm, far beyond any flow that these cases have
    continuity=$(sed -n 's/^time step continuity errors : sum local = \([^,]*\),.*/\1/p' "$log" | tail -n 1)
    [[ "$continuity" != *[ni]* ]] && awk -v sum="${continuity:-0}" 'BEGIN { exit !(sum < 1e5) }' ||
        fail "the steady flow has diverged (continuity errors of $continuity), see $PWD/$log"
    [ -z "$parallel" ] || run log.reconstructPar.spinUp "Its fields are the start of the coupled run" \
        reconstructPar -case spinUp -latestTime
    steady=$(foamListTimes -case spinUp -latestTime)
    for field in "${fields[@]}"
    do
        cp "spinUp/$steady/$field" 0/
    done
    sed -n 's/^ *patch pipeWall y+ : /    y+ at the pipe wall: /p' "$log" | tail -n 1
}

# mapped_start <folder>: the fields to begin from are the steady flow of a case with a coarser mesh, made there first
mapped_start()
{
    (
        unset -f start_stage
        cd "$1"
        [ ! -f stage.steady ] || exit 0
        echo "On the coarse mesh that the steady flow starts from, $PWD:"
        mesh_stage
        steady_stage
        touch stage.steady
    )
    run log.mapFields "Its flow on this mesh" mapFields "$1" -consistent -sourceTime 0 -mapMethod interpolate
}

# From time 0, or from the latest time that is complete
coupled_stage()
{
    launcher
    local at=. solver
    solver=$(awk '$1 == "application" { sub(/;.*/, "", $2); print $2 }' system/controlDict)
    if [ -n "$parallel" ]
    then
        at=processor0
        [ -d processor0/0 ] || run log.decomposePar "Cutting the mesh for $ranks ranks" decomposePar
    fi
    complete_times
    if [ "$start" = 0 ]
    then
        echo "Coupled run: $solver and LIGGGHTS on $ranks ranks"
        find postProcessing -mindepth 2 -delete
    else
        echo "Coupled run goes on from $start s on $ranks ranks"
        mv "log.$solver" "log.$solver.until.$start" 2> /dev/null || true
    fi
    "${mpi[@]}" "$solver" $parallel > "log.$solver" 2>&1 &
    following "log.$solver" "$(parameter endTime)" "coupled run" "$start"
    [ -z "$parallel" ] || run log.reconstructPar "Joining the fields of the ranks" reconstructPar
}

# is_complete <time>: it holds the grains, and on all ranks the file that OpenFOAM writes last
is_complete()
{
    local part
    [ -f "$at/$1/uniform/liggghts.restart" ] || return 1
    for part in $([ "$at" = . ] && echo . || echo processor*)
    do
        [ -s "$part/$1/uniform/functionObjects/functionObjectProperties" ] || return 1
    done
}

# complete_times: drop the times in $at that a killed run left incomplete, set $start
complete_times()
{
    local time
    start=0
    for time in $(find "$at" -maxdepth 1 -type d -name '[0-9]*' -printf '%f\n' | grep -E '^[0-9.e-]+$' | sort -g)
    do
        [ "$time" != 0 ] || continue
        if is_complete "$time"
        then
            start=$time
        elif [ "$at" = . ]
        then
            rm -rf "./$time"
        else
            rm -rf processor*/"$time"
        fi
    done
}
