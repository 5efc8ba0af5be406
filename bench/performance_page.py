#!/usr/bin/env python3
"""Writes docs/performance.md's tables and its chart from what the benchmarks printed; no number is typed by hand.

    ./dev bench                                             own figures: build/release/bench_results/*.md
    bench/performance_page.py PEERS.json [PEERS.json]...    the page and docs/images/performance.svg; PEERS.json: rounds
                                                            of the peers' benchmark (bench/peers/run.sh beside this
                                                            repository); of several, each ratio's median
    bench/performance_page.py --summary FOLDER              prints the headlines of FOLDER's own figures
"""
import json
import math
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RESULTS = ROOT / "build/release/bench_results"
PAGE = ROOT / "docs/performance.md"
CHART = ROOT / "docs/images/performance.svg"

# What is compared: title, workload, its parameter, storage, drydock's rows (the fastest counts), goal as a part of the
# best peer's time, if it has one. A parameter of None is any.
AGAINST_PEERS = (
    [(f"Gaussian, sigma {s}", "gauss", 3 * s, "f32", ("drydock_separable", "usf_ps"), 1.0) for s in (2, 8, 32, 64)]
    + [(f"dual Kawase, {n} levels", "kawase", n, "f32", ("drydock_kawase",), 1.0) for n in (3, 4, 5)]
    + [(f"bloom, 6 levels, {name}", "bloom", None, t, ("drydock_bloom", "drydock_bloom_fast"), 0.8)
       for t, name in (("f32", "float"), ("f16", "half"))]
    + [(f"box, radius {r}", "box", r, "f32", ("drydock_box",), 1.0) for r in (1, 8, 32)]
    + [(f"box, radius {r}: a user's loop in a .usf", "box", r, "f32", ("usf_cs",), None) for r in (1, 8, 32)]
    + [("bright, screen, pow: a user's .usf", "bsp", 0, "f32", ("usf_ps", "usf_cs"), 1.0),
       ("tonemap: a user's .usf", "tone", 0, "f32", ("usf_ps", "usf_cs"), 1.0)])
AGAINST_LAVAPIPE = [("bright, screen, pow: a user's .usf", "bsp", 0, "f32", ("usf_ps", "usf_cs"), 0.2),
                    ("tonemap: a user's .usf", "tone", 0, "f32", ("usf_ps", "usf_cs"), 0.2)]
# Title, workload, parameter, storage, row, goal in copies of the image.
IN_COPIES = ([(f"Gaussian by the pyramid, sigma {s}", "gauss", 3 * s, "f32", "drydock_pyramid", 1.6)
              for s in (2, 8, 32, 64)]
             + [("Tonemap pass, table", "tone", 0, "f32", "drydock_Tonemap_8bit", 1.5)])
# Title, workload, parameter, row: half over float.
HALVES = ([(f"Gaussian, sigma {s}", "gauss", 3 * s, "drydock_separable") for s in (2, 8, 32)]
          + [("dual Kawase, 5 levels", "kawase", 5, "drydock_kawase"), ("bloom, 6 levels", "bloom", None, "drydock_bloom")])
GOAL_OF_HALF = 0.7


class Round:
    """What one run of the peers' benchmark measured at 1920 x 1080 on two threads. Only rows of one round are compared."""

    def __init__(self, file):
        data = json.loads(Path(file).read_text())
        self.peak = data["fma_peak_gfma"]["2"]
        self.rows = [row for row in data["results"] if row["w"] == 1920 and row["threads"] == 2]

    def find(self, workload, parameter, storage, peer=None):
        return [row for row in self.rows if row["workload"] == workload and row["type"] == storage
                and (parameter is None or row["param"] == parameter) and (peer is None or row["peer"] == peer)]

    def pick(self, workload, parameter, storage, peers):
        """The fastest of drydock's rows, or None."""
        return fastest([row for peer in peers for row in self.find(workload, parameter, storage, peer)])

    def best_peer(self, workload, parameter, storage):
        return fastest([row for row in self.find(workload, parameter, storage)
                        if not row["peer"].startswith(("drydock", "usf", "rdg"))
                        and not re.search("~|approx|different", row["note"])])


