#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""check_manual.py CMAKE BUILD PACKAGING: as installed, every command has its man page, every option of the help is in it and is completed by
bash, zsh and fish, and the file type knows the files."""
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

BASH = """
source "$1"
shift
COMP_WORDS=("$@")
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
_bmt
printf '%s\\n' "${COMPREPLY[@]}"
"""


def complete(bash, *words):
    return subprocess.run(
        ["bash", "-c", BASH, "bash", bash, *words], capture_output=True, text=True, check=True).stdout.split()


def read(*parts):
    with open(os.path.join(*parts), encoding="utf-8") as file:
        return file.read()


def check(bmt, prefix, pages, wrong):
    share = os.path.join(prefix, "share")
    bash = os.path.join(share, "bash-completion", "completions", "bmt")
    zsh = read(share, "zsh", "vendor-completions", "_bmt")
    fish = read(share, "fish", "vendor_completions.d", "bmt.fish")
    options = 0
    for command, page in pages.items():
        name = "-".join(("bmt",) + command)
        path = os.path.join(share, "man", "man1", name + ".1")
        if not os.path.exists(path):
            wrong.append(f"{name} has no man page")
            continue
        manual = read(path).replace("\\-", "-")
        completed = complete(bash, "bmt", *command, "--") if command else []
        for option in page.options:
            options += 1
            long = [each for each in option.names if each.startswith("--")]
            for each in option.names:
                if each not in manual:
                    wrong.append(f"{each} is not in {name}.1")
            if command and not set(long) <= set(completed):
                wrong.append(f"bash does not complete {long} of {name}")
            if command and not all(f"'{each}[" in zsh for each in long):
                wrong.append(f"zsh does not complete {long} of {name}")
            if command and not all(re.search(rf"from {command[0]}'.* -l {each[2:]} ", fish) for each in long):
                wrong.append(f"fish does not complete {long} of {name}")
    if complete(bash, "bmt", "ren") != ["render"]:
        wrong.append("bash does not complete 'bmt ren'")
    if set(complete(bash, "bmt", "build", "--compression", "")) != {"fast", "none", "small"}:
        wrong.append("bash does not complete the values of --compression")
    print(len(pages), "pages,", options, "options")
    return options


def check_type(bmt, prefix, wrong):
    tree = ElementTree.parse(os.path.join(prefix, "share", "mime", "packages", "multitriangulation.xml"))
    space = {"m": "http://www.freedesktop.org/standards/shared-mime-info"}
    value = tree.find(".//m:match", space).get("value").encode().decode("unicode_escape").encode("latin-1")
    mesh, model = os.path.join(prefix, "sphere.ply"), os.path.join(prefix, "sphere.bmt")
    subprocess.run([bmt, "generate", "fractal-sphere", "--triangles", "1280", "-o", mesh], check=True, capture_output=True)
    subprocess.run([bmt, "build", mesh, "-o", model], check=True, capture_output=True)
    with open(model, "rb") as file:
        if file.read(len(value)) != value:
            wrong.append("the file type does not know a model")
    icon = os.path.join(prefix, "share", "icons", "hicolor", "scalable", "mimetypes", "model-x-multitriangulation.svg")
    ElementTree.parse(icon)


def main(cmake, build, packaging):
    sys.path.insert(0, packaging)
    import help as texts

    wrong = []
    with tempfile.TemporaryDirectory() as prefix:
        subprocess.run([cmake, "--install", build, "--prefix", prefix], check=True, capture_output=True)
        bmt = os.path.join(prefix, "bin", "bmt")
        pages = texts.read_all(bmt)
        check(bmt, prefix, pages, wrong)
        check_type(bmt, prefix, wrong)
    for each in wrong:
        print(each, file=sys.stderr)
    return 1 if wrong or len(pages) < 5 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
