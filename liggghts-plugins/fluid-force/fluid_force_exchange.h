/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_FLUID_FORCE_EXCHANGE_H
#define GRAINJET_FLUID_FORCE_EXCHANGE_H

/* The data that a coupling and `fix fluid/force coupled` exchange. This header is the whole
   interface. A coupling finds the fix by its style name and asks before every access

       int dim;
       auto *exchange = static_cast<FluidForceExchange *>(
           fix->extract("fluid_force_exchange", dim));

   since the arrays may have moved: LIGGGHTS grows and sorts them during a run. The layout
   belongs to a version of Grainjet. Once, before the first access, a coupling compares

       auto *version = static_cast<const char *>(fix->extract("fluid_force_version", dim));

   with GRAINJET_VERSION of host/grainjet_version.h. NULL: the fix is older than that entry.

   Index of all arrays: local atom, 0 <= i < atom->nlocal. Values are in SI units and of the
   whole GRAIN. They move with it between ranks and are in restart files.

   Two kinds of force are told apart: those whose reaction acts on the fluid, and those
   without (buoyancy, whose reaction is in the fluid's hydrostatic pressure). Each has its own
   sum of impulses. A model without reaction, torque or state asks for them by a request, as does
   a coupling for the work; what nobody has requested takes neither memory nor time.  */

namespace LAMMPS_NS {

// Columns of FluidForceExchange::owner
enum { OWNER_RANK, OWNER_NUMBER, OWNER_PRESENT };

// The fluid of style uniform: extract("fluid_force_uniform", dim), NULL in style coupled
struct UniformFluid {
  double velocity[3];         // m/s
  double density;             // kg/m3
  double viscosity;           // m2/s, kinematic
};

// What tells one restart file from all others. stamp: -1 if there is none
struct GrainFile {
  double stamp;               // differs from file to file
  double step;                // DEM step
  double grains;              // number of grains
};

struct FluidForceExchange {

  // ---- Written by the coupling, constant over the DEM steps of an interval.
  //      Coefficients are not negative.

  double **fluidVelocity;     // [n][3] m/s, fluid velocity that the grain sees
  double *dragCoefficient;    // [n] kg/s, implicit force dragCoefficient (fluidVelocity - v)
                              // with reaction on the fluid; v: the grain's velocity of the step
  double **explicitForce;     // [n][3] N, constant force with reaction on the fluid

  // Forces without reaction on the fluid. NULL unless requested (useNonReacting)
  double *nonReactingCoefficient;    // [n] kg/s, implicit force
                                     // nonReactingCoefficient (fluidVelocity - v)
  double **nonReactingForce;         // [n][3] N, constant force

  // Torque. NULL unless requested (useTorque). Its reaction on the fluid is not booked
  double **fluidSpin;         // [n][3] rad/s, angular velocity of the fluid at the grain
  double *spinCoefficient;    // [n] kg m2/s, implicit torque spinCoefficient (fluidSpin - omega)
  double **explicitTorque;    // [n][3] N m, constant torque

  // Added mass. NULL unless requested (useAddedMass)
  double *addedMass;          // [n] kg, not negative: mass of fluid that gains the velocity which
                              // the grain gains. Force -addedMass dv/dt, with reaction on the
                              // fluid, v the grain's velocity; solved for, not lagged. The part
                              // addedMass DU/Dt belongs into explicitForce

  // ---- Written by the fix. Impulses are the kicks that velocity Verlet really gave to the
  //      grain since the coupling last set them to zero

  double **impulse;              // [n][3] N s, of forces with reaction
  double **nonReactingImpulse;   // [n][3] N s, of forces without; NULL unless requested
  double **fluidForce;           // [n][3] N, all fluid forces of the latest DEM step
  double *work;                  // [n] J, by which these kicks of forces with reaction changed the grain's
                                 // kinetic energy: each kick times the mean of the velocities before
                                 // and after it. NULL unless requested (useWork)

  // ---- Carried for the coupling. LIGGGHTS reads neither

  double **startPosition;     // [n][3] m, position at the start of the interval; a grain
                              // inserted since has its insertion position
  double **owner;             // [n][3] the fluid rank that holds the grain's place in the mesh
                              // (OWNER_RANK, -1: none), the grain's number there
                              // (OWNER_NUMBER), and of which interval that number is
                              // (OWNER_PRESENT: 1 of this one; 0 of the one before, since the
                              // grain has left the mesh). A new grain has -1, -1, 0

  // ---- Grains removed on this rank since the coupling last called clearRemoved, from its
  //      first call of extract on. What they had received belongs to the balance

  enum Fate {
    LEFT_BOX,                 // crossed a fixed (f) boundary of the box
    DELETED                   // by a fix massflow/mesh with delete_atoms yes
  };

  struct Removed {
    int tag;                      // atom ID
    double position[3];           // m, where it was when it was removed
    double startPosition[3];      // m
    double velocity[3];           // m/s
    double mass;                  // kg
    double radius;                // m
    double impulse[3];            // N s
    double nonReactingImpulse[3]; // N s, 0 unless requested
    double work;                  // J, 0 unless requested
    double heat;                  // J, FluidHeatExchange::heat of fluid-heat/fluid_heat_exchange.h with all
                                  // steps before the removal; 0 without fix fluid/heat
    double temperature;           // K, 0 without fix fluid/heat
    double owner[3];
    Fate fate;
  };

  int nRemoved;
  const Removed *removed;
  void (*clearRemoved)(FluidForceExchange *);

  // ---- Requests: on all ranks alike, after the script has run and before the first set-up
  //      of steps (before LAMMPS::init). Pointers of this struct are up to date after the call.
  //      In a continued run the values of the restart file come back

  void (*useNonReacting)(FluidForceExchange *);
  void (*useTorque)(FluidForceExchange *);
  void (*useAddedMass)(FluidForceExchange *);
  void (*useWork)(FluidForceExchange *);

  // State of a model: `size` numbers per grain, which move with it, are sorted and restart.
  // New grains get `initial` (`size` numbers). Returns an index. The same name and size again
  // gives the same index. Errors: a name in use with another size, a name of other characters
  // than letters, digits and _, a size below 1, an initial value that is not finite.
  int (*addState)(FluidForceExchange *, const char *name, int size, const double *initial);

  // Rows of `size` numbers in one block, row i at size*i. It may move: ask before every
  // access. NULL is possible on a rank without grains only
  double *(*state)(FluidForceExchange *, int index);

  // ---- Continuing

  GrainFile written;          // the restart file written last
  GrainFile read;             // the restart file that the fix has taken its state from

  void *fix;                  // the fix itself, for the functions above
};

}

#endif
