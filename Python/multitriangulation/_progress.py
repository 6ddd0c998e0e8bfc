# SPDX-License-Identifier: BSD-3-Clause
"""How far long work has come, for whoever waits for it."""
import sys


def _has_terminal():
    return sys.stderr is not None and sys.stderr.isatty()


class _Bar:
    """A bar of tqdm's."""

    def __init__(self, tqdm, title):
        self._bar = tqdm(total=100.0, desc=title, bar_format="{desc} {percentage:3.0f} %|{bar}| {elapsed}<{remaining}")

    def __call__(self, fraction, text):
        self._bar.set_postfix_str(text, refresh=False)
        self._bar.update(max(0.0, 100.0 * fraction - self._bar.n))

    def close(self):
        self._bar.close()


class _Lines:
    """A line for every tenth, where there is no tqdm."""

    def __init__(self, title):
        self._title = title
        self._next = 0.1

    def __call__(self, fraction, text):
        if fraction >= self._next:
            print(f"{self._title}: {100.0 * fraction:.0f} % {text}".rstrip(), file=sys.stderr)
            self._next = 0.1 * (int(10.0 * fraction) + 1)

    def close(self):
        pass


def _make_display(wanted, title):
    if wanted is False or (wanted is None and not _has_terminal()):
        return None
    try:
        from tqdm import tqdm
    except ImportError:
        return _Lines(title) if wanted else None
    return _Bar(tqdm, title)


class Progress:
    """
    Shows an algorithm's progress while it works.

    wanted: None (a bar where there are tqdm and a terminal), True, False, or a function of the fraction that is done and
    of a text. An exception in that function ends the work and is raised when it has ended.
    """

    def __init__(self, algorithm, wanted, title):
        self._algorithm = algorithm
        self._display = None if callable(wanted) else _make_display(wanted, title)
        self._show = wanted if callable(wanted) else self._display
        self._exception = None
        self._tag = algorithm.AddObserver("ProgressEvent", self._advance) if self._show else None

    def _advance(self, caller, event):
        # An exception that left an observer would be printed and forgotten.
        try:
            if self._exception is None:
                self._show(caller.GetProgress(), caller.GetProgressText() or "")
        except BaseException as exception:  # noqa: B902
            self._exception = exception
            caller.SetAbortExecute(1)

    def __enter__(self):
        return self

    def __exit__(self, kind, value, trace):
        if self._tag is not None:
            self._algorithm.RemoveObserver(self._tag)
        if self._display is not None:
            self._display.close()
        if kind is None and self._exception is not None:
            raise self._exception
