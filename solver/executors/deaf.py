"""Importing this module makes a process deaf to Ctrl-C, which a terminal sends to all: the one that began ends it."""

import signal

signal.signal(signal.SIGINT, signal.SIG_IGN)
