/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Problems on the sphere for tests, and curves that solve them: circles of
 * latitude, arcs, and four splines on the unit sphere, solved by a program in
 * another language with other formulas: points of [IOR15, sec. 5], cases 19, 11
 * and 4, and a loop around the sphere.
 */
#ifndef PH_TESTS_CERT_SPHERE_UNIT_H
#define PH_TESTS_CERT_SPHERE_UNIT_H

#include "unit.h"

#include "curve/problem.h"
#include "curve/result.h"
#include "kernel/vec3.h"

/* A spline on the unit sphere. */
struct unit_spline {
  bool nielson; /* or exact */
  bool rest;    /* or natural */
  bool closed;
  bool shape; /* whether the criteria hold, with epsilon = 0.01 */
  size_t n;
  double points[3 * 7], tensions[7];
  signed char indicators[7];
  double inner[6 * 7]; /* the control points R and L of each segment */
  double lengths[7];
};

static const struct unit_spline UNIT_SPLINES[] = {
    {false,
     false,
     false,
     true,
     6,
     {0.44152515873825748, 0.86429331073294768, 0.24094108662375741,
      0.51234221984378814, 0.45346219457862885, 0.72929931293912054,
      0.87501017275327542, 0.47246809327938488, 0.1055040208296609,
      0.76866029543540992, 0.55549321350441305, 0.31715712189968037,
      0.87601433644651083, 0.48047518453373722, 0.041743016032034536,
      0.21217305870256478, 0.9656822671782469, 0.14980104144590925},
     {0, 3, 10, 25, 15, 0},
     {0, 1, 1, -1, 1, 0},
     {0.43781917233223483, 0.71930456390434183, 0.53936566138817343,
      0.38591249206691891, 0.4951256370485444,  0.77841001535435905,
      0.64264089986134842, 0.39546248363088798, 0.65621802616652181,
      0.91800997946297769, 0.39655628808797566, -0.00088768478052732303,
      0.85652180124473964, 0.49636181534473095, 0.14140492304071239,
      0.77199774137073074, 0.55324091869010339, 0.31296001854137878,
      0.76456504867176001, 0.55820792067780034, 0.32224866740161412,
      0.86549167019597473, 0.49088289517347922, 0.099790540871796424,
      0.88867588123996744, 0.44241309378856802, -0.12052316186855758,
      0.61583045567556538, 0.78770844601450163, 0.016378459629779948},
     {0.70352733599775208, 0.79027421519182828, 0.25183689103799978,
      0.30667062945979734, 0.92427399257079634}},
    {false,
     false,
     false,
     false,
     6,
     {0.82169495831500494, -0.2975399849056482, -0.48609397534021026,
      -0.0037800014697385673, 0.48055518684926385, 0.87695634097779229,
      0.23622011199056431, 0.64982630807882669, 0.72244434250660927,
      -0.059149987063426043, 0.99815978169449426, -0.013353997079374324,
      -0.62825974123180284, -0.2220309085497062, -0.74564869288153401,
      -0.22315098654555796, -0.97318394132382247, -0.055826996634022998},
     {0, 0, 0, 0, 0, 0},
     {0, -1, 1, 1, 1, 0},
     {0.58251775947286244,  -0.50774628671823185,  0.63471786505703798,
      -0.44749230878263296, -0.028630338128146304, 0.89382936700416016,
      0.069784360793016642, 0.5439783708794963,    0.83619236722419266,
      0.1779098671539851,   0.59171618312647134,   0.78626969787439438,
      0.37850843426361003,  0.76951894061266746,   0.51436559491247902,
      0.15530219582953986,  0.95442384960234272,   0.25486534342818712,
      -0.434215084276104,   0.74758789461420694,   -0.50256303128403035,
      -0.57730931114868655, 0.32677249213487869,   -0.74828717591910499,
      -0.55494465389360881, -0.5597475071186373,   -0.6154016244611108,
      -0.42161845944538534, -0.83063335936814453,  -0.36371155736337318},
     {2.7056348759057531, 0.33410392935304356, 0.9443935146914243,
      1.7477289393439663, 1.1620826785214371}},
    {true,
     true,
     false,
     false,
     5,
     {0.58778508448999756, 0, -0.80901711629055573, 0.80901711629055573, -0,
      -0.58778508448999756, 0.80901711629055573, -0, 0.58778508448999756,
      -0.65450896200902842, 0.47552797239797961, 0.58778496588202267,
      0.24999986828197912, 0.18163590430106225, -0.95105649891461697},
     {30, 30, 30, 0, 0},
     {0, 0, -1, -1, 0},
     {0.58778508448999756,    0,
      -0.80901711629055573,   0.77620255132154048,
      4.0850297627861054e-05, -0.6304836220340575,
      0.91596600261931227,    -0.00016221834387952831,
      -0.4012558482200696,    0.84712723781102295,
      -0.0039034175795851374, 0.53137576750343629,
      0.74950927202710693,    0.0054501260332249432,
      0.66197140970862045,    0.006388479895283794,
      0.14580119099709843,    0.98929328312106524,
      -0.79316006450225518,   0.39900344810214372,
      -0.46010146759315829,   0.24999986828197912,
      0.18163590430106225,    -0.95105649891461697},
     {0.31415968425339735, 1.2566538128659124, 1.7811908872188609,
      2.3184485582815997}},
    {false,
     false,
     true,
     false,
     7,
     {1,
      0,
      0,
      0.71984631039295421,
      0.60402277355505363,
      0.34202014332566871,
      0.07139380484326964,
      0.81603492345170836,
      0.57357643635104605,
      -0.6208851530148457,
      0.73994211169384805,
      0.25881904510252074,
      -0.89253893528902994,
      0.1573786956242626,
      -0.42261826174069944,
      -0.26200263022938491,
      -0.71984631039295421,
      -0.64278760968653925,
      0.63302222155948906,
      -0.75440650673548892,
      -0.17364817766693033},
     {0, 4, 0, 2.5, 0.5, 0, 1},
     {1, 1, -1, -1, 1, -1, -1},
     {0.95923211045793089,  0.26836698715359047,  0.088616694096137219,
      0.82862019729765024,  0.50222910963056921,  0.24729433893659747,
      0.59417581994463387,  0.68411605418509369,  0.42301337969305391,
      0.33988876776329657,  0.75797286758543092,  0.55673400969643183,
      -0.21974045830113317, 0.80992219356616346,  0.54381998065038217,
      -0.4750802451575647,  0.78934259848041854,  0.38889204528404686,
      -0.76640430130237314, 0.63696120332120598,  0.083095561908098164,
      -0.88981059786687378, 0.40070378301431403,  -0.21834279974804219,
      -0.77783153253064852, -0.15271440076477086, -0.60963630042844408,
      -0.57062115256472412, -0.44909315924396881, -0.68753678779100769,
      0.058437384413005278, -0.86016565627800046, -0.50665581597649034,
      0.38833678910702735,  -0.88384622535583757, -0.26078801381636013,
      0.79726772133766488,  -0.59698203583494602, -0.089311977939193266,
      0.94583459732351616,  -0.30827689730143404, -0.1017952312049198},
     {0.7711574891141354, 0.73888323326982053, 0.78929194150847981,
      0.97495587622883106, 1.1691248381136758, 1.0688300240839101,
      0.88710840857452655}},
};
enum { UNIT_SPLINES_N = COUNT(UNIT_SPLINES) };

