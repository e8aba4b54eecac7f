# SPDX-License-Identifier: Apache-2.0
"""The check that comments have a subject, and rooms a page."""

import importlib.util
import pathlib
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "check_comments.py"


class CheckComments(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        spec = importlib.util.spec_from_file_location("check_comments", SCRIPT)
        cls.check = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(cls.check)

    def lines(self, text, name="a.hpp"):
        """Numbers of the lines that the check complains of."""
        return [int(message.split(":")[1]) for message in self.check.mistakes(name, text)]

    def test_sentences_and_noun_phrases_pass(self):
        self.assertEqual(self.lines("// SPDX-License-Identifier: Apache-2.0\n"
                                    "/// Charge of the bottom electrode under the taxel [C].\nint a;\n"
                                    "/// In a sweep, the points share their mechanics.\nint b; ///< of the core [m]\n"
                                    "// The layers\n// of the skin.\nint c;\n"), [])

    def test_comments_without_a_subject(self):
        self.assertEqual(self.lines("/// Of the bottom electrode.\nint a;\n/// Whether it moves.\nint b;\n"
                                    "  // Those of the core.\nint c;\n/// That of the\n/// skin.\nint d;\n"), [1, 3, 5, 7])

    def test_comments_that_leave_the_subject_to_the_one_before(self):
        self.assertEqual(self.lines("/// The same of a file that is open.\nint a;\n/// Likewise of a pipe.\nint b;\n"
                                    "/// The same bits as alone.\nint c;\n"), [1, 3, 5])

    def test_headers_say_more_of_a_function_than_its_parameters(self):
        self.assertEqual(self.lines("/// @param a first\n///   of all\nint sum(int a);\n/// @param a first\nexplicit Sum(int a);\n"
                                    "/// Sum. @param a first\nint sum(int a);\n/// @returns the sum\nint sum();\n"), [1, 8])

    def test_unit_tests_are_named_in_capitalised_words(self):
        found = list(self.check.name_mistakes("a_test.cpp", "TEST(Contact, FindsTheForce) {}\nTEST_F(Contact,\n finds_the_area) {}\n"))
        self.assertEqual([one.split(": ")[0] for one in found], ["a_test.cpp:2"])
        self.assertIn("Contact.finds_the_area", found[0])

    def test_a_preposition_needs_a_comma_in_its_own_sentence(self):
        self.assertEqual(self.lines("/// Over the core [C]. One entry, if any.\nint a;\n/// On a drive, it swings.\nint b;\n"), [1])

    def test_words_that_only_begin_alike(self):
        self.assertEqual(self.lines("/// Offset of a line.\nint a;\n/// Outline of the body.\nint b;\n/// Whole skin.\nint c;\n"), [])

    def test_a_comment_behind_a_name_may_go_on_from_it(self):
        self.assertEqual(self.lines("double length; ///< along x [m]\nbool cut; ///< whether it is\nint n; ///< that follow\n"), [2, 3])

    def test_docstrings(self):
        text = '"""Numbers of a run."""\n\n\nclass A:\n    """What it is."""\n\n    def f(self):\n        """A\n        sum."""\n'
        self.assertEqual(self.lines(text, "a.py"), [5])

    def test_pages_of_rooms(self):
        self.assertEqual(list(self.check.page_mistakes("a", "**In:** b **Out:** c **Equations:** none **Begin with:** d")), [])
        self.assertEqual(list(self.check.page_mistakes("a", "**In:** b **Out:** c **Equations:** none")),
                         ["a/README.md: lacks **Begin with:**"])
        self.assertEqual(len(list(self.check.page_mistakes("a", None))), 1)


if __name__ == "__main__":
    unittest.main()
