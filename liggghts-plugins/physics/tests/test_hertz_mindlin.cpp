/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* The Hertz-Mindlin law against theory: impacts integrated here, without LIGGGHTS */

#include "physics/contact/coarse_graining.h"
#include "physics/contact/hertz_mindlin.h"
#include "physics/contact/rolling.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace grainjet::contact;

namespace {

const double pi = 3.14159265358979323846;

PairMaterial glass(double restitution, double friction = 0.18)
{
  PairMaterial m;
  m.youngs = effectiveYoungs(5e7, 0.25, 5e7, 0.25);
  m.shear = effectiveShear(5e7, 0.25, 5e7, 0.25);
  m.damping = dampingRatio(restitution);
  m.friction = friction;
  m.rollingFriction = 0.01;
  return m;
}

struct Impact { double overlap, duration, force, speedAfter; };

// Two equal spheres meet head-on at relative speed v: velocity Verlet with `steps` steps per contact
Impact headOn(const PairMaterial &m, double radius, double density, double v, int steps)
{
  const double mass = 4.0 / 3.0 * pi * radius * radius * radius * density;
  Geometry g = {0.0, 0.5 * radius, 0.5 * mass};
  const double estimate = 2.94 * std::pow(std::pow(g.mass / m.youngs, 2) / (g.radius * v), 0.2);
  const double dt = estimate / steps;
  Impact out = {0.0, 0.0, 0.0, 0.0};
  double gap = 0.0, speed = -v, force = 0.0;    // speed of parting
  for (int n = 0; n < 100 * steps; ++n) {
    speed += 0.5 * dt * force / g.mass;
    gap += dt * speed;
    if (gap >= 0.0) {
      // the end lies within the step
      out.duration = n * dt + dt * (1.0 - gap / (dt * speed));
      out.speedAfter = speed;
      return out;
    }
    g.overlap = -gap;
    const Stiffness k = stiffness(m, g);
    Vector3 spring = {0, 0, 0};
    force = hertzMindlin(m, k, g.overlap, speed, {0, 0, 0}, spring, true).normal;
    speed += 0.5 * dt * force / g.mass;
    out.overlap = std::max(out.overlap, g.overlap);
    out.force = std::max(out.force, force);
  }
  return out;
}

}

// Hertz (1882); Johnson, Contact Mechanics, section 11.4. The tolerances are those of an
// explicit step of 1/1000 of the contact; the error found is printed by a failure.
TEST(HertzMindlin, elasticImpactFollowsHertz)
{
  for (double v : {0.01, 1.0, 10.0})
    for (double radius : {40e-6, 1e-3}) {
      const PairMaterial m = glass(1.0);
      const double density = 2500.0;
      const double mass = 2.0 / 3.0 * pi * radius * radius * radius * density;
      const double R = 0.5 * radius;
      const double overlap = std::pow(15.0 * mass * v * v / (16.0 * std::sqrt(R) * m.youngs), 0.4);
      const double force = 4.0 / 3.0 * m.youngs * std::sqrt(R) * std::pow(overlap, 1.5);
      const double duration = 2.9432750643 * overlap / v;
      const Impact found = headOn(m, radius, density, v, 1000);
      EXPECT_NEAR(found.overlap, overlap, 1e-3 * overlap);
      EXPECT_NEAR(found.force, force, 1e-3 * force);
      EXPECT_NEAR(found.duration, duration, 3e-3 * duration);
      EXPECT_NEAR(found.speedAfter, v, 1e-3 * v);
    }
}

// gamma = 2 sqrt(5/6) (-beta) sqrt(Sn m*) gives back the restitution it was made from at any speed.
// The explicit end of the contact leaves an error of the order of the step, 1/2000 of the contact.
TEST(HertzMindlin, restitutionOutIsRestitutionIn)
{
  for (double e : {0.1, 0.3, 0.5, 0.7, 0.9, 1.0})
    for (double v : {0.05, 5.0}) {
      const Impact found = headOn(glass(e), 40e-6, 2950.0, v, 2000);
      EXPECT_NEAR(found.speedAfter / v, e, 3e-3) << "e = " << e << ", v = " << v;
    }
}

