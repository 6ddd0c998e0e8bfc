# SPDX-License-Identifier: BSD-3-Clause
"""Every public setting of the classes is a property of the plugin, with documentation, a range and the class's default.

usage: test_settings.py SOURCE_DIRECTORY

Settings are the setters of the public headers: what is not a property is named below, with the reason. Defaults are
asked of the classes themselves, by properties that only read, made here."""
import re
import sys
import xml.etree.ElementTree as tree
from pathlib import Path

from mtparaview import check, finish, load_plugin, servermanager, simple

ROOT = Path(sys.argv[1])
PROXIES = {  # class: headers that have its settings
    "vtkMTParaViewReader": ["IO/MultiTriangulation/vtkMultiTriangulationReader"],
    "vtkMultiTriangulationWriter": ["IO/MultiTriangulation/vtkMultiTriangulationWriter"],
    "vtkMTParaViewBuilder": ["Filters/Construction/vtkMultiTriangulationBuilder"],
    "vtkMultiTriangulationFileBuilder": ["Filters/Building/vtkMultiTriangulationFileBuilder"],
    "vtkMTParaViewCutFilter": ["Filters/General/vtkMultiTriangulationCutFilter"],
    "vtkMTParaViewSection": ["Filters/General/vtkMultiTriangulationSection"],
    "vtkMTParaViewTransform": ["Filters/General/vtkMultiTriangulationTransform"],
    "vtkMTPartitionFilter": ["Filters/Partition/vtkMTPartitionFilter", "Filters/Partition/vtkMTPartitionAlgorithm"],
    "vtkMTPartitionSequence": ["Filters/Partition/vtkMTPartitionSequence", "Filters/Partition/vtkMTPartitionAlgorithm"],
    "vtkMTCrossing": ["Filters/Partition/vtkMTCrossing"],
    "vtkMTSimplificationFilter": ["Filters/Simplification/vtkMTSimplificationFilter"],
    "vtkMTEdgeCollapse": ["Filters/Simplification/vtkMTEdgeCollapse"],
    "vtkMTVoronoiPartition": ["Filters/Partition/vtkMTVoronoiPartition"],
    "vtkMTRegularPartition": ["Filters/Partition/vtkMTRegularPartition"],
    "vtkMTKdPartition": ["Filters/Partition/vtkMTKdPartition"],
    "vtkMTQuadPartition": ["Filters/Partition/vtkMTDomainPartition"],
    "vtkMTHexagonPartition": ["Filters/Partition/vtkMTDomainPartition"],
    "vtkMTFractalSphereSource": ["Filters/Sources/vtkMTFractalSphereSource"],
    "vtkMTPlaneSource": ["Filters/Sources/vtkMTPlaneSource"],
    "vtkMultiTriangulationRepresentation": ["Rendering/OpenGL2/vtkMultiTriangulationMapper"],
}
EXCEPTIONS = {
    ("vtkMTParaViewBuilder", "SpoolStore"): "an object of C++",
    ("vtkMTParaViewBuilder", "Resume"): "there is no store to go on from",
    ("vtkMTParaViewBuilder", "InputIdentity"): "for checkpoints",
    ("vtkMultiTriangulationFileBuilder", "FileName"): "AddFileName",
    ("vtkMTParaViewCutFilter", "Renderer"): "the camera is given by numbers",
    ("vtkMTParaViewCutFilter", "View"): "the camera is given by numbers",
    ("vtkMTParaViewCutFilter", "Region"): "RegionFunction and UseRegion",
    ("vtkMTEdgeCollapse", "ModeByName"): "Mode",
    ("vtkMultiTriangulationRepresentation", "ColorBy"): "CutColoring",
    ("vtkMultiTriangulationRepresentation", "ColorByElevation"): "ParaView's Elevation filter and colour maps",
    ("vtkMultiTriangulationRepresentation", "DrawnShare"): "ranks know theirs",
}
SETTER = re.compile(r"vtkSet(?:Clamp|Vector\d|FilePath|StdStringFromChar)?Macro\((\w+)|void Set(\w+)\(|void Add(\w+Name)\(")
NAMED_VALUE = re.compile(r"To[A-Z]")


