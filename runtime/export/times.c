/* Where in time a condition changes its sign, as in runtime/schemes/switching/times.py: by bounds over intervals. */

#if defined(__GNUC__)
#define MAY __attribute__((unused))
#else
#define MAY
#endif

typedef struct {
  double low, high;
} I;

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

#define BOUNDS

static double sign_at(int k, double t, const Run *r) { /* of condition k, with the inputs that z holds in cd */
  double g[NT];
  M(conditions)(g, &t, r->cd, r->w);
  return g[k];
}

static int holds(int k, double x, double side, int flipped, const Run *r) {
  const double g = sign_at(k, flipped ? -x : x, r);
  return side < 0 ? g < 0 : g > 0;
}

/* the last float from low to high until which a condition has this sign, by halving */
static double last_of(int k, double low, double high, double side, int flipped, int at_low, const Run *r) {
  const double finest = 1e-18 * (high - low);
  if (!at_low) high = low;
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(low < middle && middle < high && high - low > finest)) return low;
    if (holds(k, middle, side, flipped, r)) low = middle;
    else high = middle;
  }
}

/* the change of condition k between two times, and clocks that show its two sides */
static int change(int k, double low, double high, const Run *r, Stop *found) {
  const double a = sign_at(k, low, r), b = sign_at(k, high, r), side = b > a ? 1 : -1;
  double before, after, reach;
  if ((a >= 0) == (b >= 0)) return 0;
  before = last_of(k, low, high, -side, 0, -side * a > 0, r);
  for (reach = 2 * (nextafter(fabs(before), INFINITY) - fabs(before)); before + reach < high; reach *= 8) {
    if (holds(k, before + reach, side, 0, r)) high = before + reach;
  }
  after = -last_of(k, -high, -before, side, 1, side * b > 0, r);
  found->time = before + (after - before) / 2;
  found->before = before - 16 * 2.220446049250313e-16 * fabs(found->time);
  found->after = after + 16 * 2.220446049250313e-16 * fabs(found->time);
  if (found->time < r->z[T0]) found->time = r->z[T0];
  return 1;
}

/* all changes between two times, in order, those at one time together; -1: more than there is room for */
static int changes(Run *r, double from, double to, Stop *found) {
  double low[64], high[64];
  int k, j, n = 0, m;
  for (k = 0; k < NT; ++k) {
    int depth = 1;
    low[0] = from, high[0] = to;
    while (depth > 0) {
      I g[2 * NT];
      int jumps = 0, one;
      Stop next;
      const double a = low[--depth], b = high[depth];
      M(bounds)(g, &jumps, I_of(a, b), r->cd);
      if (g[2 * k].low > 0 || g[2 * k].high < 0) continue;
      one = (g[2 * k + 1].low > 0 || g[2 * k + 1].high < 0) && !jumps;
      if (one || b - a <= NARROW * r->dt || depth > 61) {
        if (!change(k, a, b, r, &next)) continue;
        if (n == MOST_STOPS) return -1;
        for (j = n++; j > 0 && found[j - 1].time > next.time; --j) found[j] = found[j - 1];
        found[j] = next;
        continue;
      }
      low[depth] = a + (b - a) / 2, high[depth] = b, ++depth;
      low[depth] = a, high[depth] = a + (b - a) / 2, ++depth;
    }
  }
  for (m = j = 0; j < n; ++j) {
    if (m > 0 && found[j].time - found[m - 1].time <= NARROW * r->dt) {
      if (found[j].before < found[m - 1].before) found[m - 1].before = found[j].before;
      if (found[j].after > found[m - 1].after) found[m - 1].after = found[j].after;
    } else {
      found[m++] = found[j];
    }
  }
  return m;
}

static void with_inputs(Run *r) {
  (void)shown_by(r, r->dt);
  memcpy(r->cd + DT_AT - NU, r->z + INPUTS_AT, NU * sizeof(double));
}

