#!/usr/bin/env python3
"""Compares the names that installed headers declare in the global namespace with GlobalNames.txt.

  global_names.py SOURCE           prints names that have no row, and rows without a name; exit code 1
  global_names.py SOURCE --list    prints the names, each with its header

A name of drydock's own stands in namespace Drydock, or begins with DRYDOCK_ or Drydock where it is a macro or extern "C".
"""
import pathlib
import re
import sys

TREES = ("passes", "rdg/core", "rdg/graph", "settings")
INNER = ("passes/Native/", "settings/Text/")  # not installed
TYPE = re.compile(r"\b(?:class|struct|union|enum class|enum)\s+(?:alignas\([^)]*\)\s*)?(?:\w+_API\s+)?(\w+)\s*(?:final\s*)?(?::[^:].*)?[{ ]*$")
MADE = re.compile(r"(?:BEGIN_\w*STRUCT\w*|DECLARE_\w+|DEFINE_\w+)\s*\(\s*(\w+)")
NOT_NAMES = {"static_assert", "alignas", "decltype", "if", "requires", "noexcept", "__attribute__"}


def outside_braces(text):
    """The text without what stands in braces: bodies, and namespaces with all in them."""
    kept, depth = [], 0
    for character in text:
        if character == "}":
            depth -= 1
        if depth == 0:
            kept.append(character)
        if character == "{":
            depth += 1
    return "".join(kept)


def without_templates(text):
    """The text without `template <...>`."""
    while found := re.search(r"\btemplate\s*<", text):
        end, depth = found.end(), 1
        while depth and end < len(text):
            depth += (text[end] == "<") - (text[end] == ">")
            end += 1
        text = text[:found.start()] + text[end:]
    return text


def declared(statement):
    """The names that one statement declares."""
    if found := re.match(r"(?:inline )?namespace (\w+)", statement):
        return [] if found[1] in ("Drydock", "std") else [found[1]]
    if made := MADE.findall(statement):
        return made
    if (found := TYPE.search(statement)) and not statement.startswith(("friend", "using", "typedef")):
        return [found[1]]
    if found := re.match(r"using (\w+) =|using (?:\w+::)*(\w+)$", statement):
        return [found[1] or found[2]]
    if (found := re.search(r"([\w:~]+)\s*\(", statement)) and "=" not in statement[:found.start()]:
        name = found[1]
        return [name] if statement[:found.start()].strip() and "::" not in name and name not in NOT_NAMES else []
    found = re.match(r"(?:extern|inline|constexpr|const|static|\w+_API)\s[^=]*?(\w+)(?:\[[^\]]*\])?\s*(?:=.*|\{)?$", statement)
    return [found[1]] if found else []


def names_of(text):
    text = re.sub(r"/\*.*?\*/", "", re.sub(r"//[^\n]*", "", text), flags=re.S).replace("\\\n", " ")
    taken_back = set(re.findall(r"^\s*#\s*undef\s+(\w+)", text, flags=re.M))
    names = set(re.findall(r"^\s*#\s*define\s+(\w+)", text, flags=re.M)) - taken_back
    text = re.sub(r"^\s*#.*$", "", text, flags=re.M)
    text = re.sub(r"\"(\\.|[^\"\\])*\"", '""', text)
    text = re.sub(r"(?<!\w)'(\\.|[^'\\])'", "' '", text)
    for statement in re.split(r"[;}]", without_templates(outside_braces(text))):
        names.update(declared(" ".join(statement.split())))
    return {name for name in names if not name.upper().startswith("DRYDOCK")}


def main():
    source = pathlib.Path(sys.argv[1])
    places = {False: {}, True: {}}  # headers that define names, and those that only name them
    for path in sorted(path for tree in TREES for path in (source / tree).rglob("*.h")):
        header = path.relative_to(source).as_posix()
        if not header.startswith(INNER):
            text = path.read_text(encoding="utf-8")
            for name in names_of(text):
                forward = re.search(rf"^(?:class|struct|enum class) {name}(?: : \w+)?;", text, flags=re.M)
                defined = re.search(rf"^(?:class|struct) (?:\w+_API )?{name}\b[^;\n]*\n\{{", text, flags=re.M)
                places[bool(forward) and not defined].setdefault(name, header)
    names = {**places[True], **places[False]}
    if sys.argv[2:] == ["--list"]:
        print("\n".join(f"{name}\t{header}" for name, header in sorted(names.items())))
        return 0
    lines = (source / "tests/project/GlobalNames.txt").read_text(encoding="utf-8").splitlines()
    rows = [line.split("\t") for line in lines if line and not line.startswith("#")]
    listed = {row[0] for row in rows}
    faults = [f"{names[name]}: {name} belongs into namespace Drydock, or, if the engine has it, into GlobalNames.txt"
              for name in sorted(set(names) - listed)]
    faults += [f"GlobalNames.txt: {name} is not declared any more" for name in sorted(listed - set(names))]
    faults += [f"GlobalNames.txt: {row[0]}: six columns, the last public, uncertain or article"
               for row in rows if len(row) != 6 or row[5] not in ("public", "uncertain", "article")]
    faults += [f"GlobalNames.txt: {row[0]} is in {names[row[0]]}" for row in rows
               if row[0] in names and row[1] != names[row[0]]]
    print("\n".join(faults))
    print(f"{len(names)} names, {len(rows)} rows")
    return 1 if faults else 0


sys.exit(main())
