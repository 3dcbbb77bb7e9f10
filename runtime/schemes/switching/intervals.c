/* Bounds of what operations give over intervals of their operands. */

MAY static I I_of(double low, double high) {
  I v;
  v.low = low, v.high = high;
  return v;
}
MAY static I I_wide(I v) { /* by rounding; what is no number may be anything */
  const double slack = 8 * 2.220446049250313e-16;
  v.low = v.low == v.low ? v.low - slack * (fabs(v.low) < INFINITY ? fabs(v.low) : 0.0) : -INFINITY;
  v.high = v.high == v.high ? v.high + slack * (fabs(v.high) < INFINITY ? fabs(v.high) : 0.0) : INFINITY;
  return v;
}
MAY static I I_any(void) { return I_of(-INFINITY, INFINITY); }
MAY static I I_hull(double a, double b, double c, double d) {
  const double p = a < b ? a : b, q = c < d ? c : d, s = a < b ? b : a, t = c < d ? d : c;
  return a == a && b == b && c == c && d == d ? I_of(p < q ? p : q, s > t ? s : t) : I_any();
}
MAY static I I_times(I a, I b) { return I_hull(a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high); }
MAY static I I_inv(I a) { return a.low <= 0 && a.high >= 0 ? I_any() : I_of(1 / a.high, 1 / a.low); }
MAY static I I_abs(I a) {
  const double p = fabs(a.low), q = fabs(a.high);
  return I_of(a.low <= 0 && a.high >= 0 ? 0.0 : p < q ? p : q, p < q ? q : p);
}
MAY static I I_cos(I a) {
  const double turn = 6.283185307179586, slack = 8 * 2.220446049250313e-16 * (1 + I_abs(a).high), p = cos(a.low), q = cos(a.high);
  return I_of(ceil((a.low - turn / 2) / turn) * turn + turn / 2 <= a.high ? -1.0 : (p < q ? p : q) - slack,
              ceil(a.low / turn) * turn <= a.high ? 1.0 : (p < q ? q : p) + slack);
}
MAY static I I_where(I yes, I a) {
  if (yes.low > 0 || yes.high < 0) return a;
  if (yes.low == 0 && yes.high == 0) return I_of(0.0, 0.0);
  return I_of(a.low < 0 ? a.low : 0.0, a.high > 0 ? a.high : 0.0);
}
MAY static I I_truth(int sure, int possible, int *jumps) {
  if (sure != possible) *jumps = 1;
  return I_of(sure, possible);
}
#define I_add(a, b) I_of((a).low + (b).low, (a).high + (b).high)
#define I_sub(a, b) I_of((a).low - (b).high, (a).high - (b).low)
#define I_neg(a) I_of(-(a).high, -(a).low)
#define I_sq(a) I_of(I_abs(a).low * I_abs(a).low, I_abs(a).high * I_abs(a).high)
#define I_sin(a) I_cos(I_of((a).low - 1.5707963267948966, (a).high - 1.5707963267948966))
#define I_min(a, b) I_of((a).low < (b).low ? (a).low : (b).low, (a).high < (b).high ? (a).high : (b).high)
#define I_max(a, b) I_of((a).low > (b).low ? (a).low : (b).low, (a).high > (b).high ? (a).high : (b).high)
#define I_lt(a, b) I_truth((a).high < (b).low, (a).low < (b).high, jumps)
#define I_le(a, b) I_truth((a).high <= (b).low, (a).low <= (b).high, jumps)
#define I_mono(f, a) I_of(f((a).low), f((a).high))
#define I_step(f, a) (f((a).low) != f((a).high) ? (void)(*jumps = 1) : (void)0, I_mono(f, a))
#define sign_of(x) ((double)(((x) > 0) - ((x) < 0)))
