/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The model `nielson`: unknown global control points d_i on the sphere, one at
 * each node, as Nielson's nu-spline of the plane has them [IOR15, sec. 3.2].
 * With G[p,q](t) the point at t on the great circle from p to q, h_i the
 * spacing before node i,
 *   gamma_i = 2 (h_i + h_{i+1}) / (nu_i h_i h_{i+1} + 2 (h_i + h_{i+1})),
 *   D = gamma_i h_i + h_{i+1} + gamma_{i+1} h_{i+2},
 *   R_i = G[d_i, d_{i+1}](gamma_i h_i / D),                              (1)
 *   L_{i+1} = G[d_i, d_{i+1}]((gamma_i h_i + h_{i+1}) / D),
 * and at every node the equation
 *   G[L_i, R_i](h_i / (h_i + h_{i+1})) = P_i,                            (2)
 * so that the curve is C1 at any tension.  It is G2 in the plane only.
 *
 * Ends of open data: h = 0 beyond them, hence R_0 = d_0 by (1), which is P_0
 * at rest and Exp(h_1 v_0 / 3) with a velocity v_0.  A natural end has d_0 =
 * P_0, and R_0 the midpoint of P_0 and L_1, so that the covariant acceleration
 * is 0: with l = h_1 / (h_1 + gamma_1 h_2), that of L_1 in (1),
 *   R_0 = G[P_0, d_1](l / (1 + l)),   L_1 = G[P_0, d_1](2 l / (1 + l));  (3)
 * and 1/3, 2/3 between two natural ends.
 *
 * What is stored is x_i = d_i - P_i, and what is computed are differences to
 * nodes, so that nothing cancels and the equations reach rounding whatever the
 * spacing:
 *   G[p,q](t) = p + w(t) (q - p) + c(t) p,
 *   w(t) = sin(t theta) / sin(theta),                                    (4)
 *   c(t) = w(t) + w(1 - t) - 1
 *        = 2 sin(t theta / 2) sin((1 - t) theta / 2) / cos(theta / 2),
 * with sin(theta) = 2 sin(theta / 2) cos(theta / 2): where p and q are nearly
 * antipodal, rounding of cos(theta / 2) divides w and c alike, or G would be
 * off by its square. Tested by t_sphere_nielson.c.
 */
#include "kernel/s2.h"
#include "solve/sphere/sphere.h"

/* Picard's iterations before Newton's; sweeps of the last resort, and the root
 * mean square at which Newton's iteration takes over. */
enum { PICARD_STEPS = 3, SWEEPS_MAX = 2000 };
static const double SWEPT = 1e-10;

/* Between d_i and d_{i+1} that are this near to antipodal, as cos(theta / 2), R
 * and L have rounding u / cos(theta / 2) of the great circle: Newton's
 * iteration does not go there, where the equations would hold to 1e-12 and no
 * better; from 1e-3 to 1e-2 as many random paths are solved, from 2e-4 down
 * fewer. */
static const double HALF_MIN = 1e-3;

/* ---- great circles ------------------------------------------------------- */

/* From p to q; X = theta^2. */
struct arc {
  ph_vec3 d; /* q - p */
  double x;
  double f0, f1; /* of X */
  double half;   /* cos(theta / 2) */
};

/* w(t) and c(t) of (4), and their derivatives by |d|^2. */
struct mix {
  double w, c, dw, dc;
};

static struct arc arc_of(ph_vec3 p, ph_vec3 d) {
  struct arc a;
  double chord = ph_vec3_abs(d), f[4], angle;
  double sum = ph_vec3_abs(ph_vec3_along(d, 2, p));
  angle = 2 * atan2(chord, sum);
  a.d = d;
  a.x = angle * angle;
  ph_s2_bessel(a.x, f);
  a.half = sum / 2;
  a.f0 = angle > 0 ? chord * a.half / angle : 1;
  a.f1 = f[1];
  return a;
}

/* The derivative of w(t) by |d|^2. */
static double weight_moved(const struct arc *a, double t) {
  double f[4];
  ph_s2_bessel(t * t * a->x, f);
  return t * (f[0] * a->f1 - t * t * f[1] * a->f0) /
         (2 * a->f0 * a->f0 * a->f0);
}

