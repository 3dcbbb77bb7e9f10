/* Which elements stick and which slide where that is open, as in runtime/schemes/switching/settle.py. */

#define AT_REST 1e-9
#define NIL 1e-12
#define SINGULAR 1e-11
#define PASSES 1e-6
#define EACH(k, n) for ((k) = 0; (k) < (n); ++(k))

/* A x = b for m columns of B, by elimination; A is lost, B becomes x */
static void solve(double *A, double *B, int n, int m) {
  int k, i, j;
  for (k = 0; k < n; ++k) {
    int p = k;
    for (i = k + 1; i < n; ++i) p = fabs(A[i + n * k]) > fabs(A[p + n * k]) ? i : p;
    for (j = 0; j < n + m; ++j) {
      double *column = j < n ? A + n * j : B + n * (j - n);
      const double one = column[k];
      column[k] = column[p], column[p] = one;
    }
    for (i = k + 1; i < n; ++i) {
      const double factor = A[i + n * k] / A[k + n * k];
      for (j = k; j < n; ++j) A[i + n * j] -= factor * A[k + n * j];
      for (j = 0; j < m; ++j) B[i + n * j] -= factor * B[k + n * j];
    }
  }
  for (k = n - 1; k >= 0; --k) {
    for (j = 0; j < m; ++j) {
      for (i = k + 1; i < n; ++i) B[k + n * j] -= A[k + n * i] * B[i + n * j];
      B[k + n * j] /= A[k + n * k];
    }
  }
}

/* side becomes x of least norm with A x = side, A symmetric: a combination of columns of A that are independent */
static void least(double *A, double *side, int n) {
  double left[NM * NM], gram[NM * NM], z[NM], largest = 0;
  int chosen[NM] = {0}, taken[NM] = {0}, m = 0, k, i, j;
  memcpy(left, A, n * n * sizeof(double));
  EACH(k, n) largest = A[k + n * k] > largest ? A[k + n * k] : largest;
  for (;;) {
    int p = -1;
    EACH(k, n) if (!taken[k] && (p < 0 || left[k + n * k] > left[p + n * p])) p = k;
    if (p < 0 || left[p + n * p] <= SINGULAR * largest) break;
    EACH(i, n) EACH(j, n) if (i != p && j != p) left[i + n * j] -= left[i + n * p] * left[p + n * j] / left[p + n * p];
    taken[p] = 1, chosen[m++] = p;
  }
  if (m == n) {
    solve(A, side, n, 1);
    return;
  }
  EACH(i, m) {
    z[i] = side[chosen[i]];
    EACH(j, m) {
      gram[i + m * j] = 0;
      EACH(k, n) gram[i + m * j] += A[k + n * chosen[i]] * A[k + n * chosen[j]];
    }
  }
  solve(gram, z, m, 1);
  EACH(k, n) {
    side[k] = 0;
    EACH(i, m) side[k] += A[k + n * chosen[i]] * z[i];
  }
}

/* those at a bound have its force, the others what keeps them from accelerating, with the least sum of (f / bound)^2 */
static void forces(double *f, const double *A, const double *b, const double *most, const int *at, int n) {
  double own[NM * NM], side[NM], H[NM] = {0}, largest = 0;
  int held[NM], m = 0, k, j;
  EACH(k, n) f[k] = at[k] * most[k];
  EACH(k, n) if (at[k] == 0) held[m++] = k;
  EACH(k, m) largest = most[held[k]] > largest ? most[held[k]] : largest;
  EACH(k, m) H[k] = most[held[k]] > 0 ? most[held[k]] : largest > 0 ? largest : 1;
  EACH(k, m) {
    side[k] = -b[held[k]];
    EACH(j, n) side[k] -= A[held[k] + n * j] * f[j];
    side[k] *= H[k];
    EACH(j, m) own[k + m * j] = H[k] * A[held[k] + n * held[j]] * H[j];
  }
  least(own, side, m);
  EACH(k, m) f[held[k]] = H[k] * side[k];
}

