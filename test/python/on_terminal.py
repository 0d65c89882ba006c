"""Runs a command on a pseudo terminal."""

import os
import pty
import time


def shown_by(command, environment):
    """Runs a command; returns its exit code, seconds, and pairs of seconds and text."""
    begin = time.monotonic()
    process, terminal = pty.fork()
    if process == 0:
        os.execvpe(command[0], command, environment)
    shown = []
    while True:
        try:
            part = os.read(terminal, 65536)
        except OSError:
            break
        if not part:
            break
        shown.append((time.monotonic() - begin, part.decode(errors="replace")))
    _, status = os.waitpid(process, 0)
    return os.waitstatus_to_exitcode(status), time.monotonic() - begin, shown
