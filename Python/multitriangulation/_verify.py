# SPDX-License-Identifier: BSD-3-Clause
"""Checks of models."""
from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any, NamedTuple

from . import vtkMultiTriangulationVerifier
from ._build import _get_mesh, _get_paths
from ._errors import Listener, MultiTriangulationError, fail
from ._model import open_model
from ._progress import Progress


class Check(NamedTuple):
    """One check: its name, how much was tested, violations, the worst of what was measured over what is allowed, and the
    first violation in words."""

    name: str
    tested: int
    violations: int
    worst: float
    message: str


class Verification:
    """What `verify` found; true where nothing wrong was found."""

    def __init__(self, verifier):
        table = verifier.GetChecks()
        columns = [table.GetColumnByName(name) for name in Check._fields]
        #: A Check for each check.
        self.checks = [Check(*(column.GetValue(row) for column in columns)) for row in range(table.GetNumberOfRows())]
        #: Whether no check found a violation.
        self.valid = bool(verifier.IsValid())
        #: Whether the input was held against the model by readers that are not the builder's.
        self.input_checked = bool(verifier.GetInputChecked())
        #: How the input was read.
        self.input_reading = verifier.GetInputReading()
        #: Whether certified errors were tested against an input.
        self.certified = bool(verifier.GetCertified())

    def __bool__(self):
        return self.valid

    def __repr__(self):
        failed = [each.name for each in self.checks if each.violations]
        result = "valid" if self.valid else "not valid: " + ", ".join(failed)
        return f"<Verification: {result}; {len(self.checks)} checks>"


def verify(
    model: Any,
    input: Any = None,
    *,
    cuts: int = 100,
    samples: int = 500000,
    seed: int = 1,
    iso: float | None = None,
    vertical_scale: float = 1.0,
    degrees: bool = False,
    progress: bool | Callable[[float, str], None] | None = None,
) -> Verification:
    """
    Checks everything that is promised of a model and can be checked: every byte, the DAG, conforming cuts; with the input
    also the finest level and the certified errors.

    model: what `read` or `build` gave, or the name of a file. input: what it was built from, as for `build`.
    cuts: random cuts whose conformity is checked. samples: on each surface. seed: of both.
    iso, vertical_scale, degrees: as they were given to `build`. progress: as for `build`.
    Gives a Verification. That something is wrong is a result and no error; MultiTriangulationError says that the checks
    could not be made.
    """
    verifier = vtkMultiTriangulationVerifier()
    verifier.SetInputDataObject(0, open_model(model))
    verifier.SetNumberOfCuts(int(cuts))
    verifier.SetNumberOfSamples(int(samples))
    verifier.SetSeed(int(seed))
    paths = None if input is None else _get_paths(input)
    for path in paths or []:
        verifier.AddInputFileName(os.fspath(path))
    if input is not None and paths is None:
        verifier.SetInputDataObject(1, _get_mesh(input))
    if iso is not None:
        verifier.SetInputIsoValue(float(iso))
    verifier.SetInputVerticalScale(float(vertical_scale))
    verifier.SetInputDegrees(bool(degrees))
    with Listener(verifier) as listener, Progress(verifier, progress, "verify"):
        verifier.Update()
    if verifier.GetErrorMessage():
        fail(verifier.GetErrorCode(), verifier.GetErrorMessage())
    if listener.errors:
        raise MultiTriangulationError(listener.errors[0])
    if verifier.GetAbortExecute():
        raise KeyboardInterrupt
    return Verification(verifier)
