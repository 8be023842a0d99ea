# SPDX-License-Identifier: Apache-2.0 OR MIT
"""A limit on the processor time of both checkers: a file that keeps one of them busy is a finding, not a run that never ends."""
import resource
import signal

SECONDS = 60
TOO_SLOW = 6                                              # no exit code of a checker


class _TooSlow(BaseException):
    """No Exception, so that the checker does not take it for a bug of its own."""


def _stop(signum, frame):
    raise _TooSlow


def within_limit(check, *files):
    """check(*files), or TOO_SLOW as the code once that has taken SECONDS of processor time."""
    before = signal.signal(signal.SIGVTALRM, _stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, SECONDS)
    try:
        return check(*files)
    except _TooSlow:
        return TOO_SLOW, "takes more than %g s of processor time" % SECONDS
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def limit_process(pid, seconds=SECONDS):
    """The system ends the process (SIGXCPU) once it has taken so many seconds of processor time."""
    try:
        resource.prlimit(pid, resource.RLIMIT_CPU, (seconds, seconds + 1))
    except ProcessLookupError:                            # it has ended already
        pass
