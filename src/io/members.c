/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of members (see members.h). */
#include "io/members_rows.h"

#include <string.h>

/* Of every record. */
#define HEADING                                                           \
  ROW("id", MAY, ANY, "id", "that of the problem"),                       \
      ROW("meta", MAY, ANY, "any", "that of the problem"),                \
      ROW("command", MUST, ANY, "command", "the command"),                \
      ROW("status", MUST, ANY, "status", "whether it succeeded"),         \
      ROW("file", MAY, ANY, "text", "that the problem stands in"),        \
      ROW("sweep", MAY, ANY, "sweep",                                     \
          "the value of each field that is swept, of FIELD* the factor"), \
      ROW("set", MAY, ANY, "set",                                         \
          "the value of each field that options have set")

/* Of what is solved. */
static const struct ph_member result[] = {
    HEADING,
    {"curve", MUST, ANY, AS("", curve), AT(ph_result, curve.kind),
     "the kind of curve"},
    {"dimension", MUST, ANY, AS("", D), AT(ph_result, curve.dimension),
     "2 in the plane, 3 in space"},
    {"degree", MUST, ANY, AS("", degree), AT(ph_result, curve.degree),
     "of the segments: the number of their control points less one"},
    {"closed", MUST, ANY, AS("", flag), AT(ph_result, curve.closed),
     "whether the curve is closed"},
    {"segments", MUST, ANY, AS("[+]", segment), LIST(ph_result, curve, curve.n),
     "the curve"},
    {"center", MUST, SPHERE, AS("[3]", number),
     AT(ph_result, curve.sphere.center), "of the sphere"},
    {"radius", MUST, SPHERE, AS("", radius), AT(ph_result, curve.sphere.radius),
     "of the sphere"},
    {"tensions", TOLD, SPHERE, AS("[N]", number),
     EACH(ph_result, curve.sphere.tensions), "of each point"},
    {"indicators", TOLD, SPHERE, AS("[N]", sign),
     EACH(ph_result, curve.sphere.indicators),
     "at each point: 1 where the data turn left, -1 right, else 0"},
    {"merged", MAY, ANY, AS("[+]", whole), LIST(ph_result, merged, merged_n),
     "the points that merge joined to others"},
    {"waived", MAY, SPHERE, AS("[+]", index),
     LIST(ph_result, curve.sphere.waived, curve.sphere.waived_n),
     "points where the curve does not keep the shape of the data"},
    {"intervals", MAY, INTERVALS, AS("[+]", interval),
     LIST(ph_result, intervals, intervals_n),
     "between consecutive data, or of each curve that is approximated"},
    {"joints", MAY, CUBIC, AS("[+]", joint),
     LIST(ph_result, curve.g2.joints, curve.g2.joints_n),
     "of curves with continuous curvature: where it jumps"},
    {"auxiliary", MAY, CUBIC, AS("[+]", index),
     LIST(ph_result, curve.g2.auxiliary, curve.g2.auxiliary_n),
     "the segments that begin at points which were added"},
    {"tangent_deviations", MAY, LENGTHS, AS("[+]", number),
     LIST(ph_result, deviations, deviations_n),
     "of tangents that were measured: the angles by which the curve misses "
     "them"},
    {"length", TOLD, ANY, AS("", number), AT(ph_result, curve.length),
     "the arc length of the curve"},
    {"area", MAY, FLAT, AS("", number), AT(ph_result, area),
     "inside of a closed curve in the plane, positive to the left of travel"},
    {"offset_range", MAY, FLAT, AS("[2]", open), EACH(ph_result, offset_range),
     "the distances to the left and right up to which its offsets are regular; "
     "null: all are"},
    {"offsets", MAY, ANY, AS("[+]", offset),
     LIST(ph_result, offsets, offsets_n),
     "one for each distance, in space four"},
    {"nurbs", MAY, ANY, AS("[+]", chain), LIST(ph_result, nurbs.v, nurbs.n),
     "the curve as B-splines, one for each chain"},
    {"frame", MAY, SPACE, AS("", frame), AT(ph_result, samples.frame),
     "which frame the samples have"},
    {"samples", MAY, ANY, AS("[+]", sample),
     LIST(ph_result, samples, samples.n), "of the curve, in its order"},
    {"diagnostics", TOLD, ANY, AS("", certificate), AT(ph_result, diagnostics),
     "the certificate of the curve, and how it was found"},
    {"solutions", MAY, ANY, AS("[+]", solution),
     LIST(ph_result, solutions, solutions_n),
     "all curves that were found, the first is that of the record"},
    {"warnings", MAY, ANY, AS("[+]", warning),
     LIST(ph_result, warnings, warnings_n), "if there are any"},
    LAST};

