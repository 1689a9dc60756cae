# SPDX-License-Identifier: GPL-3.0-or-later
"""python3 bench/others.py PHSPLINE: the cells of README's table of what others
do not, each found by running the program or library on points of a circle; one
that is not as README has it is told, with exit status 1.  That something is
missing (-) is what the names of functions or the option list tell."""
import json
import math
import os
import subprocess
import sys
import tempfile

import numpy
import scipy.integrate
import scipy.interpolate
import shapely.geometry

N = 24  # points, of which the last is the first
PHSPLINE = os.path.abspath(sys.argv[1])
FOLDER = tempfile.TemporaryDirectory()
os.chdir(FOLDER.name)
TURN = 2 * numpy.pi * numpy.arange(N + 1) / N
CIRCLE = numpy.column_stack((numpy.cos(TURN), numpy.sin(TURN)))
CHORDS = numpy.hypot(*numpy.diff(CIRCLE, axis=0).T).sum()
numpy.savetxt('points', CIRCLE, fmt='%.17g')
numpy.savetxt('knots', numpy.column_stack((numpy.arange(N + 1), CIRCLE)),
              fmt='%.17g')
numpy.savetxt('csv', CIRCLE, fmt='%.17g', delimiter=',')
HALF = CIRCLE[:N // 2 + 1]  # GMT 6.4 prints what is no number for rings
numpy.savetxt('half', HALF, fmt='%.17g')
bad = []


def run(*command, text=''):
    """What a program prints, and its exit status."""
    ran = subprocess.run(command, input=text, capture_output=True, text=True,
                         check=False)
    return ran.stdout + ran.stderr * (not ran.stdout), ran.returncode


def table(*command):
    """The numbers that a program prints."""
    return numpy.loadtxt(run(*command)[0].splitlines(), comments=('#', '>'))


def phspline(*options, text=''):
    """A result of the program."""
    return json.loads(run(PHSPLINE, *options, text=text)[0])


def cell(row, column, what, found):
    """One cell of README, and whether it is so."""
    print(f'  {row:<24} {column:<10} {what:<11}', 'yes' if found else 'NO')
    if not found:
        bad.append((row, column))


def passes(points, bound=1e-6):
    """Whether samples pass through the points and lie between on no chord."""
    off = abs(points[::2] - CIRCLE).max()
    bend = numpy.hypot(*points[3:-3:2].T)  # natural splines miss at the ends
    chord = 1 - math.cos(TURN[1] / 2)
    return off < bound and abs(bend - 1).max() < chord / 5


def bezier(control, t):
    """The derivative of a Bezier curve at t."""
    steps = numpy.diff(numpy.array(control), axis=0)
    n = len(steps)
    return n * sum(math.comb(n - 1, i) * t**i * (1 - t)**(n - 1 - i) * step
                   for i, step in enumerate(steps))


def gauss(control):
    """The length, exact if the speed is of degree 9 or less."""
    nodes, weights = numpy.polynomial.legendre.leggauss(5)
    return sum(w / 2 * numpy.linalg.norm(bezier(control, (1 + t) / 2))
               for t, w in zip(nodes, weights))


def names(thing, *words):
    """Names of a library that have one of the words."""
    return [n for n in dir(thing) if any(w in n.lower() for w in words)]


def of_phspline():
    ours = phspline('planar', '--closed', '--offset=0.1', 'csv')
    segments = ours['segments']
    ends = numpy.array([s['control_points'][0] for s in segments])
    cell('smooth through points', 'phspline', 'yes',
         abs(ends - CIRCLE[:-1]).max() < 1e-12)
    cell('control points', 'phspline', 'yes',
         all(len(s['control_points']) == 6 for s in segments))
    cell('arc length', 'phspline', 'formula',
         all(abs(gauss(s['control_points']) - s['length']) < 1e-14
             for s in segments))
    miss = 0
    for piece in ours['offsets'][0]['segments']:
        segment = segments[piece['segment']]
        weights = numpy.array(piece['weights'])
        points = numpy.array(piece['control_points'])
        for t in numpy.linspace(0, 1, 9):
            b = [math.comb(len(weights) - 1, i) * t**i *
                 (1 - t)**(len(weights) - 1 - i) for i in range(len(weights))]
            place = (b * weights) @ points / (b @ weights)
            curve = sum(math.comb(5, i) * t**i * (1 - t)**(5 - i) *
                        numpy.array(p)
                        for i, p in enumerate(segment['control_points']))
            off = place - curve
            along = bezier(segment['control_points'], t)
            miss = max(miss, abs(numpy.hypot(*off) - 0.1),
                       abs(off @ along) / numpy.hypot(*along))
    cell('offsets, trimmed', 'phspline', 'exact', miss < 1e-13)
    given = [1.2, 1.3, 1.25]
    exact = phspline('arclength', text=json.dumps({
        'points': [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1]],
        'lengths': given}))
    found = [gauss(s['control_points']) for s in exact['segments']]
    cell('prescribed lengths', 'phspline', 'yes',
         abs(numpy.reshape(found, (3, 2)).sum(1) - given).max() < 1e-12)
    places = numpy.array([
        s['point'] for s in phspline(
            'sphere', '--closed', '--sample=9', text=json.dumps(
                {'lonlat': [[i, 60] for i in (0, 50, 95, 130, 200, 240, 300)]})
        )['samples']])
    keep = numpy.linalg.norm(numpy.roll(places, -1, 0) - places, axis=1) > 1e-9
    places = places[keep]
    turns = numpy.linalg.det(numpy.stack(
        (places, numpy.roll(places, -1, 0), numpy.roll(places, -2, 0)), 1))
    cell('shape kept on a sphere', 'phspline', 'yes', turns.min() > 0)
    right = run(PHSPLINE, 'verify', text=json.dumps(ours))[1]
    segments[3]['length'] *= 1 + 1e-6
    wrong = run(PHSPLINE, 'verify', text=json.dumps(ours))[1]
    cell('result checked', 'phspline', 'yes', (right, wrong) == (0, 1))


