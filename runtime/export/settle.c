/* What is held and what moves where that is open, as in runtime/schemes/switching: settle.py, stops.py,
   complementarity.py, consistency.py. Matrices stand by columns; sums begin with the first entry, as there. */

#define AT_REST 1e-9
#define BROKEN 1e-6
#define NOTHING (-1e-12)
#define PASSES 1e-6
#define PIVOT 1e-9
#define ROUNDING 1e-12
#define SINGULAR 1e-11
#define TOUCH 1e-9
#define TOO_CLOSE 1e-4
#define MOST_HITS 50
#define EACH(k, n) for ((k) = 0; (k) < (n); ++(k))
/* entries of y, what `weights` says: of v = G q_i' and v' = b + A f */
#define V_REL (NV * NI)
#define HOLDS (V_REL + NV)
#define GAP (HOLDS + NV)
#define BACK (GAP + NSTOPS)
#define BY (BACK + NSTOPS)
#define A_OF (BY + NI * NV)
#define B_OF (A_OF + NV * NV)
#define SLIDES (B_OF + NV) /* where some friction falls as it lets go */

static double larger(double a, double b) { return a > b ? a : b; }

static double largest_of(const double *x, long n) {
  double found = 0;
  while (n-- > 0) found = larger(fabs(x[n]), found);
  return found;
}

/* row k of A x; one row stands so far from the next column */
static double row_times(const double *A, int k, int apart, const double *x, int n) {
  double sum = 0;
  int j;
  EACH(j, n) sum += A[k + apart * j] * x[j];
  return sum;
}

/* A x = b, by elimination; A is lost, b becomes x */
static void solve(double *A, double *b, int n) {
  int k, i, j;
  EACH(k, n) {
    int p = k;
    for (i = k + 1; i < n; ++i) p = fabs(A[i + n * k]) > fabs(A[p + n * k]) ? i : p;
    for (j = 0; j <= n; ++j) {
      double *column = j < n ? A + n * j : b;
      const double one = column[k];
      column[k] = column[p], column[p] = one;
    }
    for (i = k + 1; i < n; ++i) {
      const double factor = A[i + n * k] / A[k + n * k];
      for (j = k; j < n; ++j) A[i + n * j] -= factor * A[k + n * j];
      b[i] -= factor * b[k];
    }
  }
  for (k = n - 1; k >= 0; --k) {
    for (i = k + 1; i < n; ++i) b[k] -= A[k + n * i] * b[i];
    b[k] /= A[k + n * k];
  }
}

/* side becomes x of least norm with A x = side, A symmetric: a combination of columns of A that are independent */
static void least(double *A, double *side, int n) {
  double left[NM * NM], gram[NM * NM], z[NM], largest = 0;
  int chosen[NM] = {0}, taken[NM] = {0}, m = 0, k, i, j;
  memcpy(left, A, n * n * sizeof(double));
  EACH(k, n) largest = larger(A[k + n * k], largest);
  for (;;) {
    int p = -1;
    EACH(k, n) if (!taken[k] && (p < 0 || left[k + n * k] > left[p + n * p])) p = k;
    if (p < 0 || left[p + n * p] <= SINGULAR * largest) break;
    EACH(i, n) EACH(j, n) if (i != p && j != p) left[i + n * j] -= left[i + n * p] * left[p + n * j] / left[p + n * p];
    taken[p] = 1, chosen[m++] = p;
  }
  if (m == n) {
    solve(A, side, n);
    return;
  }
  EACH(i, m) {
    z[i] = side[chosen[i]];
    EACH(j, m) {
      gram[i + m * j] = 0;
      EACH(k, n) gram[i + m * j] += A[k + n * chosen[i]] * A[k + n * chosen[j]];
    }
  }
  solve(gram, z, m);
  EACH(k, n) {
    side[k] = 0;
    EACH(i, m) side[k] += A[k + n * chosen[i]] * z[i];
  }
}

/* forces on n directions, between bounds: v' = b + A f; at: -1, 1 at the lower, the upper one, 0 held between them */
typedef struct {
  int n, at[NM], let_go[NM];
  double A[NM * NM], b[NM], lower[NM], upper[NM], f[NM];
} Bounded;

static double accelerates(const Bounded *o, int k, const double *f) { return o->b[k] + row_times(o->A, k, o->n, f, o->n); }

