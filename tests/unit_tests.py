#!/usr/bin/env python3
"""Finds the tests of one unit, for `./dev test UNIT`.

unit_tests.py UNIT prints a line for each test program: its name, a tab, a filter for GTEST_FILTER. UNIT is a file's name
with or without folders and ending (passes/Native/TapSum.cpp, TapSum). A test file is the unit's where its own name begins
with the unit's, or where it includes the unit's header. Exit code 1, with the nearest names, where there is none.
"""
import difflib
import pathlib
import re
import sys

TESTS = pathlib.Path(__file__).resolve().parent
# As in tests/CMakeLists.txt: folders whose files, and whose folders' files, are one program.
ROOMS = ["project", "settings", "passes", "pipeline", "stability"] + [f"rdg/{p.name}" for p in (TESTS / "rdg").iterdir()]
KINDS = {"TEST": "{0}.{1}", "TEST_F": "{0}.{1}", "RC_GTEST_PROP": "{0}.{1}", "TEST_P": "*{0}.{1}/*", "TYPED_TEST": "*{0}/*.{1}"}


def find_tests(text):
    for kind, suite, name in re.findall(r"^(\w+)\(\s*(\w+),\s*(\w+)", text, re.M):
        if kind in KINDS:
            yield KINDS[kind].format(suite, name)


def main(unit):
    stem = pathlib.PurePath(unit).name.split(".")[0]
    includes = re.compile(r'^#include "(?:[^"]*/)?%s\.h"' % re.escape(stem), re.M)
    filters, names = {}, set()
    for room in ROOMS:
        for path in sorted(p for p in (TESTS / room).rglob("*.cpp") if "NegativeCompile" not in p.parts):
            text = path.read_text()
            names.add(path.stem.removesuffix("Test"))
            if path.stem.startswith(stem) or includes.search(text):
                filters.setdefault("test_" + room.replace("/", "_"), []).extend(find_tests(text))
    filters = {program: tests for program, tests in filters.items() if tests}
    for program, tests in filters.items():
        print(program, ":".join(tests), sep="\t")
    if not filters:
        near = ", ".join(difflib.get_close_matches(stem, names, 3)) or "see ctest -N"
        print(f"dev: no test is called {unit}, and no test file names a unit of that name; nearest: {near}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]) if len(sys.argv) == 2 else __doc__)
