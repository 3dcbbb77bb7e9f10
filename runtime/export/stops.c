/* Steps that end where loads jump in time, where events happen and where loads kink, as in runtime/schemes/switching.
   M(name) are functions of this file; z has KEPT numbers more than the scheme's: of the grid and of what has happened. */

#define NEVER 1e300
#define ON_THE_GRID 1e-9
#define LOST 1e-11
#define LOCATED 1e-12
#define OF_STEP 1e-7
#define NARROW (1e-12 * 4096)
#define MOST_STOPS 64
#define MOST_LOOKS 100
#define MOST_CLOSE 500
#define MOST_IN_A_STEP 50
#define MOST_BOUNCES 20000
#define MOST_KINKS 20
#define OF_STEPS 60
#define T0 (NZ)
#define ENDED (NZ + 1)
#define KINKS (NZ + 2)
#define ROW (NE + 1)

typedef struct {
  double time, before, after;
} Stop;
typedef struct {
  double start, length, before, after;
} Part;
typedef struct { /* arrays of the caller's w; S, F, T: of a step in parts, where a part leads, where a look leads */
  double *z, *w, *S, *F, *T, *saved, *read, *cd, *looks, *room;
  const double *c;
  double dt, start, length, first[ROW], last[ROW]; /* of the part that is looked at, with values at its ends */
  int count[ROW], acted;
} Run;

static Run made_run(double *z, const double *c, double *w) {
  Run r;
  memset(&r, 0, sizeof r);
  r.z = z, r.c = c, r.dt = c[DT_AT], r.w = w + KEPT_IN_W;
  r.S = w, r.F = r.S + NS, r.T = r.F + NS, r.saved = r.T + NS, r.read = r.saved + NZ;
  r.cd = r.read + NREADY + NC, r.looks = r.cd + NC, r.room = r.looks + MOST_CLOSE * ROW;
  memcpy(r.read, c, NREADY * sizeof(double)), memcpy(r.read + NREADY, c, NC * sizeof(double));
  return r;
}

/* constants that show a state which steps of dt led to */
static const double *shown_by(Run *r, double dt) {
  long k;
  memcpy(r->cd, r->c, DT_AT * sizeof(double));
  for (k = DT_AT; k < NC; ++k) r->cd[k] = r->c[k] * (dt / r->c[DT_AT]);
  return r->cd;
}

/* S: a part so long from a clock on */
static void make_part(Run *r, double *S, double start, double length) {
  length = length * (1 - 2 * 2.220446049250313e-16 * SUB_STEPS);
  S[START] = start, S[LENGTH] = length, S[SHARE] = length / r->dt;
  M(set_out)(S, r->read, r->w);
  M(steps)(S, S + READY, r->w, 1);
  S[SEEN] = length;
}

#if NE > 0
/* ---- events ---- */

static double *quiet_of(double *z) { return QUIET_AT < 0 ? NULL : z + QUIET_AT; }

static int passes(double from, double to, int way) {
  return (way >= 0 && from < 0 && to >= 0) || (way <= 0 && from > 0 && to <= 0);
}

/* does one happen between two sets of values? which: kinks and events, or one kind of them; asleep until then */
enum { ALL, DECLARED, LOADS };
static int passed(const double *from, const double *to, const double *quiet, double t, int which, int *found) {
  int k, any = 0;
  for (k = 0; k < NE; ++k) {
    const int here = (which == ALL || (which == DECLARED) == (k < ND)) && !(quiet != NULL && quiet[k] > t) &&
                     passes(from[k], to[k], events_of[k].way);
    if (found != NULL) found[k] = here;
    any = any || here;
  }
  return any;
}

static void values_shown(Run *r, double *values, const double *S) { M(events)(values, S, shown_by(r, S[SEEN]), r->w); }