def read_properties():
    """Of every proxy of the plugin: class -> {command: element}."""
    classes = {}
    for file in sorted((ROOT / "ParaView/Plugin/Xml").glob("*.xml")):
        for proxy in tree.parse(file).iter():
            if "class" in proxy.attrib:
                classes[proxy.get("class")] = {
                    p.get("command"): p for p in proxy if p.get("command") and p.get("information_only") != "1"}
    return classes


def find_settings(header):
    text = (ROOT / (header + ".h")).read_text(encoding="utf-8")
    public = re.split(r"\nprotected:", text)[0]
    names = {next(filter(None, groups)) for groups in SETTER.findall(public)}
    return {name for name in names if not NAMED_VALUE.search(name)}


def check_presence(classes):
    for name, headers in PROXIES.items():
        commands = set(classes[name])
        settings = set().union(*(find_settings(header) for header in headers))
        missing = {s for s in settings
                   if "Set" + s not in commands and "Add" + s not in commands and (name, s) not in EXCEPTIONS}
        check(f"{name}: all {len(settings)} settings are properties", settings and not missing, *sorted(missing))


def check_documents(classes):
    for name, commands in classes.items():
        without = [c for c, p in commands.items()
                   if p.tag != "SubProxy" and (p.find("Documentation") is None or not p.find("Documentation").text)]
        unbounded = [c for c, p in commands.items() if p.tag in ("IntVectorProperty", "DoubleVectorProperty")
                     and not any(child.tag.endswith("Domain") for child in p) and p.get("repeat_command") != "1"]
        check(f"{name}: properties have documentation and a range", not without and not unbounded, *without, *unbounded)


def ask_defaults(name, commands):
    """What an untouched object answers."""
    kinds = {"IntVectorProperty": "Int", "DoubleVectorProperty": "Double", "IdTypeVectorProperty": "IdType",
             "StringVectorProperty": "String"}
    asked = {c[3:]: p for c, p in commands.items()
             if c.startswith("Set") and p.get("number_of_elements") == "1" and p.tag in kinds}
    text = "".join(f'<{p.tag} name="{n}" command="Get{n}" information_only="1"><Simple{kinds[p.tag]}InformationHelper/>'
                   f"</{p.tag}>" for n, p in asked.items())
    servermanager.vtkSMProxyManager.GetProxyManager().GetActiveSessionProxyManager().GetProxyDefinitionManager() \
        .LoadConfigurationXMLFromString('<ServerManagerConfiguration><ProxyGroup name="mt_asked">'
                                        f'<Proxy name="{name}" class="{name}">{text}</Proxy></ProxyGroup>'
                                        "</ServerManagerConfiguration>")
    proxy = servermanager.ProxyManager().NewProxy("mt_asked", name)
    proxy.UpdateVTKObjects()
    proxy.UpdatePropertyInformation()
    return {n: (p.get("default_values", ""), proxy.GetProperty(n)) for n, p in asked.items()}


def check_defaults(classes):
    for name in PROXIES:
        if name in ("vtkMultiTriangulationRepresentation", "vtkMTParaViewCutFilter"):
            continue  # setters alone: their defaults are pushed to an object that has the same
        wrong, compared = [], 0
        for setting, (default, value) in ask_defaults(name, classes[name]).items():
            if value.GetNumberOfElements() == 0:
                continue
            answer = value.GetElement(0)
            if value.IsA("vtkSMStringVectorProperty"):
                same = (answer or "") == default
            else:
                same = float(answer) == min(float(default), 1e299)  # ParaView's largest
            compared += 1
            if not same and not setting.endswith("FileName"):
                wrong.append(f"{setting}: {default} and not {answer}")
        check(f"{name}: {compared} defaults are the class's", not wrong, *wrong)


load_plugin()
simple.CreateView("RenderView")
found = read_properties()
check_presence(found)
check_documents(found)
check_defaults(found)
finish()
