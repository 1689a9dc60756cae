/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places on curves and their offsets (see local.h). */
#include "check/local.h"

#include "check/checks.h"
#include "check/dips.h"
#include "check/kind.h"
#include "check/spherical.h"
#include "kernel/pi.h"
#include "kernel/quat.h"

enum { N = PH_CHECK_JET };

/* Lengths, relative. */
static const double LENGTH = 1e-13;

/* Roundings of a parameter and of the few operations that follow. */
static const double PARAMETER = 4 * DBL_EPSILON;

/* Roundings of a distance: of the unit normal, its product and the sum. */
static const double ROUND_DISTANCE = 4 * DBL_EPSILON;

/* A direction that changes by its curvature over its speed does so for its
 * derivatives again, and they are polynomials of some degree. */
static const double NEXT = 8;

/* ---- power series ------------------------------------------------------- */

/* Coefficients of a power series from derivatives. */
static void to_series(ph_vec3 *x) {
  x[2] = ph_vec3_scale(1.0 / 2, x[2]);
  x[3] = ph_vec3_scale(1.0 / 6, x[3]);
}

/* The root of a series with positive start. */
static void root_of(const double *x, double *root) {
  root[0] = sqrt(x[0]);
  for (size_t i = 1; i < N; i++) {
    double sum = x[i];
    for (size_t j = 1; j < i; j++) {
      sum -= root[j] * root[i - j];
    }
    root[i] = sum / (2 * root[0]);
  }
}

/* x / y, in local. */
static void divide(ph_vec3 *x, const double *y) {
  for (size_t i = 0; i < N; i++) {
    for (size_t j = 1; j <= i; j++) {
      x[i] = ph_vec3_along(x[i], -y[j], x[i - j]);
    }
    x[i] = ph_vec3_scale(1 / y[0], x[i]);
  }
}

/* The left normal of a plane curve, from r' as a series. */
static void left_normal(const ph_vec3 *first, ph_vec3 *e) {
  double square[N], speed[N];
  for (size_t i = 0; i < N; i++) {
    square[i] = 0;
    for (size_t j = 0; j <= i; j++) {
      square[i] += ph_vec3_dot(first[j], first[i - j]);
    }
    e[i] = ph_vec3_of(-first[i].y, first[i].x, 0);
  }
  root_of(square, speed);
  divide(e, speed);
}

/* The claimed preimage at unit scale, as a series. */
static void preimage_at(const struct ph_check_path *path, double u,
                        ph_quat *a) {
  const struct ph_check_segment *s = path->s;
  const size_t n = path->v->curve->preimage.n;
  ph_quat w[3];
  double series[2][N], factor = 1;
  ph_check_preimage(path->v, s->k, w);
  ph_check_basis(s->angle, u, N, series);
  for (size_t i = 0; i < N; i++) {
    a[i] = ph_quat_of(0, 0, 0, 0);
  }
  for (size_t i = 0; i < n; i++) {
    double b[N] = {s->angle > 0 && i == 1 ? 2 * cos(s->angle / 2) : factor};
    for (size_t j = 0; j + 1 < n; j++) {
      const double *by = series[j < i];
      for (size_t l = N; l-- > 0;) {
        double sum = 0;
        for (size_t m = 0; m <= l; m++) {
          sum += b[m] * by[l - m];
        }
        b[l] = sum;
      }
    }
    for (size_t l = 0; l < N; l++) {
      a[l] = ph_quat_add(a[l], ph_quat_scale(b[l], w[i]));
    }
    factor *= (double)(n - 1 - i) / (double)(i + 1);
  }
}

/* e2 or e3 of the frame of the preimage; NaN where there is none. */
static void frame_normal(const struct ph_check_path *path, double u,
                         ph_vec3 *e) {
  ph_quat a[N];
  double square[N];
  if (!path->v->curve->preimage.v) {
    const double none = (double)NAN;
    for (size_t i = 0; i < N; i++) {
      e[i] = ph_vec3_of(none, none, none);
    }
    return;
  }
  preimage_at(path, u, a);
  for (size_t i = 0; i < N; i++) {
    square[i] = 0;
    e[i] = ph_vec3_of(0, 0, 0);
    for (size_t j = 0; j <= i; j++) {
      square[i] += ph_quat_dot(a[j], a[i - j]);
      e[i] = ph_vec3_add(e[i], path->binormal ? ph_quat_k(a[j], a[i - j])
                                              : ph_quat_j(a[j], a[i - j]));
    }
  }
  divide(e, square);
}

