/* Steps that end where loads jump in time, where events happen and where loads kink: of runs, compiled (stops.ll), and
   of exported C. What a model is comes by a struct Model; z has KEPT numbers more than the scheme's: of the grid and of
   what has happened. A plain reading is in event_search.py, steps_with_stops.py, settle.py; tests hold them together. */

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
#define T0 (of->NZ)
#define ENDED (of->NZ + 1)
#define KINKS (of->NZ + 2)
#define ROW (of->NE + 1)
#define RESOLVED_STEPS 2
#define RESOLVING_PARTS 4
#define MOST_PARTS (2 * MOST_STOPS + 2)
#define ROOM_OF_A_STEP 200 /* records: with less, a step with events is left to the next call */

#include "model.h"

typedef struct {
  double time, before, after;
} Stop;
typedef struct { /* arrays of the caller's w; S, F, T: of a step in parts, where a part leads, where a look leads */
  double *z, *w, *S, *F, *T, *saved, *read, *cd, *looks, *there, *first, *last, *signs;
  Stop *stops;
  I *bounds;
  const double *c, *ready; /* the constants, and what whole steps read */
  double dt, start, length; /* of the part that is looked at; first, last: values at its ends */
  int *count, acted;
  const Grid *grid; /* where it is known which steps are broken */
  Log *log;         /* of who wants to know what has happened */
} Run;

static Run made_run(const Model *of, double *z, const double *ready, const double *c, double *w, Room *room) {
  Run r;
  memset(&r, 0, sizeof r);
  r.z = z, r.c = c, r.ready = ready, r.dt = c[of->DT_AT], r.w = w + of->KEPT_IN_W;
  r.S = w, r.F = r.S + of->NS, r.T = r.F + of->NS, r.saved = r.T + of->NS, r.read = r.saved + of->NZ;
  r.cd = r.read + of->NREADY + of->NC, r.looks = r.cd + of->NC, r.there = r.looks + MOST_CLOSE * ROW;
  r.first = r.there + of->NTHERE, r.last = r.first + ROW, r.signs = r.last + ROW;
  r.bounds = (I *)(r.signs + of->NT), r.stops = (Stop *)(r.bounds + 2 * of->NT);
  room->reals = (double *)(r.stops + MOST_STOPS), room->wholes = (int *)(room->reals + of->NREALS);
  r.count = room->wholes, room->wholes += ROW;
  memcpy(r.read, ready, of->NREADY * sizeof(double)), memcpy(r.read + of->NREADY, c, of->NC * sizeof(double));
  return r;
}

/* constants that show a state which steps of dt led to */
static const double *shown_by(const Model *of, Run *r, double dt) {
  int64_t k;
  memcpy(r->cd, r->c, of->DT_AT * sizeof(double));
  for (k = of->DT_AT; k < of->NC; ++k) r->cd[k] = r->c[k] * (dt / r->c[of->DT_AT]);
  return r->cd;
}

/* S: a part so long from a clock on */
static void make_part(const Model *of, Run *r, double *S, double start, double length) {
  length = length * (1 - 2 * 2.220446049250313e-16 * of->SUB_STEPS);
  S[of->START] = start, S[of->LENGTH] = length, S[of->SHARE] = length / r->dt;
  of->set_out(S, r->read, r->w);
  of->steps(S, S + of->READY, r->w, 1);
  S[of->SEEN] = length;
}

/* ---- events ---- */

static double *quiet_of(const Model *of, double *z) { return of->QUIET_AT < 0 ? NULL : z + of->QUIET_AT; }

static int passes(double from, double to, int way) {
  return (way >= 0 && from < 0 && to >= 0) || (way <= 0 && from > 0 && to <= 0);
}

/* does one happen between two sets of values? which: kinks and events, or one kind of them; asleep until then */
enum { ALL, DECLARED, LOADS };
static int passed(const Model *of, const double *from, const double *to, const double *quiet, double t, int which, int *found) {
  int k, any = 0;
  for (k = 0; k < of->NE; ++k) {
    const int here = (which == ALL || (which == DECLARED) == (k < of->ND)) && !(quiet != NULL && quiet[k] > t) &&
                     passes(from[k], to[k], of->events_of[k].way);
    if (found != NULL) found[k] = here;
    any = any || here;
  }
  return any;
}

