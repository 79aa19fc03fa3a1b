"""What adapters of the tests have in common: the protocol."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable
from typing import Any

Model = dict[str, Any]


def serve(
    listing: dict[str, Any], engines: dict[str, Callable[[list[list[float]], float | None], Model]]
) -> None:
    """Answers cases until there are none. Engines get the tolerance of a case, if it has one."""
    if sys.argv[1:] == ["--list"]:
        print(json.dumps(listing))
        return
    engine = engines[sys.argv[1]]
    for line in sys.stdin:
        case = json.loads(line)
        start = time.perf_counter()
        answer: dict[str, Any] = {"case": case["case"]}
        try:
            model = engine(case["segments"], case.get("tolerance"))
            answer |= {"seconds": time.perf_counter() - start, "model": model}
        except Exception as error:
            answer["error"] = {"class": type(error).__name__, "message": str(error)}
        print(json.dumps(answer), flush=True)