static void across(const struct ph_check_path *path, double u,
                   const ph_vec3 *first, ph_vec3 *e) {
  if (path->v->curve->dimension == 2) {
    left_normal(first, e);
  } else {
    frame_normal(path, u, e);
  }
}

/* ---- what moves --------------------------------------------------------- */

/* Derivatives of o, and by how much they may be off. */
struct motion {
  ph_vec3 jet[N - 1];
  double error[N - 1];
};

/* How far a unit vector may be from its place if it is that of a vector which
 * is off by this part of it: it turns by asin(error), or to any side. */
static double chord_of(double error) {
  return error < 1 ? error * sqrt(2 / (1 + sqrt(1 - error * error))) : 2;
}

/* Adds d e; derivatives of e are as uncertain as the direction of r', more so
 * where it changes fast.  Where that is not known, nor is how fast. */
static void displace(const struct ph_check_path *path, double u,
                     const ph_vec3 *r, struct motion *m,
                     struct ph_check_local *local) {
  double d = path->distance, speed = ph_vec3_abs(r[0]), factorial = 1;
  bool known = m->error[0] < PH_CHECK_NO_DIRECTION * speed;
  double error = known ? fabs(d) * (m->error[0] / speed + PARAMETER) : HUGE_VAL;
  double fast =
      NEXT + 2 * ph_vec3_abs(r[1]) / speed + sqrt(ph_vec3_abs(r[2]) / speed);
  ph_vec3 e[N];
  across(path, u, r, e);
  local->point = ph_vec3_along(local->point, d, e[0]);
  local->side_error = chord_of(m->error[0] / speed);
  local->point_error += fabs(d) * (local->side_error + PARAMETER);
  for (size_t i = 0; i + 1 < N; i++) {
    factorial *= (double)(i + 1);
    m->jet[i] = ph_vec3_along(m->jet[i], d * factorial, e[i + 1]);
    error *= fast;
    m->error[i] += error;
  }
}

/* Brings the derivatives of a far offset near 1, as their products would leave
 * the range of a double.  ret  what they were multiplied by */
static double bring_near(struct motion *m) {
  double largest = ph_check_larger(fabs(m->jet[0].x), fabs(m->jet[0].y));
  double scale;
  largest = ph_check_larger(largest, fabs(m->jet[0].z));
  if (!(largest > 1) || !isfinite(largest)) {
    return 1;
  }
  scale = ldexp(1, -ph_pow2_exponent(largest));
  for (size_t i = 0; i + 1 < N; i++) {
    m->jet[i] = ph_vec3_scale(scale, m->jet[i]);
    m->error[i] *= scale;
  }
  return scale;
}

/*
 * Speed, tangent, curvature and torsion of what moves so.
 *
 * Numbers b and b' that are both within e of a speed have
 *   |1/b - 1/b'| <= 2 e / (b (b - 2 e)),                                (2)
 * and a curvature is a quotient by a speed^3: so two that are right are no
 * farther apart than twice what the first order says over (1 - 2 e / b)^3.
 * [Derived here]
 */
static void curvatures(const struct ph_check_path *path, struct motion *m,
                       struct ph_check_local *local) {
  double scale = bring_near(m);
  double speed = ph_vec3_abs(m->jet[0]), square = speed * speed;
  double second = ph_vec3_abs(m->jet[1]);
  ph_vec3 turn = ph_vec3_cross(m->jet[0], m->jet[1]);
  double area = ph_vec3_abs(turn);
  double error = speed * m->error[1] + second * m->error[0];
  double slower = 1 - 2 * m->error[0] / speed;
  local->speed = speed / scale;
  local->tangent = ph_vec3_scale(1 / speed, m->jet[0]);
  local->tangent_error = m->error[0] / speed;
  local->curvature =
      (path->v->curve->dimension == 2 ? turn.z : area) / (square * speed);
  local->curvature_error = (m->error[1] + 4 * second * local->tangent_error) /
                           (square * slower * slower * slower);
  local->flat = error / area;
  local->torsion = ph_vec3_dot(turn, m->jet[2]) / (area * area);
  local->torsion_error =
      (area * m->error[2] + ph_vec3_abs(m->jet[2]) * error) / (area * area) +
      2 * fabs(local->torsion) * local->flat;
  local->curvature *= scale;
  local->curvature_error *= scale;
  local->torsion *= scale;
  local->torsion_error *= scale;
}