/* those at a bound have its force, the others what keeps them from accelerating, with the least sum of (f / bound)^2 */
static void balance(Bounded *o) {
  double own[NM * NM], side[NM], H[NM] = {0}, largest = 0;
  int held[NM], m = 0, k, j;
  EACH(k, o->n) {
    o->f[k] = o->at[k] > 0 ? o->upper[k] : o->at[k] < 0 ? o->lower[k] : 0.0;
    if (o->at[k] != 0) continue;
    H[m] = o->upper[k] < INFINITY ? o->upper[k] : o->lower[k] > -INFINITY ? -o->lower[k] : 0.0;
    largest = larger(H[m], largest), held[m++] = k;
  }
  EACH(k, m) H[k] = H[k] > 0 ? H[k] : largest > 0 ? largest : 1;
  EACH(k, m) {
    side[k] = -H[k] * accelerates(o, held[k], o->f);
    EACH(j, m) own[k + m * j] = H[k] * o->A[held[k] + o->n * held[j]] * H[j];
  }
  least(own, side, m);
  EACH(k, m) o->f[held[k]] = H[k] * side[k];
}

static int nearest(const Bounded *o, int k) { return o->upper[k] - o->f[k] <= o->f[k] - o->lower[k] ? 1 : -1; }

/* which are held and which are at a bound; 0: no choice is consistent */
static int complementary(Bounded *o) {
  const double most = largest_of(o->b, o->n);
  double largest = 0, still;
  int k, turn;
  EACH(k, o->n) {
    if (o->upper[k] < INFINITY) largest = larger(fabs(o->upper[k]), largest);
    if (o->lower[k] > -INFINITY) largest = larger(fabs(o->lower[k]), largest);
    o->at[k] = 0;
  }
  still = ROUNDING * (most + largest_of(o->A, (long)o->n * o->n) * largest);
  balance(o);
  EACH(k, o->n) o->at[k] = o->upper[k] <= o->lower[k] ? 1 : o->let_go[k] ? nearest(o, k) : 0;
  for (turn = 0; turn < 2 * o->n + 20; ++turn) {
    int beyond = -1, wrong = -1, pulled[NM] = {0};
    double worst = 0, against = 0;
    balance(o);
    EACH(k, o->n) {
      const double pivot = o->A[k + o->n * k], open = !(o->upper[k] < INFINITY && o->lower[k] > -INFINITY);
      /* what presses on a stop by rounding only does not hold it closed */
      const double dust = ROUNDING * largest + (open ? ROUNDING * most / larger(pivot, 1e-300) + 1e-300 : 0.0);
      const double over = (larger(o->f[k] - o->upper[k], o->lower[k] - o->f[k]) + dust) * pivot;
      const double moves = accelerates(o, k, o->f), a = o->at[k] * moves - (o->let_go[k] ? 1e6 * still : still);
      if (o->at[k] == 0 && over > worst) worst = over, beyond = k;
      if (o->upper[k] <= o->lower[k]) pulled[k] = moves > 0 ? -1 : 1; /* holds nothing, and goes where it is pulled */
      else if (o->at[k] != 0 && a > against) against = a, wrong = k;
    }
    if (beyond < 0 && wrong < 0) {
      EACH(k, o->n) if (pulled[k] != 0) o->at[k] = pulled[k];
      return 1;
    }
    if (beyond >= 0) o->at[beyond] = nearest(o, beyond);
    else o->at[wrong] = 0;
  }
  return o->n == 0;
}

/* v (NI) so that these rates become zero; where a coordinate can do it alone, to the last bit */
static void bring_to_rest(double *v, const double *y, const int *rest, double *left) {
  const double *G = y, most_of_v = 1.0 + largest_of(v, NI);
  double side[NV], most[NV], push[NI] = {0};
  int rows[NV], column[NV], k, j, i, n = 0;
  EACH(k, NV) {
    most[k] = 0;
    EACH(j, NI) most[k] = larger(fabs(G[k + NV * j]), most[k]);
    if (!rest[k] || fabs(y[V_REL + k]) > PASSES * most[k] * most_of_v) continue; /* G is zero: it passes on */
    EACH(j, NI) left[n * NI + j] = G[k + NV * j];
    side[n] = y[V_REL + k], rows[n++] = k;
  }
  EACH(k, n) {
    column[k] = -1;
    EACH(j, NI) if (fabs(left[k * NI + j]) > PIVOT * most[rows[k]]) column[k] = j;
    for (i = 0; i < n && column[k] >= 0; ++i) {
      if (i != k && left[i * NI + column[k]] != 0) {
        const double factor = left[i * NI + column[k]] / left[k * NI + column[k]];
        EACH(j, NI) left[i * NI + j] -= factor * left[k * NI + j];
        side[i] -= factor * side[k];
      }
    }
  }
  EACH(k, n) if (column[k] >= 0) push[column[k]] = -side[k] / left[k * NI + column[k]];
  EACH(j, NI) v[j] = v[j] + push[j];
}

