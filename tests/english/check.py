#!/usr/bin/env python3
"""Checks the English of pages, help, messages and comments against patterns that must be read twice.

  check.py SOURCE            compares the findings of each file with exceptions.tsv, which may only shrink; exit code 1
  check.py SOURCE FILE...    prints the findings of these files
  check.py SOURCE --renew    writes exceptions.tsv anew

A sentence begins with its subject, not with "Of", "What" and the like. A sentence has 25 words at most in README.md,
docs/concepts.md, CONTRIBUTING.md, texts in quotes (--help and messages) and the first sentence of a header. A colon or
the end of a line of output ends a sentence, too. A code span, or a value put between two texts in quotes, is one word.
Codespell, where it is installed, reads the same files.
"""
import os
import re
import shutil
import subprocess
import sys

PATTERNS = [
    ("begins", re.compile(r"(?:^|(?<=[.!?:;] )|(?<=[.!?]\" ))(Of|What|Where|Alone|Compared|Likewise)\b")),
    ("is no", re.compile(r"(?<!there )(?<!There )\b(is|are|was|were) no (?!longer|more than|less|fewer)")),
    ("likewise", re.compile(r"\blikewise\b")),
    ("is said", re.compile(r"\b(is|are) said\b(?! to)")),
    ("says what", re.compile(r"\b(says|say|tells|tell) (what|which|how|where|why|so)\b")),
    ("the like", re.compile(r"\bstand(s)? (at|for|in) (the|a) (beginning|there)\b")),
]
MOST_WORDS = 25
SHORT_PAGES = ("README.md", "docs/concepts.md", "CONTRIBUTING.md")
SHORT_TEXTS = ("pipeline/", "settings/", "passes/", "rdg/")
TREES = ["docs", "configs", "rdg", "settings", "passes", "pipeline", "cmake", "dev", "report/src", "templates",
         "README.md", "CONTRIBUTING.md", "CHANGELOG.md"]


def page_sentences(text):
    """The prose of a page by paragraph: without fences, comments and code spans."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    text = re.sub(r"<!-- made by.*?<!-- end -->", "", text, flags=re.S)
    text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
    text = re.sub(r"^#.*$", "", text, flags=re.M)
    text = re.sub(r"`[^`\n]*`", "CODE", text)
    text = re.sub(r"\]\([^)]*\)", "]", text)
    for paragraph in re.split(r"\n\s*\n|\n(?=\s*[-*|] )|\n(?=\d+\. )", text):
        for cell in paragraph.split("|") if paragraph.lstrip().startswith("|") else [paragraph]:
            yield re.sub(r"\s+", " ", cell.strip().lstrip("-*#> ").replace("**", ""))


def comments(text, line_mark):
    """The comments of a source file, by block."""
    block = []
    for line in text.split("\n"):
        found = re.match(r"\s*(?:///?<?|/\*\*?|\*(?=\s|$)|" + line_mark + r")\s?(.*)", line)
        if found:
            begins = re.match(r"\s*/\*\*", line)
            if begins and block:
                yield " ".join(block)
                block = []
            block.append(re.sub(r"\*/.*", "", found[1]).strip())
            continue
        if block:
            yield " ".join(block)
            block = []
        trailing = re.search(r"\s// (.*)", line)
        if trailing:
            yield trailing[1]
    if block:
        yield " ".join(block)


def texts_in_quotes(text):
    """The texts in quotes of a source file; pieces that become one text are one."""
    joined = re.sub(r'"\)?\s*(?:TEXT\()?"', "", text)
    joined = re.sub(r'"\s*\+[^";{}]*\+\s*"', "X", joined)
    for found in re.finditer(r'"((?:[^"\\\n]|\\.)*)"', joined):
        if re.search(r"[.,;:!?'(]|\b(a|the|is)\b", found[1]) and " " in found[1] and not joined[:found.start()].endswith("#include "):
            yield found[1].replace("\\n", "\n").replace('\\"', "'")


def long_sentences(chunk):
    chunk = re.sub(r"`[^`\n]*`", "CODE", chunk)
    for sentence in re.split(r"[.!?][\"')]*\s+|: |\n", chunk):
        if len(re.findall(r"\S*[A-Za-z]\S*", sentence)) > MOST_WORDS:
            yield "long", sentence


def findings(source, name):
    with open(os.path.join(source, name), encoding="utf-8") as file:
        text = file.read()
    if name.endswith(".md"):
        chunks = list(page_sentences(text))
        short = chunks if name in SHORT_PAGES else []
    else:
        is_c = name.endswith((".h", ".cpp", ".inl", ".usf", ".ush", ".ts"))
        heads = list(comments(text, "(?!)" if is_c else r"#(?!!)"))
        texts = list(texts_in_quotes(text))
        chunks = heads + texts
        short = texts if name.startswith(SHORT_TEXTS) else []
        if name.endswith(".h") and heads:
            short = [re.split(r"[.!?]\s", heads[0])[0], *short]
    for chunk in short:
        yield from long_sentences(chunk)
    for chunk in (chunk.replace("\n", " ") for chunk in chunks):
        for kind, pattern in PATTERNS:
            for found in pattern.finditer(chunk):
                if kind == "begins" and re.match(r"[^.!]*\?", chunk[found.start():]):
                    continue  # a question
                at = max(0, found.start() - 20)
                yield kind, chunk[at:found.end() + 60]


def files(source):
    listed = subprocess.run(["git", "-C", source, "ls-files", "--cached", "--others", "--exclude-standard", "--", *TREES],
                            capture_output=True, text=True, check=True).stdout.split("\n")
    return [name for name in sorted(set(listed))
            if name.endswith((".md", ".h", ".cpp", ".inl", ".usf", ".ush", ".ts", ".cmake")) or name == "dev"]


def spelling(source, names):
    program = shutil.which("codespell")
    if not program:
        print("codespell is not installed: spelling was not looked at")
        return 0
    words = os.path.join(source, "tests/english/words.txt")
    run = subprocess.run([program, "--ignore-words", words, *names], cwd=source, capture_output=True, text=True)
    print(run.stdout, end="")
    return 1 if run.stdout else 0


def main():
    source = sys.argv[1]
    listing = os.path.join(source, "tests/english/exceptions.tsv")
    if len(sys.argv) > 2 and sys.argv[2] != "--renew":
        for path in sys.argv[2:]:
            for kind, text in findings(source, os.path.relpath(path, source)):
                print(f"{path}: {kind}: ...{text}...")
        return 0
    names = files(source)
    counts = {name: len(list(findings(source, name))) for name in names}
    counts = {name: count for name, count in counts.items() if count}
    if sys.argv[2:] == ["--renew"]:
        with open(listing, "w", encoding="utf-8") as file:
            file.writelines(f"{name}\t{count}\n" for name, count in sorted(counts.items()))
        return 0
    with open(listing, encoding="utf-8") as file:
        allowed = {name: int(count) for name, count in (line.split("\t") for line in file)}
    faults = 0
    for name in sorted(set(counts) | set(allowed)):
        have, may = counts.get(name, 0), allowed.get(name, 0)
        if have > may:
            faults += 1
            print(f"{name}: {have} sentences must be read twice, {may} are excepted: tests/english/check.py . {name}")
        elif have < may:
            faults += 1
            print(f"{name}: {have} are left of {may}: tests/english/check.py . --renew")
    faults += spelling(source, names)
    print(f"{len(names)} files, {sum(counts.values())} exceptions in {len(counts)} of them")
    return 1 if faults else 0


sys.exit(main())
