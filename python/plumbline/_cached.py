"""Properties that are computed once."""

from __future__ import annotations

from functools import cached_property
from typing import Any, TypeVar, overload

T = TypeVar("T")


class cached(cached_property[T]):
    """As functools.cached_property, without its lock, which before Python 3.12 all instances
    share: threads would wait for each other. Two that ask at once both compute; one value is
    kept."""

    @overload
    def __get__(self, instance: None, owner: type[Any] | None = None) -> cached[T]: ...
    @overload
    def __get__(self, instance: object, owner: type[Any] | None = None) -> T: ...
    def __get__(self, instance: object | None, owner: type[Any] | None = None) -> cached[T] | T:
        if instance is None:
            return self
        assert self.attrname is not None
        values = instance.__dict__
        if self.attrname in values:
            value: T = values[self.attrname]
            return value
        kept: T = values.setdefault(self.attrname, self.func(instance))
        return kept
