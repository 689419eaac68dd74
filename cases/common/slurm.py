# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The batch script of a run for a cluster."""


def script(settings, cases, runs):
    """A run that continues when it is submitted again, until it is finished."""
    return f"""#!/bin/bash
# Run {settings['name']} of size {settings['size']}. Submit it again if the time was too short: it goes
# on from the last time that was written. Cores and hours: validation/cases/report.md.
#SBATCH --job-name={settings['name']}
#SBATCH --ntasks={settings['ranks']}
#SBATCH --time=24:00:00
#SBATCH --output=job.%j.log
export GRAINJET_LAUNCHER=srun
export GRAINJET_RUNS="{runs}"
exec "{cases}/Allrun" {settings['name']} {settings['size']}
"""
