/* Where in time a condition changes its sign, as in runtime/schemes/switching/times.py: by bounds over intervals. */

static double sign_at(const Model *of, int k, double t, const Run *r) { /* of condition k, with the inputs that z holds in cd */
  double *g = r->signs;
  of->conditions(g, &t, r->cd, r->w);
  return g[k];
}

static int holds(const Model *of, int k, double x, double side, int flipped, const Run *r) {
  const double g = sign_at(of, k, flipped ? -x : x, r);
  return side < 0 ? g < 0 : g > 0;
}

/* the last float from low to high until which a condition has this sign, by halving */
static double last_of(const Model *of, int k, double low, double high, double side, int flipped, int at_low, const Run *r) {
  const double finest = 1e-18 * (high - low);
  if (!at_low) high = low;
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(low < middle && middle < high && high - low > finest)) return low;
    if (holds(of, k, middle, side, flipped, r)) low = middle;
    else high = middle;
  }
}

/* the change of condition k between two times, and clocks that show its two sides */
static int change(const Model *of, int k, double low, double high, const Run *r, Stop *found) {
  const double a = sign_at(of, k, low, r), b = sign_at(of, k, high, r), side = b > a ? 1 : -1;
  double before, after, reach;
  if ((a >= 0) == (b >= 0)) return 0;
  before = last_of(of, k, low, high, -side, 0, -side * a > 0, r);
  for (reach = 2 * (nextafter(fabs(before), INFINITY) - fabs(before)); before + reach < high; reach *= 8) {
    if (holds(of, k, before + reach, side, 0, r)) high = before + reach;
  }
  after = -last_of(of, k, -high, -before, side, 1, side * b > 0, r);
  found->time = before + (after - before) / 2;
  found->before = before - 16 * 2.220446049250313e-16 * fabs(found->time);
  found->after = after + 16 * 2.220446049250313e-16 * fabs(found->time);
  if (found->time < r->z[T0]) found->time = r->z[T0];
  return 1;
}

/* all changes between two times, in order, those at one time together; -1: more than there is room for */
static int changes(const Model *of, Run *r, double from, double to, Stop *found) {
  double low[64], high[64];
  I *g = r->bounds;
  int k, j, n = 0, m;
  for (k = 0; k < of->NT; ++k) {
    int depth = 1;
    low[0] = from, high[0] = to;
    while (depth > 0) {
      int jumps = 0, one;
      Stop next;
      const double a = low[--depth], b = high[depth];
      of->bounds(g, &jumps, a, b, r->cd);
      if (g[2 * k].low > 0 || g[2 * k].high < 0) continue;
      one = (g[2 * k + 1].low > 0 || g[2 * k + 1].high < 0) && !jumps;
      if (one || b - a <= NARROW * r->dt || depth > 61) {
        if (!change(of, k, a, b, r, &next)) continue;
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

static void with_inputs(const Model *of, Run *r) {
  (void)shown_by(of, r, r->dt);
  memcpy(r->cd + of->DT_AT - of->NU, r->z + of->INPUTS_AT, of->NU * sizeof(double));
}

/* of so many steps at most, how many from here on have no stop; -1: too many stops in a step */
static int64_t clear(const Model *of, Run *r, int64_t n) {
  const double near = 2 * ON_THE_GRID * r->dt;
  Stop *found = r->stops;
  I *g = r->bounds;
  if (of->NT == 0) return n;
  with_inputs(of, r);
  for (; n > 1; n /= 2) {
    int k, jumps = 0, none = 1;
    of->bounds(g, &jumps, time_of(of, r, r->z[1]) - near, time_of(of, r, r->z[1] + (double)n) + near, r->cd);
    for (k = 0; k < of->NT; ++k) none = none && (g[2 * k].low > 0 || g[2 * k].high < 0);
    if (none) return n;
  }
  n = changes(of, r, time_of(of, r, r->z[1]) - near, time_of(of, r, r->z[1] + 1) + near, found);
  return n < 0 ? -1 : n == 0;
}

/* the clocks on both sides of what jumps at the start of a step */
static Stop sides(const Model *of, Run *r, double step, const Stop *all, int n) {
  Stop found = {0.0, INFINITY, -INFINITY};
  for (; n > 0; --n, ++all) {
    if (fabs(all->time - time_of(of, r, step)) > ON_THE_GRID * r->dt) continue;
    if (all->before < found.before) found.before = all->before;
    if (all->after > found.after) found.after = all->after;
  }
  return found;
}

static double clock_at(const Model *of, Run *r, double t) {
  Stop *all = r->stops, here;
  int n;
  if (of->NT == 0) return t;
  with_inputs(of, r);
  n = changes(of, r, t - 2 * ON_THE_GRID * r->dt, t + 2 * ON_THE_GRID * r->dt, all);
  here = sides(of, r, 0.0, all, n > 0 ? n : 0);
  return here.after > t ? here.after : t;
}

/* the parts of the step that z is at, see Breaks.parts; clock: from where the next one starts */
static int parts_of(const Model *of, Run *r, Part *parts, double *clock) {
  const double step = r->z[1], here = time_of(of, r, step), next = time_of(of, r, step + 1);
  Stop *all = r->stops, begin, end;
  int n, k, m = 0, count = 0;
  if (of->NT == 0) {
    parts[0].start = here, parts[0].length = next - here, parts[0].before = NEVER, parts[0].after = -NEVER;
    return 1;
  }
  with_inputs(of, r);
  n = changes(of, r, here - 2 * ON_THE_GRID * r->dt, next + 2 * ON_THE_GRID * r->dt, all);
  begin = sides(of, r, step, all, n), begin.time = here, end = sides(of, r, step + 1, all, n), end.time = next;
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
DOOR int next_jump(const Model *of, double *found, const double *c, double t, double until, double *w) {
  Room room;
  Run r = made_run(of, NULL, c, c, w, &room);
  double *z = REALS(of->NZ + of->KEPT), step = 64 * c[of->DT_AT], end;
  Stop *all = r.stops;
  memset(z, 0, (of->NZ + of->KEPT) * sizeof(double));
  r.z = z;
  memcpy(r.cd, c, of->NC * sizeof(double)), z[T0] = -NEVER;
  for (;;) {
    int n = -1;
    for (end = t + step; n < 0; step /= 2) {
      end = t + step < until ? t + step : until;
      n = changes(of, &r, t, end, all);
      if (n < 0 && step < 1e-6 * c[of->DT_AT]) return 0;
    }
    if (n > 0 || end >= until) {
      found[0] = n > 0 ? all[0].time : until;
      found[1] = n > 0 ? all[0].before : until, found[2] = n > 0 ? all[0].after : until;
      return 1;
    }
    t = end, step *= 4;
  }
}
