#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the layers (Documentation/architecture.md): which folder may use which.

usage: check_layers.py SOURCE_DIRECTORY

Evidence: DEPENDS and PRIVATE_DEPENDS of every vtk.module, the #include lines of every source, and headers of another folder
whose module vtk.module does not name. What a browser can run (graph, cut, view, target cut, follower, DAG reader, decoders)
includes no VTK header but vtkType.h, neither itself nor through the toolkit's own headers. CGAL is included in its folder
and in one source of the report, which is not installed. Exit code 0 and what was looked
at, or 1 and one line per violation.
"""
import re
import sys
from pathlib import Path

OPENGL = r"^(opengl|glew|RenderingOpenGL2|RenderingUI)$"
RENDERING = r"^(opengl|glew|Rendering.*|Interaction.*|Views.*|Charts.*)$"
INPUT_OUTPUT = r"^IO.*$"
BOTH = f"{RENDERING}|{INPUT_OUTPUT}"
MESH_FILES = r"^IO(Geometry|PLY|Legacy|XML.*|Import)$"
# Folder: (module name, the toolkit's folders that it may use beside Module, VTK modules that it must not use).
LAYERS = {
    # Layer 0
    "Module": ("MTCore", (), BOTH),
    # Layer 1
    "Filters/Sources": ("MTSources", (), BOTH),
    "Filters/Partition": ("MTPartition", (), BOTH),
    "Filters/Simplification": ("MTSimplification", (), BOTH),
    "Filters/Core": ("MTFiltersCore", (), BOTH),
    "Filters/Certification": ("MTCertification", (), BOTH),
    "Filters/Verification": ("MTVerification", (), RENDERING),
    "IO/Core": ("MTIOCore", (), RENDERING),
    "Rendering/Core": ("MTRenderingCore", (), f"{RENDERING}|{INPUT_OUTPUT}"),
    # Layer 2
    "IO/MultiTriangulation": ("MTIO", ("IO/Core",), f"{RENDERING}|{MESH_FILES}"),
    "IO/Mesh": ("MTIOMesh", ("IO/Core",), RENDERING),
    "IO/Image": ("MTIOImage", ("IO/Core",), RENDERING),
    "Filters/Construction": (
        "MTConstruction",
        ("Filters/Core", "Filters/Partition", "Filters/Simplification", "Filters/Certification"),
        BOTH,
    ),
    "Rendering/OpenGL2": ("MTRenderingOpenGL2", ("Rendering/Core",), INPUT_OUTPUT),
    # Layer 3
    "Filters/General": ("MTFilters", ("IO/MultiTriangulation", "Rendering/Core"), f"{OPENGL}|{MESH_FILES}"),
    "Filters/Building": (
        "MTBuilding",
        ("IO/Core", "IO/MultiTriangulation", "IO/Mesh", "IO/Image", "Filters/Core", "Filters/Partition",
         "Filters/Simplification", "Filters/Construction"),
        RENDERING,
    ),
    "Interaction/Viewer": ("MTInteraction", ("IO/Core", "Rendering/OpenGL2", "Filters/General"), f"{OPENGL}|{MESH_FILES}"),
}
# Layer 4 meets everything; only the rules about CGAL, OpenGL and JSON hold there.
TOP = ("Applications", "Examples", "ParaView", "Testing")
CGAL_FOLDER = "Filters/Simplification"
# The one source elsewhere that includes it: the report's second oracle, in a program that is not installed.
CGAL_SOURCE = "Testing/Report/MTReportCgal.cxx"
JSON_FOLDERS = ("IO/Mesh", "Applications", "Testing")
# What runs without VTK: these, and every header of the toolkit that they include.
WITHOUT_VTK = {
    "Module": ("vtkMTGraph", "vtkMTCut", "vtkMTMadeNormals", "vtkMTView"),
    "Rendering/Core": ("vtkMTTargetCut", "vtkMTArcViews", "vtkMTArcProjector", "vtkMTCutFollower"),
    "IO/MultiTriangulation": (
        "vtkMTFileBlocks", "vtkMTFileDag", "vtkMTFileDagReader", "vtkMTFileDagWalk",
        "vtkMTFileMetadata", "vtkMTFilePages", "vtkMTFilePatches", "vtkMTPatchCodec", "vtkMTPackedGeometry", "vtkMTRawGeometry",
        "vtkMTTriangleDecoder", "vtkMTPositionCodec", "vtkMTIdCodec", "vtkMTColumnCodec", "vtkMTNormalCodec", "vtkMTByteCodec", "vtkMTRiceCode",
    ),
}
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
    name, allowed, forbidden = LAYERS[folder]
    file = root / folder / "vtk.module"
    if not file.exists():
        return set()
    folder_of = {entry[0]: key for key, entry in LAYERS.items()}
    named = set()
    for depend in read_depends(file):
        package, _, module = depend.partition("::")
        if package == "MultiTriangulation":
            used = folder_of.get(module)
            named.add(used)
            if used != "Module" and used not in allowed:
                violations.append(f"{folder}/vtk.module: {name} must not depend on {depend}")
        elif package == "VTK" and re.match(forbidden, module):
            violations.append(f"{folder}/vtk.module: {name} must not depend on {depend}")
    return named


def check_includes(root, folder, owner_of_header, named, violations):
    """Checks the include lines of one folder and gives the number of files and of includes."""
    files = includes = 0
    allowed = LAYERS[folder][1] if folder in LAYERS else None
    for file in sources_of(root, folder):
        files += 1
        text = file.read_text(encoding="utf-8", errors="replace")
        for match in INCLUDE.finditer(text):
            includes += 1
            header = match.group(1)
            where = f"{file.relative_to(root)}:{text.count(chr(10), 0, match.start()) + 1}"
            if header.startswith("CGAL/") and folder != CGAL_FOLDER and file.relative_to(root).as_posix() != CGAL_SOURCE:
                violations.append(f"{where}: CGAL (GPL) is included in {CGAL_FOLDER} only, not {header}")
            if header.startswith("nlohmann/") and folder not in JSON_FOLDERS:
                violations.append(f"{where}: JSON is read and written in {', '.join(JSON_FOLDERS)} only, not {header}")
            if OPENGL_HEADER.match(header) and folder not in OPENGL_FOLDERS:
                violations.append(f"{where}: {folder} must not include OpenGL's {header}")
            owner = owner_of_header.get(header.rsplit("/", 1)[-1])
            if allowed is None or owner is None or owner == folder:
                continue
            if owner != "Module" and owner not in allowed:
                violations.append(f"{where}: {folder} must not include {header} of {owner}")
            elif owner not in named:
                violations.append(f"{where}: {header} of {owner} is included, but vtk.module does not name {LAYERS[owner][0]}")
    return files, includes


def check_not_installed(root, violations):
    """What is linked with CGAL_SOURCE stays where it was built."""
    for file in sorted((root / CGAL_SOURCE).parent.glob("*CMake*")):
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            if re.match(r"\s*install\s*\(", line, re.IGNORECASE):
                violations.append(f"{file.relative_to(root)}:{number}: what includes CGAL (GPL) beside {CGAL_FOLDER} is not installed")


def find_vtk_headers(root, start, file_of_header):
    """(file, header) for every VTK header but vtkType.h that the file includes, also through the toolkit's headers."""
    seen, waiting, found = {start}, [start], []
    while waiting:
        file = waiting.pop()
        for match in INCLUDE.finditer(file.read_text(encoding="utf-8", errors="replace")):
            header = match.group(1)
            own = file_of_header.get(header)
            if own and own not in seen:
                seen.add(own)
                waiting.append(own)
            elif not own and re.match(r"vtk(?!MT\w+Module\.h$|Type\.h$)", header):
                found.append((file.relative_to(root), header))
    return found


