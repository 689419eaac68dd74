/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_LANGEVIN_STEP_H
#define GRAINJET_LANGEVIN_STEP_H

#include <algorithm>
#include <cmath>

namespace grainjet {
namespace turbulence {

/* The turbulence at a grain: isotropic, of which an eddy-viscosity model knows

     s = sqrt(2k/3)    m/s, rms of one component of the fluctuation u'
     T                 s, Lagrangian time scale of the fluid's own particles           */
struct SeenTurbulence {
  double speed;              // s
  double speed_gradient[3];  // 1/s
  double time;               // T
  double time_gradient[3];   // s/m
};

/* The Langevin equation for xi = u'/s, the fluctuation seen by a grain over its rms:

     d xi = - xi dt/T + sqrt(2/T) dW + grad(s)/(1 + St) dt        St = tau/T

   (Wilson, Legg and Thomson 1983; for u' itself this is the well-mixed equation of Thomson 1987.
   The factor of the drift for grains with a response time tau: Bocksell and Loth 2006). Over an
   interval, with the coefficients at its start, both xi at the end and the integral X of
   xi are Gaussian and known exactly, for any interval: here for one direction.

   A flow that is not uniform needs more if the interval is not short against T. To first order in
   the gradients, the mean path of tracers then gets, since xi and the place are correlated,
     - s at the middle of the path s X instead of at its start (LangevinStep),
     - the shift of xi and X by a gradient of T that is below.
   With both, tracers stay evenly spread for any interval. Neither is meant for a T that changes by more
   than itself on the way of s in the interval, or in T if that is shorter: at the edge of fluid that is
   nearly at rest T may rise a millionfold from one cell to the next. The gradient is limited to that.  */
struct LangevinInterval {
  double kept;            // xi from xi
  double kick;            // xi from the first random number
  double integral;        // s, X from xi
  double kick_integral;   // s, X from the first random number
  double own_integral;    // s, X from the second one
  double drift;           // s, xi from grad s
  double drift_integral;  // s2, X from grad s
  double shift;           // xi from s grad T
  double shift_integral;  // s, X from s grad T
  double follows;         // 1/(1 + St)

  LangevinInterval(double dt, double time, double response_time)
  {
    // below a millionth of the interval nothing of the time scale is seen
    const double T = std::max(time, 1e-6 * dt);
    const double x = dt / T;
    const double lost = -std::expm1(-x);

    kept = 1.0 - lost;
    kick = std::sqrt(lost * (1.0 + kept));
    integral = T * lost;
    kick_integral = T * lost * lost / kick;

    // variance of X less what the first number gives; the series, since its terms cancel
    const double variance = x < 0.1
      ? x*x*x * (2.0/3 - x * (1.0/2 - x * (7.0/30 - x * (1.0/12 - x * (31.0/1260 - x / 160.0)))))
      : 2.0 * x - 3.0 + 4.0 * kept - kept * kept;
    own_integral = T * std::sqrt(std::max(0.0, variance - lost*lost*lost / (1.0 + kept)));

    follows = T / (T + response_time);
    drift = integral * follows;
    drift_integral = T * (dt - integral) * follows;
    shift = (lost - kept * x) * follows;
    shift_integral = (dt * (1.0 + kept) - 2.0 * integral) * follows;
  }
};

/* The step of a grain. Crossing trajectories (Csanady 1963): a grain with a mean slip leaves eddies
   earlier, T/b with

     b parallel = sqrt(1 + 0.64 w2/s2),  b normal = sqrt(1 + 4 0.64 w2/s2)    w mean slip.  */
class LangevinStep {
public:
  static constexpr double CROSSING = 0.64;

  LangevinStep(const SeenTurbulence &seen, double dt, double response_time, const double *slip)
    : seen_(seen),
      dt_(dt),
      crossing_(crossing(seen, slip)),
      parallel_(dt, seen.time / factor(1.0), response_time),
      normal_(dt, seen.time / factor(4.0), response_time)
  {
    const double size = std::sqrt(dot(slip, slip));
    for (int k = 0; k < 3; k++)
      direction_[k] = size > 0.0 ? slip[k] / size : 0.0;
  }

  /* Advance xi.
     normals: six independent standard normal numbers
     mean:    m/s, the mean of u' over the interval                                    */
  void advance(const double *normals, double *xi, double *mean) const
  {
    const double s = seen_.speed;
    const double steepness = s * std::sqrt(dot(seen_.time_gradient, seen_.time_gradient));
    const double steepest = std::max(1.0, seen_.time / dt_);
    const double limited = s * (steepness > steepest ? steepest / steepness : 1.0);
    double shift[3];
    for (int k = 0; k < 3; k++)
      shift[k] = limited * seen_.time_gradient[k];

    double end[3] = {0.0, 0.0, 0.0}, X[3] = {0.0, 0.0, 0.0}, followed[3] = {0.0, 0.0, 0.0};
    add(&LangevinInterval::kept, xi, 1.0, 1.0, end);
    add(&LangevinInterval::kick, normals, 1.0, 1.0, end);
    add(&LangevinInterval::drift, seen_.speed_gradient, 1.0, 1.0, end);
    add(&LangevinInterval::shift, shift, factor(1.0), factor(4.0), end);

    add(&LangevinInterval::integral, xi, 1.0, 1.0, X);
    add(&LangevinInterval::kick_integral, normals, 1.0, 1.0, X);
    add(&LangevinInterval::own_integral, normals + 3, 1.0, 1.0, X);
    add(&LangevinInterval::drift_integral, seen_.speed_gradient, 1.0, 1.0, X);
    add(&LangevinInterval::shift_integral, shift, factor(1.0), factor(4.0), X);

    // s at the middle of the path; at most to the point where s vanishes, or as far up
    add(&LangevinInterval::follows, X, 1.0, 1.0, followed);
    const double change = std::clamp(0.5 * dot(seen_.speed_gradient, followed), -1.0, 1.0);

    for (int k = 0; k < 3; k++) {
      xi[k] = end[k];
      mean[k] = s * (1.0 + change) * X[k] / dt_;
    }
  }

private:
  const SeenTurbulence &seen_;
  const double dt_;
  const double crossing_;
  const LangevinInterval parallel_, normal_;
  double direction_[3];

  static double dot(const double *a, const double *b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  // 0.64 w2/s2; without turbulence any value will do
  static double crossing(const SeenTurbulence &seen, const double *slip)
  {
    return CROSSING * dot(slip, slip) / std::max(seen.speed * seen.speed, 1e-30);
  }

  double factor(double times) const { return std::sqrt(1.0 + times * crossing_); }

  // sum += c v, with the coefficient c of the direction of the slip and of those normal to it
  void add(double LangevinInterval::*c, const double *v, double by_parallel, double by_normal,
           double *sum) const
  {
    const double normal = normal_.*c / by_normal;
    const double along = (parallel_.*c / by_parallel - normal) * dot(v, direction_);
    for (int k = 0; k < 3; k++)
      sum[k] += normal * v[k] + along * direction_[k];
  }
};

}
}

#endif
