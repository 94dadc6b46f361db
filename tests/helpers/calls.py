"""Functions that are called in other processes: what is sent there must be one of a module."""

import os
import signal
import sys
import time


def process_after(seconds):
    """Sleep, and tell which process this is; a negative time is waited for without end."""
    time.sleep(seconds if seconds >= 0 else 1000)
    return os.getpid()


def die(number):
    """End by a signal."""
    os.kill(os.getpid(), number)


def deep(size):
    """Return lists within lists."""
    found = []
    for _ in range(size):
        found = [found]
    return found


def fail(message):
    raise ValueError(message)


def greedy(megabytes):
    """Take memory."""
    return len(bytearray(megabytes * 2**20))


def modules():
    """Tell what is loaded, and what `__main__` is."""
    return sorted(sys.modules), getattr(sys.modules["__main__"], "__file__", None), sys.path


def hears_interrupts():
    """Whether Ctrl-C would reach this process."""
    return signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, ()) and (
        signal.getsignal(signal.SIGINT) is not signal.SIG_IGN
    )


def start_child(path):
    """Start a process as TeX is started, write its number to a file, and be stuck."""
    import subprocess  # noqa: PLC0415 - only here

    child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(1000)"])
    with open(path, "w", encoding="ascii") as file:  # noqa: PTH123
        file.write(str(child.pid))
    time.sleep(1000)


def wait_until(holds, seconds=20):
    end = time.monotonic() + seconds
    while not holds() and time.monotonic() < end:
        time.sleep(0.02)
    return holds()