/* Of a surface. */
static const struct ph_member surface[] = {
    HEADING,
    {"surface", MUST, ANY, AS("", curve), AT(ph_result, curve.kind),
     "the kind of surface"},
    {"closed", MUST, ANY, AS("", flag), AT(ph_result, curve.closed),
     "whether the last strip leads to the first"},
    {"height", TOLD, ANY, AS("[2]", number),
     AT(ph_result, curve.surface.height),
     "the part of the rulings that is meant, from the given points"},
    {"merged", MAY, ANY, AS("[+]", whole), LIST(ph_result, merged, merged_n),
     "the points that merge joined to others"},
    {"strips", MUST, ANY, AS("[+]", strip),
     LIST(ph_result, curve.surface.strips, curve.n), "the surface"},
    {"pairs", MAY, ANY, AS("[+]", pair),
     LIST(ph_result, curve.surface.pairs, curve.surface.pairs_n),
     "two strips each, from one contact element to the next"},
    {"length", TOLD, ANY, AS("", number), AT(ph_result, curve.length),
     "the arc length of the contact curve"},
    {"area", TOLD, ANY, AS("", number), AT(ph_result, curve.surface.area),
     "of the height"},
    {"offsets", MAY, ANY, AS("[+]", parallel),
     LIST(ph_result, parallels, parallels_n), "one for each distance"},
    {"samples", MAY, ANY, AS("[+]", node), LIST(ph_result, grid.v, grid.n),
     "strip by strip, along it, and across"},
    {"located", MAY, ANY, AS("[+]", located),
     LIST(ph_result, located.v, located.n),
     "the points of flat that are on the surface, in their order"},
    {"panorama", MAY, ANY, AS("", panorama),
     LIST(ph_result, panorama, panorama.width), "the volume on the surface"},
    {"diagnostics", TOLD, ANY, AS("", certificate), AT(ph_result, diagnostics),
     "the certificate of the surface, and how it was found"},
    {"warnings", MAY, ANY, AS("[+]", warning),
     LIST(ph_result, warnings, warnings_n), "if there are any"},
    LAST};

/* Of a surface of patches. */
static const struct ph_member patchwork[] = {
    HEADING,
    {"surface", MUST, ANY, AS("", curve), AT(ph_result, curve.kind),
     "the kind of surface"},
    {"closed", MUST, ANY, AS("", flag), AT(ph_result, curve.closed),
     "whether every edge has two faces"},
    {"continuity", MUST, ANY, AS("", continuity),
     AT(ph_result, curve.surface.continuity),
     "across edges: 0 of points, 1 of normals, 2 of curvatures"},
    {"patches", MUST, ANY, AS("[+]", patch),
     LIST(ph_result, curve.surface.patches, curve.n),
     "the surface, in the order of the faces"},
    {"vertices", MAY, ANY, AS("[+]", patch_vertex),
     LIST(ph_result, curve.surface.vertices, curve.surface.vertices_n),
     "of a surface without control points: the points of the mesh"},
    {"area", TOLD, ANY, AS("", number), AT(ph_result, curve.surface.area),
     "of the surface"},
    {"volume", MAY, ANY, AS("", number), AT(ph_result, curve.surface.volume),
     "inside of a closed surface, by the orientation of the faces"},
    {"offsets", MAY, ANY, AS("[+]", beside),
     LIST(ph_result, parallels, parallels_n), "one for each distance"},
    {"samples", MAY, ANY, AS("[+]", patch_sample),
     LIST(ph_result, places.v, places.n), "patch by patch, u fastest"},
    {"edges", MAY, ANY, AS("[+]", patch_edge),
     LIST(ph_result, curve.surface.edges.v, curve.surface.edges.n),
     "of the mesh"},
    {"diagnostics", TOLD, ANY, AS("", certificate), AT(ph_result, diagnostics),
     "the certificate of the surface, and how it was found"},
    {"warnings", MAY, ANY, AS("[+]", warning),
     LIST(ph_result, warnings, warnings_n), "if there are any"},
    LAST};

