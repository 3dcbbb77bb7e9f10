/* Central differences of a linear structure whose groups of nodes have steps of their own (Eqs. 3-14, 72).
 *
 * M x'' + D x' + K x = F(t), M diagonal. Group 0 is the fastest; one step of group g holds `sub_steps` steps of group
 * g - 1. Increments d = h x'(t - h/2) are the state beside x:
 *
 *     d <- keep d + gain (F - K x - D v),   x <- x + d,   gain = h^2 / (m (1 + a h / 2)),   keep = (1 - a h / 2) / (1 + a h / 2)
 *
 * where a is the mass-proportional damping, implicit, and v a prediction of x' at the beginning of the step. While faster
 * groups step, a slower coordinate that their rows read moves along its chord (13), x + f d, f = 0, 1/N, 2/N ...: the
 * reading that does not grow without damping (docs/theory/schemes.md).
 *
 * This text is compiled to central_difference.ll, which is checked in: see native.py. It calls nothing.
 */
#include <stdint.h>

typedef struct {
    int64_t first, last;             /* blocks of the group */
    int64_t sub_steps;               /* steps of the next faster group in one of this */
    int64_t fastest;                 /* steps of group 0 in one of this */
    double rate;                     /* 1 / h */
    const int32_t *row, *column;     /* K's rows of the group, by blocks */
    const double *block;
    const int32_t *damper_row, *damper_column; /* D's, or null */
    const double *damper_block;
    const double *gain, *keep;       /* by coordinate of the structure */
    int64_t seen;                    /* blocks of the group that rows of faster groups read */
    const int32_t *seen_block;
    int64_t loads;                   /* entries of F in this group: factor times law at coordinate at */
    const int32_t *at, *law;
    const double *factor;
    const double *laws;              /* values of the laws at the steps of this group */
} Group;

typedef struct {
    const Group *group;
    int64_t groups, width, laws;     /* width: coordinates of a block */
    double *x, *base, *d, *last, *v, *force; /* by coordinate */
    int64_t *count, *elapsed;        /* by group: steps in this call; steps of group 0 since its step began */
} Run;

#define PRODUCT(NAME, W)                                                                                        \
    static void NAME(int64_t rows, const int32_t *row, const int32_t *column, const double *block,             \
                     const double *x, double *f)                                              \
    {                                                                                                           \
        for (int64_t r = 0; r < rows; r++) {                                                                    \
            double sum[W];                                                                                      \
            for (int i = 0; i < W; i++) sum[i] = 0.0;                                                           \
            for (int64_t k = row[r]; k < row[r + 1]; k++) {                                                     \
                const double *b = block + k * W * W, *y = x + (int64_t)column[k] * W;                           \
                for (int j = 0; j < W; j++)                                                                     \
                    for (int i = 0; i < W; i++) sum[i] += b[j * W + i] * y[j];                                  \
            }                                                                                                   \
            for (int i = 0; i < W; i++) f[r * W + i] -= sum[i];                                                 \
        }                                                                                                       \
    }
/* f -= A x; blocks are stored by columns, so that a processor takes a column at a time */
PRODUCT(product_1, 1)
PRODUCT(product_2, 2)
PRODUCT(product_3, 3)

static void product(int64_t width, int64_t rows, const int32_t *row, const int32_t *column, const double *block,
                    const double *x, double *f)
{
    if (width == 1) product_1(rows, row, column, block, x, f);
    else if (width == 2) product_2(rows, row, column, block, x, f);
    else product_3(rows, row, column, block, x, f);
}

/* The rates that dampers see: extrapolated from the last two increments, of this group and all faster ones. */
static void predict(const Run *s, int64_t g)
{
    for (int64_t k = 0; k <= g; k++) {
        const Group *group = s->group + k;
        for (int64_t i = group->first * s->width; i < group->last * s->width; i++)
            s->v[i] = group->rate * (1.5 * s->d[i] - 0.5 * s->last[i]);
    }
}

/* The increments of group g from the forces at the beginning of its step (10), (40)-(45). */
static void increments(const Run *s, int64_t g)
{
    const Group *group = s->group + g;
    const int64_t w = s->width, from = group->first * w, to = group->last * w, rows = group->last - group->first;
    const double *law = group->laws + s->count[g] * s->laws;
    for (int64_t i = from; i < to; i++) s->force[i] = 0.0;
    for (int64_t k = 0; k < group->loads; k++) s->force[group->at[k]] += group->factor[k] * law[group->law[k]];
    product(w, rows, group->row, group->column, group->block, s->x, s->force + from);
    if (group->damper_row) {
        predict(s, g);
        product(w, rows, group->damper_row, group->damper_column, group->damper_block, s->v, s->force + from);
        for (int64_t i = from; i < to; i++) s->last[i] = s->d[i];
    }
    for (int64_t i = from; i < to; i++) s->d[i] = group->keep[i] * s->d[i] + group->gain[i] * s->force[i];
    s->count[g]++;
}

/* What faster rows read of the slower groups g, g + 1, ...: displacements on the chords of their steps (13), rates on
 * the line through the middles of the step before and this one. */
static void interpolate(const Run *s, int64_t g)
{
    for (int64_t k = g; k < s->groups; k++) {
        const Group *group = s->group + k;
        const double f = (double)s->elapsed[k] / (double)group->fastest;
        for (int64_t n = 0; n < group->seen; n++)
            for (int64_t i = group->seen_block[n] * s->width, end = i + s->width; i < end; i++) {
                s->x[i] = s->base[i] + f * s->d[i];
                s->v[i] = group->rate * (s->last[i] + (f + 0.5) * (s->d[i] - s->last[i]));
            }
    }
}

static void step(const Run *s, int64_t g)
{
    const Group *group = s->group + g;
    increments(s, g);
    if (g > 0) {
        for (int64_t n = 0; n < group->seen; n++)
            for (int64_t i = group->seen_block[n] * s->width, end = i + s->width; i < end; i++) s->base[i] = s->x[i];
        s->elapsed[g] = 0;
        for (int64_t j = 0; j < group->sub_steps; j++) {
            interpolate(s, g);
            step(s, g - 1);
        }
        for (int64_t n = 0; n < group->seen; n++)
            for (int64_t i = group->seen_block[n] * s->width, end = i + s->width; i < end; i++) s->x[i] = s->base[i];
    } else {
        for (int64_t k = 1; k < s->groups; k++) s->elapsed[k]++;
    }
    for (int64_t i = group->first * s->width; i < group->last * s->width; i++) s->x[i] += s->d[i];
}

/* So many steps of the slowest group. */
void advance(const Run *s, int64_t steps)
{
    for (int64_t n = 0; n < s->groups; n++) s->count[n] = 0;
    for (int64_t n = 0; n < steps; n++) step(s, s->groups - 1);
}