static struct mix mix_of(const struct arc *a, double t, bool derivatives) {
  struct mix m = {0, 0, 0, 0};
  double u = 1 - t;
  m.w = t * ph_s2_f0(t * t * a->x) / a->f0;
  m.c = t * u * a->x / 2 * ph_s2_f0(t * t * a->x / 4) *
        ph_s2_f0(u * u * a->x / 4) / a->half;
  if (derivatives) {
    m.dw = weight_moved(a, t);
    m.dc = m.dw + weight_moved(a, u);
  }
  return m;
}

/* G[p,q] - p, seen from p (sign = 1) or, as G[q,p] - q, from q (sign = -1). */
static ph_vec3 mixed(const struct arc *a, const struct mix *m, double sign,
                     ph_vec3 base) {
  return ph_vec3_along(ph_vec3_scale(sign * m->w, a->d), m->c, base);
}

/* The derivative of G when the base moves by `near` and the other end by `far`.
 */
static ph_vec3 mixed_moved(const struct arc *a, const struct mix *m,
                           double sign, ph_vec3 base, ph_vec3 near,
                           ph_vec3 far) {
  ph_vec3 dd = ph_vec3_sub(far, near);
  double ds = 2 * sign * ph_vec3_dot(a->d, dd);
  ph_vec3 v = ph_vec3_along(ph_vec3_scale(1 + m->c, near), m->w, dd);
  v = ph_vec3_along(v, ds * sign * m->dw, a->d);
  return ph_vec3_along(v, ds * m->dc, base);
}

/* ---- segments ------------------------------------------------------------ */

/* gamma_i times the spacing before node i, or after it. */
static double tense(const struct ph_sphere_spline *s, size_t i, double h) {
  double a = ph_sphere_left(s->data, i), b = ph_sphere_right(s->data, i);
  return h * 2 * (a + b) / (s->nu[i] * a * b + 2 * (a + b));
}

/* The parameters of R and, from the other end, of L in (1) and (3). */
static void parameters(const struct ph_sphere_spline *s, size_t k,
                       double t[2]) {
  const struct ph_sphere_data *d = s->data;
  size_t next = ph_sphere_next(d, k);
  double before = tense(s, k, ph_sphere_left(d, k));
  double after = tense(s, next, ph_sphere_right(d, next));
  double sum = before + d->h[k] + after;
  bool natural[2] = {d->ends == PH_SPHERE_NATURAL && ph_sphere_is_end(d, k),
                     d->ends == PH_SPHERE_NATURAL && ph_sphere_is_end(d, next)};
  t[0] = before / sum;
  t[1] = after / sum;
  if (natural[0] && natural[1]) {
    t[0] = t[1] = 1 / 3.0;
  } else if (natural[0] || natural[1]) {
    int w = natural[0] ? 0 : 1;
    double l = d->h[k] / sum;
    t[w] = l / (1 + l);
    t[1 - w] = (1 - l) / (1 + l);
  }
}

/* d_i - P_i brought to |d_i| = 1, to rounding of the difference. */
static ph_vec3 normalised(ph_vec3 p, ph_vec3 x) {
  double excess = 2 * ph_vec3_dot(p, x) + ph_vec3_dot(x, x);
  double size = sqrt(1 + excess);
  return ph_vec3_scale(1 / size, ph_vec3_along(x, -excess / (1 + size), p));
}

/* The great circle of segment k, from the d of its begin to that of its end. */
static struct arc arc_at(const struct ph_sphere_spline *s, size_t k,
                         ph_vec3 d[2]) {
  const ph_vec3 *p = s->data->p, *x = s->x;
  size_t next = ph_sphere_next(s->data, k);
  d[0] = ph_vec3_add(p[k], x[k]);
  d[1] = ph_vec3_add(p[next], x[next]);
  return arc_of(d[0], ph_vec3_add(ph_vec3_sub(p[next], p[k]),
                                  ph_vec3_sub(x[next], x[k])));
}

/* The larger of the angles from node i to its neighbours. */
static double size_at(const struct ph_sphere_data *d, size_t i) {
  double a = d->closed || i > 0 ? d->theta[ph_sphere_before(d, i)] : 0;
  double b = i < d->m ? d->theta[i] : 0;
  return a > b ? a : b;
}

/* Of x[i], coordinates: the node's frame, turned along the great circle to d_i,
 * times the size. */