/* what is added to q_i' by impacts on stops, which ones are hit; 0: no impulses are consistent */
static int struck(double *push, int *hit, const double *y, const int *on, const double *e, double slow) {
  double speed[NM];
  int count, k, j;
  EACH(k, NM) speed[k] = side_of[k] * y[V_REL + row_of[k]];
  EACH(count, MOST_HITS + 1) {
    const int last = count == MOST_HITS;
    int some[NM], any = 0;
    Bounded o;
    o.n = 0;
    EACH(k, NM) {
      const int comes = on[k] && speed[k] < -slow;
      if (!on[k] || !(last || speed[k] <= slow)) continue;
      any = any || comes, hit[k] = hit[k] || comes, some[o.n] = k;
      o.b[o.n] = (1 + (comes && !last ? e[k] : 0.0)) * speed[k];
      o.lower[o.n] = 0.0, o.upper[o.n] = INFINITY, o.let_go[o.n++] = 0;
    }
    if (!any) return 1;
    EACH(k, o.n) EACH(j, o.n) {
      o.A[k + o.n * j] = side_of[some[k]] * y[A_OF + row_of[some[k]] + NV * row_of[some[j]]] * side_of[some[j]];
    }
    if (!complementary(&o)) return 0;
    balance(&o);
    EACH(k, o.n) o.f[k] = larger(o.f[k], 0.0);
    EACH(k, NM) {
      double sum = 0;
      EACH(j, o.n) sum += side_of[k] * y[A_OF + row_of[k] + NV * row_of[some[j]]] * side_of[some[j]] * o.f[j];
      speed[k] = speed[k] + sum;
    }
    EACH(k, NI) {
      double sum = 0;
      EACH(j, o.n) sum += y[BY + k + NI * row_of[some[j]]] * side_of[some[j]] * o.f[j];
      push[k] = push[k] + sum;
    }
  }
  return 1;
}

/* a state (q_i, q_d, q_i', q_d', t), its constants, what `weights` says of it, room for rows */
typedef struct {
  double *at, *c, *y, *left, *w;
} Place;

static void weigh(const Place *o) { M(weights)(o->y, o->at, o->c, o->w); }

static void moved(const Place *o) { /* rates of q_d by those of q_i */
#if NQD > 0
  double rates[NQD];
  M(velocities)(rates, o->at, o->c, o->w);
  memcpy(o->at + 2 * NI + NQD, rates, sizeof rates);
#else
  (void)o;
#endif
}

/* do modes (NM) keep the laws of friction and stops, by the equations that go on with them? rest, force (NV): rows at
   rest, and what was found there */
static int lawful(const Place *o, const double *modes, const int *rest, const double *force) {
  const double *y = o->y, *A = y + A_OF;
  double found[NM + 2 * NV], *v = found + NM, *a = v + NV, most = 0;
  const double slow = BROKEN * (1.0 + largest_of(o->at + NI + NQD, NI));
  int k, j;
  EACH(k, NM) o->c[DT_AT - NU + modes_at[k]] = modes[k];
  M(with_modes)(found, o->at, o->c, o->w);
  EACH(k, NV) {
    double acts = fabs(y[B_OF + k]);
    EACH(j, NV) acts += fabs(A[k + NV * j]) * fabs(force[j]);
    most = larger(BROKEN * acts / sqrt(larger(A[k + NV * k], 1e-300)), most);
  }
  EACH(k, NM) {
    const int row = row_of[k], side = side_of[k];
    const double root = sqrt(larger(A[row + NV * row], 1e-300));
    if (!rest[row]) continue;
    if (modes[k] == 0) {
      if (fabs(v[row]) > slow || found[k] < -(most / root + BROKEN * fabs(y[HOLDS + row]))) return 0;
    } else if ((side == 0 || modes[k] < 0) && (side != 0 ? side : modes[k]) * a[row] < -most * root) {
      return 0;
    }
  }
  return 1;
}