#include "io/members_patch.def"

static const struct ph_member parallel[] = {
    {"distance", MUST, ANY, AS("", number), AT(ph_parallel, distance),
     "along the normals"},
    {"strips", MUST, ANY, AS("[+]", strip),
     LIST(ph_parallel, curve.surface.strips, curve.n), "the surface"},
    {"length", TOLD, ANY, AS("", number), AT(ph_parallel, curve.length),
     "the arc length of its contact curve"},
    {"area", TOLD, ANY, AS("", number), AT(ph_parallel, curve.surface.area),
     "of the height"},
    {"samples", MAY, ANY, AS("[+]", node), LIST(ph_parallel, grid.v, grid.n),
     "strip by strip, along it, and across"},
    LAST};

static const struct ph_member strip[] = {
    {"pair", MUST, ANY, AS("", whole), AT(ph_strip, pair),
     "that it is one of two strips of"},
    {"method", MUST, ANY, AS("", strip_method), AT(ph_strip, method),
     "what the strip is a piece of"},
    {"frame", MUST, ANY, AS("", strip_frame), AT(ph_strip, frame),
     "at its start"},
    {"geodesic_curvature", MUST, CIRCULAR, AS("", number), AT(ph_strip, k),
     "of the contact curve, positive towards the ruling"},
    {"normal_curvature", MUST, CIRCULAR, AS("", number), AT(ph_strip, kn),
     "of the contact curve, positive towards the normal"},
    {"alpha", MUST, GENERAL, AS("", positive), EACH(ph_strip, alpha),
     "the angle of the directrix"},
    {"angles", MAY, DIRECTRIX, AS("[2]", number), EACH(ph_strip, angles),
     "theta and beta of the directrix"},
    {"control_points", MUST, DIRECTRIX, AS("[6][3]", number),
     EACH(ph_strip, control_points),
     "of the directrix, the contact curve: coefficients in its B-basis"},
    {"preimage", MUST, DIRECTRIX, AS("[3][4]", number),
     EACH(ph_strip, preimage),
     "coefficients of the function whose square is its derivative"},
    {"length", MUST, ANY, AS("", number), AT(ph_strip, length),
     "the arc length of the contact curve"},
    {"vertex", TOLD, ANY, AS("[3]", open), AT(ph_strip, vertex),
     "of the cone, null of a cylinder, and beside a general cone"},
    {"half_angle", TOLD, CIRCULAR, AS("", number), AT(ph_strip, half_angle),
     "between the axis and the rulings"},
    {"sweep", TOLD, CIRCULAR, AS("", number), AT(ph_strip, sweep),
     "angle about the axis"},
    {"development_angle", TOLD, ANY, AS("", number),
     AT(ph_strip, development_angle), "by which the development turns"},
    {"turn", TOLD, GENERAL, AS("", number), AT(ph_strip, turn),
     "by which the tangents of the rulings' spherical image turn, either way"},
    {"F1", MAY, GENERAL, AS("", number), AT(ph_strip, fairness[0]),
     "the functional F1 of the directrix"},
    {"F2", MAY, GENERAL, AS("", number), AT(ph_strip, fairness[1]),
     "the functional F2 of the directrix"},
    {"F3", MAY, GENERAL, AS("", number), AT(ph_strip, fairness[2]),
     "the functional F3 of the directrix"},
    {"shift", TOLD, ANY, AS("[2]", number), AT(ph_strip, shift),
     "of the contact curve along the ruling, from the height 0, at its start "
     "and its end"},
    {"contact", TOLD, CIRCULAR, AS("", arc3), AT(ph_strip, contact),
     "the contact curve"},
    {"development", TOLD, ANY, AS("", arc2), AT(ph_strip, development),
     "the same in the plane"},
    LAST};

