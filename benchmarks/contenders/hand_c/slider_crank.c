/* Central difference with sub-cycling of the two-mode flexible slider-crank, written by hand.

   The scheme is that of runtime/schemes/central_difference.py with the options `direct`, `predictor`, `end_point_sum`,
   one Newton step on the velocities of the common update and two on the loop closure. The state between two calls is
   the same, field by field (struct State).

   Minimal coordinates: x0 = theta (crank), slow; x1, x2 = q (rod modes), fast. phi = angle of the rod. With
   l, L the lengths of crank and rod, S = int x dm, p q1 = int y dm, e = int x Phi_y dm, mu the modal mass, J the inertia
   of the rod about its crank end, m3 the slider and s, c sines and cosines of theta and phi, D = phi - theta:

     closure    l s1 + L s2 = 0,  phi' = k theta',  k = -l c1 / (L c2),  phi'' = k theta'' + b theta'^2,
                b = (l s1 + L s2 k^2) / (L c2)
     slider     x3' = X theta',  X = -l s1 - k L s2,  x3'' = X theta'' + Y theta'^2,  Y = -l c1 - L c2 k^2 - L s2 b
     M_hat      m00 = J0 + 2 k l alpha + k^2 I + m3 X^2,  m01 = l p cosD + k e1,  m02 = k e2,  m11 = m22 = mu, m12 = 0
                alpha = cosD S - sinD p q1,  I = J + mu (q1^2 + q2^2),  J0 = crank about its pin + rod mass l^2
     Q_hat      every inertia force is quadratic in the velocities, with phi' = k theta' put in:
                Q0 = A theta'^2 + theta' (B1 q1' + B2 q2'),  Qj = Fj theta'^2 - Kj qj
                A  = k l sigma (k - 1) - (l alpha + k I) b - m3 X Y,  sigma = sinD S + cosD p q1
                B1 = 2 k (l p sinD - k mu q1),  B2 = -2 k^2 mu q2
                F1 = k^2 mu q1 - l p sinD - e1 b,  F2 = k^2 mu q2 - e2 b
   so that the derivative of Q_hat by the velocities costs next to nothing, and M_hat - h/2 dQ/dv is an arrow:
   eliminating q1 and q2 first leaves one division. */

#include <math.h>

typedef struct {
  double x[3], d[3], a[3];         /* position, last increment, acceleration */
  double base_q, base_v, base_a;   /* crank at the start of its step */
  double s;                        /* time since then */
  double phi, phi_old, phi_dot;    /* rod angle: last, the one before, last rate */
  double closure_error, n;
} State;

typedef struct {
  double l, L, S, p, e1, e2, mu, J, J0, m3, K1, K2;
  double H, h, sub_steps;          /* major step, sub-step, sub-steps after the common update */
} Data;

typedef struct {
  double H, h, H2, h2, half_H, half_h, inv_H, inv_h, two_h; /* steps */
  double l, L, inv_L, S, p, e1, e2, mu, inv_mu, J, J0, m3, K1, K2, lp, two_lp;
} Constants;

typedef struct {
  double s1, c1, s2, c2, k, b, sin_D, cos_D;
} Pose;

/* Rod angle by two Newton steps, then everything the forces need of the configuration. */
static inline Pose pose(const Constants *g, State *z, double theta) {
  Pose f;
  f.s1 = sin(theta);
  f.c1 = cos(theta);
  double phi = z->phi_old + g->two_h * z->phi_dot, error = 0;
  for (int k = 0; k < 2; ++k) {
    error = g->l * f.s1 + g->L * sin(phi);
    phi -= error / (g->L * cos(phi));
  }
  z->closure_error = fmax(z->closure_error, fabs(error));
  z->phi_old = z->phi;
  z->phi = phi;
  f.s2 = sin(phi);
  f.c2 = cos(phi);
  const double inverse = g->inv_L / f.c2;
  f.k = -g->l * f.c1 * inverse;
  f.b = (g->l * f.s1 + g->L * f.s2 * (f.k * f.k)) * inverse;
  f.sin_D = f.s2 * f.c1 - f.c2 * f.s1;
  f.cos_D = f.c2 * f.c1 + f.s2 * f.s1;
  return f;
}

static inline void move(double *x, double *d, double a, double step2) {
  *d += step2 * a;
  *x += *d;
}

