#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The check of the language is checked: words planted in comments, messages and documents are found, and only there."""
import tempfile
import unittest
from pathlib import Path

import check_language
import wrap_markdown


class PlantedWords(unittest.TestCase):
    def hits(self, name, content):
        return [(line, words) for line, words, _ in check_language.check_file(name, content)]

    def test_each_pattern_finds_its_word(self):
        planted = (
            "what is said in a byte", "no disk to be had", "values that nobody asks for",
            "triangles speak of points", "the patch in hand",
            "patches at hand", "it puts the fragments together", "parts that hang together", "the classes of floor 0",
            "before cutting it", "the file is cut here", "cut along a curve", "it cuts the mesh", "programs read, cut and draw",
            "a side stream", "in stream order", "a piece of the file", "the same count, give or take one", "it goes on for ever",
            "it runs to and fro", "turned round", "it needs not wait", "in the place of a number",
        )
        self.assertEqual(len(planted), len(check_language.WORDS))
        for (pattern, _), text in zip(check_language.WORDS, planted):
            found = self.hits("Module/vtkMTOne.h", f"// {text}\n")
            self.assertTrue(found, (pattern, text))
            self.assertEqual(found[0][0], 1)

    def test_words_are_found_across_lines_of_a_comment(self):
        self.assertEqual(self.hits("Module/a.h", "int x;\n/**\n * no mesh to be\n * had\n */\n"), [(3, "to be had")])
        self.assertEqual(self.hits("Module/a.h", "// no mesh to be\n// had\n"), [(1, "to be had")])
        self.assertEqual(self.hits("a.md", "no mesh to be\nhad\n"), [(1, "to be had")])

    def test_messages_are_looked_at_and_code_is_not(self):
        self.assertEqual(self.hits("Module/a.cxx", 'int said = 0; Piece piece;\nerror = "is cut off";\n')[0][0], 2)
        self.assertEqual(self.hits("Module/a.cxx", "int said = 0; Piece piece;\n"), [])
        self.assertEqual(self.hits("a.md", "`piece`\n\n    piece = said\n\n```cpp\npiece\n```\n"), [])
        self.assertEqual(self.hits("CMake/a.cmake", "set(said 1) # as said\n"), [(1, "said")])

    def test_right_uses_are_not_found(self):
        for text in ("the cut and the view", "a cut of the model", "conforming cuts", "a triangle stream", "the floor's triangles",
                     "VTP files of several pieces", "the largest error in that cut"):
            self.assertEqual(self.hits("Module/a.h", f"// {text}\n"), [], text)
        self.assertEqual(self.hits("Filters/Certification/a.h", "// a piece of a triangle\n"), [])

    def test_long_lines_of_markdown_are_found(self):
        long = "word " * 30
        self.assertEqual(self.hits("a.md", f"short\n\n{long}\n")[0][0], 3)
        for right in (f"| {long} |\n", f"```\n{long}\n```\n", f"    {long}\n", f"![{long}](picture.png)\n", "x" * 150 + "\n"):
            self.assertEqual(self.hits("a.md", right), [], right)

    def test_wrapping_makes_lines_short_and_keeps_the_words(self):
        text = "# Title\n\n" + "word " * 50 + "\n- " + "item " * 40 + "\n\n| " + "cell " * 40 + "|\n"
        wrapped = wrap_markdown.wrap(text)
        self.assertEqual(wrap_markdown.find_long_lines(wrapped), [])
        self.assertEqual(wrapped.split(), text.split())
        self.assertEqual(wrap_markdown.wrap(wrapped), wrapped)
        self.assertIn("\n`bmt info model.bmt`", wrap_markdown.wrap("x" * 110 + " `bmt info\nmodel.bmt` and more\n"))

    def test_the_command_fails_on_a_hit_and_on_an_empty_tree(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(check_language.main([folder]), 1)
            (Path(folder) / "README.md").write_text("A mesh.\n", encoding="utf-8")
            self.assertEqual(check_language.main([folder]), 0)
            (Path(folder) / "README.md").write_text("As said.\n", encoding="utf-8")
            self.assertEqual(check_language.main([folder]), 1)

    def test_dead_links_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "README.md").write_text(
                "[this](README.md#top) [that](https://example.org/x) `[code](x.md)`\n\n[gone](gone.md)\n", encoding="utf-8")
            self.assertEqual(check_language.check(root)[0], ["README.md:3: there is no gone.md"])


if __name__ == "__main__":
    unittest.main()