def check_without_vtk(root, violations):
    """Gives the number of sources that were looked at."""
    file_of_header = {
        file.name: file for folder in LAYERS for file in sources_of(root, folder) if file.suffix == ".h"
    }
    looked_at = 0
    for folder, names in WITHOUT_VTK.items():
        for name in names:
            for file in (root / folder / f"{name}.h", root / folder / f"{name}.cxx"):
                if file.exists():
                    looked_at += 1
                    for where, header in find_vtk_headers(root, file, file_of_header):
                        violations.append(f"{file.relative_to(root)} is to run without VTK, but {where} includes {header}")
    return looked_at


def check(root):
    """All violations, and what was looked at: modules, files, includes."""
    violations = []
    owner_of_header = {}
    for folder, (name, _, _) in LAYERS.items():
        owner_of_header[f"vtk{name}Module.h"] = folder
        for file in sources_of(root, folder):
            if file.suffix == ".h":
                owner_of_header[file.name] = folder
    modules = files = includes = 0
    check_without_vtk(root, violations)
    check_not_installed(root, violations)
    for folder in LAYERS:
        modules += (root / folder / "vtk.module").exists()
        named = check_module_file(root, folder, violations)
        counts = check_includes(root, folder, owner_of_header, named, violations)
        files, includes = files + counts[0], includes + counts[1]
    for folder in TOP:
        counts = check_includes(root, folder, owner_of_header, set(), violations)
        files, includes = files + counts[0], includes + counts[1]
    for file in sorted(root.rglob("vtk.module")):
        folder = file.parent.relative_to(root).as_posix()
        if not folder.startswith(("build", ".", "ParaView/")) and folder not in LAYERS:
            violations.append(f"{folder}/vtk.module: the layers have no such folder")
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