static const struct ph_member strip_frame[] = {
    {"point", MUST, ANY, AS("[3]", number), AT(ph_strip_frame, point),
     "of the contact curve"},
    {"ruling", MUST, ANY, AS("[3]", number), AT(ph_strip_frame, ruling),
     "unit vector"},
    {"tangent", MUST, ANY, AS("[3]", number), AT(ph_strip_frame, tangent),
     "of the contact curve"},
    {"normal", MUST, ANY, AS("[3]", number), AT(ph_strip_frame, normal),
     "ruling x tangent"},
    LAST};

static const struct ph_member arc3[] = {
    {"control_points", MUST, ANY, AS("[3][3]", number),
     AT(ph_arc3, control_points), "of a rational Bezier curve"},
    {"weights", MUST, ANY, AS("[3]", number), AT(ph_arc3, weights),
     "of the points"},
    LAST};

static const struct ph_member arc2[] = {
    {"control_points", MUST, CIRCULAR, AS("[3][2]", number),
     AT(ph_arc2, control_points), "of a rational Bezier curve"},
    {"weights", MUST, CIRCULAR, AS("[3]", number), AT(ph_arc2, weights),
     "of the points"},
    {"samples", MUST, GENERAL, AS("[+]", flat_sample),
     LIST(ph_arc2, samples, samples_n),
     "of the directrix laid flat, its chords within the tolerance"},
    {"angle", MUST, ANY, AS("", number), AT(ph_arc2, angle),
     "of the tangent at the start, from the x axis; the ruling is to its left"},
    LAST};

static const struct ph_member flat_sample[] = {
    {"t", MUST, ANY, AS("", number), AT(ph_flat_sample, t),
     "the local parameter of the directrix, from 0 to alpha"},
    {"point", MUST, ANY, AS("[2]", number), AT(ph_flat_sample, point),
     "the point"},
    LAST};

static const struct ph_member pair[] = {
    {"case", TOLD, ANY, AS("", case), AT(ph_pair, which),
     "how its contact elements lie to one another"},
    {"lambda", TOLD, ANY, AS("[2]", open), AT(ph_pair, lambda),
     "legs of both arcs, null where there is none"},
    {"center", TOLD, ANY, AS("[3]", open), AT(ph_pair, center),
     "of the sphere that touches both tangent planes, or null"},
    {"radius", MAY, ANY, AS("", number), AT(ph_pair, radius),
     "of it, positive if it is on the side of the normals"},
    LAST};

/* A place of a surface, in a struct or a member of it. */
#define NODE(type, in)                                                          \
  {"strip", MUST, ANY, AS("", index), AT(type, in strip), "of the surface"},    \
      {"s",                                                                     \
       MUST,                                                                    \
       ANY,                                                                     \
       AS("", number),                                                          \
       AT(type, in s),                                                          \
       "the arc length of the contact curve from the start of the strip"},      \
      {"h",                                                                     \
       MUST,                                                                    \
       ANY,                                                                     \
       AS("", number),                                                          \
       AT(type, in h),                                                          \
       "the distance from the contact curve along the ruling"},                 \
      {"point", MUST, ANY, AS("[3]", number), AT(type, in point), "the point"}, \
      {"normal",         TOLD, ANY, AS("[3]", number), AT(type, in normal),     \
       "the unit normal"},                                                      \
  {                                                                             \
    "flat", TOLD, ANY, AS("[2]", number), AT(type, in flat),                    \
        "the point of the development"                                          \
  }