/* modes (NM) at a place, whose rates are moved; soon: stops that are to rest. -1: none are consistent, 1: once more */
static int once(const Place *o, double *modes, const int *happened, const double *come, int *soon) {
  double *v = o->at + NI + NQD, *y = o->y, push[NI] = {0}, rate[NV], e[NM], until[NM], force[NV] = {0};
  const double slow = AT_REST * (1.0 + largest_of(v, NI));
  int on[NM], touched[NM], hit[NM] = {0}, rest[NV] = {0}, open[NV] = {0}, k, j, s = 0, any = 0, again = 0, drops;
  Bounded b;
  memcpy(until, modes, sizeof until);
  weigh(o);
  EACH(k, NV) if (!(y[HOLDS + k] >= NOTHING)) return -1; /* a limit of friction is none any more */
  EACH(k, NM) {
    const int stop = side_of[k] != 0, near = until[k] == 0 || (happened != NULL && happened[k]);
    on[k] = stop && (near || y[GAP + s] <= 0), touched[k] = stop && (near || y[GAP + s] <= TOUCH);
    e[k] = stop && !soon[k] ? y[BACK + s] : 0.0, s += stop;
  }
  if (!struck(push, hit, y, on, e, slow)) return -1;
  EACH(k, NV) rate[k] = y[V_REL + k] + row_times(y, k, NV, push, NI);
  EACH(k, NM) {
    const double speed = fabs(rate[row_of[k]]);
    touched[k] = touched[k] && speed <= slow;
    if (touched[k] || (side_of[k] == 0 && speed <= larger(come[k], slow))) rest[row_of[k]] = any = 1;
    open[row_of[k]] = open[row_of[k]] || (happened != NULL && happened[k] && until[k] == 0);
  }
  EACH(k, NM) {
    const double moves = rate[row_of[k]];
    modes[k] = side_of[k] != 0 ? 1.0 : rest[row_of[k]] ? 0.0 : (double)((moves > 0) - (moves < 0));
    o->c[DT_AT - NU + modes_at[k]] = modes[k];
  }
  EACH(j, NI) v[j] = v[j] + push[j];
  moved(o);
  EACH(k, any ? 2 : 1) { /* the second time what the first one rounded */
    weigh(o);
    bring_to_rest(v, y, rest, o->left);
    moved(o);
  }
  weigh(o); /* with the laws of those that move */
  b.n = 0;
  EACH(k, NV) {
    if (!rest[k]) continue;
    b.b[b.n] = y[B_OF + k], b.lower[b.n] = -y[HOLDS + k], b.upper[b.n] = y[HOLDS + k], b.let_go[b.n] = open[k];
    EACH(j, NM) {
      if (row_of[j] == k && touched[j] && side_of[j] > 0) b.upper[b.n] = INFINITY;
      if (row_of[j] == k && touched[j] && side_of[j] < 0) b.lower[b.n] = -INFINITY;
    }
    rest[k] = ++b.n; /* its number among them, from 1 */
  }
  EACH(k, NV) EACH(j, NV) if (rest[k] && rest[j]) b.A[rest[k] - 1 + b.n * (rest[j] - 1)] = y[A_OF + k + NV * j];
  do {
    drops = 0;
    if (!complementary(&b)) return -1;
    EACH(k, NV) if (NSEEN > SLIDES && rest[k] && b.at[rest[k] - 1] != 0) {
      const double slides = y[SLIDES + k];
      j = rest[k] - 1;
      if (b.upper[j] < INFINITY && slides < b.upper[j]) b.upper[j] = slides, drops = 1;
      if (b.lower[j] > -INFINITY && -slides > b.lower[j]) b.lower[j] = -slides, drops = 1;
    }
  } while (drops); /* what lets go falls to that at once, which others may not hold */
  balance(&b);
  EACH(k, NV) if (rest[k]) force[k] = b.f[rest[k] - 1];
  EACH(k, NM) {
    const int number = rest[row_of[k]];
    if (side_of[k] == 0 && number) modes[k] = -(double)b.at[number - 1];
    if (touched[k]) modes[k] = number && b.at[number - 1] == 0 ? 0.0 : -1.0;
  }
  if (any && !lawful(o, modes, rest, force)) return -1;
  EACH(k, NM) { /* bounces that come too close are over at once */
    const double a = side_of[k] * (y[B_OF + row_of[k]] + row_times(y + A_OF, row_of[k], NV, force, NV));
    const double speed = side_of[k] * y[V_REL + row_of[k]];
    if (hit[k] && !soon[k] && 0 < 2 * speed && 2 * speed < -a * (1 - e[k]) * TOO_CLOSE) soon[k] = again = 1;
  }
  return again;
}

