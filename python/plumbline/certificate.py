"""Proofs of arrangements, and what checks them."""

from __future__ import annotations

import os
from pathlib import Path

from plumbline import _core
from plumbline._arguments import arrangement_of
from plumbline._core import Verdict
from plumbline._numbers import Numbers
from plumbline.arrangement import Arrangement
from plumbline.errors import Error
from plumbline.line_inputs import lines as lines_of
from plumbline.lines import LinesLike

__all__ = ["Verdict", "certificate", "verify"]


def certificate(arrangement: Arrangement | LinesLike) -> bytes:
    """The certificate of an arrangement: the whole result with what is needed to prove it.

    Parameters
    ----------
    arrangement : Arrangement, or line work as `arrange` takes it

    Returns
    -------
    bytes
        ASCII text; the same whatever the engine, the machine and the number of threads. `verify`
        proves it, and so does the program ``plumbline-verify``.

    Examples
    --------
    >>> import plumbline
    >>> drawing = [(0, 0, 2, 2), (0, 2, 2, 0), (0, 0, 0, 2)]
    >>> proof = plumbline.certificate(plumbline.arrange(drawing))
    >>> proof.splitlines()[0]
    b'plumbline certificate 1'
    >>> plumbline.verify(drawing, proof)
    <Verdict: proved>
    """
    of = arrangement_of(arrangement)
    return _core.certificate(of._core, of.lines._core)


def verify(
    lines: LinesLike,
    certificate: bytes | bytearray | memoryview | os.PathLike[str],
    *,
    numbers: Numbers | None = None,
) -> Verdict:
    """Whether a certificate proves the arrangement of these lines, by a checker that shares no code
    with what makes arrangements. Any bytes are proved or refused, however hostile.

    Parameters
    ----------
    lines : line work as `lines` takes it
        The same as was arranged: in the same order, floats standing for the same numbers.
    certificate : bytes or path
        What `certificate` made, or a file that has it.
    numbers : {"doubles", "decimals"}, optional
        As in `lines`.

    Returns
    -------
    Verdict
        True in a condition if proved; else with the reason, and the line of the certificate.

    Raises
    ------
    Error
        For lines that the checker cannot read: numbers of more than 10,000 digits.

    Notes
    -----
    O(n log n), a third of the time of `arrange`. The work is done without the GIL.

    Examples
    --------
    >>> import plumbline
    >>> proof = plumbline.certificate([(0, 0, 2, 2), (0, 2, 2, 0)])
    >>> verdict = plumbline.verify([(0, 0, 2, 2), (0, 2, 2, 1)], proof)
    >>> bool(verdict)
    False
    """
    if isinstance(lines, Arrangement):
        lines = lines.lines
    if isinstance(certificate, os.PathLike):
        certificate = Path(certificate).read_bytes()
    if not isinstance(certificate, (bytes, bytearray, memoryview)):
        raise Error(f"a certificate is bytes or a path: {type(certificate).__name__}")
    verdict = _core.verify(lines_of(lines, numbers=numbers)._core, bytes(certificate))
    if verdict.is_bad_input:
        raise Error(f"the checker cannot read these lines: {verdict.reason}", "", verdict.line)
    return verdict