static void frame_at(const struct ph_sphere_spline *s, size_t i,
                     ph_vec3 frame[2]) {
  ph_vec3 p = s->data->p[i], e = s->data->e[i], x = s->x[i];
  double size = size_at(s->data, i);
  ph_vec3 d = ph_vec3_add(p, x);
  e = ph_vec3_along(e, -ph_vec3_dot(e, x) / (2 + ph_vec3_dot(p, x)),
                    ph_vec3_add(p, d));
  frame[0] = ph_vec3_scale(size, e);
  frame[1] = ph_vec3_scale(size, ph_vec3_cross(d, e));
}

/* From P to P + x, brought to the sphere. */
static ph_vec3 leg_of(ph_vec3 p, ph_vec3 x) {
  return ph_vec3_sub(ph_vec3_unit(ph_vec3_add(p, x)), p);
}

/* The part is R and L, each less its node.
 * out  mix[2]  of R and L; ret  cos(theta / 2) */
static double control(struct ph_sphere_spline *s, size_t k, bool derivatives,
                      struct ph_sphere_part *part, struct mix mix[2]) {
  const ph_vec3 zero = {0, 0, 0};
  size_t node[2] = {k, ph_sphere_next(s->data, k)};
  double t[2];
  ph_vec3 d[2], frame[2][2];
  struct arc arc = arc_at(s, k, d);
  parameters(s, k, t);
  for (int w = 0; derivatives && w < 2; w++) {
    frame_at(s, node[w], frame[w]);
  }
  for (int w = 0; w < 2; w++) {
    double sign = w == 0 ? 1 : -1;
    mix[w] = mix_of(&arc, t[w], derivatives);
    part->f[w] = ph_vec3_add(s->x[node[w]], mixed(&arc, &mix[w], sign, d[w]));
    for (int c = 0; derivatives && c < 2; c++) {
      part->d[w][w][c] =
          mixed_moved(&arc, &mix[w], sign, d[w], frame[w][c], zero);
      part->d[w][1 - w][c] =
          mixed_moved(&arc, &mix[w], sign, d[w], zero, frame[1 - w][c]);
    }
  }
  s->r[k] = leg_of(s->data->p[node[0]], part->f[0]);
  s->l[k] = leg_of(s->data->p[node[1]], part->f[1]);
  return arc.half;
}

static void segment(struct ph_sphere_spline *s, size_t k, bool derivatives,
                    struct ph_sphere_part *part) {
  struct mix mix[2];
  if (control(s, k, derivatives, part, mix) < HALF_MIN) {
    part->f[0] = part->f[1] = ph_vec3_of((double)NAN, 0, 0);
  }
}

/* ---- nodes --------------------------------------------------------------- */

/* (2) at a node: the great circle from L to R, and G less the node. */
struct joint {
  struct arc arc;
  struct mix mix;
  ph_vec3 l, miss;
};

static struct joint joint_of(const struct ph_sphere_spline *s, size_t i,
                             const struct ph_sphere_part *left,
                             const struct ph_sphere_part *right,
                             bool derivatives) {
  const struct ph_sphere_data *d = s->data;
  double a = ph_sphere_left(d, i), b = ph_sphere_right(d, i);
  struct joint j;
  j.l = ph_vec3_add(d->p[i], left->f[1]);
  j.arc = arc_of(j.l, ph_vec3_sub(right->f[0], left->f[1]));
  j.mix = mix_of(&j.arc, a / (a + b), derivatives);
  j.miss = ph_vec3_add(left->f[1], mixed(&j.arc, &j.mix, 1, j.l));
  return j;
}

/* One coordinate of what is missing, along g, for all that may move. */
static void put_row(const ph_vec3 moved[3][2], ph_vec3 g, size_t c,
                    struct ph_block2_row *row) {
  for (size_t j = 0; j < 2; j++) {
    row->lo[2 * c + j] = ph_vec3_dot(g, moved[0][j]);
    row->di[2 * c + j] = ph_vec3_dot(g, moved[1][j]);
    row->up[2 * c + j] = ph_vec3_dot(g, moved[2][j]);
  }
}

/* What is missing is G as seen from -P in the plane that touches P, so that (2)
 * does not hold at -P, too: with the miss m, G = P + m,
 *   f = q (m.e1, m.e2),  q = 2 / (2 + m.P),  df_c = q dm.(e_c - f_c P / 2). */
