/* What both versions of the standard do. M(name) are the functions of the bundle, N(NAME) its numbers. Value references
   count time, then p (parameters and inputs), then y (what the model shows). */
#include <stdio.h>
#include <stdlib.h>

#define NP N(P)
#define NPAR N(PARAMETERS)
#define NU N(INPUTS)
#define NY N(OUTPUTS)
#define MOST_EVENTS 50 /* within a step of the scheme */
#define MOST_BOUNCES 20000
#define VR_P 1u
#define VR_Y (VR_P + NP)
#define VR_G (VR_Y + NY)
#define VR_END (VR_G + NG)

#define NEVER 1e300

enum { OK, WARNING, DISCARD, ERROR };                             /* as in both versions */
enum { INSTANTIATED, INITIALISING, EVENT, CONTINUOUS, STEPPING, ENDED }; /* modes */

/* all that lasts; two instances with equal states go on alike */
typedef struct {
  int mode, fresh, stale, changed, moved, seen, ended; /* at the start?; is it, are c, inputs, y to be made?; over? */
  double t, h, started;                                /* time, step [s], time of the start */
  double p[NP + 1], slope[NU + 1], starts[N(STARTS) + 1], c[N(C)], z[N(Z)], y[NY], x[NX + 1];
  int happened[NE + 1], count;              /* of model exchange: events that nobody has answered; lately, how many */
  double g[NG + 1], quiet[NE + 1], counted; /* indicators as they were last; asleep until; since when counted [s] */
  int due;                                  /* is the next jump in time to be looked for? */
  double jump[3], shown;                    /* the next one, clocks on its two sides; the clock behind the last one */
} State;

typedef struct {
  State s, before;
  int exchange, early; /* model exchange? else co-simulation: may a step end early? */
  char name[64];
  void *environment;
  void *logger;
  double w[WORK];
} Instance;

static int say(Instance *I, int status, const char *message);

static int said(Instance *I, int status, const char *what, double value) {
  char text[200];
  (void)snprintf(text, sizeof text, "%s (%.17g)", what, value);
  return say(I, status, text);
}

static void defaults(Instance *I) {
  State *s = &I->s;
  int k;
  memset(s, 0, sizeof *s);
  M(defaults)(s->p);
  for (k = 0; k < N(STARTS); ++k) s->starts[k] = M(starts)[k].start;
  for (k = 0; k < NE; ++k) s->quiet[k] = -NEVER;
  s->mode = INSTANTIATED, s->h = N(DT), s->fresh = s->stale = s->changed = s->due = 1;
  s->jump[0] = s->jump[1] = s->jump[2] = NEVER, s->shown = -NEVER;
}

/* the constants for what p and h are now */
static void prepare(Instance *I) {
  if (I->s.changed) M(constants)(I->s.c, I->s.p, I->s.h, I->w);
  I->s.changed = 0;
}

/* the state of the start, once what it follows from is known */
static void begin(Instance *I) {
  State *s = &I->s;
  int k;
  prepare(I);
  if (!s->stale) return;
  M(start)(s->z, s->c, s->started, s->starts, I->w);
  M(held)(s->p + NPAR, s->z); /* with what sticks at the start */
  M(observe)(s->y, s->z, s->c, I->w);
  for (k = 0; k < NX; ++k) s->x[k] = s->y[state_of[k]];
  s->t = s->started, s->stale = s->moved = 0, s->seen = 1;
}

/* the time that loads see: up to a jump in time that before it, from there on that behind it */
static double clock_of(const State *s) { return s->t < s->shown ? s->shown : s->t > s->jump[1] ? s->jump[1] : s->t; }

static void look(Instance *I) {
  State *s = &I->s;
  if (s->stale) begin(I);
  prepare(I);
  if (s->seen) return;
  s->seen = 1;
#if NX > 0
  if (I->exchange) {
    const double t = clock_of(s);
    memcpy(s->c + INPUTS_IN_C, s->p + NPAR, NU * sizeof(double));
    M(ode)(s->y, s->x, &t, s->c, I->w);
    return;
  }
#endif
  M(observe)(s->y, s->z, s->c, I->w);
}

/* what passes zero where events happen, behind it where loads kink */
static void indicate(Instance *I, double *g) {
  if (I->s.stale) begin(I);
  prepare(I);
#if NG > 0
  memcpy(I->s.c + INPUTS_IN_C, I->s.p + NPAR, NU * sizeof(double));
  if (I->exchange) {
    const double t = clock_of(&I->s);
    M(indicators)(g, I->s.x, &t, I->s.c, I->w);
  } else {
    memset(g, 0, NG * sizeof(double));
  }
#else
  (void)g;
#endif
}

