/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_FLUID_FORCE_EXCHANGE_H
#define GRAINJET_FLUID_FORCE_EXCHANGE_H

/* The door through which a coupling writes to `fix fluid/force coupled`.

   A coupling finds the fix by its style name and asks for

       int dim;
       auto *door = static_cast<FluidForceExchange *>(
           fix->extract("fluid_force_exchange", dim));

   before every access, and once at first whether both are of one Grainjet, since the layout
   below belongs to its version:

       auto *version = static_cast<const char *>(fix->extract("fluid_force_version", dim));

   gives GRAINJET_VERSION of the plugin (host/grainjet_version.h); NULL: it is older than
   these versions. The arrays may have moved since (LIGGGHTS grows and sorts them
   during a run). Index = local atom index, 0 <= i < atom->nlocal.
   All values are of the whole GRAIN in SI units and travel with it between ranks
   and through restart files.                                                */

namespace LAMMPS_NS {

// What tells one restart file from all others. stamp: -1 if there is none
struct GrainFile {
  double stamp;               // differs from file to file
  double step;                // DEM step
  double grains;              // number of grains
};

struct FluidForceExchange {

  // ---- written by the coupling, held constant over the DEM steps of an interval

  double **fluidVelocity;     // [n][3] m/s, undisturbed fluid velocity at the grain
  double *dragCoefficient;    // [n] kg/s, drag = dragCoefficient (fluidVelocity - v)
  double **explicitForce;     // [n][3] N, all other fluid forces (pressure gradient,
                              // viscous, buoyancy)

  // ---- written by the fix

  double **impulse;           // [n][3] N s, momentum the fluid gave to the grain (drag and
                              // explicitForce, as velocity Verlet really applied them) since
                              // the coupling last set it to zero
  double **fluidForce;        // [n][3] N, fluid force of the latest DEM step

  // ---- carried for the coupling, never interpreted by LIGGGHTS

  double **startPosition;     // [n][3] m, position at the start of the interval; a grain
                              // inserted since has its insertion position
  double **host;              // [n][2] fluid rank that holds the grain and its number there;
                              // (-1, -1) for a grain the coupling has not seen yet

  // ---- grains that left the box across a non-periodic boundary on this rank since the
  //      coupling last called clearLost: what they had received is not lost to the balance

  struct Lost {
    int tag;                  // atom ID
    double position[3];       // m, where it was when it left
    double startPosition[3];  // m
    double velocity[3];       // m/s
    double mass;              // kg
    double radius;            // m
    double impulse[3];        // N s
    double host[2];
  };

  int nLost;
  const Lost *lost;
  void (*clearLost)(FluidForceExchange *);

  // ---- continuing

  GrainFile written;          // the restart file written last
  GrainFile read;             // the restart file that the fix has taken its state from

  void *fix;                  // the owner, for clearLost
};

}

#endif
