# SPDX-License-Identifier: LGPL-3.0-or-later
"""The program on a terminal of its own."""
import fcntl
import os
import pty
import struct
import subprocess
import termios

from support import BIN


def read_terminal(ours):
    """All that was written to the other side, which is closed; a terminal hands it over in pieces, and an error ends it."""
    output = b""
    while True:
        try:
            piece = os.read(ours, 65536)
        except OSError:
            break
        if not piece:
            break
        output += piece
    os.close(ours)
    return output.decode()


def run_on_terminal(*arguments, environment=None, columns=None, folder=None):
    """Standard output and error of a program that believes it writes to a terminal."""
    ours, theirs = pty.openpty()
    if columns:
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 40, columns, 0, 0))
    child = subprocess.Popen([BIN / "veritope", *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=theirs, stderr=theirs, cwd=folder,
                             env={**os.environ, "TERM": "xterm", **(environment or {})})
    os.close(theirs)
    output = read_terminal(ours)
    child.wait()
    return output