static int get(Instance *I, const unsigned int *vr, size_t n, double *value) {
  double g[NG + 1];
  size_t k;
  if (n > 0 && (vr == NULL || value == NULL)) return say(I, ERROR, "no place to read from or to write to");
  for (k = 0; k < n; ++k) {
    if (vr[k] >= VR_END) return said(I, ERROR, "there is no variable with this value reference", (double)vr[k]);
    if (vr[k] >= VR_Y) look(I);
    if (vr[k] >= VR_G) {
      indicate(I, g);
      value[k] = g[vr[k] - VR_G];
      continue;
    }
    value[k] = vr[k] == 0 ? (I->s.stale ? I->s.started : I->s.t) : vr[k] < VR_Y ? I->s.p[vr[k] - VR_P] : I->s.y[vr[k] - VR_Y];
  }
  return OK;
}

static int set_start(Instance *I, unsigned int at, double value) {
  int k;
  for (k = 0; k < N(STARTS); ++k) {
    if (start_of[k] == (int)at) {
      I->s.starts[k] = value, I->s.stale = 1, I->s.seen = 0;
      return OK;
    }
  }
  return said(I, ERROR, "this variable follows from others and cannot be set", (double)(at + VR_Y));
}

static int set(Instance *I, const unsigned int *vr, size_t n, const double *value) {
  State *s = &I->s;
  const int before = s->mode == INSTANTIATED || s->mode == INITIALISING;
  size_t k;
  if (n > 0 && (vr == NULL || value == NULL)) return say(I, ERROR, "no place to read from or to write to");
  for (k = 0; k < n; ++k) {
    const unsigned int at = vr[k] - VR_P;
    if (vr[k] == 0 || vr[k] >= VR_G) return said(I, ERROR, "nothing with this value reference can be set", (double)vr[k]);
    if (!(value[k] - value[k] == 0.0)) return said(I, ERROR, "a value must be finite", value[k]);
    if (vr[k] >= VR_Y) {
      if (!before) return say(I, ERROR, "start values are set before the initialisation is left");
      if (set_start(I, vr[k] - VR_Y, value[k]) != OK) return ERROR;
      continue;
    }
    if ((bound_of[at] == 2 && value[k] <= 0) || (bound_of[at] == 1 && value[k] < 0)) {
      return said(I, ERROR, "a parameter has a value of the wrong sign", value[k]);
    }
    if (s->p[at] == value[k]) continue;
    s->p[at] = value[k], s->seen = 0;
    if ((int)at >= NPAR) {
      s->moved = 1, s->due = s->due || JUMPS_BY_INPUTS;
      if (SINCE >= 0) s->p[NPAR + SINCE] = s->t;
    } else {
      s->changed = s->moved = s->due = 1;
    }
    if (before) s->changed = s->stale = 1;
  }
  return OK;
}

/* directions: dy along the seeds of states and inputs */
static int derivatives(Instance *I, const unsigned int *unknown, size_t n, const unsigned int *known, size_t m,
                       const double *seed, double *found) {
  const State *s = &I->s;
  double dx[NX + 1] = {0}, du[NU + 1] = {0}, dy[NY], x[NX + 1];
  size_t k;
  int j, hit;
  if (unknown == NULL || known == NULL || seed == NULL || found == NULL) return say(I, ERROR, "no place to read from or to write to");
  look(I);
  for (k = 0; k < m; ++k) {
    for (hit = j = 0; j < NX; ++j) {
      if (known[k] == VR_Y + (unsigned int)state_of[j]) dx[j] += seed[k], hit = 1;
    }
    if (known[k] >= VR_P + NPAR && known[k] < VR_Y) du[known[k] - VR_P - NPAR] += seed[k], hit = 1;
    if (!hit) return said(I, ERROR, "derivatives are by states and inputs only, not by this value reference", (double)known[k]);
  }
#if NX > 0
  for (j = 0; j < NX; ++j) x[j] = s->y[state_of[j]];
  memcpy(I->s.c + INPUTS_IN_C, s->p + NPAR, NU * sizeof(double));
  M(ode_along)(dy, x, &s->t, s->c, dx, du, I->w);
  for (k = 0; k < n; ++k) {
    if (unknown[k] < VR_Y || unknown[k] >= VR_G) return said(I, ERROR, "this variable has no derivatives", (double)unknown[k]);
    found[k] = dy[unknown[k] - VR_Y];
  }
  return OK;
#else
  (void)s, (void)dy, (void)x, (void)n, (void)unknown, (void)dx, (void)du;
  return say(I, ERROR, "this unit has no derivatives");
#endif
}

