#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the floor plan (Documentation/architecture.md): which folder may use which.

usage: check_floors.py SOURCE_DIRECTORY

Three kinds of evidence: DEPENDS and PRIVATE_DEPENDS of every vtk.module, the #include lines of every source, and a floor's
header that is included without its module being named in vtk.module. Exit code 0 and the number of files and includes
looked at, or 1 and one line per violation.
"""
import re
import sys
from pathlib import Path

# Folder: (module name, the toolkit's folders that it may use, VTK modules and headers that it must not use).
OPENGL = r"^(opengl|glew|RenderingOpenGL2|RenderingUI)$"
RENDERING = r"^(opengl|glew|Rendering.*|Interaction.*|Views.*|Charts.*)$"
INPUT_OUTPUT = r"^IO.*$"
FLOORS = {
    "Module": ("MTCore", (), f"{RENDERING}|{INPUT_OUTPUT}"),
    "Filters/Partition": ("MTPartition", ("Module",), f"{RENDERING}|{INPUT_OUTPUT}"),
    "Filters/Simplification": ("MTSimplification", ("Module",), f"{RENDERING}|{INPUT_OUTPUT}"),
    "Filters/Construction": (
        "MTConstruction",
        ("Module", "Filters/Partition", "Filters/Simplification"),
        f"{RENDERING}|{INPUT_OUTPUT}",
    ),
    "IO": ("MTIO", ("Module",), RENDERING),
    "Rendering/Cut": ("MTCut", ("Module",), f"{OPENGL}|{INPUT_OUTPUT}"),
    "Rendering/OpenGL2": ("MTRenderingOpenGL2", ("Module", "Rendering/Cut"), INPUT_OUTPUT),
}
# The top floor meets everything; only the rule about CGAL holds there.
TOP = ("Applications", "Examples", "ParaView", "Testing")
CGAL_FOLDER = "Filters/Simplification"
OPENGL_HEADER = re.compile(r"^(vtkOpenGL|vtk_glew|vtk_glad|vtkShader|GL/|vtkTextureObject)")
OPENGL_FOLDERS = ("Rendering/OpenGL2", *TOP)
SOURCE_ENDINGS = (".h", ".hxx", ".hpp", ".cxx", ".cpp", ".cc", ".txx", ".in")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.MULTILINE)


def read_depends(file):
    """The values of DEPENDS, PRIVATE_DEPENDS and OPTIONAL_DEPENDS."""
    depends = []
    key = ""
    for line in file.read_text(encoding="utf-8").splitlines():
        line = line.split("#", 1)[0].rstrip()
        if line and not line[0].isspace():
            key = line.strip()
        elif line.strip() and key in ("DEPENDS", "PRIVATE_DEPENDS", "OPTIONAL_DEPENDS"):
            depends.append(line.strip())
    return depends


def sources_of(root, folder):
    base = root / folder
    for file in sorted(base.rglob("*")) if base.is_dir() else []:
        if file.is_file() and file.suffix in SOURCE_ENDINGS:
            yield file


def check_module_file(root, folder, violations):
    """Checks one vtk.module and gives the toolkit's folders that it names."""
    name, allowed, forbidden = FLOORS[folder]
    file = root / folder / "vtk.module"
    if not file.exists():
        return set()
    folder_of = {entry[0]: key for key, entry in FLOORS.items()}
    named = set()
    for depend in read_depends(file):
        package, _, module = depend.partition("::")
        if package == "MultiTriangulation":
            used = folder_of.get(module)
            named.add(used)
            if used not in allowed:
                violations.append(f"{folder}/vtk.module: {name} must not depend on {depend}")
        elif package == "VTK" and re.match(forbidden, module):
            violations.append(f"{folder}/vtk.module: {name} must not depend on {depend}")
    return named


def check_includes(root, folder, owner_of_header, named, violations):
    """Checks the include lines of one folder and gives the number of files and of includes."""
    files = includes = 0
    allowed = FLOORS[folder][1] if folder in FLOORS else None
    for file in sources_of(root, folder):
        files += 1
        text = file.read_text(encoding="utf-8", errors="replace")
        for match in INCLUDE.finditer(text):
            includes += 1
            header = match.group(1)
            where = f"{file.relative_to(root)}:{text.count(chr(10), 0, match.start()) + 1}"
            if header.startswith("CGAL/") and folder != CGAL_FOLDER:
                violations.append(f"{where}: CGAL (GPL) is included in {CGAL_FOLDER} only, not {header}")
            if OPENGL_HEADER.match(header) and folder not in OPENGL_FOLDERS:
                violations.append(f"{where}: {folder} must not include OpenGL's {header}")
            owner = owner_of_header.get(header.rsplit("/", 1)[-1])
            if allowed is None or owner is None or owner == folder:
                continue
            if owner not in allowed:
                violations.append(f"{where}: {folder} must not include {header} of {owner}")
            elif owner not in named:
                violations.append(f"{where}: {header} of {owner} is included, but vtk.module does not name {FLOORS[owner][0]}")
    return files, includes


def check(root):
    """All violations, and what was looked at: modules, files, includes."""
    violations = []
    owner_of_header = {}
    for folder, (name, _, _) in FLOORS.items():
        owner_of_header[f"vtk{name}Module.h"] = folder
        for file in sources_of(root, folder):
            if file.suffix == ".h":
                owner_of_header[file.name] = folder
    modules = files = includes = 0
    for folder in FLOORS:
        modules += (root / folder / "vtk.module").exists()
        named = check_module_file(root, folder, violations)
        counts = check_includes(root, folder, owner_of_header, named, violations)
        files, includes = files + counts[0], includes + counts[1]
    for folder in TOP:
        counts = check_includes(root, folder, owner_of_header, set(), violations)
        files, includes = files + counts[0], includes + counts[1]
    for file in sorted(root.rglob("vtk.module")):
        folder = file.parent.relative_to(root).as_posix()
        if not folder.startswith(("build", ".")) and folder not in FLOORS:
            violations.append(f"{folder}/vtk.module: the floor plan has no such folder")
    return violations, (modules, files, includes)


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    violations, (modules, files, includes) = check(Path(arguments[0]))
    if not modules:
        violations.append(f"{arguments[0]}: no vtk.module found")
    for violation in violations:
        print(violation)
    print(f"{modules} modules, {files} sources, {includes} includes, {len(violations)} violations")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
