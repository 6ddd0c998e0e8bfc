#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""make_completion.py BMT FOLDER: writes completions of bmt for bash (bmt), zsh (_bmt) and fish (bmt.fish), from the help texts."""
import os
import sys

import help

BASH = """# bash completion of bmt
_bmt()
{{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} command=${{COMP_WORDS[1]}}
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W "{commands} --help --version" -- "${{current}}"))
    return
  fi
  case "${{command}} ${{previous}}" in
{choices}
  esac
  if [[ ${{current}} == -* ]]; then
    case "${{command}}" in
{options}
    esac
    return
  fi
  COMPREPLY=($(compgen -f -- "${{current}}"))
}}
complete -o filenames -F _bmt bmt
"""

ZSH = """#compdef bmt
# zsh completion of bmt
_bmt()
{{
  local -a commands
  commands=(
{commands}
  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  case "${{words[2]}}" in
{options}
  esac
}}
_bmt "$@"
"""


def get_long(option):
    return [name for name in option.names if name.startswith("-")]


def quote(text):
    return text.replace("'", "'\\''")


def make_bash(pages):
    choices, options = [], []
    for command, page in pages.items():
        if not command:
            continue
        names = " ".join(name for option in page.options for name in get_long(option))
        options.append(f'      {command[0]}) COMPREPLY=($(compgen -W "{names}" -- "${{current}}")) ;;')
        for option in page.options:
            words = help.get_choices(option.takes)
            if words:
                cases = " | ".join(f'"{command[0]} {name}"' for name in get_long(option))
                choices.append(
                    f'    {cases}) COMPREPLY=($(compgen -W "{" ".join(words)}" -- "${{current}}")); return ;;')
    names = " ".join(command[0] for command in pages if command)
    return BASH.format(commands=names, choices="\n".join(choices), options="\n".join(options))


def make_zsh(pages):
    def describe(text):
        return quote(text).replace("[", "\\[").replace("]", "\\]").replace(":", "\\:")

    commands = "\n".join(f"    '{name}:{describe(text)}'" for name, text in pages[()].commands)
    cases = []
    for command, page in pages.items():
        if not command:
            continue
        lines = []
        for option in page.options:
            words = help.get_choices(option.takes)
            action = f":value:({' '.join(words)})" if words else ":value:_files" if option.takes else ""
            for name in get_long(option):
                lines.append(f"'{name}[{describe(option.text)}]{action}'")
        body = " \\\n        ".join(lines + ["'*:file:_files'"])
        cases.append(f"    {command[0]})\n      _arguments \\\n        {body} ;;")
    return ZSH.format(commands=commands, options="\n".join(cases))


def make_fish(pages):
    lines = ["# fish completion of bmt"]
    for name, text in pages[()].commands:
        lines.append(f"complete -c bmt -n __fish_use_subcommand -f -a {name} -d '{quote(text)}'")
    for command, page in pages.items():
        if not command:
            continue
        for option in page.options:
            words = help.get_choices(option.takes)
            takes = f" -x -a '{' '.join(words)}'" if words else " -r" if option.takes else ""
            names = "".join(
                f" -l {name[2:]}" if name.startswith("--") else f" -s {name[1:]}" for name in get_long(option))
            lines.append(
                f"complete -c bmt -n '__fish_seen_subcommand_from {command[0]}'{names}{takes} -d '{quote(option.text)}'")
    return "\n".join(lines) + "\n"


def main(bmt, folder):
    os.makedirs(folder, exist_ok=True)
    pages = help.read_all(bmt)
    for name, make in (("bmt", make_bash), ("_bmt", make_zsh), ("bmt.fish", make_fish)):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(make(pages))


if __name__ == "__main__":
    main(*sys.argv[1:])