static const struct ph_member node[] = {NODE(ph_surface_sample, ), LAST};

static const struct ph_member located[] = {{"index", MUST, ANY, AS("", whole),
                                            AT(ph_located, index),
                                            "of the point in flat"},
                                           NODE(ph_located, at.),
                                           LAST};

static const struct ph_member panorama[] = {
    {"resolution", MUST, ANY, AS("", positive), AT(ph_panorama, resolution),
     "points over the unit"},
    {"width", MUST, ANY, AS("", whole), AT(ph_panorama, width),
     "points in a row"},
    {"height", MUST, ANY, AS("", whole), AT(ph_panorama, height), "rows"},
    {"origin", MUST, ANY, AS("[2]", number), AT(ph_panorama, origin),
     "the point of the development that is the first in the upper row"},
    {"points", MUST, ANY, AS("", whole), AT(ph_panorama, points),
     "those on the development"},
    {"outside", MUST, ANY, AS("", whole), AT(ph_panorama, outside),
     "of these, those outside of the volume"},
    {"range", TOLD, ANY, AS("[2]", open), AT(ph_panorama, range),
     "the least and the greatest value, or null"},
    {"mean", MAY, ANY, AS("", number), AT(ph_panorama, mean), "of all values"},
    LAST};

#define ERROR ROW("error", MUST, ANY, "error", "why there is no result")

/* Of a record that failed. */
static const struct ph_member failure[] = {HEADING, ERROR, LAST};

static const struct ph_member segment[] = {
    {"interval", TOLD, ANY, AS("", knots), EACH(ph_curve, knots),
     "the knots between which the segment lies"},
    {"alpha", TOLD, ATPH, AS("", positive), EACH(ph_curve, preimage.alpha),
     "the angle of the segment"},
    {"control_points", MUST, ANY, AS("[P][D]", number),
     JOINED(ph_curve, control_points),
     "the Bezier points; of atph the coefficients in its B-basis"},
    {"preimage", TOLD, SQUARE, AS("[W][Q]", number), EACH(ph_curve, preimage.v),
     "coefficients of the function whose square is the derivative"},
    {"length", TOLD, ANY, AS("", number), EACH(ph_curve, lengths),
     "the arc length of the segment"},
    {"tension", TOLD, TENSION, AS("", number), EACH(ph_curve, choice.tension),
     "by its square the derivatives at both ends were scaled"},
    {"angles", MAY, TENSION, AS("[2]", number), EACH(ph_curve, choice.angles),
     "theta and beta"},
    {"shape_ok", TOLD, TENSION, AS("", flag), EACH(ph_curve, choice.shape_ok),
     "whether the segment keeps the shape of its data"},
    {"blaschke", MAY, CUBIC, AS("[]", image), EACH(ph_curve, blaschke.v),
     "the image of the segment on the Blaschke cylinder"},
    LAST};

/* Of a piece of an image on the Blaschke cylinder. */
static const struct ph_member image[] = {
    {"interval", MUST, ANY, AS("[2]", number), AT(ph_blaschke, interval),
     "the part of the segment, in its local parameter"},
    {"control_points", MUST, ANY, AS("[6][3]", number),
     AT(ph_blaschke, control_points), "of a rational Bezier curve"},
    {"weights", MUST, ANY, AS("[6]", positive), AT(ph_blaschke, weights),
     "of the points"},
    LAST};

