#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the language of comments, documents and messages to the terms of the field, Markdown to 120 columns, and its
links to files that are there.

usage: check_language.py SOURCE_DIRECTORY

Of sources, comments and string literals are looked at; of Markdown, all but code. WORDS has what must not be written and
what to write instead, ALLOWED where a word is right. Exit code 0, or 1 and one line per hit.
"""
import re
import subprocess
import sys
from pathlib import Path

import wrap_markdown

# Pattern (upper and lower case alike), and what to write instead.
WORDS = (
    (r"\bsaid\b", "encoded, stored, given, reported"),
    (r"\bto be had\b", "available"),
    (r"\b(nobody|somebody)\b", "the thread, caller or user that is meant; not requested, not used"),
    (r"\b(speak|speaks|speaking) of\b", "refer to, hold for, are those of"),
    (r"\bin hand\b", "in work, being processed"),
    (r"\bat hand\b", "in memory, resident"),
    (r"\b(put|puts|putting)\b[^.;:|]{0,50}\btogether\b", "assemble"),
    (r"\b(hang|hangs|hanging) together\b", "are connected"),
    (r"\bfloors? [0-9]\b|\bfloor by floor\b|\bfloor zero\b|FloorsAreKept|check_floors|Testing/Floors", "layer"),
    (r"\bcutting\b", "splitting"),
    (r"\b(is|are|was|were|be|been|being) cut\b(?! (and|extraction))", "is split; of files: is truncated"),
    (r"\bcuts? (along|into|off|up|apart)\b|\bcuts through\b", "split; of files: truncated"),
    (r"\bto cut\b|\bcuts (an?|the|every|each|its|fragments|pieces|points|regions|files)\b|\bcut (them|it) ", "split"),
    (r"\breads?,? cuts?,? (and|or) draws?\b", "read models, extract cuts and draw them"),
    (r"\bside streams?\b|\bstreams? of (vert|bytes|bits|numbers|values|codes|triangle data)", "sequence, bytes, buffer"),
    (r"\bstream order\b|\bstream by stream\b|\bper stream\b|\bvertex streams?\b", "order of use; buffer"),
    (r"\bpieces?\b", "part, block, chunk (a piece is one of a triangle, in the certification)"),
    (r"\bgive or take\b", "differ by at most"),
    (r"\bfor ever\b", "without end"),
    (r"\bto and fro\b", "back and forth"),
    (r"\b(turn|turns|turned|turning) round\b", "reverse"),
    (r"\bneeds not\b", "does not need to"),
    (r"\bin the place of\b", "instead of"),
)
# (pattern of WORDS, beginning of the path): the word is right there.
ALLOWED = (
    (r"\bpieces?\b", "Filters/Certification/"),
    (r"\bpieces?\b", "Filters/Verification/"),
    (r"\bpieces?\b", "Testing/Certification/"),
    (r"\bpieces?\b", "Testing/Verification/"),
    (r"\bpieces?\b", "IO/Mesh/Vtk/vtkMTVtpStream"),
    (r"\bpieces?\b", "CONTRIBUTING.md"),
    (r"\bpieces?\b", "Documentation/decisions/README.md"),
    (r"\bpieces?\b", "Documentation/decisions/0011"),
    (r"\bpieces?\b", "Documentation/decisions/0014"),
    (r"\bpieces?\b", "Documentation/decisions/0015"),
)
# VTK's XML files have pieces by name; a link may have a name that was given before.
RIGHT = re.compile(r"VTP(\s+files?)?\s+of[\s*]+(one|several)\s+pieces?|<Piece|</Piece|\]\([^)]*\)|`[^`]*`")
# The lists of words themselves.
EXEMPT = ("Testing/Format/check_language.py", "Testing/Format/test_check_language.py")
CPP = (".h", ".hxx", ".cxx", ".cpp", ".glsl", ".in")
HASH = (".py", ".cmake", ".txt", ".module", ".yml", ".bash", "")
CPP_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)
HASH_TEXT = re.compile(r'"""(?:.|\n)*?"""|#[^\n]*|"(?:\\.|[^"\\\n])*"')
CODE = re.compile(r"^```.*?^```|^(?:    [^\n]*\n)+|`[^`\n]*`", re.MULTILINE | re.DOTALL)

LINE_END = re.compile(r"\n(?:[ \t]*(?://+!?<?|\*|#)[ \t]+|[ \t]*)")


def blank(match):
    """The same number of lines, without the words."""
    return "\n" * match.group(0).count("\n")


def get_text(name, content):
    """Comments, string literals and documents: everything else is blank, and lines keep their numbers."""
    if name.endswith(".md"):
        return CODE.sub(blank, content)
    suffix = Path(name).suffix
    pattern = CPP_TEXT if suffix in CPP else HASH_TEXT if suffix in HASH else None
    if not pattern:
        return ""
    kept, end = [], 0
    for match in pattern.finditer(content):
        kept.append("\n" * content.count("\n", end, match.start()) or " ")
        if not content[:match.start()].endswith("#include "):
            kept.append(match.group(0))
        end = match.end()
    return "".join(kept)


def check_file(name, content):
    """(line, words, what to write instead) for every hit; words that a line's end parts are found too."""
    text = get_text(name, content)
    text = RIGHT.sub(lambda match: re.sub(r"[^\n]", " ", match.group(0)), text)
    # An end of a line, with what begins the next line of a comment, is one blank; starts are the places of these blanks.
    starts, removed = [], 0
    for match in LINE_END.finditer(text):
        starts.append(match.start() - removed)
        removed += len(match.group(0)) - 1
    running = LINE_END.sub(" ", text)
    hits = []
    for pattern, instead in WORDS:
        if any(pattern == word and name.startswith(begin) for word, begin in ALLOWED):
            continue
        for match in re.finditer(pattern, running, re.IGNORECASE):
            line = 1 + sum(1 for start in starts if start < match.start())
            hits.append((line, match.group(0), instead))
    if name.endswith(".md"):
        for line in wrap_markdown.find_long_lines(content):
            hits.append((line, f"more than {wrap_markdown.WIDTH} columns", "Testing/Format/wrap_markdown.py FILE"))
    return sorted(hits)


