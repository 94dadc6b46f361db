"""What every executor can do."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator
from typing import Any, Self

from solver.limits import Limits

Arguments = tuple[Any, ...]


class Unavailable(Exception):  # noqa: N818 - said to the user; no error of the program
    """Who is to make the calls is not there; the message says why, in words."""


class Executor(ABC):
    """Makes calls within limits, as many at a time as there are `jobs`; who leaves its context ends what it started."""

    jobs: int

    @abstractmethod
    def calls(
        self, limits: Limits, function: Callable[..., Any], calls: Iterable[Arguments]
    ) -> Iterator[tuple[int, Any]]:
        """Call the function with each of the arguments; yield the place of each call and its result, or Exceeded.

        They come as they are found. The limits are those of one call; one that meets them costs the others nothing.
        The function is one of a module; it and its arguments are sent to where the call is made.
        """

    def in_order(self, limits: Limits, function: Callable[..., Any], calls: Iterable[Arguments]) -> Iterator[Any]:
        """Yield the results, or Exceeded, in the order of the calls, each as soon as it and those before are there."""
        waiting: dict[int, Any] = {}
        following = 0
        for place, result in self.calls(limits, function, calls):
            waiting[place] = result
            while following in waiting:
                yield waiting.pop(following)
                following += 1

    def begin(self) -> None:  # noqa: B027 - who has nothing to prepare does nothing
        """Prepare for calls that will come soon, while the caller goes on."""

    def close(self) -> None:  # noqa: B027 - who has started nothing does nothing
        """End what was started."""

    def __enter__(self) -> Self:
        self.begin()
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
