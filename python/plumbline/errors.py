"""Why a job could not be done."""

from __future__ import annotations


class Error(ValueError):
    """The content of a file, or an argument, cannot be used.

    Attributes
    ----------
    file : str
        The file that it is about; "" without one.
    line, column : int
        The place in it, from 1; 0 where it is not known.
    text : str
        The text that caused it, shortened to 60 characters; "" where there is none.
    """

    def __init__(
        self, message: str, file: str = "", line: int = 0, column: int = 0, text: str = ""
    ) -> None:
        super().__init__(message)
        self.file = file
        self.line = line
        self.column = column
        self.text = text

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (str(self), self.file, self.line, self.column, self.text)


class FileError(Error, OSError):
    """A file cannot be opened, read or written."""


class LimitError(Error):
    """A stated limit is exceeded."""


class InternalError(Error, RuntimeError):
    """A promise of this library is broken: please report it."""


class LossWarning(UserWarning):
    """Something of the input takes no part in the result; `rejected` lists it."""