static void node(const struct ph_sphere_spline *s, size_t i,
                 const struct ph_sphere_part *left,
                 const struct ph_sphere_part *right, bool derivatives,
                 struct ph_block2_row *row) {
  const ph_vec3 zero = {0, 0, 0};
  ph_vec3 p = s->data->p[i], e = s->data->e[i], frame[2], moved[3][2];
  struct joint j = joint_of(s, i, left, right, derivatives);
  double q = 2 / (2 + ph_vec3_dot(j.miss, p)), scale = q / size_at(s->data, i);
  frame[0] = e;
  frame[1] = ph_vec3_cross(p, e);
  for (int c = 0; derivatives && c < 2; c++) {
    moved[0][c] = mixed_moved(&j.arc, &j.mix, 1, j.l, left->d[1][0][c], zero);
    moved[1][c] = mixed_moved(&j.arc, &j.mix, 1, j.l, left->d[1][1][c],
                              right->d[0][0][c]);
    moved[2][c] = mixed_moved(&j.arc, &j.mix, 1, j.l, zero, right->d[0][1][c]);
  }
  for (size_t c = 0; c < 2; c++) {
    double m = ph_vec3_dot(j.miss, frame[c]);
    row->f[c] = -scale * m;
    if (derivatives) {
      ph_vec3 g = ph_vec3_along(frame[c], -q * m / 2, p);
      put_row((const ph_vec3(*)[2])moved, ph_vec3_scale(scale, g), c, row);
    }
  }
}

static ph_vec3 move(const struct ph_sphere_spline *s, size_t i,
                    const double step[2]) {
  ph_vec3 frame[2];
  frame_at(s, i, frame);
  return normalised(s->data->p[i],
                    ph_vec3_along(ph_vec3_along(s->x[i], step[0], frame[0]),
                                  step[1], frame[1]));
}

static double reach(const struct ph_sphere_spline *s, size_t i) {
  return size_at(s->data, i);
}

/* ---- starts -------------------------------------------------------------- */

/* d = P, but next to ends with a velocity. */
static void hug(struct ph_sphere_spline *s, struct ph_sphere_range range) {
  const struct ph_sphere_data *d = s->data;
  for (size_t j = 0; j < range.count; j++) {
    s->x[ph_sphere_node(d, range, j)] = ph_vec3_of(0, 0, 0);
  }
  for (size_t e = 0; !d->closed && e < 2; e++) {
    size_t i = e == 0 ? 0 : d->n - 1;
    bool clamped = d->ends == PH_SPHERE_CLAMPED;
    double h = e == 0 ? d->h[0] : -d->h[d->m - 1];
    ph_vec3 u = ph_vec3_scale(clamped ? h / 3 : 0, d->end[e]);
    double x = ph_vec3_dot(u, u), half = ph_s2_f0(x / 4);
    s->x[i] = ph_vec3_along(ph_vec3_scale(ph_s2_f0(x), u), -x / 2 * half * half,
                            d->p[i]);
  }
}

/*
 * Where angles stand still, (2) is linear in d, for each coordinate:
 *   lo d_{i-1} + di d_i + up d_{i+1} = P_i.                            (5)
 * linearise: (5) at the nodes of a range, for the change of d.
 *
 * out  weight[j]  lo, di, up
 * out  rest[j]    what the change has to make up for
 * ret  root mean square of the rests, relative to the spacings
 */
static double linearise(struct ph_sphere_spline *s,
                        struct ph_sphere_range range, ph_vec3 *weight,
                        ph_vec3 *rest) {
  const struct ph_sphere_data *d = s->data;
  struct ph_sphere_part left, right;
  struct mix a[2], b[2];
  double sum = 0;
  control(s, ph_sphere_before(d, range.first), false, &left, a);
  for (size_t k = 0; k < range.count; k++) {
    size_t i = ph_sphere_node(d, range, k);
    struct joint j;
    double near, far, scale = 1 / size_at(d, i);
    control(s, i, false, &right, b);
    j = joint_of(s, i, &left, &right, false);
    far = j.mix.w;
    near = 1 + j.mix.c - far;
    weight[k] =
        ph_vec3_of(near * a[1].w,
                   near * (1 + a[1].c - a[1].w) + far * (1 + b[0].c - b[0].w),
                   far * b[0].w);
    rest[k] = ph_vec3_scale(-1, j.miss);
    sum += scale * scale * ph_vec3_dot(j.miss, j.miss);
    left = right;
    a[1] = b[1];
  }
  return sqrt(sum / (double)range.count);
}