struct ph_check_local ph_check_form_local(const struct ph_check_path *path,
                                          double u) {
  const struct ph_check_segment *s = path->s;
  struct ph_check_local local;
  struct motion m;
  ph_vec3 r[N], direction;
  ph_check_jet(s, u, r, N);
  for (size_t i = 0; i + 1 < N; i++) {
    m.jet[i] = r[i];
    m.error[i] = ph_check_uncertain(s, i + 1) +
                 PARAMETER * (ph_vec3_abs(r[i]) + ph_vec3_abs(r[i + 1]));
  }
  direction = ph_vec3_unit(r[0]);
  local.point = ph_check_point(path->v, s, u);
  local.point_error = s->noise + PARAMETER * s->speed;
  local.side_error = 0;
  if (fabs(path->distance) > 0) {
    to_series(r);
    displace(path, u, r, &m, &local);
  }
  local.speed_error = m.error[0];
  local.along = ph_vec3_dot(m.jet[0], direction);
  local.along_error = m.error[0];
  curvatures(path, &m, &local);
  return local;
}

/* (1); the curve itself is at some point also where it is at rest. */
static void parallel(const struct ph_check_path *path, const ph_vec3 jet[3],
                     double turn, struct ph_check_local *local) {
  const struct ph_check_segment *s = path->s;
  double d = path->distance;
  ph_vec3 on = jet[0];
  local->point_error = s->noise + PARAMETER * s->speed;
  local->along = s->radius * ph_vec3_abs(jet[1]);
  if (fabs(d) > 0) {
    ph_vec3 left = ph_vec3_cross(jet[0], local->tangent);
    on = ph_vec3_along(ph_vec3_scale(cos(d), jet[0]), sin(d), left);
    local->side_error = chord_of(local->tangent_error);
    local->point_error += s->radius * fabs(sin(d)) * local->side_error;
    local->along = cos(d) * local->along - s->radius * sin(d) * turn;
  }
  local->point = ph_vec3_along(s->center, s->radius, on);
}

struct ph_check_local ph_check_great_local(const struct ph_check_path *path,
                                           double u) {
  const struct ph_check_segment *s = path->s;
  struct ph_check_local local = {.torsion = 0};
  double d = path->distance, noise, speed, turn, error, next, top, bottom, down;
  ph_vec3 jet[3];
  noise = s->noise / s->radius * ph_check_great(s->p, s->x, u, jet);
  speed = ph_vec3_abs(jet[1]);
  error = noise + PARAMETER * ph_vec3_abs(jet[2]);
  next = PH_CHECK_ROUND_NEXT * noise;
  turn = ph_vec3_dot(jet[0], ph_vec3_cross(jet[1], jet[2])) / (speed * speed);
  local.flat = (next + 2 * ph_vec3_abs(jet[2]) * error / speed) * speed /
               ph_vec3_abs(ph_vec3_cross(jet[1], jet[2]));
  next = next / speed + 4 * ph_vec3_abs(jet[2]) * error / (speed * speed);
  local.tangent = ph_vec3_scale(1 / speed, jet[1]);
  local.tangent_error = error / speed;
  parallel(path, jet, turn, &local);
  down = fabs(d) > 0 ? error + fabs(sin(d)) * next : error;
  local.along_error = local.speed_error = s->radius * down;
  local.speed = fabs(local.along);
  if (local.along < 0) {
    local.tangent = ph_vec3_scale(-1, local.tangent);
  }
  /* kappa = turn / speed; cot(rho - d) = (cos d kappa + sin d) /
   * (cos d - sin d kappa); its error by (2), of the speed itself */
  top = cos(d) * turn + sin(d) * speed;
  bottom = local.speed / s->radius;
  local.curvature = top / (bottom * s->radius);
  local.curvature_error = (error + next + fabs(top) * down / bottom) /
                          ((bottom - 2 * down) * s->radius);
  return local;
}