/* T: the state of S behind a restart to steps dt at a clock, and the constants that show it */
static const double *set_out(Run *r, const double *S, double dt, double clock) {
  double *T = r->T;
  memcpy(T, S, NOWN * sizeof(double));
  T[NOWN] = S[SEEN], T[NOWN + 1] = dt, T[NOWN + 2] = clock;
  memcpy(T + NOWN + 3, S + INPUTS, NU * sizeof(double));
  memcpy(T + NOWN + 3 + NU, S + PUSH, NPUSH * sizeof(double));
  M(again)(T, shown_by(r, r->dt), r->w);
  return shown_by(r, dt);
}

/* values so far into the part that is looked at */
static void look(Run *r, double s, double *values) {
  if (s == 0.0 || s == r->length) {
    memcpy(values, s == 0.0 ? r->first : r->last, NE * sizeof(double));
    return;
  }
  memcpy(r->T, r->S, NS * sizeof(double));
  make_part(r, r->T, r->start, s);
  values_shown(r, values, r->T);
}

/* of event k, by the parabola s(e) through both ends of its bracket and the last look beside them, or the secant */
static double zero_of(int k, const double *low, const double *high, const double *looks, int n) {
  const double a = low[NE], b = high[NE], e_a = low[k], e_b = high[k], all = fabs(e_a) + fabs(e_b);
  const double secant = a + (b - a) * fabs(e_a) / (all > 1e-300 ? all : 1e-300);
  double s, e, found;
  while (--n >= 0 && (looks[n * ROW + NE] == a || looks[n * ROW + NE] == b)) continue;
  if (n < 0) return secant;
  s = looks[n * ROW + NE], e = looks[n * ROW + k];
  if (e == e_a || e == e_b || e_a == e_b) return secant;
  found = a * e_b * e / ((e_a - e_b) * (e_a - e)) + b * e_a * e / ((e_b - e_a) * (e_b - e)) +
          s * e_a * e_b / ((e - e_a) * (e - e_b));
  return a < found && found < b ? found : secant;
}

/* how far into the part an event has just happened, between two places; which ones are */
static double first_passage(Run *r, double from, double to, int *happened) {
  const double width = LOCATED < OF_STEP * r->length ? LOCATED : OF_STEP * r->length, *quiet = quiet_of(r->S);
  double before[ROW], low[ROW], high[ROW], now[ROW], *looks = r->looks;
  int k, n, hits[ROW];
  look(r, from, low), low[NE] = from, look(r, to, high), high[NE] = to;
  memcpy(before, low, sizeof low), memcpy(looks, low, sizeof low), memcpy(looks + ROW, high, sizeof high);
  for (n = 0; n < MOST_LOOKS && high[NE] - low[NE] > width; ++n) {
    double guess = (low[NE] + high[NE]) / 2, zero = NEVER;
    if (n % 5 != 4) {
      (void)passed(before, high, quiet, r->start, ALL, hits);
      for (k = 0; k < NE; ++k) {
        if (hits[k]) {
          const double one = zero_of(k, low, high, looks, n + 2);
          zero = one < zero ? one : zero;
        }
      }
      guess = zero + (high[NE] - zero > zero - low[NE] ? 0.4 : -0.4) * width;
    }
    guess = guess > low[NE] + width / 4 ? guess : low[NE] + width / 4;
    guess = guess < high[NE] - width / 4 ? guess : high[NE] - width / 4;
    look(r, guess, now), now[NE] = guess;
    memcpy(looks + (n + 2) * ROW, now, sizeof now);
    memcpy(passed(before, now, quiet, r->start, ALL, NULL) ? high : low, now, sizeof now);
  }
  (void)passed(before, high, quiet, r->start, ALL, happened);
  return high[NE];
}

/* may the cubic through values and slopes at the ends reach zero, or turn? of what the scene declares */
static int unsure(const Run *r, const double *slopes, const double *ends, const double *quiet) {
  int k;
  for (k = 0; k < ND; ++k) {
    const double old = r->first[k], new = r->last[k], a = old + r->length / 3 * slopes[k], b = new - r->length / 3 * ends[k];
    const double side = (old > 0) - (old < 0), way = (new - old > 0) - (new - old < 0);
    if (quiet != NULL && quiet[k] > r->start) continue;
    if (side * new > 0 ? side * a <= 0 || side * b <= 0 : way * (a - old) < 0 || way * (b - a) < 0 || way * (new - b) < 0) return 1;
  }
  return 0;
}

