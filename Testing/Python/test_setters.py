# SPDX-License-Identifier: BSD-3-Clause
"""Every setter of a number refuses what is not a number: of all classes of the package, found by their names."""
import importlib
import math
import pkgutil
import sys

from vtkmodules.vtkCommonCore import vtkObject

import multitriangulation

vtkObject.GlobalWarningDisplayOff()


def classes():
    for info in pkgutil.iter_modules(multitriangulation.__path__):
        if not info.name.startswith("vtk"):
            continue  # the functions' modules, which name classes of VTK's
        module = importlib.import_module(f"multitriangulation.{info.name}")
        for name, each in sorted(vars(module).items()):
            if isinstance(each, type) and each.__name__ == name and issubclass(each, vtkObject):
                yield each


def make(each):
    try:
        return each()
    except TypeError:
        return None  # abstract


def check(each, name):
    """Whether it takes a double, and what it does with NaN: (checked, problem)."""
    thing = make(each)
    getter = getattr(thing, "Get" + name[3:], None)
    if thing is None or getter is None:
        return False, ""
    try:
        before = getter()
    except TypeError:
        return False, ""
    if not isinstance(before, float):
        return False, ""
    time = thing.GetMTime()
    getattr(thing, name)(math.nan)
    after = getter()
    if after != before or thing.GetMTime() != time:
        return True, f"{each.__name__}.{name}(nan): {before} became {after}"
    value = 0.5 if before != 0.5 else 0.25
    getattr(thing, name)(value)
    return True, "" if getter() != before else f"{each.__name__}.{name}({value}) changes nothing"


def main():
    checked, problems = [], []
    for each in classes():
        for name in sorted(vars(each)):
            if name.startswith("Set") and callable(getattr(each, name)):
                done, problem = check(each, name)
                checked += [f"{each.__name__}.{name}"] if done else []
                problems += [problem] if problem else []
    print(len(checked), "setters:", ", ".join(checked))
    print("\n".join(problems))
    return 1 if problems or len(checked) < 15 else 0


if __name__ == "__main__":
    sys.exit(main())
