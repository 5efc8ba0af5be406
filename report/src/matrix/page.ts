// The page of a matrix: a plugin under every engine version, what lies behind each cell, and the pictures that differ.
import { el, section, table } from "../dom";
import { count, number } from "../format";
import { PicturePanel } from "../picture/panel";
import { listAnswers, row, to } from "../sections/answers";
import { MatrixReport, MatrixVersion, Said, gatherMessages } from "./data";

/** Names the frame that was run. */
export function nameConfig(report: MatrixReport): string {
	const { config } = report.matrix;
	return config.endsWith("/templates/matrix.json") ? "drydock's own small frame" : config;
}

interface Cell {
	text: string;
	tone: "good" | "note" | "bad" | "quiet";
	kinds: string[]; // of the messages that lie behind it
}

const columns: [string, string, (version: MatrixVersion) => Cell][] = [
	["builds", "Builds", (version) => (version.builds ? { text: "yes", tone: "good", kinds: ["note"] } : { text: "no", tone: "bad", kinds: ["does not build"] })],
	["engine", "In the engine", ({ inEngine: { answer } }) => ({ text: answer === "-" ? "–" : answer, tone: answer === "yes" ? "good" : answer === "-" ? "quiet" : answer.startsWith("no") ? "bad" : "note", kinds: ["not in the engine"] })],
	["compiler", "Compiler", ({ compilerWarnings: list }) => ({ text: list.length ? count(list.length, "warning") : "–", tone: list.length ? "note" : "quiet", kinds: ["the compiler warns"] })],
	["runs", "Runs", ({ run }) => (!run ? { text: "–", tone: "quiet", kinds: [] } : run.exitCode === 0 ? { text: "yes", tone: "good", kinds: [] } : { text: run.end ?? "no", tone: "bad", kinds: ["does not run"] })],
	["warnings", "Warnings", ({ run }) => ({ text: run?.warnings.length ? [...new Set(run.warnings.map((message) => message.code))].join(", ") : "–", tone: run?.warnings.length ? "note" : "quiet", kinds: ["the run warns"] })],
	["picture", "Picture", ({ picture }) => (!picture ? { text: "–", tone: "quiet", kinds: [] } : picture.before === null ? { text: "the first", tone: "good", kinds: [] }
		: picture.same ? { text: "same as " + picture.before, tone: "good", kinds: [] } : { text: picture.max === undefined ? "another size" : `off by ${picture.max === null ? "∞" : number(Number(picture.max.toPrecision(3)))}`, tone: "note", kinds: [] })],
	["difference", "First difference", ({ firstDifference: first }) => ({ text: first ? `${first.pass} ${first.what}` : "–", tone: first ? "note" : "quiet", kinds: [] })],
];

export class MatrixPage {
	readonly parts: HTMLElement[];
	readonly sections: [string, string][];
	readonly picture: PicturePanel | null;
	private readonly said: Said[];
	private readonly side = el("aside", { class: "detail", id: "cell-detail", tabindex: -1, "aria-live": "polite" });
	private readonly table: HTMLElement;

	constructor(private readonly report: MatrixReport) {
		const { matrix, pictures } = report;
		this.said = gatherMessages(report);
		this.picture = pictures.length ? new PicturePanel(pictures, {
			a: pictures[pictures.length - 1].id, b: pictures[pictures.length - 2]?.id, title: "Pictures",
			note: pictures.length === 1 ? "All versions that ran drew this one." : "Each version whose picture is not that of the version before it.",
		}) : null;
		this.table = this.makeTable();
		const good = matrix.versions.filter((version) => version.run?.exitCode === 0).length;
		this.parts = [
			listAnswers(row("worked", "Does it work?", !matrix.passed ? "bad" : matrix.advice.length ? "note" : "good", [matrix.summary], matrix.advice),
				row("same", "Same picture?", pictures.length > 1 ? "note" : "good", [pictures.length ? to("picture", count(pictures.length, "picture")) : "No picture", ` under ${count(good, "version")} that ran.`])),
			section("table", "Versions", "Open a cell for what lies behind it.", el("div", { class: "matrix" }, this.table, this.side)),
			...(this.picture ? [this.picture.element] : []),
			this.makeMessages(),
		];
		this.sections = [["table", "Versions"], ...(this.picture ? [["picture", "Pictures"] as [string, string]] : []), ["messages", "Messages"]];
		this.open(matrix.versions.find((version) => version.run?.exitCode !== 0) ?? matrix.versions[matrix.versions.length - 1], 0, false);
	}

