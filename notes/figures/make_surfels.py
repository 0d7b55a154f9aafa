#!/usr/bin/env python3
"""Writes surfels.json: a sphere of surfels, once as they are needed to close it and once at half their radius, so
that the discs can be told apart."""
import json
import math
import pathlib

N = 420                    # surfels on each sphere
RADIUS = 1.0               # of the spheres
CLOSED = 2.6 / math.sqrt(N)  # radius of a surfel so that neighbours overlap: their spacing is about 3.5 / sqrt(N)
LIGHT = (-0.48, 0.6, 0.64)
NEAR = 0.1
WIDTH, HEIGHT = 640, 320


def sphere(center, surfel_radius, color):
    """Points of a Fibonacci spiral, each shaded by Lambert's law."""
    surfels = []
    for i in range(N):
        y = 1 - (2 * i + 1) / N
        angle = i * math.pi * (3 - math.sqrt(5))
        ring = math.sqrt(1 - y * y)
        normal = (ring * math.cos(angle), y, ring * math.sin(angle))
        if normal[2] < -0.25:  # faces away
            continue
        light = 0.2 + 0.8 * max(0.0, sum(n * l for n, l in zip(normal, LIGHT)))
        surfels.append({"center": [round(c + RADIUS * n, 3) for c, n in zip(center, normal)],
                        "normal": [round(n, 3) for n in normal], "radius": round(surfel_radius, 4),
                        "color": [round(light * c) for c in color] + [255]})
    return surfels


def main():
    scale = 3.2  # 1 / tan(half the vertical field of view)
    clip_from_world = [scale * HEIGHT / WIDTH, 0, 0, 0, 0, scale, 0, 0, 0, 0, 0, -1, 0, 0, NEAR, 0]  # column-major
    draws = [{"surfels": sphere((-1.15, 0, -4.2), CLOSED, (232, 140, 50))},
             {"surfels": sphere((1.15, 0, -4.2), CLOSED / 2, (90, 150, 240))}]
    lines = ",\n".join(json.dumps(d).replace('}, {', '},\n   {') for d in draws)
    head = {"size": [WIDTH, HEIGHT], "samples": 16, "clear": [24, 26, 32, 255], "clip_from_world": clip_from_world}
    path = pathlib.Path(__file__).with_name("surfels.json")
    path.write_text(json.dumps(head)[:-1] + ',\n "draws": [\n' + lines + "]}\n")


if __name__ == "__main__":
    main()