static const struct ph_member interval[] = {
    {"length", MUST, ANY, AS("", number), AT(ph_interval, length),
     "the arc length of the curve in this interval"},
    {"natural_length", MAY, LENGTHS, AS("", number),
     AT(ph_interval, natural_length),
     "what it is on the curve whose lengths are free"},
    {"segments", MUST, ANY, AS("", range), AT(ph_interval, first),
     "the first and the last of its segments"},
    {"root", MAY, CUBIC, AS("", root), AT(ph_interval, root), "which one"},
    {"D", MAY, CUBIC, AS("", number), AT(ph_interval, ratio), "of one cubic"},
    {"lambda", MAY, CUBIC, AS("", number), AT(ph_interval, lambda),
     "length of the derivatives over that of the chord"},
    {"joint_angle", MAY, CUBIC, AS("", number), AT(ph_interval, joint_angle),
     "from the chord to the curve, at a joint on it"},
    {"joint_position", MAY, CUBIC, AS("", number),
     AT(ph_interval, joint_position),
     "the part of the chord before a joint on it"},
    LAST};

static const struct ph_member joint[] = {
    {"segment", MUST, ANY, AS("", index), AT(ph_joint, segment),
     "that begins there"},
    {"point", MUST, ANY, AS("[2]", number), AT(ph_joint, point), "the point"},
    {"curvature", MUST, ANY, AS("[2]", open), AT(ph_joint, curvature),
     "before and after it, positive to the left; null beyond all numbers"},
    {"kind", MUST, ANY, AS("", joint_kind), AT(ph_joint, kind),
     "an inflection, straight on one side, or of the mode spline: a tangent or "
     "the joint of a pair"},
    LAST};

static const struct ph_member solution[] = {
    {"good", TOLD, ANY, AS("", flag), AT(ph_solution, good),
     "whether it is the curve that would be given alone"},
    {"segments", MUST, ANY, AS("[+]", segment),
     LIST(ph_solution, curve, curve.n), "the curve"},
    {"intervals", MAY, INTERVALS, AS("[I]", interval),
     EACH(ph_solution, intervals), "if the record has them"},
    {"length", TOLD, ANY, AS("", number), AT(ph_solution, curve.length),
     "the arc length of the curve"},
    {"diagnostics", TOLD, ANY, AS("", diagnostics),
     AT(ph_solution, diagnostics), "of this curve"},
    LAST};

#include "io/members_offset.def"

static const struct ph_member sample[] = {
    {"segment", MUST, ANY, AS("", index), EACH(ph_samples, segment),
     "of the curve"},
    {"t", MUST, ANY, AS("", number), EACH(ph_samples, t),
     "the local parameter in the segment, from 0 to 1, for atph to alpha"},
    {"s", MUST, ANY, AS("", number), EACH(ph_samples, s),
     "the arc length from the beginning"},
    {"point", MUST, ANY, AS("[D]", number), EACH(ph_samples, point),
     "the point"},
    {"tangent", MAY, ANY, AS("[D]", number), EACH(ph_samples, tangent),
     "the unit tangent"},
    {"curvature", MAY, ANY, AS("", number), EACH(ph_samples, curvature),
     "in the plane and on a sphere positive where the curve turns left"},
    {"torsion", MAY, SPACE, AS("", number), EACH(ph_samples, torsion),
     "the torsion"},
    {"lonlat", TOLD, SPHERE, AS("[2]", number), EACH(ph_samples, lonlat),
     "longitude and latitude in degrees, as seen from the center"},
    {"normal", MAY, SPACE, AS("[3]", number), EACH(ph_samples, normal),
     "unit vector of the frame"},
    {"binormal", MAY, SPACE, AS("[3]", number), EACH(ph_samples, binormal),
     "unit vector of the frame"},
    LAST};

#define DIAGNOSTIC(symbol, name, type, what) ROW(name, MAY, ANY, type, what),
static const struct ph_member diagnostics[] = {PH_DIAGNOSTICS(DIAGNOSTIC) LAST};

