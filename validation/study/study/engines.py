"""Engines that are programs: what each says of itself, and cases sent to it.

The protocol: `adapter --list` prints one JSON object; `adapter CONFIGURATION` takes cases as JSON
objects, a line each, and answers with a line for each, in order.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import resource
import selectors
import signal
import subprocess
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any, Literal

NOT_HERE = 3  # the exit code of an adapter whose engine is not installed
_AT_ONCE = 1 << 16  # bytes read or written at a time
_LONGEST_ANSWER = 1 << 30
_OUT_OF_MEMORY = re.compile(
    r"MemoryError|bad_alloc|OutOfMemory|heap out of memory|Cannot allocate memory|memory exhausted",
    re.IGNORECASE,
)

Ending = Literal["model", "error", "crash", "timeout", "memory"]


@dataclass(frozen=True)
class Configuration:
    """One way to run an engine: what results are told apart by."""

    engine: str
    title: str
    version: str
    algorithm: str
    name: str
    configuration_title: str
    tolerance_kind: Literal["none", "grid", "snap", "relative"]
    tolerance: float
    source: str
    promise: str = ""
    """What the tolerance promises, where it is something else than its kind alone says."""
    way: str = ""
    """What is called, without the tolerance, where there is one: configurations of an engine with
    the same one differ by tolerance alone."""
    takes: tuple[str, ...] = ()
    """Of engines of rings: kinds of rings and rules, as "simple nonzero". Empty: segments."""

    @property
    def key(self) -> tuple[str, str, str]:
        return self.engine, self.version, self.name


@dataclass(frozen=True)
class Limits:
    seconds: float = 10.0
    start_seconds: float = 60.0
    """More, for the first case of a process: virtual machines and servers start."""
    memory: int = 4 << 30
    """Bytes that a process may write to. `RLIMIT_DATA` and not the address space, of which Java's
    and JavaScript's machines reserve far more than they touch."""


@dataclass(frozen=True)
class Reply:
    """What became of a case."""

    ending: Ending
    seconds: float | None = None
    model: dict[str, Any] | None = None
    message: str = ""


class NotHere(Exception):
    """The engine is not installed: a row of the table, no failure."""


class _Broken(Exception):
    """The program did not keep to the protocol."""


