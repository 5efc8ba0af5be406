#!/usr/bin/env python3
"""Finds the tests of one unit, for `./dev test UNIT`.

unit_tests.py UNIT prints a line for each test program: its name, a tab, a filter for GTEST_FILTER. UNIT is a file's name
with or without folders and ending (passes/Native/TapSum.cpp, TapSum). A test file is the unit's where its own name begins
with the unit's, or where it includes the unit's header; of a unit without such a file, all test files of its room. It
prints nothing if UNIT is a pattern that one of ctest's names matches: that comes first. Exit code 1,
with the nearest names, where there is neither.
"""
import difflib
import pathlib
import re
import sys

TESTS = pathlib.Path(__file__).resolve().parent
# As in tests/CMakeLists.txt: folders whose files, and whose folders' files, are one program.
STOREYS = ["rdg", "settings", "passes", "pipeline"]
ROOMS = ["project", "settings", "passes", "pipeline", "pipeline/Live", "stability"] + sorted(
    str(p.relative_to(TESTS)) for p in (TESTS / "rdg").rglob("*") if p.name != "NegativeCompile" and any(p.glob("*.cpp")))
KINDS = {"TEST": "{0}.{1}", "TEST_F": "{0}.{1}", "RC_GTEST_PROP": "{0}.{1}", "TEST_P": "*{0}.{1}/*", "TYPED_TEST": "*{0}/*.{1}"}


def name_program(room):
    return re.sub("/([a-z]+/)?", "_", room)


def find_program(path):
    """The room whose program holds the test file: the innermost."""
    return max((room for room in ROOMS if TESTS / room in path.parents), key=len)


def find_room(folder):
    """The nearest folder of tests at or above the one that mirrors a source's folder."""
    return folder if folder.is_dir() or folder == TESTS else find_room(folder.parent)


def list_ctest_names():
    """As tests/CMakeLists.txt makes them: rooms, pages of docs/, and tests by name."""
    yield from map(name_program, ROOMS)
    yield from ("page_" + page.stem for page in (TESTS.parent / "docs").rglob("*.md"))
    for listing in TESTS.rglob("CMakeLists.txt"):
        yield from re.findall(r"add_test\(NAME (\w+) ", listing.read_text())


def find_tests(text):
    for kind, suite, name in re.findall(r"^(\w+)\(\s*(\w+),\s*(\w+)", text, re.M):
        if kind in KINDS:
            yield KINDS[kind].format(suite, name)


def find_filters(is_wanted):
    """The tests of the wanted files by program, and the names of all units."""
    filters, names = {}, set()
    for room in ROOMS:
        for path in sorted(p for p in (TESTS / room).rglob("*.cpp") if "NegativeCompile" not in p.parts and find_program(p) == room):
            text = path.read_text()
            names.add(path.stem.removesuffix("Test"))
            tests = list(find_tests(text)) if is_wanted(path, text) else []
            if tests:
                filters.setdefault("test_" + name_program(room), []).extend(tests)
    return filters, names


def main(unit):
    if any(re.search(unit, name) for name in list_ctest_names()):
        return 0
    stem = pathlib.PurePath(unit).name.split(".")[0]
    includes = re.compile(r'^#include "(?:[^"]*/)?%s\.h"' % re.escape(stem), re.M)
    sources = [source for storey in STOREYS for source in (TESTS.parent / storey).rglob(stem + ".*")]
    rooms = {find_room(TESTS / source.parent.relative_to(TESTS.parent)) for source in sources}
    filters, names = find_filters(lambda path, text: path.stem.startswith(stem) or includes.search(text))
    if not filters:
        filters, _ = find_filters(lambda path, text: rooms.intersection(path.parents))
    for program, tests in filters.items():
        print(program, ":".join(tests), sep="\t")
    if not filters:
        near = ", ".join(difflib.get_close_matches(stem, names, 3)) or "none"
        print(f"dev: no test is called {unit}, and no test file names a unit of that name; nearest: {near}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]) if len(sys.argv) == 2 else __doc__)