/* modes among the inputs u (NU) and rates at a state `at`; happened: elements that ask, or NULL; come: rates below which
   one has come to rest. 0: no modes are consistent, and nothing has changed */
static int decide(double *at, double *u, const double *c, const int *happened, const double *come, double *room, double *w) {
  double modes[NM];
  int soon[NM] = {0}, k, found;
  Place o;
  o.y = room, o.c = o.y + NSEEN, o.at = o.c + DT_AT, o.left = o.at + NAT, o.w = w;
  do {
    memcpy(o.at, at, NAT * sizeof(double)), memcpy(o.c, c, DT_AT * sizeof(double));
    memcpy(o.c + DT_AT - NU, u, NU * sizeof(double));
    EACH(k, NM) modes[k] = u[modes_at[k]];
    found = once(&o, modes, happened, come, soon);
  } while (found > 0);
  if (found < 0) return 0;
  memcpy(at, o.at, NAT * sizeof(double));
  EACH(k, NM) u[modes_at[k]] = modes[k];
  return 1;
}

/* modes into inputs and what is added to the rates, at a state S that constants show; happened: elements that ask */
static void settle(Run *r, double *inputs, double *push, const double *S, const double *shown, const int *happened) {
  double *at = r->room, *v = at + NI + NQD, slopes[ROW], start[NI], come[NM] = {0};
  int k;
  M(seen)(at, S, shown, r->w);
  memcpy(start, v, sizeof start);
  if (happened != NULL) {
    M(slopes)(slopes, S, shown, r->w);
    EACH(k, NM) if (happened[k] && inputs[modes_at[k]] != 0) come[k] = LOST * fabs(slopes[ND - NM + k]);
  }
  if (!decide(at, inputs, r->c, happened, come, at + NAT, r->w)) r->z[ENDED] = M(NO_MODE);
  EACH(k, NI) push[k] = v[k] - start[k];
}

/* at a start, and where inputs change */
static void settle_there(Run *r) {
  const double clock[2] = {r->z[0], r->z[1]};
  double *T = r->T, *inputs = T + NOWN + 3, *push = inputs + NU;
  int k, moves = 0;
  memcpy(T, r->z, NOWN * sizeof(double)), memcpy(inputs, r->z + INPUTS_AT, NU * sizeof(double));
  T[NOWN] = T[NOWN + 1] = r->dt, T[NOWN + 2] = clock[0] + clock[1] * r->dt;
  settle(r, inputs, push, r->z, r->c, NULL);
  EACH(k, NI) moves = moves || push[k] != 0;
  EACH(k, NU) moves = moves || inputs[k] != r->z[INPUTS_AT + k];
  if (!moves) return;
  M(again)(T, r->c, r->w);
  memcpy(r->z, T, NOWN * sizeof(double)), r->z[0] = clock[0], r->z[1] = clock[1];
  look_at_events(r);
}

#if NSTOPS > 0
/* is a start on the right side of its stops? */
static int within_stops(Run *r) {
  Place o;
  int k;
  o.at = r->room, o.y = o.at + NAT, o.c = o.y + NSEEN, o.w = r->w;
  M(seen)(o.at, r->z, r->c, o.w);
  memcpy(o.c, r->c, DT_AT * sizeof(double));
  weigh(&o);
  EACH(k, NSTOPS) if (!(o.y[GAP + k] >= -TOUCH)) return 0;
  return 1;
}
#endif

/* the same at a state of model exchange, whose master says roughly when something comes to rest */
int M(settle)(double *at, double *u, const double *c, const int *happened, double *w) {
  double come[NM];
  int k;
  EACH(k, NM) come[k] = happened[k] ? PASSES * (1.0 + largest_of(at + NI + NQD, NI)) : 0.0;
  return decide(at, u, c, happened, come, w, w + NSEEN + DT_AT + NAT + NI * NV);
}