def listing(adapter: Path, timeout: float = 60.0) -> list[Configuration]:
    """What an adapter can run. Throws: NotHere, with the reason."""
    try:
        run = subprocess.run(
            [adapter, "--list"], capture_output=True, text=True, timeout=timeout, check=False
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise NotHere(str(error)) from error
    if run.returncode:
        lines = run.stderr.strip().splitlines() or [f"exit code {run.returncode}"]
        raise NotHere(lines[0])
    try:
        said = json.loads(run.stdout)
        return [
            Configuration(
                said["engine"],
                said["title"],
                str(said["version"]),
                said["algorithm"],
                c["name"],
                c["title"],
                c["tolerance"]["kind"],
                float(c["tolerance"].get("value") or 0),
                c.get("source", ""),
                c["tolerance"].get("promise", ""),
                c["tolerance"].get("way") or "",
                takes=tuple(said.get("takes", ())),
            )
            for c in said["configurations"]
        ]
    except (ValueError, KeyError, TypeError) as error:
        raise NotHere(f"its list is not of the protocol: {error!r}") from error


class Adapter:
    """A running adapter; restarted where it ended, or had to be ended. A context manager."""

    def __init__(self, program: Path, configuration: str, limits: Limits | None = None) -> None:
        self._command = [str(program), configuration]
        self._limits = limits or Limits()
        self._process: subprocess.Popen[bytes] | None = None
        self._said: IO[bytes] | None = None  # what it writes to stderr
        self._rest = bytearray()
        self._is_new = True
        self._case = 0

    def __enter__(self) -> Adapter:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def ask(self, segments: Sequence[Sequence[float]], tolerance: float | None = None) -> Reply:
        """The answer to a case, whatever happens. None: within the configuration's tolerance."""
        case: dict[str, Any] = {"segments": [list(s) for s in segments]}
        if tolerance is not None:
            case["tolerance"] = tolerance
        return self._ask(case)

    def ask_rings(self, rings: Sequence[Sequence[Sequence[float]]], rule: str) -> Reply:
        """The same of an engine of rings."""
        return self._ask({"rings": rings, "rule": rule})

    def _ask(self, question: dict[str, Any]) -> Reply:
        self._case += 1
        line = json.dumps({"case": self._case, **question}).encode() + b"\n"
        if self._process is None or self._process.poll() is not None:
            self._start()
        allowed = self._limits.seconds + (self._limits.start_seconds if self._is_new else 0)
        start = time.perf_counter()
        try:
            answer = self._exchange(line, start + allowed)
            self._is_new = False
            return self._reply(answer, time.perf_counter() - start)
        except TimeoutError:
            self.close()
            return Reply("timeout", self._limits.seconds, message=f"after {allowed:g} s")
        except EOFError:
            return self._ended()
        except _Broken as error:
            self.close()
            return Reply("crash", message=f"not of the protocol: {error}")

    def close(self) -> None:
        """Ends the program and what it started."""
        process, self._process = self._process, None
        if process is None:
            return
        # The group also outlives its leader: what an adapter started goes with it.
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        for stream in (process.stdin, process.stdout, self._said):
            if stream is not None:
                with contextlib.suppress(OSError):
                    stream.close()

    def _start(self) -> None:
        self.close()
        memory = self._limits.memory

        def limit() -> None:
            resource.setrlimit(resource.RLIMIT_DATA, (memory, memory))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

        self._said = tempfile.TemporaryFile()  # noqa: SIM115, `close` closes it
        self._process = subprocess.Popen(
            self._command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._said,
            preexec_fn=limit,
            start_new_session=True,
        )
        assert self._process.stdin and self._process.stdout
        os.set_blocking(self._process.stdin.fileno(), False)
        os.set_blocking(self._process.stdout.fileno(), False)
        self._rest, self._is_new = bytearray(), True

    def _exchange(self, line: bytes, deadline: float) -> bytearray:
        """Writes a case while reading, until there is a line."""
        assert self._process and self._process.stdin and self._process.stdout
        out, into = self._process.stdout.fileno(), self._process.stdin.fileno()
        left = memoryview(line)
        with selectors.DefaultSelector() as ready:
            ready.register(out, selectors.EVENT_READ)
            ready.register(into, selectors.EVENT_WRITE)
            while b"\n" not in self._rest[-_AT_ONCE:]:
                remaining = deadline - time.perf_counter()
                events = ready.select(remaining) if remaining > 0 else []
                if not events:
                    raise TimeoutError
                for key, _ in events:
                    if key.fd == out:
                        self._read(out)
                        continue
                    try:
                        left = left[os.write(into, left[:_AT_ONCE]) :]
                    except BrokenPipeError:
                        left = left[:0]  # what it had to say comes from its output
                    if not left:
                        ready.unregister(into)
        answer, _, self._rest = self._rest.partition(b"\n")
        if left:
            raise _Broken("an answer before the case was read")
        return answer

    def _read(self, out: int) -> None:
        read = os.read(out, _AT_ONCE)
        if not read:
            raise EOFError
        self._rest += read
        if len(self._rest) > _LONGEST_ANSWER:
            raise _Broken("an answer without an end")

    def _reply(self, line: bytearray, waited: float) -> Reply:
        try:
            answer = json.loads(line)
        except ValueError:
            raise _Broken(f"no JSON: {bytes(line[:60])!r}") from None
        if not isinstance(answer, dict) or answer.get("case") != self._case:
            raise _Broken(f"case {self._case} was asked: {bytes(line[:60])!r}")
        if "error" in answer:
            said = answer["error"] if isinstance(answer["error"], dict) else {}
            message = f"{said.get('class', '')}: {said.get('message', '')}"
            is_memory = _OUT_OF_MEMORY.search(message) is not None
            return Reply("memory" if is_memory else "error", waited, message=message)
        model, seconds = answer.get("model"), answer.get("seconds", waited)
        if not isinstance(model, dict) or "V" not in model:
            raise _Broken(f"neither a model nor an error: {bytes(line[:60])!r}")
        if not isinstance(seconds, (int, float)):
            raise _Broken(f"seconds are a number: {seconds!r:.60}")
        return Reply("model", float(seconds), model)

    def _ended(self) -> Reply:
        """The program ended instead of answering."""
        assert self._process and self._said
        code = self._process.wait()
        self._said.seek(0, os.SEEK_END)
        self._said.seek(max(0, self._said.tell() - _AT_ONCE))
        said = self._said.read().decode(errors="replace").strip()
        self.close()
        last = said.splitlines()[-1] if said else ""
        if code == NOT_HERE and self._is_new:
            raise NotHere(last or "exit code 3")
        # The kernel ends with SIGKILL what takes the machine's memory.
        is_memory = _OUT_OF_MEMORY.search(said) is not None or code == -signal.SIGKILL
        how = signal.Signals(-code).name if code < 0 else f"exit code {code}"
        return Reply("memory" if is_memory else "crash", message=f"{how}: {last}".rstrip(": "))
