/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of commands (see command.h). */
#include "cli/command.h"

#include "cli/verify.h"
#include "cli/work.h"
#include "solve/method.h"

#include <string.h>

const struct ph_command ph_commands[] = {
    {PH_SOLVES_BY(ph_method_planar, CURVE), ph_describe_planar,
     "printf '0,0\\n2,1\\n3,0\\n5,2\\n' | phspline planar\t"
     "Four points, the curve as JSON\n"
     "phspline planar --closed -d -10 --offset-mode=trimmed coast.csv "
     "-o coast.json\t"
     "A closed curve with its trimmed offset to the right, in a file\n"
     "phspline planar --closed --columns=x,y,-,- -f csv track.csv\t"
     "Columns without names, two of them skipped; control points\n"
     "phspline planar -f csv --table=lengths problems.jsonl\t"
     "Many problems, the arc lengths of their segments\n"
     "phspline planar --sweep=knots=chordal,uniform --strict points.csv\t"
     "Each knot spacing in turn, no warnings allowed\n"
     "phspline planar --basis=atph --convert=bezier --tolerance=1e-6 points.csv"
     "\tAn algebraic-trigonometric curve as polynomial Bezier segments\n"
     "phspline planar --minimize=IES points.csv | jq .diagnostics\t"
     "The fairest knots\n"
     "phspline planar --spacing=0.5 --table=samples points.csv\t"
     "A point every half unit of length, as a table\n"
     "phspline planar --closed -d -5,-10 --offset-mode=trimmed -p coast.svg "
     "coast.csv -o coast.json"
     "\tA figure of a curve, two offsets and the curvature\n"
     "phspline planar --format=svg-path --chord-error=0.01 points.csv\t"
     "A path of cubics for a drawing, within a hundredth\n"},
    {PH_SOLVES_BY(ph_method_spatial_hermite, CURVE), ph_describe_spatial,
     "printf '0,0,0\\n1,1,0\\n2,0,1\\n' | phspline spatial-hermite\t"
     "Three points, the curve as JSON\n"
     "phspline spatial-hermite --columns=x,y,z,tx,ty,tz -f csv sensors.csv\t"
     "Points with tangents, in columns without names; control points\n"
     "phspline spatial-hermite --offset=0.5 -f csv --table=offsets path.csv\t"
     "The curves 0.5 to either side, above and below\n"
     "phspline spatial-hermite --sweep=criterion=cc,hc,bv --strict path.csv\t"
     "By each criterion, where the shape of the data can be kept\n"
     "phspline spatial-hermite --basis=atph --criterion=F1 path.csv\t"
     "Algebraic-trigonometric segments that bend least\n"
     "phspline spatial-hermite --shape=false --angles='[0,0]' "
     "--sweep='angles[1]=-3:3:13' path.csv\tOther members of the family\n"
     "phspline spatial-hermite --chord-error=1e-3 --frame=rmf "
     "--table=samples path.csv\t"
     "A polygon within 1e-3, with frames that do not spin\n"
     "phspline spatial-hermite --sweep=tension=0.7,1,1.4 -p path.pdf path.csv "
     "-o path.json\tThree tensions in one figure\n"},
    {PH_SOLVES_BY(ph_method_arclength, CURVE), NULL,
     "phspline arclength --columns=x,y,z,length survey.csv\t"
     "Points, each with the distance from the one before, as JSON\n"
     "phspline arclength --length_sigma=0.001 survey.csv\t"
     "Distances that were measured to a thousandth\n"
     "phspline arclength --columns=tx,ty,tz,length ribbon.csv -f csv\t"
     "A ribbon of sensors, directions and distances; control points\n"
     "phspline arclength --refine=1 --all_minima --starts=20 problem.json\t"
     "The spline of the paper, and all minima that 20 more starts find\n"
     "phspline arclength --sweep='lengths[1]=1.4:1.456:5' problem.json\t"
     "One length in five steps\n"
     "phspline arclength --spacing=0.05 -f text --table=samples survey.csv\t"
     "Where 5 cm of cable end, for gnuplot and awk\n"
     "phspline arclength -q --sweep='lengths*=0.99,1,1.01' -p lengths.svg "
     "problem.json -o lengths.json\tA hundredth too short and too long\n"},
    {PH_SOLVES_BY(ph_method_sphere, CURVE), NULL,
     "printf 'lon,lat\\n-9,39\\n-25,38\\n-64,32\\n-74,40\\n' | "
     "phspline sphere\tA voyage, the curve as JSON\n"
     "phspline sphere --columns=lon,lat --radius=6371 --sample=20 -f csv "
     "--table=samples track.csv\tA ground track in km, sampled\n"
     "phspline sphere --columns=lon,lat --radius=6371 --offset=-100,100 "
     "track.csv\tA corridor 100 km to either side\n"
     "phspline sphere --shape=false --sweep=tension=0,10,100 points.csv\t"
     "At three tensions, whatever shape that gives\n"
     "phspline sphere --model=nielson --ends=rest --criterion=legacy "
     "--increase=plus:10 --epsilon=1e-3 points.csv\t"
     "As the thesis does it\n"
     "phspline sphere --columns=lon,lat --radius=6371 --spacing=500 "
     "--table=samples track.csv\tA place every 500 km\n"
     "phspline sphere --columns=lon,lat --offset=-0.05,0.05 -p track.png "
     "--plot-size=1200x900 track.csv -o track.json\t"
     "The globe with track and corridor\n"},
    {PH_SOLVES_BY(ph_method_tc, CURVE), ph_describe_cubics,
     "printf '0,0\\n2,1\\n3,3\\n2,5\\n' | phspline tc\t"
     "A spline with continuous curvature, as JSON\n"
     "phspline tc --columns=x,y,tx,ty --mode=g1-fair -f csv outline.csv\t"
     "Points with tangents, one cubic or two, what is fairer; control points\n"
     "phspline tc --tolerance=0.01 --offset=-3 --offset-mode=trimmed "
     "drawing.json -o path.json\t"
     "Bezier curves of a drawing as cubics, with the path of a cutter, in a "
     "file\n"
     "phspline tc --mode=approximate --pieces=8 bezier.csv | "
     "jq .diagnostics.distance\tHow near eight cubics come to a Bezier curve\n"
     "phspline tc --mode=g1 --solutions=all -q problem.json | "
     "jq '.solutions[].length'\tEvery single cubic, those with loops too\n"
     "phspline tc --sweep=lambda=0.3,0.5,0.8 points.csv\t"
     "Tangents of three lengths\n"
     "phspline tc --tolerance=0.01 --offset=-3 --offset-mode=trimmed "
     "--format=svg-path drawing.json\t"
     "Outline and cutter path as one SVG path\n"
     "phspline tc --format=opendrive points.csv -o road.xodr\t"
     "A road, for simulators\n"
     "phspline tc --tolerance=0.01 --format=gcode --feed=600 drawing.json "
     "-o part.ngc\tMoves along the outline, for a machine\n"
     "phspline tc --sweep=lambda=0.3:0.8:6 -q -p lambda.svg points.csv "
     "-o lambda.json\tSix of them in one figure\n"},
    {PH_SOLVES_BY(ph_method_cone, SURFACE), NULL,
     "phspline cone --height='[-5,5]' elements.csv\t"
     "A surface through contact elements, columns x,y,z,rx,ry,rz,tx,ty,tz\n"
     "phspline cone --height='[-5,5]' --format=svg-path elements.csv\t"
     "Its flat pattern as an SVG path\n"
     "phspline cone --height='[-5,5]' --format=obj --sample=32x4 elements.csv\t"
     "A mesh with normals and flat coordinates\n"
     "phspline cone --height='[-5,5]' --offset=0.5 --table=strips "
     "elements.csv\t"
     "The strips, and those of the surface at the distance 0.5\n"},
    {PH_SOLVES_BY(ph_method_bubble, PATCHES), NULL,
     "phspline bubble mesh.json\t"
     "A smooth surface over a mesh, a patch for each face, as JSON\n"
     "phspline bubble --continuity=2 mesh.json | jq .diagnostics\t"
     "With continuous curvature; by how much normals and curvatures jump\n"
     "phspline bubble --degree=9 --table=patches mesh.json\t"
     "Patches of bidegree 10, their control points as a table\n"
     "phspline bubble --degree=exact --format=stl --sample=16 mesh.json "
     "-o mesh.stl\tA fine mesh of the exact surface\n"
     "phspline bubble --sample=4 --table=samples mesh.json\t"
     "Points with normals and curvatures\n"
     "phspline bubble -S continuity=0,1,2 -p mesh.png mesh.json "
     "-o mesh.jsonl\tA figure that compares three surfaces by isophotes\n"},
    {&ph_verify_schema, "checks of results, from their control points alone",
     PH_USE_VERIFY, ph_verify_work,
     .examples =
         "phspline planar points.csv | phspline verify\t"
         "A curve and all that is said about it\n"
         "phspline planar points.csv | phspline verify --problems=points.csv\t"
         "... and that it is one through these points\n"
         "phspline planar problems.jsonl | phspline verify -q | "
         "jq -c '[.id, .worst]'\tThe worst error of each result\n"
         "phspline tc points.csv | phspline verify --tolerance=1e-6 "
         "-o verdict.json\tNumbers of six digits would do\n"},
};

const size_t ph_commands_n = sizeof ph_commands / sizeof ph_commands[0];

const struct ph_command *ph_command_find(const char *name) {
  for (size_t i = 0; i < ph_commands_n; i++) {
    if (strcmp(ph_commands[i].schema->command, name) == 0) {
      return &ph_commands[i];
    }
  }
  return NULL;
}

const struct ph_field *ph_command_field(const struct ph_schema *schema,
                                        const char *name, size_t n) {
  char field[64];
  if (n > sizeof field) {
    return NULL;
  }
  for (size_t i = 0; i < n; i++) {
    field[i] = name[i];
    if (name[i] == '-') {
      field[i] = '_';
    }
  }
  return ph_field_find(schema, field, n);
}
