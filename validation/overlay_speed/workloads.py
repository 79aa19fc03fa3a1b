"""workloads.py NAME N FILE: writes a published workload of Boolean operations: `OPERATION RULE valid|free`, then a ring a
line, `A` or `B` and its corners. Those of iOverlay's performance page (checkerboard, apart, net, spiral, windows, nested)
and Clipper2's (random)."""

import math
import random
import sys


def square(x, y, side):
    return [(x, y), (x + side, y), (x + side, y + side), (x, y + side)]


def many(origin, side, step, n):
    return [square(origin + i * step, origin + j * step, side) for i in range(n) for j in range(n)]


def checkerboard(n):
    return "xor evenodd valid", many(0, 20, 30, n), many(15, 20, 30, n - 1)


def apart(n):
    return "xor evenodd valid", many(0, 10, 30, n), many(15, 10, 30, n - 1)


def net(n):
    length = 20 * n
    across = [[(0, y), (length, y), (length, y + 10), (0, y + 10)] for y in range(0, length, 20)]
    return "and evenodd valid", across, [[(y, x) for x, y in reversed(ring)] for ring in across]


def spiral(n):
    """Two bands along one spiral, half a turn apart."""

    def band(phase):
        turns = math.sqrt(n) / 8
        places = [(i / (n // 2)) * turns * 2 * math.pi for i in range(1, n // 2 + 1)]
        inner = [(round(4000 * t * math.cos(t + phase)), round(4000 * t * math.sin(t + phase))) for t in places]
        outer = [
            (round((4000 * t + 15000) * math.cos(t + phase)), round((4000 * t + 15000) * math.sin(t + phase)))
            for t in places
        ]
        return inner + outer[::-1]

    return "xor evenodd free", [band(0)], [band(math.pi)]


def windows(n):
    """Frames, each a square and its hole as two rings, under squares that cover their corners."""
    frames = many(0, 20, 30, n) + many(5, 10, 30, n)
    return "xor evenodd free", frames, many(15, 20, 30, n)


def nested(n):
    return (
        "xor evenodd free",
        [square(-2 * i - 2, -2 * i - 2, 4 * i + 4) for i in range(n)],
        [square(-2 * i - 1, -2 * i - 1, 4 * i + 2) for i in range(n)],
    )


def scattered(n):
    dice = random.Random(7)

    def ring():
        return [(dice.randrange(800_000), dice.randrange(600_000)) for _ in range(n)]

    return "and nonzero free", [ring()], [ring()]


WORKLOADS = {f.__name__: f for f in (checkerboard, apart, net, spiral, windows, nested, scattered)}


def main():
    name, n, file = sys.argv[1:]
    head, first, second = WORKLOADS[name](int(n))
    with open(file, "w") as out:
        print(head, file=out)
        for letter, rings in ("A", first), ("B", second):
            for ring in rings:
                print(letter, *(number for corner in ring for number in corner), file=out)


if __name__ == "__main__":
    main()
