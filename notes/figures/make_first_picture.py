#!/usr/bin/env python3
"""Writes first_picture.json, the picture on the README: a ground with an anisotropic filter, a torus and a ball of
shaded surfels, soft shadows, translucent discs, and stippled orbits. The camera is the only thing that this script
computes for the renderer: `lodestone draw` knows no cameras."""
import json
import math
import pathlib

WIDTH, HEIGHT = 960, 540
EYE, TARGET, FOV_DEG, NEAR = (0.6, 1.75, 5.6), (0.0, 1.12, 0.0), 38.0, 0.1
TO_LIGHT = (-0.55, 0.62, 0.56)
HAZE = (246, 214, 190)


def add(a, b, s=1.0): return tuple(x + s * y for x, y in zip(a, b))
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def unit(a): return tuple(x / math.sqrt(dot(a, a)) for x in a)
def cross(a, b): return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


BACK = unit(add(EYE, TARGET, -1))
RIGHT = unit(cross((0, 1, 0), BACK))
UP = cross(BACK, RIGHT)
SCALE = 1 / math.tan(math.radians(FOV_DEG) / 2)


def clip_from_world():
    """Column-major; depth is NEAR / distance: 1 near, 0 at infinity."""
    rows = [[SCALE * HEIGHT / WIDTH * c for c in RIGHT], [SCALE * c for c in UP], [0, 0, 0], [-c for c in BACK]]
    rows = [r + [-dot(r, EYE)] for r in rows]
    rows[2][3] = NEAR
    return [round(rows[r][c], 6) for c in range(4) for r in range(4)]


def clip(p):
    m = clip_from_world()
    return [round(sum(m[4 * c + r] * (*p, 1)[c] for c in range(4)), 5) for r in range(4)]


def surfel(center, normal, radius, rgb):
    """Lambert's law, a highlight (Blinn), and light from the ground."""
    to_eye = unit(add(EYE, center, -1))
    half = unit(add(unit(TO_LIGHT), to_eye))
    diffuse = 0.30 + 0.12 * normal[1] + 0.72 * max(0.0, dot(normal, unit(TO_LIGHT)))
    highlight = 190 * max(0.0, dot(normal, half)) ** 40
    color = [min(255, round(diffuse * c + highlight)) for c in rgb]
    return {"center": [round(c, 2) for c in center], "normal": [round(n, 2) for n in normal], "radius": radius,
            "color": color + [255]}


def faces_eye(center, normal):
    return dot(normal, unit(add(EYE, center, -1))) > -0.12


def hue(t):
    """From warm to cool and back."""
    stops = [(236, 96, 72), (245, 166, 66), (94, 186, 140), (72, 132, 214), (150, 96, 190), (236, 96, 72)]
    i, f = int(t * 5) % 5, t * 5 % 1
    return [a + f * (b - a) for a, b in zip(stops[i], stops[i + 1])]


def torus(center, axis, major, minor, n_around, n_across, radius):
    u = unit(cross(axis, (0.3, 0.1, 1)))
    v = cross(axis, u)
    result = []
    for i in range(n_around):
        for j in range(n_across):
            a = 2 * math.pi * (i + 0.5 * (j % 2)) / n_around
            b = 2 * math.pi * j / n_across
            spoke = add(tuple(math.cos(a) * x for x in u), v, math.sin(a))
            normal = add(tuple(math.cos(b) * x for x in spoke), axis, math.sin(b))
            p = add(add(center, spoke, major), normal, minor)
            if faces_eye(p, normal):
                result.append(surfel(p, normal, radius, hue(a / (2 * math.pi) % 1)))
    return result


def ball(center, size, n, radius, rgb):
    result = []
    for i in range(n):
        y, a = 1 - (2 * i + 1) / n, i * math.pi * (3 - math.sqrt(5))
        r = math.sqrt(1 - y * y)
        normal = (r * math.cos(a), y, r * math.sin(a))
        p = add(center, normal, size)
        if faces_eye(p, normal):
            result.append(surfel(p, normal, radius, rgb))
    return result


def shadow(x, z, size):
    """Discs on the ground, each darkening a little: the sum is soft."""
    return [{"center": [x, round(0.002 + 0.0002 * k, 4), z], "normal": [0, 1, 0], "radius": round(size * (1.2 - 0.04 * k), 3),
             "color": [0, 0, 0, 7]} for k in range(25)]


