// The page of a sweep: a figure of every task as a table whose cells open pictures, two of them over each other, and plots.
import { drawPanel } from "../chart";
import { el, section, table } from "../dom";
import { count, ms, number } from "../format";
import { PicturePanel } from "../picture/panel";
import { listAnswers, row, to } from "../sections/answers";
import { SweepPiece, SweepReport, SweepRow } from "./data";

const seconds = "seconds";
const mostRows = 400; // of the table
const mostLines = 8; // of a plot, as pipeline/Sweep/SweepReduce.cpp draws them

export class SweepPage {
	readonly parts: HTMLElement[];
	readonly sections: [string, string][];
	readonly picture: PicturePanel | null;
	private readonly grid = el("div", { id: "grid" });
	private readonly facts = el("aside", { class: "detail", id: "cell-detail", tabindex: -1, "aria-live": "polite" });
	private figure: string;

	constructor(private readonly report: SweepReport) {
		const { sweep, pictures, plots } = report;
		this.figure = sweep.figures.find((name) => this.varies(name)) ?? sweep.figures[0] ?? seconds;
		const figures = el<HTMLSelectElement>("select", { id: "figure", onchange: () => {
			this.figure = figures.value;
			this.fill();
		} }, [...sweep.figures, seconds].map((name) => el("option", { value: name, selected: name === this.figure }, name)));
		this.picture = pictures.length ? new PicturePanel(pictures, { a: pictures[0].id, b: pictures[1]?.id, title: "Pictures",
			note: pictures.length < sweep.rows.length ? `Of ${pictures.length} tasks, evenly spread, so that the page stays small; all are in results/.` : "" }) : null;
		const drawn = plots.filter((plot) => plot.panels.length);
		this.parts = [this.makeAnswers(),
			section("table", "Tasks", pictures.length ? "Open a cell for its picture as A; the one before becomes B." : "", el("div", { class: "tools" }, el("label", {}, el("span", {}, "Figure"), figures)),
				el("div", { class: "matrix" }, this.grid, this.facts)),
			...(this.picture ? [this.picture.element] : []),
			...(sweep.pieces.length ? [this.makePieces()] : []),
			...(drawn.length ? [section("plots", "Figures over axes", "", ...drawn.map(({ axis, panels }) => this.makePlots(axis, panels)))] : [])];
		this.sections = [["table", "Tasks"], ...(this.picture ? [["picture", "Pictures"] as [string, string]] : []),
			...(sweep.pieces.length ? [["pieces", "Pieces"] as [string, string]] : []), ...(drawn.length ? [["plots", "Figures over axes"] as [string, string]] : [])];
		this.fill();
	}

	private value(index: number, figure = this.figure): number | null {
		return figure === seconds ? this.report.seconds[index] : this.report.sweep.rows[index].figures[figure] ?? null;
	}

	private varies(figure: string): boolean {
		return new Set(this.report.sweep.rows.map((one) => one.figures[figure])).size > 1;
	}

	private show(value: number | null): string {
		return value === null ? "–" : this.figure === seconds ? ms(1000 * value) : number(value);
	}

	private makeAnswers(): HTMLElement {
		const { rows, notes, against, figures } = this.report.sweep;
		const said = rows.filter((one) => one.messages.length).length;
		const total = this.report.seconds.reduce((sum, one) => sum + one, 0);
		const errors = rows.map((one, index) => [one.figures["error rms"] ?? -1, index]).sort((a, b) => b[0] - a[0]);
		return listAnswers(
			row("worked", "Did it work?", said ? "note" : "good", [`Yes: all of ${count(rows.length, "task")} are there, which took ${ms(1000 * total)} in all` + (said ? `; ${count(said, "task")} gave messages.` : ".")], notes),
			...(figures.includes("error rms") ? [row("error", "How far apart?", "note", [
				`Against ${Object.entries(against).map(([name, value]) => `${name} ${value}`).join(", ")} the largest error is ${number(errors[0][0])} RMS, of `, to("table", rows[errors[0][1]].values.join(", ")), "."])] : []));
	}