/* ---- co-simulation ---- */

/* from here on steps of h */
static void take_step(Instance *I, double h) {
  State *s = &I->s;
  if (h == s->h && !s->changed) return;
  if (h != s->h && !s->fresh) M(restart)(s->z, s->c, s->h, h, I->w);
  s->h = h, s->changed = 1;
  prepare(I);
  if (s->fresh) M(start)(s->z, s->c, s->started, s->starts, I->w);
}

/* how a step ends that nothing stops, or that an event does; others leave the state as it was */
static int stepped(Instance *I, int why, double end) {
  State *s = &I->s;
  s->fresh = s->seen = 0;
  M(held)(s->p + NPAR, s->z);
  s->t = why == 0 ? end : M(time)(s->z, s->c);
  if (why != 0 && why != N(BY_EVENT)) {
    *s = I->before;
    return said(I, DISCARD, why == N(CHATTERING)   ? "an event undoes itself for ever in this step"
                            : why == N(NO_MODE)    ? "no choice of what sticks and what slides is consistent in this step"
                            : why == N(NOT_FINITE) ? "an event sets what is not finite in this step"
                                                   : "there are too many jumps in this step: take a shorter one of the scheme", end);
  }
  if (!M(finite)(s->z)) {
    *s = I->before;
    return said(I, DISCARD, "the motion is lost in this step: take shorter ones", end);
  }
  s->ended = why;
  return OK;
}

static int do_step(Instance *I, double t, double H) {
  State *s = &I->s;
  double n, h, u[NU + 1];
  int sloping = 0, k, why = 0;
  long step;
  if (s->mode != STEPPING) return say(I, ERROR, "a step is made behind the initialisation, in co-simulation");
  if (!(H > 0.0) || H - H != 0.0) return said(I, ERROR, "the length of a step must be positive and finite", H);
  if (s->ended) return said(I, ERROR, "an event has ended the motion", s->t);
  if (!(fabs(t - s->t) <= 1e-6 * H)) return said(I, ERROR, "the unit is at another time than the step begins at", s->t);
  n = ceil(H / N(DT) - 1e-6);
  n = n < 1.0 ? 1.0 : n;
  if (n > 1e9) return said(I, DISCARD, "the step is longer than a thousand million steps of the scheme", H);
  h = fabs(H / n - N(DT)) <= 1e-9 * N(DT) ? N(DT) : fabs(H / n - s->h) <= 1e-9 * s->h ? s->h : H / n;
  I->before = *s;
  take_step(I, h);
  for (k = 0; k < NU; ++k) sloping = sloping || s->slope[k] != 0.0;
  if (sloping) { /* each step with the values at its middle */
    for (step = 0; step < (long)n && why == 0; ++step) {
      for (k = 0; k < NU; ++k) u[k] = s->p[NPAR + k] + s->slope[k] * ((double)step + 0.5) * h;
      M(hold)(s->z, s->c, u, I->w);
      why = M(step)(s->z, s->c, I->w, 1);
    }
    memcpy(u, s->p + NPAR, NU * sizeof(double));
    if (stepped(I, why, t + H) != OK) return DISCARD;
    memcpy(s->p + NPAR, u, NU * sizeof(double)), s->moved = 1; /* what the master gave is where slopes begin */
    return OK;
  }
  if (s->moved) M(hold)(s->z, s->c, s->p + NPAR, I->w);
  s->moved = 0;
  return stepped(I, M(step)(s->z, s->c, I->w, (long)n), t + H);
}

/* ---- model exchange ---- */

static int set_states(Instance *I, const double *x, size_t n) {
  size_t k;
  if (x == NULL || n != NX || !I->exchange) return said(I, ERROR, "another number of states", (double)n);
  for (k = 0; k < n; ++k) {
    if (!(x[k] - x[k] == 0.0)) return said(I, DISCARD, "a state must be finite", x[k]);
  }
  memcpy(I->s.x, x, NX * sizeof(double));
  I->s.seen = 0;
  return OK;
}