def sky():
    horizon = round(HEIGHT / 2 * (1 - clip((EYE[0], EYE[1], -1e6))[1] / clip((EYE[0], EYE[1], -1e6))[3]), 1)
    bands = [(0, (52, 84, 150)), (0.62 * horizon, (150, 176, 214)), (horizon, HAZE), (HEIGHT, HAZE)]
    quads, colors = [], []
    for (y0, c0), (y1, c1) in zip(bands, bands[1:]):
        quads += [[0, y0, 0], [0, y1, 0], [WIDTH, y1, 0], [WIDTH, y0, 0]]
        colors += [[*c0, 255], [*c1, 255], [*c1, 255], [*c0, 255]]
    return {"quads": quads, "colors": colors}


def ground():
    n, far = 32, 600
    texels = []
    for y in range(n):
        for x in range(n):
            dark = (x < n // 2) != (y < n // 2)
            joint = x % (n // 2) == 0 or y % (n // 2) == 0
            texels += [205, 196, 184, 255] if joint else [112, 124, 142, 255] if dark else [236, 230, 218, 255]
    corners = [(-far, 0, 5.4), (far, 0, 5.4), (far, 0, -far), (-far, 0, -far)]
    yield {"clip_quads": [clip(c) for c in corners], "uv": [[x / 1.8, z / 1.8] for x, _, z in corners],
           "texture": {"size": [n, n], "rgba": texels, "filter": "anisotropic", "max_anisotropy": 16}}
    # Haze, thicker with distance: strips of the ground again, a hair above it.
    strips, colors = [], []
    depths = [(-4, 0), (-14, 0.38), (-40, 0.75), (-150, 0.94), (-far, 1)]
    for (z0, a0), (z1, a1) in zip(depths, depths[1:]):
        strips += [clip((-far, 0.001, z0)), clip((far, 0.001, z0)), clip((far, 0.001, z1)), clip((-far, 0.001, z1))]
        for a in (a0, a0, a1, a1):
            colors.append([round(a * c) for c in (*HAZE, 255)])
    yield {"clip_quads": strips, "colors": colors, "blend": "over"}


def orbit(center, axis, size, color, pattern):
    u = unit(cross(axis, (1, 0, 0)))
    v = cross(axis, u)
    ring = [2 * math.pi * k / 120 for k in range(121)]
    points = [clip(add(add(center, u, size * math.cos(a)), v, size * math.sin(a))) for a in ring]
    return {"clip_line_strip": points, "color": color, "stipple": {"pattern": pattern, "factor": 3}}


def bubbles():
    """Window discs, premultiplied: a faint fill and a brighter crescent."""
    result = []
    for x, y, r, rgb in [(118, 150, 64, (255, 190, 120)), (228, 92, 30, (160, 205, 255)), (846, 118, 82, (150, 190, 255)),
                         (745, 64, 26, (255, 205, 150)), (905, 262, 34, (255, 170, 150)), (60, 286, 24, (190, 230, 190))]:
        fill = [round(0.20 * c) for c in rgb]
        shine = [round(0.30 * c) for c in (255, 255, 255)]
        result.append({"discs": [{"center": [x, y, 0.9], "radius": r}], "color": fill + [51], "blend": "over"})
        result.append({"discs": [{"center": [round(x - 0.36 * r, 1), round(y - 0.36 * r, 1), 0.9], "radius": round(0.3 * r, 1)}],
                       "color": shine + [77], "blend": "over"})
    return result


def main():
    center, axis = (0.0, 1.25, 0.0), unit((0.42, 0.72, 0.55))
    draws = [sky(), *ground(),
             {"surfels": shadow(0.25, -0.25, 1.45) + shadow(-1.95, 0.55, 0.5) + shadow(2.1, 0.75, 0.44), "blend": "over"},
             {"surfels": torus(center, axis, 1.0, 0.36, 58, 22, 0.085)},
             {"surfels": ball(center, 0.40, 190, 0.078, (238, 236, 230))},
             {"surfels": ball((-1.95, 0.4, 0.5), 0.40, 150, 0.088, (72, 132, 214))},
             {"surfels": ball((2.1, 0.34, 0.7), 0.34, 130, 0.08, (236, 112, 84))},
             orbit(center, unit((-0.25, 0.95, 0.2)), 1.85, [40, 60, 110, 255], 0x0FFF),
             orbit(center, unit((0.35, 0.9, -0.3)), 2.15, [190, 80, 60, 255], 0x3333),
             *bubbles()]
    head = {"size": [WIDTH, HEIGHT], "samples": 16, "clip_from_world": clip_from_world()}
    lines = ",\n".join(json.dumps(d, separators=(",", ":")).replace("},{", "},\n{") for d in draws)
    path = pathlib.Path(__file__).with_name("first_picture.json")
    path.write_text(json.dumps(head)[:-1] + ',\n"draws": [\n' + lines + "]}\n")


if __name__ == "__main__":
    main()