/* Of the member diagnostics of a record. */
static const struct ph_member certificate[] = {
    PH_DIAGNOSTICS(DIAGNOSTIC)
        ROW("kantorovich", MAY, ANY, "kantorovich",
            "the theorem of Kantorovich for the equations of the solver"),
    ROW("start", MAY, LENGTHS, "text", "the start that led to the curve"),
    {"starts", MAY, LENGTHS, AS("[+]", start),
     LIST(ph_result, starts, starts_n), "that were tried, in order"},
    {"lambda_interval", MAY, SURFACE, AS("[+]", bounds),
     LIST(ph_result, curve.surface.pairs, curve.surface.pairs_n),
     "of each pair: the first leg between these has a second one, above 0; "
     "null: no bound"},
    ROW("natural_lengths", MAY, LENGTHS, "[+]number",
        "the lengths of the curve whose lengths are free"),
    LAST};

static const struct ph_member kantorovich[] = {
    {"B", MAY, ANY, AS("", number), AT(ph_kantorovich, b),
     "a bound of the inverse of the Jacobian"},
    {"C", MAY, ANY, AS("", number), AT(ph_kantorovich, c),
     "the length of the next step of Newton"},
    {"K", MAY, ANY, AS("", number), AT(ph_kantorovich, k),
     "a Lipschitz constant of the Jacobian"},
    {"h", MAY, ANY, AS("", number), AT(ph_kantorovich, h),
     "the product of these"},
    {"radius", MAY, ANY, AS("", number), AT(ph_kantorovich, radius),
     "of a ball around the unknowns that contains an exact solution"},
    {"certified", MUST, ANY, AS("", flag), AT(ph_kantorovich, certified),
     "whether h is at most 1/2"},
    LAST};

static const struct ph_member start[] = {
    {"start", MUST, ANY, AS("", text), AT(ph_start, name), "its name"},
    {"outcome", MUST, ANY, AS("", outcome), AT(ph_start, outcome),
     "what became of it"},
    {"F", MAY, ANY, AS("", number), AT(ph_start, f),
     "the functional it led to"},
    {"iterations", MUST, ANY, AS("", whole), AT(ph_start, iterations),
     "the steps that it took"},
    LAST};

static const struct ph_member warning[] = {
    ROW("code", MUST, ANY, "warning_code", "what it is about"),
    ROW("segment", MAY, ANY, "whole", "the first one concerned"),
    ROW("message", MUST, ANY, "text", "what was found"), LAST};

static const struct ph_member error[] = {
    ROW("code", MUST, ANY, "code", "what it is about"),
    ROW("message", MUST, ANY, "text", "what was found and is allowed"),
    ROW("field", MAY, ANY, "text", "which field, or element of it"),
    ROW("file", MAY, ANY, "text", "that the problem stands in, or -"),
    ROW("line", MAY, ANY, "whole", "in the file, from 1"),
    ROW("byte", MAY, ANY, "whole",
        "of parts of the input (--shard), in place of the line: where the "
        "record begins in the file, from 0"),
    ROW("column", MAY, ANY, "whole", "in the line, in bytes, from 1"),
    LAST};

/* Of what verify says of a result: what it is of, in failures as it stands
 * there; and what was found. */
#define OF ROW("of", MUST, ANY, "method", "the command of the result")
#define NAMED ROW("of", MUST, ANY, "text", "what the result has as its command")
#define CLAIMS                          \
  ROW("claims", MUST, ANY, "no_claims", \
      "the result is an error record, which claims no curve")
#define VERDICT                                                              \
  ROW("curve", MAY, ANY, "kind", "the kind of curve, or"),                   \
      ROW("surface", MAY, ANY, "kind", "of surface"),                        \
      ROW("segments", MAY, ANY, "whole", "how many the curve has, or"),      \
      ROW("strips", MAY, ANY, "whole", "the surface, or"),                   \
      ROW("patches", MAY, ANY, "whole", "it"),                               \
      ROW("worst", MAY, ANY, "worst", "the largest of all errors"),          \
      ROW("checks", MUST, ANY, "checks", "the largest error of each check"), \
      ROW("unchecked", MAY, ANY, "[+]text",                                  \
          "members that cannot be checked without --volume")

/* What is right, what claims nothing; what is wrong, what should not claim
 * nothing, what cannot be looked at. */