/* Where a speed may vanish errors say nothing, and where r' x r'' may, nothing
 * of the torsion, whose error is that of the first order. */
struct ph_check_local ph_check_local_at(const struct ph_check_path *path,
                                        double u) {
  struct ph_check_local local = path->s->kind->local(path, u);
  if (!(local.speed_error < PH_CHECK_NO_DIRECTION * local.speed)) {
    local.curvature_error = local.torsion_error = HUGE_VAL;
  }
  if (!(local.flat < PH_CHECK_NO_DIRECTION)) {
    local.torsion_error = HUGE_VAL;
  }
  return local;
}

/* The point nearest to the one that was found at the distance of the path from
 * a point of its curve: round that in any direction. */
static ph_vec3 nearest_about(const struct ph_check_path *path, ph_vec3 on,
                             ph_vec3 found) {
  const struct ph_check_segment *s = path->s;
  const bool sphere = path->v->kind->sphere;
  ph_vec3 from = sphere
                     ? ph_vec3_scale(1 / s->radius, ph_vec3_sub(on, s->center))
                     : ph_vec3_of(0, 0, 0);
  ph_vec3 away = ph_vec3_normal(ph_vec3_sub(found, on), from);
  double d = path->distance, far = ph_check_apart(away, ph_vec3_of(0, 0, 0));
  away = far > 0  ? ph_vec3_scale(1 / far, away)
         : sphere ? ph_vec3_any_normal(from)
                  : ph_vec3_of(1, 0, 0);
  return sphere ? ph_vec3_along(s->center, s->radius,
                                ph_vec3_along(ph_vec3_scale(cos(d), from),
                                              fabs(sin(d)), away))
                : ph_vec3_along(on, fabs(d), away);
}

struct ph_check_local ph_check_local_beside(const struct ph_check_path *path,
                                            double u, ph_vec3 found) {
  struct ph_check_local local = ph_check_local_at(path, u);
  if (!(local.side_error < 2)) {
    const struct ph_check_segment *s = path->s;
    const ph_vec3 on = ph_check_point(path->v, s, u);
    local.point = nearest_about(path, on, found);
    local.point_error =
        s->noise + PARAMETER * s->speed + ROUND_DISTANCE * fabs(path->distance);
  }
  return local;
}

ph_vec3 ph_check_across(const struct ph_check_path *path, double u) {
  ph_vec3 r[N], e[N];
  ph_check_jet(path->s, u, r, N);
  to_series(r);
  across(path, u, r, e);
  return e[0];
}

/* ---- length ------------------------------------------------------------- */

/* Coefficients of a preimage are rounded, and so are products of them. */
static const double PREIMAGE = 8 * DBL_EPSILON;

/* Whether there is a preimage w of a plane curve: where it is slow, r' = w^2 is
 * rounding of the control points before w is. */
static bool has_root(const struct ph_check_path *path) {
  return path->v->curve->dimension == 2 && path->v->curve->preimage.v;
}

/* A number, and by how much it may be off. */
struct known {
  double value, error;
};

/* The speed | |w|^2 - d theta' |, theta' = 2 w x w' / |w|^2. */
static struct known speed_by_root(const struct ph_check_path *path, double u) {
  ph_quat w[N];
  double noise = PREIMAGE * sqrt(path->s->speed), size, rate, turn;
  preimage_at(path, u, w);
  size = sqrt(ph_quat_dot(w[0], w[0]));
  rate = sqrt(ph_quat_dot(w[1], w[1])) / size;
  turn = 2 * (w[0].u * w[1].q - w[0].q * w[1].u) / (size * size);
  return (struct known){
      fabs(size * size - path->distance * turn),
      2 * noise * (size + fabs(path->distance) * (2 * rate + NEXT) / size)};
}

/* Of the control points and the preimage, what knows it better. */
static void speed_at(const void *context, double u, double *value) {
  const struct ph_check_path *path = context;
  const struct ph_check_local local = ph_check_local_at(path, u);
  struct known speed = {local.speed, local.speed_error};
  if (has_root(path)) {
    struct known by_root = speed_by_root(path, u);
    speed = by_root.error < speed.error ? by_root : speed;
  }
  value[0] = speed.value;
  value[1] = speed.error;
}