static int get_states(Instance *I, double *x, size_t n, int what) { /* 0: states, 1: derivatives, 2: nominal values */
  size_t k;
  if (x == NULL || n != NX) return said(I, ERROR, "another number of states", (double)n);
  if (what != 2) look(I);
  for (k = 0; k < n; ++k) {
    x[k] = what == 0 ? I->s.x[k] : what == 1 ? I->s.y[derivative_of[k]] : nominal_of[k];
    if (!(x[k] - x[k] == 0.0)) return said(I, DISCARD, "a derivative is not finite", x[k]);
  }
  return OK;
}

static int get_indicators(Instance *I, double *g, size_t n) {
  size_t k;
  if (n != NG || (n > 0 && g == NULL)) return said(I, ERROR, "another number of event indicators", (double)n);
  indicate(I, g);
  for (k = 0; k < n; ++k) {
    if (!(g[k] - g[k] == 0.0)) return said(I, DISCARD, "an event indicator is not finite", g[k]);
  }
  return OK;
}

/* which events have happened since the last look, what sticks or is closed asks for another mode; is there one? */
static int look_for_events(Instance *I) {
  int any = NJ > 0 && I->s.due;
#if NE > 0
  State *s = &I->s;
  double g[NG];
  int k;
  if (!I->exchange) return 0;
  indicate(I, g);
  for (k = 0; k < NE; ++k) {
    const int way = events_of[k].way, rises = s->g[k] < 0 && g[k] >= 0, falls = s->g[k] > 0 && g[k] <= 0;
    if (s->quiet[k] <= s->t && ((way >= 0 && rises) || (way <= 0 && falls))) s->happened[k] = 1;
    any = any || s->happened[k];
  }
  memcpy(s->g, g, sizeof g);
#endif
  return any;
}

/* jumps in time that the unit has come to are over; the next one */
static int pass_jumps(Instance *I) {
#if NJ > 0
  State *s = &I->s;
  const double near = 1e-9 * (fabs(s->t) + N(DT)); /* masters take times so close together for one */
  if (!s->due && s->t < s->jump[0] - near) return OK;
  if (!s->due) s->shown = s->jump[2];
  s->due = s->seen = 0;
  prepare(I);
  memcpy(s->c + INPUTS_IN_C, s->p + NPAR, NU * sizeof(double));
  for (;;) {
    const double from = s->shown > s->t - near ? s->shown : s->t - near;
    if (!M(next_jump)(s->jump, s->c, from, s->t + 1e5 * N(DT), I->w)) return said(I, ERROR, "there are too many jumps in a step", s->t);
    if (s->jump[0] > s->t + near) return OK;
    s->shown = s->jump[2];
  }
#else
  (void)I;
  return OK;
#endif
}

#if NM > 0
/* which elements stick, which stops are closed, at the states and inputs as they are; rates may change */
static int decide_modes(Instance *I, int *moved) {
  State *s = &I->s;
  double at[NAT];
  const double t = clock_of(s);
  int k, any = 0, asks[NM];
  for (k = 0; k < NM; ++k) asks[k] = s->g[NE - NM + k] <= 0, any = any || asks[k];
  if (!any) return OK;
  M(place)(at, s->x, &t, s->c, I->w);
  if (!M(settle)(at, s->p + NPAR, s->c, asks, I->w)) return said(I, ERROR, "no choice of what sticks and what slides is consistent", s->t);
  for (k = 0; k < NI; ++k) {
    *moved = *moved || s->x[NI + k] != at[V_AT + k];
    s->x[NI + k] = at[V_AT + k];
  }
  s->seen = 0;
  return OK;
}
#endif