static void values_shown(const Model *of, Run *r, double *values, const double *S) { of->events(values, S, shown_by(of, r, S[of->SEEN]), r->w); }

/* T: the state of S behind a restart to steps dt at a clock, and the constants that show it */
static const double *set_out(const Model *of, Run *r, const double *S, double dt, double clock) {
  double *T = r->T;
  memcpy(T, S, of->NOWN * sizeof(double));
  T[of->NOWN] = S[of->SEEN], T[of->NOWN + 1] = dt, T[of->NOWN + 2] = clock;
  memcpy(T + of->NOWN + 3, S + of->INPUTS, of->NU * sizeof(double));
  memcpy(T + of->NOWN + 3 + of->NU, S + of->PUSH, of->NPUSH * sizeof(double));
  of->again(T, shown_by(of, r, r->dt), r->w);
  return shown_by(of, r, dt);
}

/* values so far into the part that is looked at */
static void look(const Model *of, Run *r, double s, double *values) {
  if (s == 0.0 || s == r->length) {
    memcpy(values, s == 0.0 ? r->first : r->last, of->NE * sizeof(double));
    return;
  }
  memcpy(r->T, r->S, of->NS * sizeof(double));
  make_part(of, r, r->T, r->start, s);
  values_shown(of, r, values, r->T);
}

/* of event k, by the parabola s(e) through both ends of its bracket and the last look beside them, or the secant */
static double zero_of(const Model *of, int k, const double *low, const double *high, const double *looks, int n) {
  const double a = low[of->NE], b = high[of->NE], e_a = low[k], e_b = high[k], all = fabs(e_a) + fabs(e_b);
  const double secant = a + (b - a) * fabs(e_a) / (all > 1e-300 ? all : 1e-300);
  double s, e, found;
  while (--n >= 0 && (looks[n * ROW + of->NE] == a || looks[n * ROW + of->NE] == b)) continue;
  if (n < 0) return secant;
  s = looks[n * ROW + of->NE], e = looks[n * ROW + k];
  if (e == e_a || e == e_b || e_a == e_b) return secant;
  found = a * e_b * e / ((e_a - e_b) * (e_a - e)) + b * e_a * e / ((e_b - e_a) * (e_b - e)) +
          s * e_a * e_b / ((e - e_a) * (e - e_b));
  return a < found && found < b ? found : secant;
}

/* how far into the part an event has just happened, between two places; which ones are */
static double first_passage(const Model *of, Run *r, double from, double to, int *happened, Room room) {
  const double width = LOCATED < OF_STEP * r->length ? LOCATED : OF_STEP * r->length, *quiet = quiet_of(of, r->S);
  double *before = REALS(ROW), *low = REALS(ROW), *high = REALS(ROW), *now = REALS(ROW), *looks = r->looks;
  int k, n, *hits = WHOLES(ROW);
  look(of, r, from, low), low[of->NE] = from, look(of, r, to, high), high[of->NE] = to;
  memcpy(before, low, ROW * sizeof(double)), memcpy(looks, low, ROW * sizeof(double)), memcpy(looks + ROW, high, ROW * sizeof(double));
  for (n = 0; n < MOST_LOOKS && high[of->NE] - low[of->NE] > width; ++n) {
    double guess = (low[of->NE] + high[of->NE]) / 2, zero = NEVER;
    if (n % 5 != 4) {
      (void)passed(of, before, high, quiet, r->start, ALL, hits);
      for (k = 0; k < of->NE; ++k) {
        if (hits[k]) {
          const double one = zero_of(of, k, low, high, looks, n + 2);
          zero = one < zero ? one : zero;
        }
      }
      guess = zero + (high[of->NE] - zero > zero - low[of->NE] ? 0.4 : -0.4) * width;
    }
    guess = guess > low[of->NE] + width / 4 ? guess : low[of->NE] + width / 4;
    guess = guess < high[of->NE] - width / 4 ? guess : high[of->NE] - width / 4;
    look(of, r, guess, now), now[of->NE] = guess;
    memcpy(looks + (n + 2) * ROW, now, ROW * sizeof(double));
    memcpy(passed(of, before, now, quiet, r->start, ALL, NULL) ? high : low, now, ROW * sizeof(double));
  }
  (void)passed(of, before, high, quiet, r->start, ALL, happened);
  return high[of->NE];
}