/* -1, 0, 1: at its bound, held, at the other one, of v' = b + A f; 0: no choice is consistent */
static int complementary(int *at, const double *A, const double *b, const double *most, const int *let_go, int n) {
  double f[NM], largest = 0, still = 0, all = 0, dust;
  int k, j, turn;
  memset(at, 0, NM * sizeof(int));
  EACH(k, n) largest = most[k] > largest ? most[k] : largest, still = fabs(b[k]) > still ? fabs(b[k]) : still;
  EACH(k, n * n) all = fabs(A[k]) > all ? fabs(A[k]) : all;
  dust = NIL * largest, still = NIL * (still + all * largest);
  forces(f, A, b, most, at, n);
  EACH(k, n) if (let_go[k]) at[k] = f[k] >= 0 ? 1 : -1;
  EACH(k, n) at[k] = most[k] > 0 ? at[k] : 1; /* what holds nothing goes where it is pulled */
  for (turn = 0; turn < 2 * n + 20; ++turn) {
    int beyond = -1, wrong = -1;
    double worst = 0, against = 0;
    forces(f, A, b, most, at, n);
    EACH(k, n) {
      const double over = (fabs(f[k]) - most[k] + dust) * A[k + n * k];
      double a = b[k];
      EACH(j, n) a += A[k + n * j] * f[j];
      if (most[k] <= 0) at[k] = a > 0 ? -1 : 1;
      a = at[k] * a - (let_go[k] ? 1e6 * still : still);
      if (at[k] == 0 && over > worst) worst = over, beyond = k;
      if (at[k] != 0 && most[k] > 0 && a > against) against = a, wrong = k;
    }
    if (beyond < 0 && wrong < 0) return 1;
    if (beyond >= 0) at[beyond] = f[beyond] >= 0 ? 1 : -1;
    else at[wrong] = 0;
  }
  return n == 0;
}

/* v (NI) so that these rates become zero; where a coordinate can do it alone, to the last bit */
static void bring_to_rest(double *v, double *G, const double *rate, const int *rest, double *left, double *push) {
  double side[NM], fastest = 0;
  int rows[NM], column[NM], k, j, i, n = 0, m = 0;
  EACH(j, NI) fastest = fabs(v[j]) > fastest ? fabs(v[j]) : fastest;
  EACH(k, NM) if (rest[k]) { /* one whose rate is zero since its G is passes on */
    double most = 0;
    EACH(j, NI) most = fabs(G[k + NM * j]) > most ? fabs(G[k + NM * j]) : most;
    if (fabs(rate[k]) <= PASSES * most * (1.0 + fastest)) rows[n++] = k;
  }
  EACH(k, n) {
    side[k] = rate[rows[k]];
    EACH(j, NI) left[k * NI + j] = G[rows[k] + NM * j];
  }
  EACH(k, n) {
    double most = 0;
    column[k] = -1;
    EACH(j, NI) most = fabs(G[rows[k] + NM * j]) > most ? fabs(G[rows[k] + NM * j]) : most;
    EACH(j, NI) if (fabs(left[k * NI + j]) > NIL * 1000 * most) column[k] = j;
    for (i = 0; i < n && column[k] >= 0; ++i) {
      if (i != k && left[i * NI + column[k]] != 0) {
        const double factor = left[i * NI + column[k]] / left[k * NI + column[k]];
        EACH(j, NI) left[i * NI + j] -= factor * left[k * NI + j];
        side[i] -= factor * side[k];
      }
    }
  }
  memset(push, 0, NI * sizeof(double));
  EACH(m, n) if (column[m] >= 0) push[column[m]] = -side[m] / left[m * NI + column[m]];
  EACH(j, NI) v[j] = v[j] + push[j];
}