def of_scipy():
    spline = scipy.interpolate.make_interp_spline(
        TURN, CIRCLE, bc_type='periodic')
    halves = numpy.linspace(0, TURN[-1], 2 * N + 1)
    cell('smooth through points', 'scipy', 'yes',
         passes(spline(halves), 1e-14))
    cell('control points', 'scipy', 'yes', spline.c.shape[1] == 2)
    speed = spline.derivative()
    quad = scipy.integrate.quad
    length = sum(quad(lambda t: numpy.hypot(*speed(t)), a, b)[0]
                 for a, b in zip(TURN, TURN[1:]))
    cell('arc length', 'scipy', 'quadrature',
         abs(length - TURN[-1]) < 1e-4 and
         not names(scipy.interpolate, 'length') + names(spline, 'length'))
    cell('prescribed lengths', 'scipy', '-',
         not names(scipy.interpolate, 'length'))
    cell('offsets, trimmed', 'scipy', '-',
         not names(scipy.interpolate, 'offset', 'parallel'))
    # surfaces over a sphere are all that it names so
    cell('shape kept on a sphere', 'scipy', '-',
         all('Bivariate' in n for n in names(scipy.interpolate, 'sphere')))


def of_spline():
    cell('smooth through points', 'spline', 'yes', passes(
        table('spline', '-d', '2', '-a', '-s', '-p', '-n', str(2 * N),
              '-P', '12', 'points')))
    options = run('spline', '--help')[0]
    cell('the other rows', 'spline', '-', options and not any(
        word in options for word in ('control', 'length', 'offset', 'sphere')))


def of_gmt():
    points = table('gmt', 'sample1d', '-Fc', f'-T0/{N}/0.5', 'knots')
    cell('smooth through points', 'GMT', 'yes', passes(points[:, 1:]))
    length = table('gmt', 'mapproject', '-G+uc', 'points')[-1, 2]
    cell('arc length', 'GMT', 'chords', abs(length - CHORDS) < 1e-9)
    around = table('gmt', 'spatial', '-Sb0.1', 'half')
    cell('offsets, trimmed', 'GMT', 'polygons', polygon(around))


def of_geos():
    line = shapely.geometry.LineString(CIRCLE)
    cell('arc length', 'GEOS', 'chords', abs(line.length - CHORDS) < 1e-12)
    around = numpy.array(
        shapely.geometry.LineString(HALF).buffer(0.1).exterior.coords)
    cell('offsets, trimmed', 'GEOS', 'polygons', polygon(around))
    cell('smooth through points', 'GEOS', '-',
         not names(line, 'spline', 'curve', 'bezier'))


def polygon(around):
    """Whether a buffer by 0.1 follows the chords: its corners are at the
    radius 1.1 (most of GMT's), its long sides come nearer."""
    away = numpy.hypot(*around.T)
    sides = [numpy.hypot(*((a + b) / 2)) for a, b in zip(around, around[1:])
             if 0.2 < numpy.hypot(*(a - b)) < 0.3 and numpy.hypot(*a) > 1.05]
    return (abs(away[away > 1.05] - 1.1) < 1e-3).mean() > 0.5 and \
        len(sides) > 4 and numpy.median(sides) < 1.1 - 5e-3


print('What others do not (README), by running each: whether it is so\n')
for of in of_phspline, of_scipy, of_spline, of_gmt, of_geos:
    of()
os.chdir('/')
sys.exit(bool(bad))
