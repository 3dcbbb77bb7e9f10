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
#define V_REL (of->NV * of->NI)
#define HOLDS (V_REL + of->NV)
#define GAP (HOLDS + of->NV)
#define BACK (GAP + of->NSTOPS)
#define BY (BACK + of->NSTOPS)
#define A_OF (BY + of->NI * of->NV)
#define B_OF (A_OF + of->NV * of->NV)
#define SLIDES (B_OF + of->NV) /* where some friction falls as it lets go */

static double larger(double a, double b) { return a > b ? a : b; }

static double largest_of(const double *x, int64_t n) {
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
static void least(const Model *of, double *A, double *side, int n, Room room) {
  double *left = REALS(of->NM * of->NM), *gram = REALS(of->NM * of->NM), *z = REALS(of->NM), largest = 0;
  int *chosen = WHOLES(of->NM), *taken = WHOLES(of->NM), m = 0, k, i, j;
  memset(chosen, 0, of->NM * sizeof(int));
  memset(taken, 0, of->NM * sizeof(int));
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
  int n, *at, *let_go;
  double *A, *b, *lower, *upper, *f;
} Bounded;

/* one for NM directions, in the room that is given */
static Bounded bounded(const Model *of, Room *free) {
  Room room = *free;
  Bounded o;
  o.n = 0, o.at = WHOLES(of->NM), o.let_go = WHOLES(of->NM);
  o.A = REALS(of->NM * of->NM), o.b = REALS(of->NM), o.lower = REALS(of->NM), o.upper = REALS(of->NM), o.f = REALS(of->NM);
  *free = room;
  return o;
}

static double accelerates(const Bounded *o, int k, const double *f) { return o->b[k] + row_times(o->A, k, o->n, f, o->n); }

/* those at a bound have its force, the others what keeps them from accelerating, with the least sum of (f / bound)^2 */
static void balance(const Model *of, Bounded *o, Room room) {
  double *own = REALS(of->NM * of->NM), *side = REALS(of->NM), *H = REALS(of->NM), largest = 0;
  int *held = WHOLES(of->NM), m = 0, k, j;
  memset(H, 0, of->NM * sizeof(double));
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
  least(of, own, side, m, room);
  EACH(k, m) o->f[held[k]] = H[k] * side[k];
}

static int nearest(const Bounded *o, int k) { return o->upper[k] - o->f[k] <= o->f[k] - o->lower[k] ? 1 : -1; }

/* which are held and which are at a bound; 0: no choice is consistent */
static int complementary(const Model *of, Bounded *o, Room room) {
  const double most = largest_of(o->b, o->n);
  double largest = 0, still;
  int *pulled = WHOLES(of->NM), k, turn;
  EACH(k, o->n) {
    if (o->upper[k] < INFINITY) largest = larger(fabs(o->upper[k]), largest);
    if (o->lower[k] > -INFINITY) largest = larger(fabs(o->lower[k]), largest);
    o->at[k] = 0;
  }
  still = ROUNDING * (most + largest_of(o->A, (int64_t)o->n * o->n) * largest);
  balance(of, o, room);
  EACH(k, o->n) o->at[k] = o->upper[k] <= o->lower[k] ? 1 : o->let_go[k] ? nearest(o, k) : 0;
  for (turn = 0; turn < 2 * o->n + 20; ++turn) {
    int beyond = -1, wrong = -1;
    double worst = 0, against = 0;
    memset(pulled, 0, of->NM * sizeof(int));
    balance(of, o, room);
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
static void bring_to_rest(const Model *of, double *v, const double *y, const int *rest, double *left, Room room) {
  const double *G = y, most_of_v = 1.0 + largest_of(v, of->NI);
  double *side = REALS(of->NV), *most = REALS(of->NV), *push = REALS(of->NI);
  int *rows = WHOLES(of->NV), *column = WHOLES(of->NV), k, j, i, n = 0;
  memset(push, 0, of->NI * sizeof(double));
  EACH(k, of->NV) {
    most[k] = 0;
    EACH(j, of->NI) most[k] = larger(fabs(G[k + of->NV * j]), most[k]);
    if (!rest[k] || fabs(y[V_REL + k]) > PASSES * most[k] * most_of_v) continue; /* G is zero: it passes on */
    EACH(j, of->NI) left[n * of->NI + j] = G[k + of->NV * j];
    side[n] = y[V_REL + k], rows[n++] = k;
  }
  EACH(k, n) {
    column[k] = -1;
    EACH(j, of->NI) if (fabs(left[k * of->NI + j]) > PIVOT * most[rows[k]]) column[k] = j;
    for (i = 0; i < n && column[k] >= 0; ++i) {
      if (i != k && left[i * of->NI + column[k]] != 0) {
        const double factor = left[i * of->NI + column[k]] / left[k * of->NI + column[k]];
        EACH(j, of->NI) left[i * of->NI + j] -= factor * left[k * of->NI + j];
        side[i] -= factor * side[k];
      }
    }
  }
  EACH(k, n) if (column[k] >= 0) push[column[k]] = -side[k] / left[k * of->NI + column[k]];
  EACH(j, of->NI) v[j] = v[j] + push[j];
}

/* what `settle` tells, NM numbers of each: in which order stops are hit, from one on, rates upon them before and after,
   impulses, and how much later bounces that are over at once would be over; then of each row (NV) the mean of its rates
   before and after, and the states (NAT) before and after */
#define ORDER 0
#define BEFORE_HIT (of->NM)
#define AFTER_HIT (2 * of->NM)
#define IMPULSE (3 * of->NM)
#define RESTS (4 * of->NM)
#define PASSING (5 * of->NM)
#define STATES (PASSING + of->NV)
#define TOLD (STATES + 2 * of->NAT)

/* what is added to q_i' by impacts on stops, which ones are hit; 0: no impulses are consistent */
static int struck(const Model *of, double *push, int *hit, const double *y, const int *on, const double *e, double slow, double *told, Room room) {
  double *speed = REALS(of->NM);
  int *some = WHOLES(of->NM), count, k, j, order = 0;
  Bounded o = bounded(of, &room);
  EACH(k, of->NM) speed[k] = of->side_of[k] * y[V_REL + of->row_of[k]];
  EACH(count, MOST_HITS + 1) {
    const int last = count == MOST_HITS;
    int any = 0;
    o.n = 0;
    EACH(k, of->NM) {
      const int comes = on[k] && speed[k] < -slow;
      if (!on[k] || !(last || speed[k] <= slow)) continue;
      if (told != NULL && comes && !hit[k]) told[ORDER + k] = ++order, told[BEFORE_HIT + k] = speed[k];
      any = any || comes, hit[k] = hit[k] || comes, some[o.n] = k;
      o.b[o.n] = (1 + (comes && !last ? e[k] : 0.0)) * speed[k];
      o.lower[o.n] = 0.0, o.upper[o.n] = INFINITY, o.let_go[o.n++] = 0;
    }
    if (!any) return 1;
    EACH(k, o.n) EACH(j, o.n) {
      o.A[k + o.n * j] = of->side_of[some[k]] * y[A_OF + of->row_of[some[k]] + of->NV * of->row_of[some[j]]] * of->side_of[some[j]];
    }
    if (!complementary(of, &o, room)) return 0;
    balance(of, &o, room);
    EACH(k, o.n) o.f[k] = larger(o.f[k], 0.0);
    if (told != NULL) EACH(k, o.n) told[IMPULSE + some[k]] += o.f[k];
    EACH(k, of->NM) {
      double sum = 0;
      EACH(j, o.n) sum += of->side_of[k] * y[A_OF + of->row_of[k] + of->NV * of->row_of[some[j]]] * of->side_of[some[j]] * o.f[j];
      if (told != NULL && on[k] && speed[k] < -slow) told[AFTER_HIT + k] = speed[k] + sum;
      speed[k] = speed[k] + sum;
    }
    EACH(k, of->NI) {
      double sum = 0;
      EACH(j, o.n) sum += y[BY + k + of->NI * of->row_of[some[j]]] * of->side_of[some[j]] * o.f[j];
      push[k] = push[k] + sum;
    }
  }
  return 1;
}

/* a state (q_i, q_d, q_i', q_d', t), its constants, what `weights` says of it, room for rows */
typedef struct {
  double *at, *c, *y, *left, *w;
} Place;

static void weigh(const Model *of, const Place *o) { of->weights(o->y, o->at, o->c, o->w); }

static void moved(const Model *of, const Place *o, Room room) { /* rates of q_d by those of q_i */
  double *rates = REALS(of->NQD);
  if (of->NQD == 0) return;
  of->velocities(rates, o->at, o->c, o->w);
  memcpy(o->at + 2 * of->NI + of->NQD, rates, of->NQD * sizeof(double));
}

/* do modes (NM) keep the laws of friction and stops, by the equations that go on with them? rest, force (NV): rows at
   rest, and what was found there */
static int lawful(const Model *of, const Place *o, const double *modes, const int *rest, const double *force, Room room) {
  const double *y = o->y, *A = y + A_OF;
  double *found = REALS(of->NM + 2 * of->NV), *v = found + of->NM, *a = v + of->NV, most = 0;
  const double slow = BROKEN * (1.0 + largest_of(o->at + of->NI + of->NQD, of->NI));
  int k, j;
  EACH(k, of->NM) o->c[of->DT_AT - of->NU + of->modes_at[k]] = modes[k];
  of->with_modes(found, o->at, o->c, o->w);
  EACH(k, of->NV) {
    double acts = fabs(y[B_OF + k]);
    EACH(j, of->NV) acts += fabs(A[k + of->NV * j]) * fabs(force[j]);
    most = larger(BROKEN * acts / sqrt(larger(A[k + of->NV * k], 1e-300)), most);
  }
  EACH(k, of->NM) {
    const int row = of->row_of[k], side = of->side_of[k];
    const double root = sqrt(larger(A[row + of->NV * row], 1e-300));
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
static int once(const Model *of, const Place *o, double *modes, const int *happened, const double *come, int *soon, double *told,
                Room room) {
  double *v = o->at + of->NI + of->NQD, *y = o->y, *push = REALS(of->NI), *rate = REALS(of->NV), *force = REALS(of->NV);
  double *e = REALS(of->NM), *until = REALS(of->NM);
  const double slow = AT_REST * (1.0 + largest_of(v, of->NI));
  int *on = WHOLES(of->NM), *touched = WHOLES(of->NM), *hit = WHOLES(of->NM), *rest = WHOLES(of->NV), *open = WHOLES(of->NV);
  int k, j, s = 0, any = 0, again = 0, drops;
  Bounded b = bounded(of, &room);
  memset(push, 0, of->NI * sizeof(double));
  memset(force, 0, of->NV * sizeof(double));
  memset(hit, 0, of->NM * sizeof(int));
  memset(rest, 0, of->NV * sizeof(int));
  memset(open, 0, of->NV * sizeof(int));
  memcpy(until, modes, of->NM * sizeof(double));
  weigh(of, o);
  if (told != NULL) memset(told, 0, RESTS * sizeof(double)), memcpy(told + PASSING, y + V_REL, of->NV * sizeof(double));
  EACH(k, of->NV) if (!(y[HOLDS + k] >= NOTHING)) return -1; /* a limit of friction is none any more */
  EACH(k, of->NM) {
    const int stop = of->side_of[k] != 0, near = until[k] == 0 || (happened != NULL && happened[k]);
    on[k] = stop && (near || y[GAP + s] <= 0), touched[k] = stop && (near || y[GAP + s] <= TOUCH);
    e[k] = stop && !soon[k] ? y[BACK + s] : 0.0, s += stop;
  }
  if (!struck(of, push, hit, y, on, e, slow, told, room)) return -1;
  EACH(k, of->NV) rate[k] = y[V_REL + k] + row_times(y, k, of->NV, push, of->NI);
  EACH(k, of->NM) {
    const double speed = fabs(rate[of->row_of[k]]);
    touched[k] = touched[k] && speed <= slow;
    if (touched[k] || (of->side_of[k] == 0 && speed <= larger(come[k], slow))) rest[of->row_of[k]] = any = 1;
    open[of->row_of[k]] = open[of->row_of[k]] || (happened != NULL && happened[k] && until[k] == 0);
  }
  EACH(k, of->NM) {
    const double moves = rate[of->row_of[k]];
    modes[k] = of->side_of[k] != 0 ? 1.0 : rest[of->row_of[k]] ? 0.0 : (double)((moves > 0) - (moves < 0));
    o->c[of->DT_AT - of->NU + of->modes_at[k]] = modes[k];
  }
  EACH(j, of->NI) v[j] = v[j] + push[j];
  moved(of, o, room);
  EACH(k, any ? 2 : 1) { /* the second time what the first one rounded */
    weigh(of, o);
    bring_to_rest(of, v, y, rest, o->left, room);
    moved(of, o, room);
  }
  weigh(of, o); /* with the laws of those that move */
  EACH(k, of->NV) {
    if (!rest[k]) continue;
    b.b[b.n] = y[B_OF + k], b.lower[b.n] = -y[HOLDS + k], b.upper[b.n] = y[HOLDS + k], b.let_go[b.n] = open[k];
    EACH(j, of->NM) {
      if (of->row_of[j] == k && touched[j] && of->side_of[j] > 0) b.upper[b.n] = INFINITY;
      if (of->row_of[j] == k && touched[j] && of->side_of[j] < 0) b.lower[b.n] = -INFINITY;
    }
    rest[k] = ++b.n; /* its number among them, from 1 */
  }
  EACH(k, of->NV) EACH(j, of->NV) if (rest[k] && rest[j]) b.A[rest[k] - 1 + b.n * (rest[j] - 1)] = y[A_OF + k + of->NV * j];
  do {
    drops = 0;
    if (!complementary(of, &b, room)) return -1;
    EACH(k, of->NV) if (of->NSEEN > SLIDES && rest[k] && b.at[rest[k] - 1] != 0) {
      const double slides = y[SLIDES + k];
      j = rest[k] - 1;
      if (b.upper[j] < INFINITY && slides < b.upper[j]) b.upper[j] = slides, drops = 1;
      if (b.lower[j] > -INFINITY && -slides > b.lower[j]) b.lower[j] = -slides, drops = 1;
    }
  } while (drops); /* what lets go falls to that at once, which others may not hold */
  balance(of, &b, room);
  EACH(k, of->NV) if (rest[k]) force[k] = b.f[rest[k] - 1];
  EACH(k, of->NM) {
    const int number = rest[of->row_of[k]];
    if (of->side_of[k] == 0 && number) modes[k] = -(double)b.at[number - 1];
    if (touched[k]) modes[k] = number && b.at[number - 1] == 0 ? 0.0 : -1.0;
  }
  if (any && !lawful(of, o, modes, rest, force, room)) return -1;
  EACH(k, of->NM) { /* bounces that come too close are over at once */
    const double a = of->side_of[k] * (y[B_OF + of->row_of[k]] + row_times(y + A_OF, of->row_of[k], of->NV, force, of->NV));
    const double speed = of->side_of[k] * y[V_REL + of->row_of[k]];
    const double left = -a * (1 - e[k]) * TOO_CLOSE;
    if (!(hit[k] && !soon[k] && 0 < 2 * speed && 2 * speed < left)) continue;
    soon[k] = again = 1;
    if (told != NULL) told[RESTS + k] = 2 * speed / left * TOO_CLOSE;
  }
  return again;
}

/* modes among the inputs u (NU) and rates at a state `at`; happened: elements that ask, or NULL; come: rates below which
   one has come to rest. 0: no modes are consistent, and nothing has changed */
static int decide(const Model *of, double *at, double *u, const double *c, const int *happened,
                  const double *come, double *there, double *w, double *told, Room room) {
  double *modes = REALS(of->NM);
  int *soon = WHOLES(of->NM), k, found;
  Place o;
  memset(soon, 0, of->NM * sizeof(int));
  o.y = there, o.c = o.y + of->NSEEN, o.at = o.c + of->DT_AT, o.left = o.at + of->NAT, o.w = w;
  do {
    memcpy(o.at, at, of->NAT * sizeof(double)), memcpy(o.c, c, of->DT_AT * sizeof(double));
    memcpy(o.c + of->DT_AT - of->NU, u, of->NU * sizeof(double));
    EACH(k, of->NM) modes[k] = u[of->modes_at[k]];
    found = once(of, &o, modes, happened, come, soon, told, room);
  } while (found > 0);
  if (found < 0) return 0;
  memcpy(at, o.at, of->NAT * sizeof(double));
  EACH(k, of->NM) u[of->modes_at[k]] = modes[k];
  return 1;
}

/* modes into inputs and what is added to the rates, at a state S that constants show; happened: elements that ask;
   told (TOLD), or NULL */
static void settle(const Model *of, Run *r, double *inputs, double *push, const double *S, const double *shown,
                   const int *happened, double *told, Room room) {
  double *at = r->there, *v = at + of->NI + of->NQD, *slopes = REALS(ROW), *start = REALS(of->NI), *come = REALS(of->NM);
  int k;
  memset(come, 0, of->NM * sizeof(double));
  of->seen(at, S, shown, r->w);
  memcpy(start, v, of->NI * sizeof(double));
  if (happened != NULL) {
    of->slopes(slopes, S, shown, r->w);
    EACH(k, of->NM) if (happened[k] && inputs[of->modes_at[k]] != 0) come[k] = LOST * fabs(slopes[of->ND - of->NM + k]);
  }
  if (told != NULL) memset(told, 0, TOLD * sizeof(double)), memcpy(told + STATES, at, of->NAT * sizeof(double));
  if (!decide(of, at, inputs, r->c, happened, come, at + of->NAT, r->w, told, room)) r->z[ENDED] = NO_MODE;
  EACH(k, of->NI) push[k] = v[k] - start[k];
  if (told == NULL) return;
  EACH(k, of->NV) told[PASSING + k] += 0.5 * row_times(at + of->NAT, k, of->NV, push, of->NI);
  memcpy(told + STATES + of->NAT, at, of->NAT * sizeof(double));
}

/* at a start, and where inputs change */
static void settle_there(const Model *of, Run *r, Room room) {
  const double clock[2] = {r->z[0], r->z[1]};
  double *T = r->T, *inputs = T + of->NOWN + 3, *push = inputs + of->NU;
  int k, moves = 0;
  memcpy(T, r->z, of->NOWN * sizeof(double)), memcpy(inputs, r->z + of->INPUTS_AT, of->NU * sizeof(double));
  T[of->NOWN] = T[of->NOWN + 1] = r->dt, T[of->NOWN + 2] = clock[0] + clock[1] * r->dt;
  settle(of, r, inputs, push, r->z, r->c, NULL, NULL, room);
  EACH(k, of->NI) moves = moves || push[k] != 0;
  EACH(k, of->NU) moves = moves || inputs[k] != r->z[of->INPUTS_AT + k];
  if (!moves) return;
  of->again(T, r->c, r->w);
  memcpy(r->z, T, of->NOWN * sizeof(double)), r->z[0] = clock[0], r->z[1] = clock[1];
  look_at_events(of, r, room);
}

/* is a start on the right side of its stops? */
static int within_stops(const Model *of, Run *r) {
  Place o;
  int k;
  o.at = r->there, o.y = o.at + of->NAT, o.c = o.y + of->NSEEN, o.w = r->w;
  of->seen(o.at, r->z, r->c, o.w);
  memcpy(o.c, r->c, of->DT_AT * sizeof(double));
  weigh(of, &o);
  EACH(k, of->NSTOPS) if (!(o.y[GAP + k] >= -TOUCH)) return 0;
  return 1;
}

/* the same at a state of model exchange, whose master says roughly when something comes to rest */
DOOR int settle_at(const Model *of, double *at, double *u, const double *c, const int *happened, double *w) {
  Room room = {w + of->NSEEN + of->DT_AT + of->NAT + of->NI * of->NV, NULL};
  double *come;
  int k;
  room.wholes = (int *)(room.reals + of->NREALS), come = REALS(of->NM);
  EACH(k, of->NM) come[k] = happened[k] ? PASSES * (1.0 + largest_of(at + of->NI + of->NQD, of->NI)) : 0.0;
  return decide(of, at, u, c, happened, come, w, (double *)room.wholes + of->NWHOLES, NULL, room);
}
