#!/usr/bin/env python3
"""Edits one line of every shader of an installation, and sees the edit in the frame.

EditedShaders.py PREFIX SOURCE WORK: PREFIX is an installation that may be changed, SOURCE the checkout with the configs.
Exit code 1 where a frame does not show an edit.
"""
import json
import pathlib
import subprocess
import sys


def run(prefix, source, config, out):
    """The picture's bytes, and for each pass the shader and how it ran."""
    command = [prefix / "bin/drydock", "run", source / f"configs/{config}.json", "--out", out]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    passes = json.loads((out / "run.json").read_text())["passes"]
    return (out / "final.exr").read_bytes(), {(row["shader"], row["runsAs"]) for row in passes if row["executed"]}


def main(prefix, source, work):
    table = source / "tests/outside/edited_shaders.tsv"
    plain, faults, native = {}, [], set()
    rows = [line.split("\t") for line in table.read_text().splitlines() if not line.startswith("#")]
    for name, config, before, after in rows:
        if config == "-":
            continue
        if config not in plain:
            plain[config] = run(prefix, source, config, work / config)
        file = prefix / "share/drydock" / name
        text = file.read_text()
        file.write_text(text.replace(before, after, 1))
        picture, passes = run(prefix, source, config, work / "edited")
        file.write_text(text)
        if picture == plain[config][0]:
            faults.append(f"{name}: an edit does not change the picture of {config}")
        native |= {shader for shader, how in plain[config][1] - passes if how == "native kernel"}
    if len(native) < 5:
        faults.append(f"native kernels gave way to edits of {sorted(native)} alone")
    print(f"{len(rows)} rows, kernels that gave way: {', '.join(sorted(native))}")
    print("\n".join(faults))
    return 1 if faults else 0


sys.exit(main(*map(pathlib.Path, sys.argv[1:4])))