/* intervals of the part are halved until none before the first change of sign has room for a zero; 0: there is none */
static int first_bracket(Run *r, double *from, double *to) {
  double *e = r->looks, new[16 * ROW];
  int known[MOST_CLOSE] = {0}, n = 5, k, j, i, m, first, halved[16], foretold[16], count;
  for (k = 0; k < n; ++k) {
    e[k * ROW + NE] = k < 4 ? k * (r->length / 4) : r->length;
    look(r, e[k * ROW + NE], e + k * ROW);
  }
  for (;;) {
    for (first = 0; first < n - 1 && !passed(e + first * ROW, e + (first + 1) * ROW, quiet_of(r->S), r->start, DECLARED, NULL);) ++first;
    for (count = k = 0; k < n - 1 && k <= first && count < 16; ++k) {
      const double width = e[(k + 1) * ROW + NE] - e[k * ROW + NE];
      int open = known[k] < 1;
      for (j = 0; j < NE && !open; ++j) {
        double most = 0, a = e[k * ROW + j], b = e[(k + 1) * ROW + j], least = fabs(a) < fabs(b) ? fabs(a) : fabs(b);
        for (i = k - 1 > 0 ? k - 1 : 0; i <= (k < n - 3 ? k : n - 3); ++i) {
          const double *p = e + i * ROW, *q = p + ROW, *s = q + ROW;
          const double bend = fabs(((s[j] - q[j]) / (s[NE] - q[NE]) - (q[j] - p[j]) / (q[NE] - p[NE])) / (s[NE] - p[NE]));
          most = bend > most ? bend : most;
        }
        open = a * b > 0 ? 3 * most * (width * width) / 4 > least : 3 * most * width > fabs((b - a) / width);
      }
      if (open && width > 1e-6 * r->length) halved[count++] = k;
    }
    if (count == 0 || n + count >= MOST_CLOSE) {
      if (first < n - 1) *from = e[first * ROW + NE], *to = e[(first + 1) * ROW + NE];
      return first < n - 1;
    }
    for (m = 0; m < count; ++m) { /* all by what was known before */
      double *now = new + m * ROW;
      const int at = halved[m], near = at - 1 < 0 ? 0 : at - 1 > n - 4 ? n - 4 : at - 1;
      now[NE] = (e[at * ROW + NE] + e[(at + 1) * ROW + NE]) / 2;
      look(r, now[NE], now);
      foretold[m] = 1;
      for (j = 0; j < NE; ++j) {
        double cubic = 0, least = INFINITY, most = -INFINITY, size = 0;
        for (k = near; k < near + 4; ++k) {
          const double one = e[k * ROW + j];
          double weight = 1;
          for (i = near; i < near + 4; ++i) {
            if (i != k) weight *= (now[NE] - e[i * ROW + NE]) / (e[k * ROW + NE] - e[i * ROW + NE]);
          }
          cubic += weight * one;
          least = one < least ? one : least, most = one > most ? one : most, size = fabs(one) > size ? fabs(one) : size;
        }
        foretold[m] = foretold[m] && fabs(now[j] - cubic) <= 0.05 * (most - least) + 1e-13 * size;
      }
    }
    while (count-- > 0) { /* from the right, so that what is left of it stays */
      const int at = halved[count];
      memmove(e + (at + 2) * ROW, e + (at + 1) * ROW, (size_t)(n - at - 1) * ROW * sizeof(double));
      memcpy(e + (at + 1) * ROW, new + count * ROW, sizeof(double) * ROW);
      memmove(known + at + 2, known + at + 1, (size_t)(n - at - 2) * sizeof(int));
      known[at] = known[at + 1] = foretold[count] ? known[at] + 1 : 0;
      ++n;
    }
  }
}