def over_rounds(rounds, measure):
    """Measure(round) gives a dict with ratio and mark, or None: of the undisturbed ones, if any, the median by ratio."""
    found = sorted((m for m in map(measure, rounds) if m), key=lambda m: m["ratio"])
    found = [m for m in found if not m["mark"]] or found
    return found[(len(found) - 1) // 2] if found else None


def time_of(*compared):
    """A function from row to milliseconds of two threads: by the clock where no row was disturbed by other processes, else
    the CPU time of both threads shared by two; with a mark for the latter."""
    if all(2 * row["dirty"] < row["n"] for row in compared):
        return (lambda row: row["median_ms"]), (lambda row: row["ratio_memcpy2"]), ""
    return (lambda row: row["cpu_ms"] / 2), (lambda row: row["ratio_cpu"]), "*"


def fastest(candidates):
    if not candidates:
        return None
    milliseconds, _, _ = time_of(*candidates)
    return min(candidates, key=milliseconds)


def multiply_adds(workload, parameter):
    """Per image of 1920 x 1080, the exact algorithm; None where it is not the bound."""
    pixels = 1920 * 1080
    if workload == "gauss":
        return pixels * 4 * 2 * (parameter + 1)
    if workload == "bsp":
        return pixels * (3 * 22 + 14)
    if workload == "tone":
        return pixels * (3 * 22 + 45)
    return None


def get_bound(rounds, workload, parameter, storage):
    """Milliseconds: a streaming copy of the image by two threads, or its multiply-adds at the measured peak."""
    copies = [row["median_ms"] for r in rounds for row in r.find("mem", None, "f32") if row["peer"].startswith("ntcopy")]
    if not copies:
        return None
    copy = min(copies) * (0.5 if storage == "f16" else 1.0) * (0.25 if workload == "box" else 1.0)
    work = (multiply_adds(workload, parameter) or 0) / max(r.peak for r in rounds) / 1e6
    return (copy, "copy") if work < copy else (work, "multiply-adds")


def relate(mine, other):
    """None where one of the two was not measured."""
    if not mine or not other:
        return None
    milliseconds, copies, mark = time_of(mine, other)
    return dict(mine=mine["peer"], best=other["peer"], mine_ms=milliseconds(mine), best_ms=milliseconds(other),
                copies=copies(mine), ratio=milliseconds(mine) / milliseconds(other), mark=mark)


def compare(rounds):
    result = []
    for title, workload, parameter, storage, own, goal in AGAINST_PEERS:
        row = over_rounds(rounds, lambda r: relate(r.pick(workload, parameter, storage, own),
                                                   r.best_peer(workload, parameter, storage)))
        if row:
            result.append(dict(row, title=title, workload=workload, parameter=parameter, storage=storage, goal=goal))
    return result


def cell(ms):
    return f"{ms:.1f}" if ms < 100 else f"{ms:.0f}"


def make_peer_tables(rounds):
    compared = compare(rounds)
    lines = ["| 1920 x 1080, two threads | best peer | ms | drydock | ms | copies | drydock / peer | goal | bound, ms | bound is |",
             "|---|---|--:|---|--:|--:|--:|--:|--:|---|"]
    for row in compared:
        bound = get_bound(rounds, row["workload"], row["parameter"], row["storage"])
        lines.append(f"| {row['title']} | {row['best']} | {cell(row['best_ms'])}{row['mark']} | {row['mine']} | "
                     f"{cell(row['mine_ms'])}{row['mark']} | {row['copies']:.1f} | {row['ratio']:.2f} | "
                     + (f"{row['goal']:.1f} | " if row["goal"] else "| ")
                     + (f"{bound[0]:.1f} | {bound[1]} |" if bound else "| |"))
    lines += ["", "| | measured | goal |", "|---|--:|--:|"]
    for title, workload, parameter, storage, own, goal in AGAINST_LAVAPIPE:
        row = over_rounds(rounds, lambda r: relate(r.pick(workload, parameter, storage, own),
                                                   r.pick(workload, parameter, storage, ("vulkan_lavapipe",))))
        if row:
            lines.append(f"| {title}, part of lavapipe's time | {row['ratio']:.2f}{row['mark']} | {goal:.1f} |")
    for title, workload, parameter, storage, name, goal in IN_COPIES:
        def in_copies(r):
            mine = r.pick(workload, parameter, storage, (name,))
            return mine and dict(ratio=time_of(mine)[1](mine), mark=time_of(mine)[2], error=mine["max_err"])
        row = over_rounds(rounds, in_copies)
        if row:
            error = f", off by {row['error']:.1e} at most" if name == "drydock_pyramid" and row["error"] is not None else ""
            lines.append(f"| {title}, copies of the image{error} | {row['ratio']:.1f}{row['mark']} | {goal:.1f} |")
    for title, workload, parameter, name in HALVES:
        row = over_rounds(rounds, lambda r: relate(r.pick(workload, parameter, "f16", (name,)),
                                                   r.pick(workload, parameter, "f32", (name,))))
        if row:
            lines.append(f"| {title}, half storage over float | {row['ratio']:.2f}{row['mark']} | {GOAL_OF_HALF:.1f} |")
    lines += ["", "`*`: other processes disturbed the samples; half of the CPU time of both threads. The input's values go up to 16."]
    return "\n".join(lines), compared


def describe(compared):
    ahead = sum(row["ratio"] <= 1.0 for row in compared)
    quickest, slowest = min(row["ratio"] for row in compared), max(row["ratio"] for row in compared)
    worst = max(compared, key=lambda row: row["ratio"])["title"]
    if ahead == len(compared):
        return f"drydock is as fast as the best ready-made CPU code, or faster, in all {ahead} of {ahead} kernels"
    if ahead == 0:
        return (f"drydock takes {quickest:.1f} to {slowest:.1f} times as long as the best ready-made CPU code; "
                f"furthest behind is {worst}")
    return (f"drydock is as fast as the best ready-made CPU code, or faster, in {ahead} of {len(compared)} kernels; "
            f"the slowest ({worst}) takes {slowest:.1f} times as long")


def escape(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def wrap(text, most):
    lines = [""]
    for word in text.split():
        if len(lines[-1]) + len(word) + 1 > most:
            lines.append("")
        lines[-1] = (lines[-1] + " " + word).strip()
    return lines


def make_chart(compared):
    """One bar a kernel, from 1 (the best peer) to drydock's time over the peer's, on a scale of powers of two."""
    title = wrap(describe(compared), 88)
    left, right, row_height, top = 290, 770, 24, 56 + 22 * len(title)
    largest = max(2.0, max(row["ratio"] for row in compared))
    smallest = min(0.5, min(row["ratio"] for row in compared))
    low, high = math.floor(math.log2(smallest)), math.ceil(math.log2(largest))
    def x_of(ratio):
        return left + (math.log2(ratio) - low) / (high - low) * (right - left)
    step = math.ceil((high - low) / 8)
    bottom = top + row_height * len(compared)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="980" height="{bottom + 62}" viewBox="0 0 980 {bottom + 62}" '
           'font-family="sans-serif" font-size="13">', f'<rect width="980" height="{bottom + 62}" fill="#ffffff"/>']
    for index, line in enumerate(title):
        out.append(f'<text x="20" y="{30 + 22 * index}" font-size="17" font-weight="bold" fill="#1a1a1a">{escape(line)}</text>')
    for power in range(low, high + 1):
        x = x_of(2.0 ** power)
        label = "" if power % step else "as fast" if power == 0 else f"{2 ** power} x" if power > 0 else f"1/{2 ** -power}"
        out.append(f'<line x1="{x:.1f}" y1="{top - 8}" x2="{x:.1f}" y2="{bottom}" stroke="{"#1a1a1a" if power == 0 else "#dddddd"}"/>')
        out.append(f'<text x="{x:.1f}" y="{bottom + 18}" text-anchor="middle" fill="#555555">{label}</text>')
    for index, row in enumerate(compared):
        y = top + row_height * index
        begin, end = sorted((x_of(1.0), x_of(row["ratio"])))
        colour = "#2b8a3e" if row["ratio"] <= 1.0 else "#c2571a"
        out.append(f'<text x="{left - 12}" y="{y + 14}" text-anchor="end" fill="#1a1a1a">{escape(row["title"])}</text>')
        out.append(f'<rect x="{begin:.1f}" y="{y + 3}" width="{max(end - begin, 1.0):.1f}" height="14" fill="{colour}"/>')
        if row["goal"]:
            goal = x_of(row["goal"])
            out.append(f'<line x1="{goal:.1f}" y1="{y}" x2="{goal:.1f}" y2="{y + 20}" stroke="#1864ab" stroke-width="3"/>')
        out.append(f'<text x="{end + 6:.1f}" y="{y + 14}" fill="#1a1a1a">{row["ratio"]:.2f}</text>')
        out.append(f'<text x="{right + 60}" y="{y + 14}" fill="#777777">{escape(row["best"])}</text>')
    out.append(f'<text x="{x_of(1.0) - 14:.1f}" y="{top - 14}" text-anchor="end" fill="#2b8a3e">drydock faster</text>')
    out.append(f'<text x="{x_of(1.0) + 14:.1f}" y="{top - 14}" fill="#c2571a">slower</text>')
    out.append(f'<text x="20" y="{bottom + 46}" fill="#555555">drydock\'s time over that of the best peer (named at the right), '
               '1920 x 1080, two threads. Blue: the goal.</text>')
    out.append("</svg>")
    return "\n".join(out) + "\n"


def read_result(folder, name):
    file = Path(folder) / f"{name}.md"
    return file.read_text().strip() if file.exists() else ""


def find_row(text, begin):
    for line in text.splitlines():
        if line.startswith("|") and line.strip("| ").startswith(begin):
            return [part.strip() for part in line.strip().strip("|").split("|")]
    return None


def make_summary(folder):
    """Headlines of the own figures, with the goals that they have."""
    lines = ["| work | measured | goal |", "|---|--:|--:|"]
    run = read_result(folder, "bench_run")
    row = find_row(run, "drydock run, toon bloom")
    if row:
        lines.append(f"| `run` toon_bloom 1080p, whole process, CPU, part of oiiotool's | {row[4]} | 0.6 |")
    large = re.search(r"takes ([0-9.]+) times .* and ([0-9]+) bytes", run)
    if large:
        lines.append(f"| the same at 3840 x 2160, times 1080p | {large[1]} | 4.1 |")
        lines.append(f"| its memory, bytes a pixel | {large[2]} | 48 |")
    row = find_row(run, "drydock --version")
    if row:
        lines.append(f"| start, CPU ms | {row[1]} | 20 |")
        lines.append(f"| start, MB | {row[3]} | 25 |")
    edit = read_result(folder, "bench_edit")
    for begin, goal in (("a shader, `run --watch`", 150), ("a shader, `run`", 300), ("a patch's C++", 500)):
        row = find_row(edit, begin)
        if row:
            lines.append(f"| edit of {row[0]}, CPU ms | {row[1]} | {goal} |")
    live = read_result(folder, "bench_live")
    for size, goal in (("960 x 540", 20), ("1920 x 1080", 50)):
        row = find_row(live, size)
        if row:
            lines.append(f"| `live`, {size}, edit to picture beside the passes, ms | {row[5]} | {goal} |")
        row = find_row(read_result(folder, "live_page"), size)
        if row:
            lines.append(f"| the same in Chromium, from the hand to the drawn picture, ms | {row[4]} | {goal} |")
    row = find_row(read_result(folder, "bench_graph"), "chain, a texture each | 60")
    if row:
        lines.append(f"| graph of 60 passes, build and compile, us | {row[4]} | 50 |")
    frame = read_result(folder, "bench_frame").partition("| frame_full")[2]
    row = find_row(frame, "all passes")
    if row:
        lines.append(f"| frame_full's passes at 1080p, one thread, ms | {float(row[1]):.0f} | 400 |")
    functions = read_result(folder, "bench_functions")
    power, exp2, log2 = (find_row(functions, name) for name in ("pow", "exp2", "log2"))
    if power and exp2 and log2:
        lines.append(f"| pow, times exp2 and log2 together | {float(power[1]) / (float(exp2[1]) + float(log2[1])):.1f} | |")
    texels = re.search(r"median of all formats: (.*), ([0-9.]+) times\. .*neighbouring operation: (.*), ([0-9.]+) times\.",
                       read_result(folder, "bench_texels"))
    if texels:
        lines.append(f"| texels, furthest from other formats ({texels[1]}), times | {texels[2]} | 4 |")
        lines.append(f"| texels, furthest from its neighbouring operation ({texels[3]}), times | {texels[4]} | 4 |")
    return "\n".join(lines)


def fill(page, mark, text):
    """Replaces what stands between <!-- MARK --> and <!-- end -->; pages keep what was not measured."""
    pattern = re.compile(rf"(<!-- {re.escape(mark)} -->\n).*?(\n<!-- end -->)", re.S)
    if not pattern.search(page):
        sys.exit(f"{PAGE} has no mark {mark}")
    return pattern.sub(lambda m: m[1] + text + m[2], page) if text else page


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "--summary":
        print(make_summary(arguments[1]))
        return
    if not arguments or arguments[0].startswith("-"):
        sys.exit(__doc__)
    page = PAGE.read_text()
    page = fill(page, "summary", make_summary(RESULTS))
    for name in ("run", "edit", "live", "picture_files", "texels", "functions", "strips", "roofline", "graph", "usf"):
        page = fill(page, f"bench_{name}", read_result(RESULTS, f"bench_{name}"))
    page = fill(page, "live_page", read_result(RESULTS, "live_page"))
    tables, compared = make_peer_tables([Round(file) for file in arguments])
    page = fill(page, "peers", tables)
    page = fill(page, "chart", f"![{describe(compared)}](images/performance.svg)")
    PAGE.write_text(page)
    CHART.write_text(make_chart(compared))


main(sys.argv[1:])