def find_dead_links(root, name, content):
    """(line, link) for every link of a document to a file that is not there."""
    text = CODE.sub(blank, content)
    for match in re.finditer(r"\]\(([^)#\s]+)(#[^)]*)?\)", text):
        if not re.match(r"[a-z]+:", match.group(1)) and not (root / name).parent.joinpath(match.group(1)).exists():
            yield 1 + text.count("\n", 0, match.start()), match.group(1)


def list_files(root):
    """The tracked files; of a release archive, all files outside build folders."""
    try:
        listed = subprocess.run(["git", "-C", str(root), "ls-files", "-co", "--exclude-standard"], capture_output=True,
            text=True, check=True).stdout.splitlines()
    except (OSError, subprocess.CalledProcessError):
        listed = [str(file.relative_to(root)) for file in root.rglob("*") if file.is_file()]
    return sorted(name for name in listed if not name.startswith("build") and (root / name).is_file())


def check(root):
    """All hits as lines of text, and the number of files that were looked at."""
    violations, files = [], 0
    for name in list_files(root):
        if name in EXEMPT:
            continue
        try:
            content = (root / name).read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        files += 1
        for line, link in find_dead_links(root, name, content) if name.endswith(".md") else ():
            violations.append(f"{name}:{line}: there is no {link}")
        for line, words, instead in check_file(name, content):
            violations.append(f"{name}:{line}: \"{' '.join(words.split())}\"; write: {instead}")
    return violations, files


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    violations, files = check(Path(arguments[0]))
    for violation in violations:
        print(violation)
    print(f"{files} files, {len(violations)} hits")
    return 1 if violations or not files else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