enum { UNIT_SPHERE_MAX = 200 };

/* A problem and its curve. */
struct unit_sphere {
  struct ph_problem problem;
  struct ph_curve curve;
  double points[3 * UNIT_SPHERE_MAX], lonlat[2 * UNIT_SPHERE_MAX], center[3];
  double knots[UNIT_SPHERE_MAX + 1], given_knots[UNIT_SPHERE_MAX + 1];
  double control_points[12 * UNIT_SPHERE_MAX], lengths[UNIT_SPHERE_MAX];
  double tensions[UNIT_SPHERE_MAX], given_tensions[UNIT_SPHERE_MAX],
      end_tangents[6];
  signed char indicators[UNIT_SPHERE_MAX];
};

/* Where the sphere is. */
struct unit_ball {
  double center[3], radius;
};

/* Fields of the problem. */
void unit_sphere_word(struct unit_sphere *u, enum ph_field_id id,
                      const char *word);
void unit_sphere_number(struct unit_sphere *u, enum ph_field_id id,
                        double number);
void unit_sphere_flag(struct unit_sphere *u, enum ph_field_id id, bool flag);
void unit_sphere_numbers(struct unit_sphere *u, enum ph_field_id id, double *v,
                         size_t n);
void unit_sphere_vectors(struct unit_sphere *u, enum ph_field_id id, double *v,
                         size_t n, size_t dimension);

/* unit_sphere_put: a point of the unit sphere, on this one.  out  v[3] */
void unit_sphere_put(const struct unit_ball *sphere, ph_vec3 p, double *v);

/* unit_cert_sphere_of: a spline of the table, with shape=warn. */
void unit_cert_sphere_of(struct unit_sphere *u, const struct unit_spline *s,
                         const struct unit_ball *sphere);

/*
 * unit_sphere_latitude: a circle at z = sin(lat) through n points; its legs are
 * an angle in the horizontal direction, and by symmetry the velocity and what
 * is normal to it are continuous, so that it is the curve of the tension
 *   nu = 2 (S''.T) / (h^2 v),  v = 3 leg / h.
 */
void unit_sphere_latitude(struct unit_sphere *u, size_t n, double lat,
                          double leg, const struct unit_ball *sphere);

/* unit_sphere_arc: two points; the velocities at the ends are turned by these
 * angles from the great circle.  out  end_tangents, no field yet */
void unit_sphere_arc(struct unit_sphere *u, double angle, double turn_from,
                     double turn_to, const struct unit_ball *sphere);

#endif