/* where in the part that leads to F an event happens first */
static int bracket(Run *r, double *from, double *to) {
  double slopes[ROW], ends[ROW], before[ROW], a = 0, b = 0;
  const double *quiet = quiet_of(r->S);
  const int whole = passed(r->first, r->last, quiet, r->start, ALL, NULL);
  int declared;
  *from = 0, *to = r->length;
  if (ND == 0) return whole;
  M(slopes)(slopes, r->T, set_out(r, r->S, r->length, r->start), r->w);
  M(slopes)(ends, r->F, shown_by(r, r->F[SEEN]), r->w);
  if (!unsure(r, slopes, ends, quiet)) return whole;
  declared = first_bracket(r, &a, &b);
  look(r, declared ? a : r->length, before);
  if (passed(r->first, before, quiet, r->start, LOADS, NULL)) { /* one behind the first event is left for later */
    *to = declared ? a : r->length;
    return 1;
  }
  *from = a, *to = b;
  return declared;
}

/* events are looked for from here on */
static void look_at_events(Run *r) {
  double values[ROW], slopes[ROW], *z = r->z;
  int k;
  M(events)(values, z, r->c, r->w);
  M(slopes)(slopes, z, r->c, r->w);
  z[STEP_AT] = NEVER;
  for (k = 0; k < NE; ++k) z[VALUES_AT + k] = values[k], z[CHANGE_AT + k] = NEVER;
  for (k = 0; k < ND; ++k) z[SLOPES_AT + k] = slopes[k];
#if NSIDES > 0
  double sides[NSIDES];
  M(sides)(sides, z, r->c, r->w);
  for (k = 0; k < NSIDES; ++k) z[SIDE + k] = z[BEFORE + k] = sides[k];
#endif
}

#if NM > 0
#include "settle.c"
#define MOST_OF(k) ((k) >= ND - NM && side_of[(k) - (ND - NM)] != 0 ? MOST_BOUNCES : MOST_IN_A_STEP)
#else
#define MOST_OF(k) MOST_IN_A_STEP
#endif

/* the same where inputs have changed: what sticks is decided anew */
static void look_anew(Run *r) {
  look_at_events(r);
#if NM > 0
  settle_there(r);
#endif
}

/* kink k at t: where it comes ever again it is not looked for for ever longer */
static void rest(Run *r, double *state, int k, double t) {
  double *own = r->z + KINKS + (k - ND) * (MOST_KINKS + 2), *steps = own + 2; /* sleeps, how many steps, steps */
  const double step = ceil((t - r->z[T0]) / r->dt - ON_THE_GRID);
  if (own[1] == MOST_KINKS) memmove(steps, steps + 1, (MOST_KINKS - 1) * sizeof(double));
  else own[1] += 1;
  steps[(int)own[1] - 1] = step;
  if (own[1] == MOST_KINKS && step - steps[0] < OF_STEPS) {
    quiet_of(state)[k] = r->z[T0] + step * r->dt + (pow(2.0, own[0]) - 1) * r->dt;
    own[0] += 1, own[1] = 0;
  }
}