/* may the cubic through values and slopes at the ends reach zero, or turn? of what the scene declares */
static int unsure(const Model *of, const Run *r, const double *slopes, const double *ends, const double *quiet) {
  int k;
  for (k = 0; k < of->ND; ++k) {
    const double old = r->first[k], new = r->last[k], a = old + r->length / 3 * slopes[k], b = new - r->length / 3 * ends[k];
    const double side = (old > 0) - (old < 0), way = (new - old > 0) - (new - old < 0);
    if (quiet != NULL && quiet[k] > r->start) continue;
    if (side * new > 0 ? side * a <= 0 || side * b <= 0 : way * (a - old) < 0 || way * (b - a) < 0 || way * (new - b) < 0) return 1;
  }
  return 0;
}

/* intervals of the part are halved until none before the first change of sign has room for a zero; 0: there is none */
static int first_bracket(const Model *of, Run *r, double *from, double *to, Room room) {
  double *e = r->looks, *new = REALS(16 * ROW);
  int known[MOST_CLOSE] = {0}, n = 5, k, j, i, m, first, halved[16], foretold[16], count;
  for (k = 0; k < n; ++k) {
    e[k * ROW + of->NE] = k < 4 ? k * (r->length / 4) : r->length;
    look(of, r, e[k * ROW + of->NE], e + k * ROW);
  }
  for (;;) {
    for (first = 0; first < n - 1 && !passed(of, e + first * ROW, e + (first + 1) * ROW, quiet_of(of, r->S), r->start, DECLARED, NULL);) ++first;
    for (count = k = 0; k < n - 1 && k <= first && count < 16; ++k) {
      const double width = e[(k + 1) * ROW + of->NE] - e[k * ROW + of->NE];
      int open = known[k] < 1;
      for (j = 0; j < of->NE && !open; ++j) {
        double most = 0, a = e[k * ROW + j], b = e[(k + 1) * ROW + j], least = fabs(a) < fabs(b) ? fabs(a) : fabs(b);
        for (i = k - 1 > 0 ? k - 1 : 0; i <= (k < n - 3 ? k : n - 3); ++i) {
          const double *p = e + i * ROW, *q = p + ROW, *s = q + ROW;
          const double bend = fabs(((s[j] - q[j]) / (s[of->NE] - q[of->NE]) - (q[j] - p[j]) / (q[of->NE] - p[of->NE])) / (s[of->NE] - p[of->NE]));
          most = bend > most ? bend : most;
        }
        open = a * b > 0 ? 3 * most * (width * width) / 4 > least : 3 * most * width > fabs((b - a) / width);
      }
      if (open && width > 1e-6 * r->length) halved[count++] = k;
    }
    if (count == 0 || n + count >= MOST_CLOSE) {
      if (first < n - 1) *from = e[first * ROW + of->NE], *to = e[(first + 1) * ROW + of->NE];
      return first < n - 1;
    }
    for (m = 0; m < count; ++m) { /* all by what was known before */
      double *now = new + m * ROW;
      const int at = halved[m], near = at - 1 < 0 ? 0 : at - 1 > n - 4 ? n - 4 : at - 1;
      now[of->NE] = (e[at * ROW + of->NE] + e[(at + 1) * ROW + of->NE]) / 2;
      look(of, r, now[of->NE], now);
      foretold[m] = 1;
      for (j = 0; j < of->NE; ++j) {
        double cubic = 0, least = INFINITY, most = -INFINITY, size = 0;
        for (k = near; k < near + 4; ++k) {
          const double one = e[k * ROW + j];
          double weight = 1;
          for (i = near; i < near + 4; ++i) {
            if (i != k) weight *= (now[of->NE] - e[i * ROW + of->NE]) / (e[k * ROW + of->NE] - e[i * ROW + of->NE]);
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
static int bracket(const Model *of, Run *r, double *from, double *to, Room room) {
  double *slopes = REALS(ROW), *ends = REALS(ROW), *before = REALS(ROW), a = 0, b = 0;
  const double *quiet = quiet_of(of, r->S);
  const int whole = passed(of, r->first, r->last, quiet, r->start, ALL, NULL);
  int declared;
  *from = 0, *to = r->length;
  if (of->ND == 0) return whole;
  of->slopes(slopes, r->T, set_out(of, r, r->S, r->length, r->start), r->w);
  of->slopes(ends, r->F, shown_by(of, r, r->F[of->SEEN]), r->w);
  if (!unsure(of, r, slopes, ends, quiet)) return whole;
  declared = first_bracket(of, r, &a, &b, room);
  look(of, r, declared ? a : r->length, before);
  if (passed(of, r->first, before, quiet, r->start, LOADS, NULL)) { /* one behind the first event is left for later */
    *to = declared ? a : r->length;
    return 1;
  }
  *from = a, *to = b;
  return declared;
}

/* events are looked for from here on */
static void look_at_events(const Model *of, Run *r, Room room) {
  double *values = REALS(ROW), *slopes = REALS(ROW), *z = r->z;
  int k;
  of->events(values, z, r->c, r->w);
  of->slopes(slopes, z, r->c, r->w);
  z[of->STEP_AT] = NEVER;
  for (k = 0; k < of->NE; ++k) z[of->VALUES_AT + k] = values[k], z[of->CHANGE_AT + k] = NEVER;
  for (k = 0; k < of->ND; ++k) z[of->SLOPES_AT + k] = slopes[k];
  if (of->NSIDES > 0) {
    double *sides = REALS(of->NSIDES);
    of->sides(sides, z, r->c, r->w);
    for (k = 0; k < of->NSIDES; ++k) z[of->SIDE + k] = z[of->BEFORE + k] = sides[k];
  }
}

#include "settle.c"
/* events of stops come more often in a step than others */
static int most_of(const Model *of, int k) {
  return k >= of->ND - of->NM && of->side_of[k - (of->ND - of->NM)] != 0 ? MOST_BOUNCES : MOST_IN_A_STEP;
}

/* the same where inputs have changed: what sticks is decided anew */
static void look_anew(const Model *of, Run *r, Room room) {
  look_at_events(of, r, room);
  if (of->NM > 0) settle_there(of, r, room);
}

/* kink k at t: where it comes ever again it is not looked for for ever longer */
static void rest(const Model *of, Run *r, double *state, int k, double t) {
  double *own = r->z + KINKS + (k - of->ND) * (MOST_KINKS + 2), *steps = own + 2; /* sleeps, how many steps, steps */
  const double step = ceil((t - r->z[T0]) / r->dt - ON_THE_GRID);
  if (own[1] == MOST_KINKS) memmove(steps, steps + 1, (MOST_KINKS - 1) * sizeof(double));
  else own[1] += 1;
  steps[(int)own[1] - 1] = step;
  if (own[1] == MOST_KINKS && step - steps[0] < OF_STEPS) {
    double longer = 1; /* two to the power of sleeps */
    int sleeps = (int)own[0];
    while (sleeps-- > 0) longer *= 2;
    quiet_of(of, state)[k] = r->z[T0] + step * r->dt + (longer - 1) * r->dt;
    own[0] += 1, own[1] = 0;
  }
}

/* ---- what has happened ---- */

#define RECORD (3 + 2 * of->NE + of->NOWN + of->NU + of->NI + (of->NM > 0 ? TOLD : 0))

/* of events at t in the state of S, which is seen before they act: t, step, steps that show it; which happened (NE),
   their values (NE), the state (NOWN). Behind it, by `act`: inputs (NU), what is added to the rates (NI), and what
   `settle` tells. NULL: nobody wants to know */
static double *record(const Model *of, Run *r, const double *S, double t, const int *happened) {
  Log *log = r->log;
  double *one;
  int k;
  if (log == NULL) return NULL;
  if (log->room <= 0) {
    log->lost = 1;
    return NULL;
  }
  one = log->records + log->n * RECORD, log->n += 1, log->room -= 1;
  one[0] = t, one[1] = S[of->NUMBER], one[2] = S[of->SEEN];
  for (k = 0; k < of->NE; ++k) one[3 + k] = happened[k];
  values_shown(of, r, one + 3 + of->NE, S);
  memcpy(one + 3 + 2 * of->NE, S, of->NOWN * sizeof(double));
  return one + 3 + 2 * of->NE + of->NOWN;
}

/* the first step from this one on that is not plain, by its place */
static int64_t place_of(const Grid *grid, double step) {
  int64_t low = 0, high = grid->n;
  while (low < high) {
    const int64_t middle = (low + high) / 2;
    if ((double)grid->step[middle] < step) low = middle + 1;
    else high = middle;
  }
  return low;
}

/* what steps err through which a load acts for less than RESOLVED_STEPS of them, by parts of that time: steps of other
   lengths end where it begins and ends, too, so that none of them shows it */
static void resolve(const Model *of, Run *r, double clock, const int *happened, Room room) {
  Log *log = r->log;
  double *T = r->T, *there = REALS(of->NAT), *finer = REALS(of->NAT), off = 0;
  const double *opened = log->opened, length = clock - opened[0];
  int64_t j;
  int k, closes = 0;
  for (k = of->ND; k < of->NE; ++k) closes = closes || (happened[k] && opened[1 + k] != 0);
  if (!closes || !(0.0 < length && length < RESOLVED_STEPS * r->dt)) return;
  for (j = place_of(r->grid, floor((opened[0] - r->z[T0]) / r->dt)); j < r->grid->n && r->grid->step[j] <= floor((clock - r->z[T0]) / r->dt); ++j) {
    if (r->grid->broken[j]) return;
  }
  memcpy(T, opened + 1 + of->NE, of->NS * sizeof(double));
  for (k = 0; k < RESOLVING_PARTS; ++k) make_part(of, r, T, opened[0] + k * length / RESOLVING_PARTS, length / RESOLVING_PARTS);
  of->seen(finer, T, shown_by(of, r, T[of->SEEN]), r->w);
  of->seen(there, r->S, shown_by(of, r, r->S[of->SEEN]), r->w);
  for (k = 0; k < of->NI; ++k) {
    const double one = fabs(there[of->NI + of->NQD + k] - finer[of->NI + of->NQD + k]);
    off = one - one == 0.0 ? (one > off ? one : off) : INFINITY;
    if (off == INFINITY) break;
  }
  if (off > log->unresolved) log->unresolved = off;
}

/* which kinks loads have come to at a clock, and the state behind */
static void note_opened(const Model *of, Run *r, double clock, const int *happened) {
  double *opened = r->log->opened;
  int k;
  opened[0] = clock;
  for (k = 0; k < of->NE; ++k) opened[1 + k] = k >= of->ND && happened[k];
  memcpy(opened + 1 + of->NE, r->S, of->NS * sizeof(double));
}

/* what events do at t to the state of S; inputs change at the next restart. Do they end the motion? */
static int act(const Model *of, Run *r, double *S, double t, const int *happened, Room room) {
  double *held = REALS(of->NU + 1), *values = REALS(of->NSETS + 1), *quiet = quiet_of(of, S), *one, *told = NULL;
  int k, j;
  memset(values, 0, (of->NSETS + 1) * sizeof(double));
  r->acted = 1;
  memcpy(held, S + of->INPUTS_AT, of->NU * sizeof(double)), memcpy(S + of->INPUTS_AT, S + of->INPUTS, of->NU * sizeof(double));
  one = record(of, r, S, t, happened);
  if (one != NULL) memset(one + of->NU, 0, of->NI * sizeof(double)), told = one + of->NU + of->NI;
  if (of->NSETS > 0) of->actions(values, S, shown_by(of, r, S[of->SEEN]), r->w);
  for (k = 0; k < of->NE; ++k) {
    if (!happened[k]) continue;
    if (quiet != NULL) quiet[k] = of->events_of[k].cool_down > 0 ? t + of->events_of[k].cool_down : -NEVER;
    if (k >= of->ND) {
      rest(of, r, S, k, t);
      continue;
    }
    for (j = of->events_of[k].from; j < of->events_of[k].to; ++j) {
      if (!(values[j] - values[j] == 0.0)) r->z[ENDED] = NOT_FINITE;
      S[of->INPUTS_AT + of->sets_of[j]] = values[j];
    }
    if (of->events_of[k].terminal && r->z[ENDED] == 0) r->z[ENDED] = BY_EVENT;
    if (++r->count[k] >= most_of(of, k) && r->z[ENDED] == 0) r->z[ENDED] = CHATTERING;
  }
  if (of->NM > 0 && r->z[ENDED] == 0) {
    double *push = REALS(of->NI);
    settle(of, r, S + of->INPUTS_AT, push, S, shown_by(of, r, S[of->SEEN]), happened + of->ND - of->NM, told, room);
    for (k = 0; k < of->NI; ++k) S[of->PUSH + k] += push[k];
    if (one != NULL) memcpy(one + of->NU, push, of->NI * sizeof(double));
  }
  if (one != NULL) memcpy(one, S + of->INPUTS_AT, of->NU * sizeof(double));
  for (k = 0; k < of->NU; ++k) S[of->INPUTS + k] = S[of->INPUTS_AT + k], S[of->INPUTS_AT + k] = held[k];
  return r->z[ENDED] != 0;
}

/* S: so far from a clock on, through the events on the way; where it has come to. Does an event end the motion? */
static int reach(const Model *of, Run *r, double start, double length, double *clock, Room room) {
  const double end = start + length, nearly = end - ON_THE_GRID * r->dt;
  int *happened = WHOLES(ROW);
  for (;;) {
    double from, to, wakes = NEVER, s, *quiet = quiet_of(of, r->S);
    int k, ends;
    for (k = 0; k < of->NE && quiet != NULL; ++k) {
      if (quiet[k] > start && quiet[k] < nearly && quiet[k] < wakes) wakes = quiet[k];
    }
    r->start = start, r->length = wakes < NEVER ? wakes - start : length;
    memcpy(r->F, r->S, of->NS * sizeof(double));
    make_part(of, r, r->F, start, r->length);
    of->events(r->first, r->T, set_out(of, r, r->S, r->length, start), r->w);
    values_shown(of, r, r->last, r->F);
    if (!bracket(of, r, &from, &to, room)) {
      memcpy(r->S, r->F, of->NS * sizeof(double));
      *clock = end;
      if (wakes == NEVER) return 0;
      start = wakes, length = end - wakes;
      continue;
    }
    s = first_passage(of, r, from, to, happened, room);
    *clock = start + s;
    make_part(of, r, r->S, start, *clock - start);
    if (r->log != NULL && of->ND < of->NE) resolve(of, r, *clock, happened, room);
    ends = act(of, r, r->S, *clock, happened, room);
    if (r->log != NULL && of->ND < of->NE) note_opened(of, r, *clock, happened);
    start = *clock, length = end - start;
    if (ends || length <= ON_THE_GRID * r->dt) return ends;
  }
}

/* events that pass zero where something jumps between two clocks */
static int jumped(const Model *of, Run *r, double before, double after, Room room) {
  double *here = REALS(ROW), *there = REALS(ROW), *quiet = quiet_of(of, r->S);
  const double clock = r->S[0];
  int *happened = WHOLES(ROW), ends;
  values_shown(of, r, here, r->S);
  of->events(there, r->T, set_out(of, r, r->S, r->S[of->SEEN], after), r->w);
  if (!passed(of, here, there, quiet, before, ALL, happened)) return 0;
  r->S[0] += after - before; /* what holds or lets go is decided by the loads behind the jump */
  ends = act(of, r, r->S, (before + after) / 2, happened, room);
  r->S[0] = clock;
  return ends;
}

/* ---- steps ---- */

static double time_of(const Model *of, const Run *r, double step) { return r->z[T0] + step * r->dt; }

/* whole steps; behind a stop the first one runs on the clock that it was given */
static void whole(const Model *of, Run *r, int64_t n) {
  if (n > 0 && r->z[0] != r->z[T0]) {
    of->steps(r->z, r->ready, r->w, 1);
    r->z[0] = r->z[T0], --n;
  }
  if (n > 0) of->steps(r->z, r->ready, r->w, n);
}

#include "times.c"

/* of so many steps at most, how many from here on are plain; -1: too many stops in a step */
static int64_t plain(const Model *of, Run *r, int64_t n) {
  int64_t k, ahead;
  if (r->grid == NULL) return clear(of, r, n);
  k = place_of(r->grid, r->z[1]);
  if (k == r->grid->n) return n;
  ahead = r->grid->step[k] - (int64_t)r->z[1];
  return ahead < n ? ahead : n;
}

/* the step that z is at: its parts, how many, is it broken? clock, origin: behind it */
static int of_step(const Model *of, Run *r, Part *parts, int *broken, double *clock, double *origin) {
  const double step = r->z[1], next = time_of(of, r, step + 1);
  int n = 1;
  *clock = next, *broken = 0, *origin = NEVER;
  if (r->grid != NULL) {
    const Grid *grid = r->grid;
    const int64_t k = place_of(grid, step);
    if (k < grid->n && (double)grid->step[k] == step) {
      n = (int)(grid->first[k + 1] - grid->first[k]);
      memcpy(parts, grid->part + grid->first[k], n * sizeof(Part));
      *clock = grid->clock[k], *broken = (int)grid->broken[k], *origin = grid->origin[k];
      return n;
    }
    parts[0].start = time_of(of, r, step), parts[0].length = next - parts[0].start, parts[0].before = NEVER, parts[0].after = -NEVER;
  } else {
    n = parts_of(of, r, parts, clock);
    *broken = n > 1 || parts[0].before < NEVER;
  }
  *origin = r->z[T0] + (*clock - next);
  return n;
}

/* the step that z is at, in parts; with: through the events in it. */
static void in_parts(const Model *of, Run *r, const Part *parts, int n, double clock, double origin, int with, Room room) {
  double *S = r->S;
  const double step = r->z[1];
  int k, ends = 0;
  memset(S, 0, of->NS * sizeof(double));
  memcpy(S, r->z, of->NZ * sizeof(double)), memcpy(S + of->INPUTS, r->z + of->INPUTS_AT, of->NU * sizeof(double));
  S[of->NUMBER] = step, S[of->SEEN] = r->dt;
  if (of->NE > 0) S[of->EVENT_BEFORE] = with ? NEVER : S[of->STEP_AT], S[of->STEP_AT] = NEVER;
  for (k = 0; k < n && !ends; ++k) {
    double reached;
    if (with) {
      ends = reach(of, r, parts[k].start, parts[k].length, &reached, room);
      if (!ends && parts[k].before < NEVER) ends = jumped(of, r, parts[k].before, parts[k].after, room);
      if (ends) clock = reached, origin = r->z[T0] + (clock - time_of(of, r, step + 1));
      continue;
    }
    make_part(of, r, S, parts[k].start, parts[k].length);
  }
  S[of->CLOCK] = clock, S[of->ORIGIN] = origin;
  of->to_grid(S, r->read, r->w);
  memcpy(r->z, S, of->NZ * sizeof(double));
}

/* one step with the stops in it */
static void one_step(const Model *of, Run *r, int with, Room room) {
  Part *parts = (Part *)REALS(4 * MOST_PARTS);
  double clock, origin;
  int broken;
  const int n = of_step(of, r, parts, &broken, &clock, &origin);
  if (broken || with) in_parts(of, r, parts, n, clock, origin, with, room);
  else whole(of, r, 1);
}

static void with_events(const Model *of, Run *r, Room room) {
  double *behind = REALS(of->NZ), *z = r->z;
  memcpy(r->saved, z, of->NZ * sizeof(double));
  r->saved[of->STEP_AT] = NEVER, r->acted = 0;
  memset(r->count, 0, ROW * sizeof(int));
  one_step(of, r, 1, room);
  z[of->STEP_AT] = NEVER;
  if (r->acted) return;
  memcpy(behind, z, of->NZ * sizeof(double)), memcpy(z, r->saved, of->NZ * sizeof(double));
  one_step(of, r, 0, room);
  if (passed(of, behind + of->VALUES_AT, z + of->VALUES_AT, NULL, 0.0, ALL, NULL)) memcpy(z, behind, of->NZ * sizeof(double));
  z[of->STEP_AT] = NEVER;
}

/* from the state at a time on as if nothing had happened yet */
static void set_out_from(const Model *of, Run *r, double t, Room room) {
  double *z = r->z;
  int k;
  memset(z + of->NZ, 0, of->KEPT * sizeof(double));
  z[T0] = t, z[0] = clock_at(of, r, t);
  if (of->NE == 0) return;
  for (k = 0; k < of->NE && of->QUIET_AT >= 0; ++k) quiet_of(of, z)[k] = -NEVER;
  if (of->NSTOPS > 0 && !within_stops(of, r)) {
    z[ENDED] = BEYOND_A_STOP;
    return;
  }
  look_anew(of, r, room);
}

DOOR void set_out_at(const Model *of, double *z, const double *c, double t, double *w) {
  Room room;
  Run r = made_run(of, z, c, c, w, &room);
  set_out_from(of, &r, t, room);
}

/* where inputs or the grid have changed */
DOOR void look_again(const Model *of, double *z, const double *c, double *w) {
  Room room;
  Run r = made_run(of, z, c, c, w, &room);
  look_anew(of, &r, room);
}

/* to step `end`, or to what ends the motion before. 1: the log has no room for the events of the next step */
static int advance(const Model *of, Run *r, double end, double *kept, Room room) {
  double *z = r->z;
  while (z[1] < end && z[ENDED] == 0) {
    const int64_t ahead = end - z[1] < 64 ? (int64_t)(end - z[1]) : 64;
    const int64_t free = plain(of, r, ahead);
    const double first = z[1];
    if (free < 0) {
      z[ENDED] = TOO_MANY;
      return 0;
    }
    memcpy(kept, z, of->NZ * sizeof(double));
    if (free > 0) whole(of, r, free);
    else one_step(of, r, 0, room);
    if (of->NE > 0 && z[of->STEP_AT] < NEVER) {
      const int64_t at = (int64_t)(z[of->STEP_AT] - 1 - first);
      memcpy(z, kept, of->NZ * sizeof(double));
      if (at > 0) whole(of, r, at);
      if (r->log != NULL && r->log->room < ROOM_OF_A_STEP) return 1;
      with_events(of, r, room);
    }
  }
  return 0;
}

DOOR int step(const Model *of, double *z, const double *c, double *w, int64_t n) {
  Room room;
  Run r = made_run(of, z, c, c, w, &room);
  double *kept = REALS(of->NZ);
  (void)advance(of, &r, z[1] + (double)n, kept, room);
  return (int)z[ENDED];
}

/* a run: to each of these steps, with a copy of z (NZ) to the rows of `out`; how many of them were reached */
DOOR int64_t run_rows(const Model *of, const Grid *grid, Log *log, double *z, const double *ready, const double *c, double *w,
                      const int64_t *ends, int64_t rows, double *out) {
  Room room;
  Run r = made_run(of, z, ready, c, w, &room);
  double *kept = REALS(of->NZ);
  int64_t k;
  r.grid = grid, r.log = log;
  for (k = 0; k < rows; ++k) {
    if (advance(of, &r, (double)ends[k], kept, room) || z[ENDED] != 0 || log->lost) return k;
    memcpy(out + k * of->NZ, z, of->NZ * sizeof(double));
  }
  return k;
}