/* Whether the curve has a direction at u, as far as that is known. */
static bool has_direction(const struct ph_check_path *path, double u) {
  struct ph_check_path curve = *path;
  ph_quat w[N];
  curve.distance = 0;
  if (ph_check_local_at(&curve, u).tangent_error < PH_CHECK_NO_DIRECTION) {
    return true;
  }
  if (!has_root(path)) {
    return false;
  }
  preimage_at(path, u, w);
  return PREIMAGE * sqrt(path->s->speed) <
         PH_CHECK_NO_DIRECTION * sqrt(ph_quat_dot(w[0], w[0]));
}

/* The integral over [from,to], where there is no cusp.  Where the curve all but
 * stands still at an end, it may turn there by a half. */
static double between_cusps(const struct ph_check_path *path, double from,
                            double to, double *error) {
  const struct ph_check_integrands of = {speed_at, path,           2,
                                         1,        path->s->noise, LENGTH};
  const double far =
      fabs(path->distance) * (path->v->kind->sphere ? path->s->radius : 1);
  double sum[2];
  ph_check_integral(&path->v->rule, &of, from, to, sum);
  *error += isfinite(sum[1]) ? sum[1] : path->v->scale.size;
  for (int end = 0; end < 2; end++) {
    if (!has_direction(path, end ? to : from)) {
      *error += PH_PI * far;
    }
  }
  return sum[0];
}

/* The first cusp after a local. */
static size_t cusp_after(const struct ph_check_path *path, double u) {
  const struct ph_cusps *cusps = path->cusps;
  size_t low = 0, high = cusps ? cusps->n : 0;
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    const struct ph_place *at = &cusps->at[middle];
    if (at->segment < path->s->k ||
        (at->segment == path->s->k && at->t <= u * path->s->unit)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

/* Steps of Newton's method to where |w| is least, and how far they may lead. */
enum { STEPS = 4 };
static const double SLOWEST = 1e-4;

struct ph_check_dips ph_check_path_slow(const struct ph_check_path *path) {
  struct ph_check_dips slow = ph_check_slow_of(path->s);
  for (size_t i = 0; i < slow.n && has_root(path); i++) {
    ph_quat a[N];
    double u = slow.x[i];
    for (int step = 0; step < STEPS; step++) {
      preimage_at(path, u, a);
      u -= ph_quat_dot(a[0], a[1]) / ph_quat_dot(a[1], a[1]);
    }
    slow.x[i] = fabs(u - slow.x[i]) < SLOWEST ? u : slow.x[i];
  }
  return slow;
}

static double between(const struct ph_check_path *path, double from, double to,
                      double *error) {
  return fabs(path->distance) > 0
             ? between_cusps(path, from, to, error)
             : ph_check_length_of(path->v, path->s, from, to);
}

/* The integral over [from,to], where there is no cusp, from one place where the
 * curve all but stands still to the next: the offset turns there, and the speed
 * on a sphere has a corner. */
static double from_dip_to_dip(const struct ph_check_path *path,
                              const struct ph_check_dips *slow, double from,
                              double to, double *error) {
  double length = 0;
  for (size_t i = 0; i < slow->n; i++) {
    if (slow->x[i] > from && slow->x[i] < to) {
      length += between(path, from, slow->x[i], error);
      from = slow->x[i];
    }
  }
  return length + between(path, from, to, error);
}

double ph_check_path_length(const struct ph_check_path *path,
                            const struct ph_check_dips *slow, double from,
                            double to, double *error) {
  const struct ph_cusps *cusps = path->cusps;
  double length = 0;
  for (size_t i = cusp_after(path, from);
       cusps && i < cusps->n && cusps->at[i].segment == path->s->k &&
       cusps->at[i].t < to * path->s->unit;
       i++) {
    double u = cusps->at[i].t / path->s->unit;
    if (u > from) { /* in order, as they should be */
      length += from_dip_to_dip(path, slow, from, u, error);
      from = u;
    }
  }
  return length + from_dip_to_dip(path, slow, from, to, error);
}