static inline void common_update(const Constants *g, State *z) {
  const double q1 = z->x[1], q2 = z->x[2];
  const Pose f = pose(g, z, z->x[0]);
  const double k = f.k, k2 = k * k, b = f.b;

  const double pq = g->p * q1;
  const double alpha = f.cos_D * g->S - f.sin_D * pq, sigma = f.sin_D * g->S + f.cos_D * pq;
  const double I = g->J + g->mu * (q1 * q1 + q2 * q2), la = g->l * alpha, kI = k * I;
  const double X = -g->l * f.s1 - k * (g->L * f.s2);
  const double Y = -g->l * f.c1 - (g->L * f.c2) * k2 - (g->L * f.s2) * b;
  const double mX = g->m3 * X;
  const double m00 = g->J0 + k * (2 * la + kI) + mX * X, m01 = g->lp * f.cos_D + k * g->e1, m02 = k * g->e2;

  const double A = k * (k - 1) * (g->l * sigma) - (la + kI) * b - mX * Y;
  const double B1 = k * (g->two_lp * f.sin_D - 2 * k * (g->mu * q1)), B2 = -2 * k2 * (g->mu * q2);
  const double F1 = k2 * (g->mu * q1) - g->lp * f.sin_D - g->e1 * b, F2 = k2 * (g->mu * q2) - g->e2 * b;

  /* (M_hat - J h/2) a = Q - J h/2 a_last, J = dQ_hat/dv at the predicted velocity */
  const double v0_half = z->d[0] * g->inv_H, v1_half = z->d[1] * g->inv_h, v2_half = z->d[2] * g->inv_h;
  const double da0 = g->half_H * z->a[0], da1 = g->half_h * z->a[1], da2 = g->half_h * z->a[2];
  const double v0 = v0_half + da0, v1 = v1_half + da1, v2 = v2_half + da2;
  const double Av = A * v0, Bv = B1 * v1 + B2 * v2, F1v = F1 * v0, F2v = F2 * v0, B1v = B1 * v0, B2v = B2 * v0;
  const double J00 = 2 * Av + Bv, J10 = 2 * F1v, J20 = 2 * F2v;
  const double r0 = v0 * (Av + Bv) - (J00 * da0 + B1v * da1 + B2v * da2);
  const double r1 = v0 * F1v - g->K1 * q1 - J10 * da0, r2 = v0 * F2v - g->K2 * q2 - J20 * da0;
  const double a00 = m00 - g->half_H * J00;
  const double a01 = (m01 - g->half_h * B1v) * g->inv_mu, a02 = (m02 - g->half_h * B2v) * g->inv_mu;
  const double a10 = m01 - g->half_H * J10, a20 = m02 - g->half_H * J20;
  const double a0 = (r0 - a01 * r1 - a02 * r2) / (a00 - a01 * a10 - a02 * a20);
  const double a1 = (r1 - a10 * a0) * g->inv_mu, a2 = (r2 - a20 * a0) * g->inv_mu;

  z->base_q = z->x[0];
  z->base_v = v0_half + g->half_H * a0;
  z->base_a = a0;
  z->phi_dot = k * z->base_v;
  z->a[0] = a0;
  z->a[1] = a1;
  z->a[2] = a2;
  move(&z->x[0], &z->d[0], a0, g->H2);
  move(&z->x[1], &z->d[1], a1, g->h2);
  move(&z->x[2], &z->d[2], a2, g->h2);
  z->s = g->h;
  z->n += 1;
}

static inline void sub_step(const Constants *g, State *z) {
  const double s = z->s, a0 = z->base_a, q1 = z->x[1], q2 = z->x[2];
  const double theta = z->base_q + s * z->base_v + 0.5 * (s * s + s * g->h) * a0, v0 = z->base_v + s * a0;
  const Pose f = pose(g, z, theta);
  const double k = f.k, w = k * v0, w2 = w * w, v02 = v0 * v0, turn = f.b * v02 + k * a0; /* phi'' */
  const double a1 = (w2 * g->mu - g->K1) * q1 - g->lp * (f.sin_D * v02 + f.cos_D * a0) - g->e1 * turn;
  const double a2 = (w2 * g->mu - g->K2) * q2 - g->e2 * turn;
  z->phi_dot = w;
  z->a[1] = a1 * g->inv_mu;
  z->a[2] = a2 * g->inv_mu;
  move(&z->x[1], &z->d[1], z->a[1], g->h2);
  move(&z->x[2], &z->d[2], z->a[2], g->h2);
  z->s = s + g->h;
}

/* n major steps of the state, data in c. */
void run(double *state, const double *c, long n) {
  const Data *d = (const Data *)c;
  const Constants g = {
    .H = d->H, .h = d->h, .H2 = d->H * d->H, .h2 = d->h * d->h, .half_H = d->H / 2, .half_h = d->h / 2,
    .inv_H = 1 / d->H, .inv_h = 1 / d->h, .two_h = 2 * d->h, .l = d->l, .L = d->L, .inv_L = 1 / d->L, .S = d->S,
    .p = d->p, .e1 = d->e1, .e2 = d->e2, .mu = d->mu, .inv_mu = 1 / d->mu, .J = d->J, .J0 = d->J0, .m3 = d->m3,
    .K1 = d->K1, .K2 = d->K2, .lp = d->l * d->p, .two_lp = 2 * d->l * d->p};
  const long sub_steps = (long)d->sub_steps;
  State z = *(State *)state;
  for (long k = 0; k < n; ++k) {
    common_update(&g, &z);
    for (long j = 0; j < sub_steps; ++j) sub_step(&g, &z);
  }
  *(State *)state = z;
}
