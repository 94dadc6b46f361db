"""One function called within limits, in a child process that can be killed."""

from __future__ import annotations

import signal
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from pickle import PickleError
from typing import Any

from solver.limits.child import Limits, as_bug, cause_of_death, new_context, restrict
from solver.words import Phrase

Arguments = tuple[Any, ...]


class Exceeded(Exception):  # noqa: N818 - a limit was met; no error of the program
    """The call was ended, or died; the reason, a phrase, says why."""

    def __init__(self, reason: str) -> None:
        super().__init__(reason)
        self.reason = reason


def call_within(limits: Limits, function: Callable[..., Any], *arguments: Any) -> Any:
    """Return what the function returns; raises Exceeded where it takes too long or too much memory, or dies."""
    context = new_context()
    channel, its_end = context.Pipe()
    process = context.Process(target=_call, args=(its_end, limits, function, arguments), daemon=True)
    process.start()
    its_end.close()
    try:
        if not channel.poll(limits.seconds):
            raise Exceeded(limits.told)
        answered, result = channel.recv()
    except (EOFError, OSError):
        process.join(1.0)
        raise Exceeded(cause_of_death(process.exitcode)) from None
    finally:
        process.kill()
        process.join()
        channel.close()
    if not answered:
        raise Exceeded(result)
    return result


def _call(channel: Connection, limits: Limits, function: Callable[..., Any], arguments: Arguments) -> None:
    """Make the call, in the child."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    restrict(limits, 1)
    with suppress(OSError):  # the parent is gone
        answer(channel.send, limits, function, arguments)


def answer(
    send: Callable[[tuple[bool, Any]], None], limits: Limits, function: Callable[..., Any], arguments: Arguments
) -> bool:
    """Make a call and send (True, its result) or (False, why there is none); return which. Raises what `send` does."""
    try:
        result = function(*arguments)
        send((True, result))
    except MemoryError:
        reason: str = Phrase("memory limit of {megabytes} MB", megabytes=limits.megabytes)
    except (RecursionError, PickleError):
        reason = "its result is nested too deeply"
    except Exception as bug:  # noqa: BLE001 - the boundary of a call: a bug in one must not lose the others
        reason = as_bug(bug)
    else:
        return True
    send((False, reason))
    return False