	private makeTable(): HTMLElement {
		const { versions } = this.report.matrix;
		const cell = (version: MatrixVersion, column: number) => {
			const { text, tone } = columns[column][2](version);
			return el("button", { type: "button", class: "cell " + tone, "data-cell": `${version.engine} ${columns[column][0]}`, "aria-pressed": "false",
				"aria-label": `${version.engine}, ${columns[column][1]}: ${text}`, onclick: () => this.open(version, column, true) }, text);
		};
		const grid = table<MatrixVersion>([
			{ title: "Engine", cell: (version) => el("strong", {}, version.engine) },
			...columns.map(([, title], column) => ({ title, cell: (version: MatrixVersion) => cell(version, column) })),
		], versions);
		grid.prepend(el("p", { class: "note" }, "Run on " + nameConfig(this.report)));
		grid.addEventListener("keydown", (event) => {
			const steps: Record<string, number> = { ArrowLeft: -1, ArrowRight: 1, ArrowUp: -columns.length, ArrowDown: columns.length };
			const cells = [...grid.querySelectorAll<HTMLElement>(".cell")];
			const next = cells[cells.indexOf(event.target as HTMLElement) + (steps[event.key] ?? NaN)];
			if (next) {
				event.preventDefault();
				next.focus();
			}
		});
		return grid;
	}

	private open(version: MatrixVersion, column: number, asked: boolean): void {
		const [id, title, describe] = columns[column];
		const { text, kinds } = describe(version);
		this.table.querySelectorAll(".cell").forEach((cell) => cell.setAttribute("aria-pressed", String(cell.getAttribute("data-cell") === `${version.engine} ${id}`)));
		const said = this.said.filter((one) => kinds.includes(one.kind) && one.engines.includes(version.engine));
		const facts: [string, string][] = id === "picture" && version.picture ? [
			["Fingerprint", version.picture.fingerprint.slice(0, 16)], ["Beside", version.picture.before ?? ""], ["Pixels that differ", version.picture.pixels?.toLocaleString("en") ?? ""],
			["The first", version.picture.first?.join(", ") ?? ""], ["The same as", version.picture.sameAs ?? ""]]
			: id === "builds" || id === "compiler" || id === "engine" ? [["Library", version.library], ["All that was said", version.log]]
			: version.run ? [["Exit code", String(version.run.exitCode)], ["Outputs", version.run.folder], ["Extensions", version.run.extensions.join(", ")]] : [];
		this.side.replaceChildren(
			el("h3", {}, `Engine ${version.engine}: ${title.toLowerCase()}`), el("p", {}, text === "–" ? "Nothing to say." : text),
			el("dl", {}, facts.filter(([, fact]) => fact).flatMap(([name, fact]) => [el("dt", {}, name), el("dd", {}, fact)])),
			el("div", {}, said.map((one) => el("p", { class: "said" }, el("a", { href: "#" + one.id }, one.message.code ?? one.kind), " " + one.message.text))),
			...(this.findPicture(version) ? [el("p", {}, el("button", { type: "button", class: "link", id: "show-version", onclick: () => this.showPicture(version) }, "show its picture"))] : []));
		if (asked && id === "picture") {
			this.showPicture(version, false);
		}
	}

	/** The version whose picture a version has: an earlier one's, if they are the same. */
	private findPicture(version: MatrixVersion): string | undefined {
		const { versions } = this.report.matrix;
		const before = versions.slice(0, versions.indexOf(version) + 1).reverse();
		return version.picture ? before.find((other) => this.report.pictures.some((picture) => picture.id === other.engine))?.engine : undefined;
	}

	private showPicture(version: MatrixVersion, scroll = true): void {
		const id = this.findPicture(version);
		const { pictures } = this.report;
		if (id && this.picture) {
			const before = pictures[pictures.findIndex((picture) => picture.id === id) - 1] ?? pictures.find((picture) => picture.id !== id);
			void this.picture.choose(id, before?.id ?? "");
			scroll && this.picture.element.scrollIntoView();
		}
	}

	private makeMessages(): HTMLElement {
		return section("messages", "Messages", this.said.length ? "" : "Neither the compiler nor a run had anything to say.", this.said.length ? table<Said>([
			{ title: "Number", cell: (one) => (one.message.code ? el("code", {}, one.message.code) : "") },
			{ title: "What", cell: (one) => one.kind },
			{ title: "Message", cell: (one) => one.message.text },
			{ title: "Where", cell: (one) => [one.message.file + (one.message.line ? `:${one.message.line}` : ""), one.message.where].filter(Boolean).join(", ") },
			{ title: "Under", cell: (one) => one.engines.map((engine) => el("button", { type: "button", class: "link", onclick: () => this.openFor(one, engine) }, engine + " ")) },
		], this.said, (one) => ({ id: one.id })) : null);
	}

	/** The cell that a message lies behind. */
	private openFor(said: Said, engine: string): void {
		const version = this.report.matrix.versions.find((one) => one.engine === engine)!;
		const column = columns.findIndex(([, , describe]) => describe(version).kinds.includes(said.kind));
		this.open(version, Math.max(column, 0), true);
		document.getElementById("table")!.scrollIntoView();
	}
}
