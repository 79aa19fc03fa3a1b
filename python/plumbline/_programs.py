"""Programs that are engines: where they are, and what they say of themselves."""

from __future__ import annotations

import os
import shutil
from dataclasses import dataclass, field
from pathlib import Path
from typing import Union

from plumbline import _core
from plumbline._core import EngineConfiguration
from plumbline.errors import Error


@dataclass(frozen=True)
class ListedEngine:
    """An engine that `cross_check` knows, as `engines` lists it."""

    name: str
    version: str = ""
    title: str = ""
    program: str | None = None
    """Its path; None: the engine is part of the library."""
    algorithm: str = ""
    licence: str = ""
    configurations: list[EngineConfiguration] = field(default_factory=list)
    """Of a program; the first is the default."""
    not_here: str | None = None
    """Why the program does not run; None where it does."""


def folders() -> list[str]:
    """Where programs are looked for: beside the tool `plumbline`, where it is found, in
    libexec/plumbline, then the folders of PATH."""
    found: list[str] = []
    tool = shutil.which("plumbline")
    if tool:
        beside = Path(tool).resolve().parent
        found = [str(folder / "libexec" / "plumbline") for folder in (beside.parent, beside)]
    return [*found, *os.get_exec_path()]


def name_of(engine: Union[str, os.PathLike[str]]) -> str:
    """A name, or what is the path of a program also to the library: with a slash."""
    return engine if isinstance(engine, str) else os.path.abspath(engine)


def engines() -> list[ListedEngine]:
    """The engines that `cross_check` knows: those of the library, then programs.

    Programs ``plumbline-engine-NAME`` are looked for in libexec/plumbline beside the tool
    ``plumbline``, and in the folders of PATH. Each is asked what it is.

    Examples
    --------
    >>> import plumbline
    >>> [e.name for e in plumbline.engines() if e.program is None]
    ['lar', 'inters', 'plasm', 'files']
    """
    built_in = _core.engine_titles()
    listed = [ListedEngine(name, version, title) for name, version, title in built_in]
    known = {e.name for e in listed}
    programs = [p for p in _core.programs_in(folders()) if p[0] not in known]
    return listed + [_listed(name, path) for name, path in programs]


def _listed(name: str, path: str) -> ListedEngine:
    try:
        says = _core.program_listing(path)
    except Error as error:
        return ListedEngine(name, program=path, not_here=str(error))
    return ListedEngine(
        name,
        says.version,
        says.title,
        path,
        says.algorithm,
        says.licence,
        says.configurations,
    )
