"""Float LAR, as published and repaired: the engines of this project, by its Python package.

Faces are LAR's FV, lists of vertices; as published they have no holes.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import plumbline
from study_adapter import Clock, Configuration, Engine, Floats, Model, edges_once, serve


def variant(
    name: Literal["published", "repaired"],
) -> Callable[[Floats, Clock, float | None], Model]:
    def run(segments: Floats, clock: Clock, radius: float | None) -> Model:
        if not len(segments):
            return {"V": [], "EV": [], "FV": []}
        with clock:
            result = plumbline.lar.arrange(
                segments, name, radius=radius, numbers="doubles", threads=1
            )
        return {
            "V": result.V.tolist(),
            "EV": edges_once(result.EV),
            "FV": result.FV.tolist(),
        }

    return run


CONFIGURATIONS = [
    Configuration(
        "repaired",
        "repaired, its own radius",
        ("snap", 0.001),
        "plumbline.lar.arrange: 0.001 of the longer side, at most a quarter of the shortest line",
        variant("repaired"),
        way="repaired",
        is_automatic=True,
    ),
    Configuration(
        "published",
        "as published, radius 0.001, four decimals",
        ("snap", 0.001),
        "Paoluzzi, 'Accelerated intersection of geometric objects', November 2015",
        variant("published"),
        way="as published, four decimals",
    ),
]

if __name__ == "__main__":
    serve(
        Engine("lar", "float LAR", plumbline.__version__, "LAR", "GPL-3.0-or-later", CONFIGURATIONS)
    )