/* of so many steps at most, how many from here on have no stop; -1: too many stops in a step */
static long clear(Run *r, long n) {
  const double near = 2 * ON_THE_GRID * r->dt;
  Stop found[MOST_STOPS];
  I g[2 * NT];
  with_inputs(r);
  for (; n > 1; n /= 2) {
    int k, jumps = 0, none = 1;
    M(bounds)(g, &jumps, I_of(time_of(r, r->z[1]) - near, time_of(r, r->z[1] + (double)n) + near), r->cd);
    for (k = 0; k < NT; ++k) none = none && (g[2 * k].low > 0 || g[2 * k].high < 0);
    if (none) return n;
  }
  n = changes(r, time_of(r, r->z[1]) - near, time_of(r, r->z[1] + 1) + near, found);
  return n < 0 ? -1 : n == 0;
}

/* the clocks on both sides of what jumps at the start of a step */
static Stop sides(Run *r, double step, const Stop *all, int n) {
  Stop found = {0.0, INFINITY, -INFINITY};
  for (; n > 0; --n, ++all) {
    if (fabs(all->time - time_of(r, step)) > ON_THE_GRID * r->dt) continue;
    if (all->before < found.before) found.before = all->before;
    if (all->after > found.after) found.after = all->after;
  }
  return found;
}

static double clock_at(Run *r, double t) {
  Stop all[MOST_STOPS], here;
  int n;
  with_inputs(r);
  n = changes(r, t - 2 * ON_THE_GRID * r->dt, t + 2 * ON_THE_GRID * r->dt, all);
  here = sides(r, 0.0, all, n > 0 ? n : 0);
  return here.after > t ? here.after : t;
}

/* the parts of the step that z is at, see Breaks.parts; clock: from where the next one starts */
static int parts_of(Run *r, Part *parts, double *clock) {
  const double step = r->z[1], here = time_of(r, step), next = time_of(r, step + 1);
  Stop all[MOST_STOPS], begin, end;
  int n, k, m = 0, count = 0;
  with_inputs(r);
  n = changes(r, here - 2 * ON_THE_GRID * r->dt, next + 2 * ON_THE_GRID * r->dt, all);
  begin = sides(r, step, all, n), begin.time = here, end = sides(r, step + 1, all, n), end.time = next;
  for (k = 0; k < n; ++k) { /* those within */
    const double t = all[k].time;
    if (floor((t - r->z[T0]) / r->dt) == step && fabs(t - here) > ON_THE_GRID * r->dt && fabs(t - next) > ON_THE_GRID * r->dt) all[m++] = all[k];
  }
  for (k = 0; k <= m; ++k) {
    const Stop from = k == 0 ? begin : all[k - 1], to = k == m ? end : all[k];
    const int open = from.after == -INFINITY;
    double length = to.time - from.time, start = from.after > from.time ? from.after : from.time;
    if (start + length - to.before > LOST * r->dt && !(open && from.time <= r->z[T0])) {
      if (open) {
        start = to.before - length;
      } else { /* in halves, one with the clocks of either side */
        length /= 2;
        parts[count].start = start, parts[count].length = length, parts[count].before = NEVER, parts[count++].after = -NEVER;
        start = to.before - length;
      }
    } else if (to.before - start < length) {
      length = to.before - start;
    }
    parts[count].start = start, parts[count].length = length;
    parts[count].before = to.before < INFINITY ? to.before : NEVER, parts[count++].after = to.after;
  }
  if (end.after > *clock) *clock = end.after;
  return count;
}

/* found: the first jump behind t, up to a time, and clocks that show its two sides; where there is none, that time */
int M(next_jump)(double *found, const double *c, double t, double until, double *w) {
  double z[NZ + KEPT] = {0}, step = 64 * c[DT_AT], end;
  Run r = made_run(z, c, w);
  Stop all[MOST_STOPS];
  memcpy(r.cd, c, NC * sizeof(double)), z[T0] = -NEVER;
  for (;;) {
    int n = -1;
    for (end = t + step; n < 0; step /= 2) {
      end = t + step < until ? t + step : until;
      n = changes(&r, t, end, all);
      if (n < 0 && step < 1e-6 * c[DT_AT]) return 0;
    }
    if (n > 0 || end >= until) {
      found[0] = n > 0 ? all[0].time : until;
      found[1] = n > 0 ? all[0].before : until, found[2] = n > 0 ? all[0].after : until;
      return 1;
    }
    t = end, step *= 4;
  }
}
