# SPDX-License-Identifier: BSD-3-Clause
"""VTK's errors and warnings as Python's."""
import errno
import os
import warnings

from vtkmodules.util.misc import calldata_type
from vtkmodules.vtkCommonCore import VTK_STRING
from vtkmodules.vtkCommonMisc import vtkErrorCode


class MultiTriangulationError(RuntimeError):
    """Something could not be built, read, cut, drawn or verified; the text says what, where and what to do."""


class Listener:
    """Collects the errors of an algorithm while it works, and hands on its warnings as Python's."""

    def __init__(self, algorithm, ignore=()):
        self.errors = []
        self._ignore = ignore

        @calldata_type(VTK_STRING)
        def note(caller, event, text):
            self.errors.append(_strip(text))

        @calldata_type(VTK_STRING)
        def warn(caller, event, text):
            warnings.warn(_strip(text), stacklevel=6)

        self._observed = [
            (sender, sender.AddObserver(event, observer))
            for sender in (algorithm, algorithm.GetExecutive())
            for event, observer in (("ErrorEvent", note), ("WarningEvent", warn))
        ]

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        for sender, tag in self._observed:
            sender.RemoveObserver(tag)


def _strip(text):
    """The message of one of VTK's errors, without file, line and class."""
    return text.split("): ", 1)[-1].strip()


def fail(code, message, path=None):
    """Raises what a failed algorithm's error code and message stand for."""
    message = message or vtkErrorCode.GetStringFromErrorCode(code)
    if code == vtkErrorCode.FileNotFoundError:
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), path)
    if code == vtkErrorCode.OutOfDiskSpaceError:
        raise OSError(errno.ENOSPC, message, path)
    raise MultiTriangulationError(message)