/* A row of (5): of the coordinates x and y, or of z. */
static struct ph_block2_row row_of(const ph_vec3 *weight, const ph_vec3 *rest,
                                   bool xy) {
  struct ph_block2_row row = {{weight->x, 0, 0, weight->x},
                              {weight->y, 0, 0, weight->y},
                              {weight->z, 0, 0, weight->z},
                              {xy ? rest->x : rest->z, xy ? rest->y : 0}};
  return row;
}

/* (5) solved for all d at once: Picard's iteration. */
static void picard(struct ph_sphere_spline *s, struct ph_sphere_range range,
                   struct ph_sphere_work *work) {
  const struct ph_sphere_data *d = s->data;
  ph_vec3 *weight = work->before, *rest = work->kept;
  size_t n = range.count;
  linearise(s, range, weight, rest);
  if (n < d->n) {
    weight[0].x = 0;
    weight[n - 1].z = 0;
  }
  for (int xy = 1; xy >= 0; xy--) {
    struct ph_block2_row row = row_of(&weight[0], &rest[0], xy),
                         last = row_of(&weight[n - 1], &rest[n - 1], xy);
    ph_block2_begin(&work->system, n, &row, &last);
    for (size_t j = 1; j + 1 < n; j++) {
      row = row_of(&weight[j], &rest[j], xy);
      ph_block2_push(&work->system, &row);
    }
    ph_block2_finish(&work->system, work->step);
    for (size_t j = 0; j < n; j++) {
      ph_vec3 *x = &s->x[ph_sphere_node(d, range, j)];
      *x =
          ph_vec3_add(*x, xy ? ph_vec3_of(work->step[j][0], work->step[j][1], 0)
                             : ph_vec3_of(0, 0, work->step[j][0]));
    }
  }
  for (size_t j = 0; j < n; j++) {
    size_t i = ph_sphere_node(d, range, j);
    s->x[i] = normalised(d->p[i], s->x[i]);
  }
}

static bool start(struct ph_sphere_spline *s, struct ph_sphere_range range,
                  size_t which, struct ph_sphere_work *work) {
  hug(s, range);
  if (which == 0 && range.count > 0) {
    for (int i = 0; i < PICARD_STEPS && !ph_arena_late(work->arena); i++) {
      picard(s, range, work);
    }
  }
  return which < 2;
}

/* Sweeps of (5), each d_i for itself from the last ones of its neighbours: slow
 * and, unlike Newton's iteration, not stopped by neighbours that become
 * antipodal on the way [IOR15, sec. 3.2]. */
static bool last_resort(struct ph_sphere_spline *s,
                        struct ph_sphere_range range,
                        struct ph_sphere_work *work) {
  ph_vec3 *weight = work->before, *rest = work->kept;
  hug(s, range);
  for (int sweep = 0; sweep < SWEEPS_MAX && !ph_arena_late(work->arena);
       sweep++) {
    if (linearise(s, range, weight, rest) <= SWEPT) {
      break;
    }
    for (size_t j = 0; j < range.count; j++) {
      size_t i = ph_sphere_node(s->data, range, j);
      ph_vec3 x = ph_vec3_along(s->x[i], 1 / weight[j].y, rest[j]);
      s->x[i] = normalised(s->data->p[i], x);
    }
  }
  return ph_sphere_newton(s, range, work);
}

/* The shorter leg is as the longer one goes on, by (2): of that, rounding of d
 * tells more, above all where d_i and d_{i+1} are nearly antipodal. */
static void join(struct ph_sphere_spline *s, size_t i) {
  const struct ph_sphere_data *d = s->data;
  const double a = ph_sphere_left(d, i), b = ph_sphere_right(d, i);
  ph_vec3 p = d->p[i], *l = &s->l[ph_sphere_before(d, i)], *r = &s->r[i];
  ph_vec3 v = ph_s2_log(p, ph_vec3_add(p, a > b ? *l : *r));
  v = ph_vec3_scale(a > b ? -b / a : -a / b, v);
  *(a > b ? r : l) = ph_vec3_sub(ph_s2_exp(p, v), p);
}

const struct ph_sphere_model ph_sphere_nielson = {
    "nielson", segment, node, NULL, move, reach, hug, start, last_resort, join};