/* what events do at t to the state of S; inputs change at the next restart. Do they end the motion? */
static int act(Run *r, double *S, double t, const int *happened) {
  double held[NU + 1], values[NSETS + 1] = {0}, *quiet = quiet_of(S);
  int k, j;
  r->acted = 1;
  memcpy(held, S + INPUTS_AT, NU * sizeof(double)), memcpy(S + INPUTS_AT, S + INPUTS, NU * sizeof(double));
#if NSETS > 0
  M(actions)(values, S, shown_by(r, S[SEEN]), r->w);
#endif
  for (k = 0; k < NE; ++k) {
    if (!happened[k]) continue;
    if (quiet != NULL) quiet[k] = events_of[k].cool_down > 0 ? t + events_of[k].cool_down : -NEVER;
    if (k >= ND) {
      rest(r, S, k, t);
      continue;
    }
    for (j = events_of[k].from; j < events_of[k].to; ++j) {
      if (!(values[j] - values[j] == 0.0)) r->z[ENDED] = M(NOT_FINITE);
      S[INPUTS_AT + sets_of[j]] = values[j];
    }
    if (events_of[k].terminal && r->z[ENDED] == 0) r->z[ENDED] = M(BY_EVENT);
    if (++r->count[k] >= MOST_OF(k) && r->z[ENDED] == 0) r->z[ENDED] = M(CHATTERING);
  }
#if NM > 0
  if (r->z[ENDED] == 0) {
    double push[NI];
    settle(r, S + INPUTS_AT, push, S, shown_by(r, S[SEEN]), happened + ND - NM);
    for (k = 0; k < NI; ++k) S[PUSH + k] += push[k];
  }
#endif
  for (k = 0; k < NU; ++k) S[INPUTS + k] = S[INPUTS_AT + k], S[INPUTS_AT + k] = held[k];
  return r->z[ENDED] != 0;
}

/* S: so far from a clock on, through the events on the way; where it has come to. Does an event end the motion? */
static int reach(Run *r, double start, double length, double *clock) {
  const double end = start + length, nearly = end - ON_THE_GRID * r->dt;
  for (;;) {
    double from, to, wakes = NEVER, s, *quiet = quiet_of(r->S);
    int k, happened[ROW], ends;
    for (k = 0; k < NE && quiet != NULL; ++k) {
      if (quiet[k] > start && quiet[k] < nearly && quiet[k] < wakes) wakes = quiet[k];
    }
    r->start = start, r->length = wakes < NEVER ? wakes - start : length;
    memcpy(r->F, r->S, NS * sizeof(double));
    make_part(r, r->F, start, r->length);
    M(events)(r->first, r->T, set_out(r, r->S, r->length, start), r->w);
    values_shown(r, r->last, r->F);
    if (!bracket(r, &from, &to)) {
      memcpy(r->S, r->F, NS * sizeof(double));
      *clock = end;
      if (wakes == NEVER) return 0;
      start = wakes, length = end - wakes;
      continue;
    }
    s = first_passage(r, from, to, happened);
    *clock = start + s;
    make_part(r, r->S, start, *clock - start);
    ends = act(r, r->S, *clock, happened);
    start = *clock, length = end - start;
    if (ends || length <= ON_THE_GRID * r->dt) return ends;
  }
}

/* events that pass zero where something jumps between two clocks */
static int jumped(Run *r, double before, double after) {
  double here[ROW], there[ROW], *quiet = quiet_of(r->S);
  const double clock = r->S[0];
  int happened[ROW], ends;
  values_shown(r, here, r->S);
  M(events)(there, r->T, set_out(r, r->S, r->S[SEEN], after), r->w);
  if (!passed(here, there, quiet, before, ALL, happened)) return 0;
  r->S[0] += after - before; /* what holds or lets go is decided by the loads behind the jump */
  ends = act(r, r->S, (before + after) / 2, happened);
  r->S[0] = clock;
  return ends;
}
#endif

/* ---- steps ---- */

static double time_of(const Run *r, double step) { return r->z[T0] + step * r->dt; }

/* whole steps; behind a stop the first one runs on the clock that it was given */
static void whole(Run *r, long n) {
  if (n > 0 && r->z[0] != r->z[T0]) {
    M(steps)(r->z, r->c, r->w, 1);
    r->z[0] = r->z[T0], --n;
  }
  if (n > 0) M(steps)(r->z, r->c, r->w, n);
}

#if NT > 0
#include "times.c"
#else /* nothing changes in time */
static long clear(Run *r, long n) { return (void)r, n; }
static double clock_at(Run *r, double t) { return (void)r, t; }
static int parts_of(Run *r, Part *parts, double *clock) {
  (void)clock;
  parts[0].start = time_of(r, r->z[1]), parts[0].length = time_of(r, r->z[1] + 1) - parts[0].start;
  parts[0].before = NEVER, parts[0].after = -NEVER;
  return 1;
}
#endif