/* modes into inputs and what is added to the rates, at a state S that constants show; happened: elements that ask */
static void settle(Run *r, double *inputs, double *push, const double *S, const double *shown, const int *happened) {
  double *at = r->room, *y = at + NAT, *by = y + NSEEN, *c = by + NI * (NM + 1), *left = c + DT_AT;
  double *G = y + NI * NI + NI, *bias = G + NM * NI, *rate = bias + NM, *holds = rate + NM, *v = at + NI + NQD;
  double slopes[ROW], start[NI], before[NM], fastest = 0, A[NM * NM] = {0}, b[NM] = {0}, most[NM] = {0};
  int rest[NM], let_go[NM] = {0}, side[NM], k, j, i, n = 0, turn, any = 0;
  M(slopes)(slopes, S, shown, r->w);
  M(seen)(at, S, shown, r->w);
  memcpy(c, r->c, DT_AT * sizeof(double)), memcpy(c + DT_AT - NU, inputs, NU * sizeof(double));
  M(elements)(y, at, c, r->w);
  memcpy(start, v, sizeof start);
  EACH(k, NM) any = any || (happened != NULL && happened[k] && inputs[modes_at[k]] != 0);
  EACH(j, NI) fastest = fabs(v[j]) > fastest ? fabs(v[j]) : fastest;
  EACH(k, NM) {
    const double come = any && happened[k] ? LOST * fabs(slopes[ND - NM + k]) : 0.0, slow = AT_REST * (1.0 + fastest);
    const int asks = happened != NULL && happened[k] && inputs[modes_at[k]] == 0;
    rest[k] = fabs(rate[k]) <= (come > slow ? come : slow);
    if (rest[k]) side[n] = k, let_go[n++] = asks;
    before[k] = inputs[modes_at[k]];
    inputs[modes_at[k]] = c[DT_AT - NU + modes_at[k]] = rest[k] ? 0.0 : rate[k] > 0 ? 1.0 : -1.0;
  }
  for (turn = 0; turn < (n > 0 ? 2 : 1); ++turn) { /* the second time what the first one rounded */
#if NQD > 0 /* of the rates before the push, as in the runtime */
    M(velocities)(at + 2 * NI + NQD, at, c, r->w);
#endif
    bring_to_rest(v, G, rate, rest, left, push);
    M(elements)(y, at, c, r->w); /* with the laws of those that move */
  }
  EACH(j, NI) push[j] = v[j] - start[j], by[NI * NM + j] = y[NI * NI + j];
  EACH(k, NM) EACH(j, NI) by[j + NI * k] = G[k + NM * j];
  solve(y, by, NI, NM + 1);
  EACH(i, n) {
    b[i] = bias[side[i]], most[i] = holds[side[i]];
    EACH(j, NI) b[i] += G[side[i] + NM * j] * by[NI * NM + j];
    EACH(k, n) {
      A[i + n * k] = 0;
      EACH(j, NI) A[i + n * k] += G[side[i] + NM * j] * by[j + NI * side[k]];
    }
  }
  if (!complementary(rest, A, b, most, let_go, n)) {
    memset(push, 0, NI * sizeof(double));
    EACH(k, NM) inputs[modes_at[k]] = before[k];
    r->z[ENDED] = M(NO_MODE);
    return;
  }
  EACH(i, n) inputs[modes_at[side[i]]] = -(double)rest[i];
}

/* at a start, and where inputs change */
static void settle_there(Run *r) {
  const double clock[2] = {r->z[0], r->z[1]};
  double *T = r->T, *inputs = T + NOWN + 3, *push = inputs + NU;
  int k, moved = 0;
  memcpy(T, r->z, NOWN * sizeof(double)), memcpy(inputs, r->z + INPUTS_AT, NU * sizeof(double));
  T[NOWN] = T[NOWN + 1] = r->dt, T[NOWN + 2] = clock[0] + clock[1] * r->dt;
  settle(r, inputs, push, r->z, r->c, NULL);
  EACH(k, NI) moved = moved || push[k] != 0;
  EACH(k, NU) moved = moved || inputs[k] != r->z[INPUTS_AT + k];
  if (!moved) return;
  M(again)(T, r->c, r->w);
  memcpy(r->z, T, NOWN * sizeof(double)), r->z[0] = clock[0], r->z[1] = clock[1];
  look_at_events(r);
}