	/** Rows: the combinations of all axes but the last; columns: its values. */
	private fill(): void {
		const { axes, rows } = this.report.sweep;
		const last = axes[axes.length - 1];
		const columns = last.values.length <= 12 ? last.values : [];
		const lines = new Map<string, number[]>();
		rows.forEach((one, index) => {
			const key = (columns.length ? one.values.slice(0, -1) : one.values).join(" · ");
			lines.set(key, [...(lines.get(key) ?? []), index]);
		});
		const values = rows.map((_, index) => this.value(index)).filter((one): one is number => one !== null);
		const [least, most] = [Math.min(...values), Math.max(...values)];
		const cell = (index: number | undefined) => {
			if (index === undefined) {
				return "";
			}
			const value = this.value(index);
			const button = el("button", { type: "button", class: "cell heat", "data-cell": index, "aria-pressed": "false",
				"aria-label": `${rows[index].values.join(", ")}: ${this.show(value)}`, onclick: () => this.open(index, true) }, this.show(value));
			button.style.setProperty("--heat", value === null || most === least ? "0%" : `${(50 * (value - least)) / (most - least)}%`);
			return button;
		};
		const others = axes.slice(0, columns.length ? -1 : undefined).map((axis) => axis.name).join(" · ");
		const shown = [...lines].slice(0, mostRows);
		this.grid.replaceChildren(
			table<[string, number[]]>([
				...(others ? [{ title: others, cell: ([key]: [string, number[]]) => el("strong", {}, key) }] : []),
				...(columns.length ? columns : [""]).map((name) => ({ title: columns.length ? `${last.name} ${name}` : this.figure,
					cell: ([, of]: [string, number[]]) => cell(columns.length ? of.find((index) => rows[index].values.at(-1) === name) : of[0]) })),
			], shown),
			el("p", { class: "note" }, lines.size > mostRows ? `The first ${mostRows} of ${lines.size} lines; all are in table.csv.` : ""));
		this.open(0, false);
	}

	private open(index: number, asked: boolean): void {
		const one: SweepRow = this.report.sweep.rows[index];
		this.grid.querySelectorAll(".cell").forEach((cell) => cell.setAttribute("aria-pressed", String(cell.getAttribute("data-cell") === String(index))));
		const facts: [string, string][] = [...Object.entries(one.set), ...(one.frames ? [["frames", one.frames] as [string, string]] : []),
			...Object.entries(one.figures).map(([name, value]): [string, string] => [name, value === null ? "∞" : number(value)]),
			["time", ms(1000 * this.report.seconds[index])], ["result", `results/${one.task.slice(0, 2)}/${one.task}`]];
		this.facts.replaceChildren(el("h3", {}, one.values.join(", ")), el("dl", {}, facts.flatMap(([name, fact]) => [el("dt", {}, name), el("dd", {}, fact)])),
			...one.messages.map((message) => el("p", { class: "said" }, message)));
		const id = String(index);
		if (asked && this.picture && this.picture.selectedA !== id && this.report.pictures.some((picture) => picture.id === id)) {
			void this.picture.choose(id, this.picture.selectedA);
		}
	}

	private makePieces(): HTMLElement {
		return section("pieces", "Pieces", "Frames of the first cut in pieces, beside the same frames of the cut that was rendered unsplit.", table<SweepPiece>([
			{ title: "Frames", cell: (piece) => piece.frames },
			{ title: "Rendered before", cell: (piece) => piece.lead || "none" },
			{ title: "Frames that differ", number: true, cell: (piece) => String(piece.different) },
			{ title: "Worst RMS", number: true, cell: (piece) => number(piece.rms ?? Infinity) },
			{ title: "Largest", number: true, cell: (piece) => number(piece.max ?? Infinity) },
		], this.report.sweep.pieces));
	}

	private makePlots(axis: string, panels: SweepReport["plots"][0]["panels"]): HTMLElement {
		const lines = panels[0].series.filter(() => panels[0].series.length > 1 && panels[0].series.length <= mostLines);
		return el("div", {}, el("h3", {}, "Over " + axis),
			el("p", { class: "quiet plot-cell" }, lines.map(({ name, color }) => el("span", {}, el("i", { class: color }), name + " "))),
			el("div", { class: "plots" }, panels.map((panel) => el("div", { class: "plot-cell" }, el("h4", {}, panel.title), drawPanel(panel, { width: 420, height: 170 })))));
	}
}