/* what events do, at the time and the states that the unit is at; moved: do they change states? */
static int answer_events(Instance *I, int *terminate, int *moved) {
  *moved = 0, *terminate = I->s.ended;
  if (!I->exchange) return OK;
  if (pass_jumps(I) != OK) return ERROR;
#if NE > 0
  State *s = &I->s;
  double values[NSETS + 1] = {0};
  int k, j;
  (void)look_for_events(I);
#if NSETS > 0
  {
    const double t = clock_of(s);
    M(acts)(values, s->x, &t, s->c, I->w);
  }
#endif
  if (s->t > s->counted + N(DT)) s->counted = s->t, s->count = 0;
  for (k = 0; k < NE; ++k) {
    if (!s->happened[k]) continue;
    s->happened[k] = 0, s->quiet[k] = s->t + events_of[k].cool_down;
    for (j = events_of[k].from; j < events_of[k].to; ++j) {
      if (!(values[j] - values[j] == 0.0)) return said(I, ERROR, "an event sets what is not finite", s->t);
      s->p[NPAR + sets_of[j]] = values[j], s->seen = 0, s->due = s->due || JUMPS_BY_INPUTS;
    }
    if (events_of[k].terminal) *terminate = s->ended = 1;
    if (++s->count > (NM > 0 ? MOST_BOUNCES : MOST_EVENTS)) return said(I, ERROR, "an event undoes itself for ever", s->t);
  }
  if (pass_jumps(I) != OK) return ERROR;
  indicate(I, s->g); /* what moves by that does not happen */
#if NM > 0
  if (decide_modes(I, moved) != OK) return ERROR;
  indicate(I, s->g);
#endif
#endif
  return OK;
}

static int set_time(Instance *I, double t) {
  if (!(t - t == 0.0)) return said(I, ERROR, "time must be finite", t);
  if (I->s.t != t) I->s.seen = 0;
  I->s.t = t;
  return OK;
}

/* ---- modes ---- */

static int initialise(Instance *I, double t) {
  if (I->s.mode != INSTANTIATED) return say(I, ERROR, "an instance is initialised once");
  if (!(t - t == 0.0)) return said(I, ERROR, "the start time must be finite", t);
  I->s.started = I->s.t = t, I->s.stale = 1, I->s.mode = INITIALISING;
  return OK;
}

static int leave_initialisation(Instance *I) {
  if (I->s.mode != INITIALISING) return say(I, ERROR, "the initialisation was not entered");
  begin(I);
  if (!M(finite)(I->s.z)) return say(I, ERROR, "the start values make no start: are the loops closed?");
  if (M(step)(I->s.z, I->s.c, I->w, 0) == N(BEYOND_A_STOP)) return say(I, ERROR, "the motion starts beyond a stop");
  I->s.mode = I->exchange ? EVENT : STEPPING;
  indicate(I, I->s.g);
  return OK;
}

static int go_to(Instance *I, int from, int mode) {
  if (!I->exchange || (I->s.mode != from && I->s.mode != mode)) return say(I, ERROR, "this mode cannot be entered from here");
  I->s.mode = mode;
  if (mode == CONTINUOUS) indicate(I, I->s.g); /* inputs may have moved it */
  return OK;
}

/* ---- states kept ---- */

static int keep(Instance *I, void **state) {
  if (state == NULL) return say(I, ERROR, "no place for the state");
  if (*state == NULL) *state = malloc(sizeof(State));
  if (*state == NULL) return say(I, ERROR, "no memory");
  memcpy(*state, &I->s, sizeof(State));
  return OK;
}

static int go_back(Instance *I, const void *state) {
  if (state == NULL) return say(I, ERROR, "there is no such state");
  memcpy(&I->s, state, sizeof(State));
  return OK;
}

static int let_go(void **state) {
  if (state != NULL) {
    free(*state);
    *state = NULL;
  }
  return OK;
}

static int as_bytes(Instance *I, const void *state, void *bytes, size_t size) {
  if (state == NULL || bytes == NULL || size < sizeof(State)) return said(I, ERROR, "the state needs more room than bytes", (double)size);
  memcpy(bytes, state, sizeof(State));
  return OK;
}

static int from_bytes(Instance *I, const void *bytes, size_t size, void **state) {
  if (bytes == NULL || state == NULL || size != sizeof(State)) return said(I, ERROR, "these bytes are no state of this unit", (double)size);
  if (*state == NULL) *state = malloc(sizeof(State));
  if (*state == NULL) return say(I, ERROR, "no memory");
  memcpy(*state, bytes, sizeof(State));
  return OK;
}

static Instance *made(const char *name, const char *token, int exchange, void *environment, void *logger) {
  Instance *I = calloc(1, sizeof *I);
  if (I == NULL) return NULL;
  I->exchange = exchange, I->environment = environment, I->logger = logger;
  if (name != NULL) strncpy(I->name, name, sizeof I->name - 1);
  defaults(I);
  if (token == NULL || strcmp(token, TOKEN) != 0) {
    (void)say(I, ERROR, "the token is not that of this unit: description and binary do not fit");
    free(I);
    return NULL;
  }
  return I;
}