/* the step that z is at, in parts; with: through the events in it. */
static void in_parts(Run *r, const Part *parts, int n, double clock, int with) {
  double *S = r->S;
  const double step = r->z[1];
  int k, ends = 0;
  memset(S, 0, NS * sizeof(double));
  memcpy(S, r->z, NZ * sizeof(double)), memcpy(S + INPUTS, r->z + INPUTS_AT, NU * sizeof(double));
  S[NUMBER] = step, S[SEEN] = r->dt;
#if NE > 0
  S[EVENT_BEFORE] = with ? NEVER : S[STEP_AT], S[STEP_AT] = NEVER;
#endif
  for (k = 0; k < n && !ends; ++k) {
#if NE > 0
    double reached;
    if (with) {
      ends = reach(r, parts[k].start, parts[k].length, &reached);
      if (!ends && parts[k].before < NEVER) ends = jumped(r, parts[k].before, parts[k].after);
      if (ends) clock = reached;
      continue;
    }
#endif
    make_part(r, S, parts[k].start, parts[k].length);
  }
  (void)with;
  S[CLOCK] = clock, S[ORIGIN] = r->z[T0] + (clock - time_of(r, step + 1));
  M(to_grid)(S, r->read, r->w);
  memcpy(r->z, S, NZ * sizeof(double));
}

/* one step with the stops in it */
static void one_step(Run *r, int with) {
  Part parts[2 * MOST_STOPS + 2];
  double clock = time_of(r, r->z[1] + 1);
  int n;
  parts[0].before = NEVER;
  n = parts_of(r, parts, &clock);
  if (n > 1 || parts[0].before < NEVER || with) in_parts(r, parts, n, clock, with);
  else whole(r, 1);
}

#if NE > 0
static void with_events(Run *r) {
  double behind[NZ], *z = r->z;
  memcpy(r->saved, z, NZ * sizeof(double));
  r->saved[STEP_AT] = NEVER, r->acted = 0;
  memset(r->count, 0, sizeof r->count);
  one_step(r, 1);
  z[STEP_AT] = NEVER;
  if (r->acted) return;
  memcpy(behind, z, sizeof behind), memcpy(z, r->saved, NZ * sizeof(double));
  one_step(r, 0);
  if (passed(behind + VALUES_AT, z + VALUES_AT, NULL, 0.0, ALL, NULL)) memcpy(z, behind, sizeof behind);
  z[STEP_AT] = NEVER;
}

#endif

/* from the state at a time on as if nothing had happened yet */
static void set_out_from(Run *r, double t) {
  double *z = r->z;
  memset(z + NZ, 0, KEPT * sizeof(double));
  z[T0] = t, z[0] = clock_at(r, t);
#if NE > 0
  int k;
  for (k = 0; k < NE && QUIET_AT >= 0; ++k) quiet_of(z)[k] = -NEVER;
#if NSTOPS > 0
  if (!within_stops(r)) {
    z[ENDED] = M(BEYOND_A_STOP);
    return;
  }
#endif
  look_anew(r);
#endif
}

int M(step)(double *z, const double *c, double *w, long n) {
  Run r = made_run(z, c, w);
  const double end = z[1] + (double)n;
  while (z[1] < end && z[ENDED] == 0) {
    const long ahead = end - z[1] < 64 ? (long)(end - z[1]) : 64;
    const long free = clear(&r, ahead);
    const double first = z[1];
    if (free < 0) return (int)(z[ENDED] = M(TOO_MANY));
#if NE > 0
    double kept[NZ];
    memcpy(kept, z, sizeof kept);
#endif
    if (free > 0) whole(&r, free);
    else one_step(&r, 0);
#if NE > 0
    if (z[STEP_AT] < NEVER) {
      const long at = (long)(z[STEP_AT] - 1 - first);
      memcpy(z, kept, sizeof kept);
      if (at > 0) whole(&r, at);
      with_events(&r);
    }
#else
    (void)first;
#endif
  }
  return (int)z[ENDED];
}