TEST(HertzMindlin, tangentialSpringFollowsMindlinUntilItSlides)
{
  const PairMaterial m = glass(0.9, 0.3);
  const Geometry g = {1e-6, 20e-6, 1e-9};
  const Stiffness k = stiffness(m, g);
  const double a = std::sqrt(g.radius * g.overlap);
  EXPECT_DOUBLE_EQ(k.normal, 4.0 / 3.0 * m.youngs * a);
  EXPECT_DOUBLE_EQ(k.tangential, 8.0 * m.shear * a);

  const double slide = m.friction * k.normal * g.overlap / k.tangential;
  const Vector3 n = {0, 0, 1}, rest = {0, 0, 0};
  Vector3 spring = {0.99 * slide, 0, 0};
  Force f = hertzMindlin(m, k, g.overlap, 0.0, rest, spring, true);
  EXPECT_NEAR(f.tangential.x, -0.99 * m.friction * f.normal, 1e-12 * f.normal);
  EXPECT_DOUBLE_EQ(spring.x, 0.99 * slide);

  advanceSpring(spring, n, {2.0 * slide, 0.0, 5.0}, 1.0);
  EXPECT_EQ(spring.z, 0.0);
  f = hertzMindlin(m, k, g.overlap, 0.0, rest, spring, false);
  EXPECT_NEAR(f.tangential.x, -m.friction * f.normal, 1e-12 * f.normal);
  EXPECT_NEAR(spring.x, 2.99 * slide, 1e-12 * slide) << "a look must not shorten the spring";
  f = hertzMindlin(m, k, g.overlap, 0.0, rest, spring, true);
  EXPECT_NEAR(spring.x, slide, 1e-12 * slide);
}

TEST(HertzMindlin, dashpotsActOnlyWhileItSticks)
{
  const PairMaterial m = glass(0.5, 0.3);
  const Geometry g = {1e-6, 20e-6, 1e-9};
  const Stiffness k = stiffness(m, g);
  EXPECT_DOUBLE_EQ(k.normalDamping,
                   2.0 * std::sqrt(5.0 / 6.0) * m.damping * std::sqrt(1.5 * k.normal * g.mass));
  EXPECT_DOUBLE_EQ(k.tangentialDamping,
                   2.0 * std::sqrt(5.0 / 6.0) * m.damping * std::sqrt(k.tangential * g.mass));
  Vector3 none = {0, 0, 0}, much = {1.0, 0, 0};
  const Vector3 vt = {0, 1e-3, 0};
  EXPECT_DOUBLE_EQ(hertzMindlin(m, k, g.overlap, 0.0, vt, none, true).tangential.y,
                   -k.tangentialDamping * vt.y);
  EXPECT_EQ(hertzMindlin(m, k, g.overlap, 0.0, vt, much, true).tangential.y, 0.0);
  // and the normal one may pull
  EXPECT_LT(hertzMindlin(m, k, 1e-12, 10.0, vt, none, true).normal, 0.0);
}

TEST(HertzMindlin, rollingTorqueOpposesRollingButNotSpin)
{
  const PairMaterial m = glass(0.9);
  const Geometry g = {1e-6, 20e-6, 1e-9};
  const Stiffness k = stiffness(m, g);
  const Vector3 n = {0, 0, 1};
  const double size = m.rollingFriction * k.normal * g.overlap * g.radius;
  Vector3 t = rollingTorque(m, k, g, n, {7.0, 0, 0});
  EXPECT_NEAR(t.x, -size, 1e-14 * size);
  t = rollingTorque(m, k, g, n, {0, 0, 7.0});
  EXPECT_EQ(length(t), 0.0);
  EXPECT_EQ(length(rollingTorque(m, k, g, n, {0, 0, 0})), 0.0);
}

// The energies behind the forces: dU/dd at constant spring is the Hertz force plus the change of
// the tangential stiffness, dU/ds is the tangential force
TEST(HertzMindlin, elasticEnergyIsTheIntegralOfTheForces)
{
  const PairMaterial m = glass(1.0);
  Geometry g = {1e-6, 20e-6, 1e-9};
  const Vector3 none = {0, 0, 0};
  double work = 0.0;
  const int steps = 100000;
  for (int n = 0; n < steps; ++n) {
    g.overlap = 1e-6 * (n + 0.5) / steps;
    work += stiffness(m, g).normal * g.overlap * 1e-6 / steps;
  }
  g.overlap = 1e-6;
  EXPECT_NEAR(elasticEnergy(stiffness(m, g), g.overlap, none), work, 1e-8 * work);
  const double kt = stiffness(m, g).tangential;
  EXPECT_NEAR(elasticEnergy(stiffness(m, g), 0.0, {3e-7, 4e-7, 0}), 0.5 * kt * 25e-14, 1e-12 * kt * 25e-14);
}