static const struct ph_member verdict[] = {HEADING, OF, VERDICT, LAST};
static const struct ph_member none[] = {HEADING, OF, CLAIMS, LAST};
static const struct ph_member wrong[] = {HEADING, ERROR, OF, VERDICT, LAST};
static const struct ph_member wrong_none[] = {HEADING, ERROR, NAMED, CLAIMS,
                                              LAST};
static const struct ph_member unknown[] = {HEADING, ERROR, NAMED, LAST};

static const struct ph_member worst[] = {
    ROW("check", MUST, ANY, "check", "its check"),
    ROW("error", MUST, ANY, "number", "the error, relative"), LAST};

static const struct ph_members objects[] = {
    {"result", false, result, sizeof(struct ph_result)},
    {"surface", false, surface, sizeof(struct ph_result)},
    {"patchwork", false, patchwork, sizeof(struct ph_result)},
    {"patch", true, patch, sizeof(struct ph_patch)},
    {"patch_sample", true, patch_sample, sizeof(struct ph_patch_sample)},
    {"beside", true, beside, sizeof(struct ph_parallel)},
    {"patch_vertex", true, patch_vertex, sizeof(struct ph_patch_vertex)},
    {"patch_edge", true, patch_edge, sizeof(struct ph_patch_edge)},
    {"patch_strip", true, patch_strip, sizeof(struct ph_patch_strip)},
    {"strip", true, strip, sizeof(struct ph_strip)},
    {"strip_frame", true, strip_frame, sizeof(struct ph_strip_frame)},
    {"arc3", true, arc3, sizeof(struct ph_arc3)},
    {"arc2", true, arc2, sizeof(struct ph_arc2)},
    {"flat_sample", true, flat_sample, sizeof(struct ph_flat_sample)},
    {"pair", true, pair, sizeof(struct ph_pair)},
    {"parallel", false, parallel, sizeof(struct ph_parallel)},
    {"node", true, node, sizeof(struct ph_surface_sample)},
    {"located", true, located, sizeof(struct ph_located)},
    {"panorama", true, panorama, sizeof(struct ph_panorama)},
    {"segment", false, segment, 0},
    {"interval", false, interval, sizeof(struct ph_interval)},
    {"joint", false, joint, sizeof(struct ph_joint)},
    {"offset", false, offset, sizeof(struct ph_offset)},
    {"piece", false, piece, 0},
    {"bezier", false, bezier, 0},
    {"chain", false, chain, sizeof(struct ph_spline)},
    {"cusp", true, cusp, sizeof(struct ph_place)},
    {"loop", false, loop, sizeof(struct ph_loop)},
    {"loop_piece", false, loop_piece, sizeof(struct ph_loop_piece)},
    {"trimming", true, trimming, sizeof(struct ph_trimming)},
    {"sample", false, sample, 0},
    {"image", true, image, sizeof(struct ph_blaschke)},
    {"solution", false, solution, sizeof(struct ph_solution)},
    {"kantorovich", true, kantorovich, sizeof(struct ph_kantorovich)},
    {"start", true, start, sizeof(struct ph_start)},
    {"certificate", false, certificate, 0},
    {"diagnostics", true, diagnostics, 0},
    {"warning", true, warning, 0},
    {"failure", false, failure, 0},
    {"error", true, error, 0},
    {"verdict", false, verdict, 0},
    {"none", false, none, 0},
    {"wrong", false, wrong, 0},
    {"wrong-none", false, wrong_none, 0},
    {"unknown", false, unknown, 0},
    {"worst", true, worst, 0},
};

const struct ph_members *ph_members_find(const char *name) {
  for (size_t i = 0; i < sizeof objects / sizeof *objects; i++) {
    if (strcmp(objects[i].name, name) == 0) {
      return &objects[i];
    }
  }
  return NULL;
}

const struct ph_members *ph_members_of(const char *name) {
  size_t i = 0;
  while (*objects[i].name != *name || strcmp(objects[i].name, name) != 0) {
    i++;
  }
  return &objects[i];
}
