/* What event search, friction, stops and breakpoints have to know of a model: sizes, places of numbers in z and S, tables
   and functions. */
#ifndef DOOR /* static where it stands in one file with a model */
#define DOOR
#endif
#ifndef MODEL_H
#define MODEL_H

#if defined(__GNUC__)
#define MAY __attribute__((unused))
#else
#define MAY
#endif

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { BY_EVENT = 1, CHATTERING, NO_MODE, NOT_FINITE, TOO_MANY, BEYOND_A_STOP };

typedef struct {
  int way, terminal, from, to; /* from, to: which of sets_of are its own */
  double cool_down;
} Event;

typedef struct {
  double start, length, before, after; /* from a clock on, so long; clocks on both sides of what jumps at its end, or NEVER */
} Part;

/* steps that are not just from one time of the grid to the next, in order: are they broken?, their parts one after
   another, from first[k] on, and behind each step the clock and t0 */
typedef struct {
  int64_t n;
  const int64_t *step, *broken, *first;
  const Part *part;
  const double *clock, *origin;
} Grid;

/* what has happened: records of events, see `record`, and room for more. lost: there was none. unresolved: error of a rate
   behind a load that acts for less than two steps; opened: clock, which kinks (NE) and S (NS) behind the last event */
typedef struct {
  double *records;
  int64_t n, room, lost;
  double unresolved, *opened;
} Log;

typedef struct { /* an interval */
  double low, high;
} I;

typedef struct {
  int64_t NZ, NOWN, NS, NREADY, NC, DT_AT, NU, NE, ND, NT, NSETS, NPUSH, KEPT, SUB_STEPS, KEPT_IN_W, INPUTS_AT, VALUES_AT,
      STEP_AT, CHANGE_AT, SLOPES_AT, NSIDES, SIDE, BEFORE, QUIET_AT, NUMBER, SEEN, START, LENGTH, SHARE, EVENT_BEFORE, READY,
      INPUTS, PUSH, CLOCK, ORIGIN, NM, NV, NSTOPS, NI, NQD, NAT, NSEEN, NTHERE, NREALS, NWHOLES;
  const Event *events_of;
  const int *sets_of, *modes_at, *row_of, *side_of;
  void (*steps)(double *z, const double *c, double *w, int64_t n);
  void (*set_out)(double *S, const double *c, double *w);
  void (*to_grid)(double *S, const double *c, double *w);
  void (*again)(double *T, const double *c, double *w);
  void (*events)(double *y, const double *z, const double *c, double *w);
  void (*slopes)(double *y, const double *z, const double *c, double *w);
  void (*actions)(double *y, const double *z, const double *c, double *w);
  void (*sides)(double *y, const double *z, const double *c, double *w);
  void (*seen)(double *at, const double *z, const double *c, double *w);
  void (*weights)(double *y, const double *at, const double *c, double *w);
  void (*with_modes)(double *y, const double *at, const double *c, double *w);
  void (*velocities)(double *rates, const double *at, const double *c, double *w);
  void (*conditions)(double *g, const double *t, const double *c, double *w);
  void (*bounds)(I *found, int *jumps, double low, double high, const double *c);
} Model;

/* free memory of the caller's; a function has a copy of it, so what it takes is free again behind it */
typedef struct {
  double *reals;
  int *wholes;
} Room;
#define REALS(n) (room.reals += (n), room.reals - (n))
#define WHOLES(n) (room.wholes += (n), room.wholes - (n))

#endif