/* The identity of coarse graining: evaluating particles and scaling is evaluating the grain.
   1e-13 is round-off of about a hundred operations.                                       */
TEST(CoarseGraining, scaledParticleLawIsTheGrainLaw)
{
  const PairMaterial m = glass(0.8, 0.3);
  for (double f : {1.0, 2.0, 3.0, 5.0, 1.7})
    for (double stretch : {1e-8, 1e-5}) {      // sticking, sliding
      const CoarseGraining scale(f);
      const Geometry grain = {1e-6 * f, 20e-6 * f, 1e-9 * f * f * f};
      const Vector3 vt = {0.02, -0.01, 0}, turn = {30.0, 10.0, 5.0}, n = {0, 0, 1};
      const double vn = -0.3;

      const Stiffness kg = stiffness(m, grain);
      Vector3 sg = {stretch * f, 0.5 * stretch * f, 0};
      const Vector3 start = sg;
      const Force fg = hertzMindlin(m, kg, grain.overlap, vn, vt, sg, true);
      const Vector3 tg = rollingTorque(m, kg, grain, n, turn);

      const Geometry particle = scale.particle(grain);
      const Stiffness kp = stiffness(m, particle);
      Vector3 sp = scale.particleSpring(start);
      const Force fp = scale.grainForce(hertzMindlin(m, kp, particle.overlap, vn, vt, sp, true));
      const Vector3 tp = scale.grainTorque(rollingTorque(m, kp, particle, n, scale.particleRotation(turn)));

      EXPECT_NEAR(fp.normal, fg.normal, 1e-13 * std::fabs(fg.normal));
      EXPECT_NEAR(length(fp.tangential - fg.tangential), 0.0, 1e-13 * length(fg.tangential));
      EXPECT_NEAR(length(scale.grainSpring(sp) - sg), 0.0, 1e-13 * length(sg));
      EXPECT_NEAR(length(tp - tg), 0.0, 1e-13 * length(tg));
      EXPECT_NEAR(scale.grainEnergy(elasticEnergy(kp, particle.overlap, sp)),
                  elasticEnergy(kg, grain.overlap, sg), 1e-13 * elasticEnergy(kg, grain.overlap, sg));
    }
}

// A collision of grains is that of particles in units of the diameter: f_cg 1, 2, 3, 5
TEST(CoarseGraining, dimensionlessImpactDoesNotDependOnTheFactor)
{
  const Impact one = headOn(glass(0.7), 40e-6, 2950.0, 1.0, 500);
  for (double f : {2.0, 3.0, 5.0}) {
    const Impact grain = headOn(glass(0.7), 40e-6 * f, 2950.0, 1.0, 500);
    EXPECT_NEAR(grain.overlap / f, one.overlap, 1e-10 * one.overlap);
    EXPECT_NEAR(grain.duration / f, one.duration, 1e-10 * one.duration);
    EXPECT_NEAR(grain.force / (f * f), one.force, 1e-10 * one.force);
    EXPECT_NEAR(grain.speedAfter, one.speedAfter, 1e-10);
  }
}

TEST(Material, effectiveModuliOfEqualAndUnequalMaterials)
{
  EXPECT_DOUBLE_EQ(effectiveYoungs(2e6, 0.0, 2e6, 0.0), 1e6);
  // G* = G/(4 - 2 nu) of two equal materials; appendix A with the factor (1 + nu), see material.h
  const double E = 3e6, nu = 0.3;
  EXPECT_NEAR(effectiveShear(E, nu, E, nu), shearModulus(E, nu) / (2.0 * (2.0 - nu)),
              1e-12 * E);
  // a stiff wall doubles E*
  EXPECT_NEAR(effectiveYoungs(E, nu, 1e20, nu), 2.0 * effectiveYoungs(E, nu, E, nu), 1e-6 * E);
  EXPECT_EQ(dampingRatio(1.0), 0.0);
  EXPECT_NEAR(dampingRatio(std::exp(-pi)), std::sqrt(0.5), 1e-15);
}
