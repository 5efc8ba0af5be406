// The page of a comparison: two pictures, or two runs picture by picture, and what differs in how they were made.
import { el, section, table } from "../dom";
import { count, ms, number } from "../format";
import { PicturePanel, beside } from "../picture/panel";
import { Difference } from "../data";
import { listAnswers, nameDifferences, row, sectionOf, showDifference, to } from "../sections/answers";
import { compareTimes, compareWritten } from "./compare";
import { Compared, DiffReport, differs } from "./data";

/** The sections of differences: kind, title, and the sentence of one without any. */
const kinds: [Difference["kind"], string, string][] = [
	["setting", "Settings", "No setting differs."], ["variable", "Variables", "No console variable differs."], ["input", "Inputs", "The same config, files and shaders."],
	["effect", "Effects", "The same effects ran, for the same reasons."], ["pass", "Passes", "The same passes ran."], ["other", "Other", "Nothing else differs."],
];

/** Figures that JSON cannot hold are not finite. */
function figure(value: number | null | undefined): string {
	return value === undefined ? "" : value === null ? "∞" : number(Number(value.toPrecision(4)));
}

function largest(report: DiffReport): Compared | undefined {
	const size = (image: Compared) => (image.max === null ? Infinity : image.max ?? 0);
	return report.diff.images.filter(differs).sort((a, b) => size(b) - size(a))[0];
}

function answer(report: DiffReport): HTMLElement {
	const { allowed, passed, images } = report.diff;
	const off = images.filter(differs);
	const single = images.filter((image) => image.max === undefined);
	const worst = largest(report);
	const rows = [
		row("same", "The same?", !off.length && !single.length ? "good" : passed ? "note" : "bad", [
			off.length ? `No: ${count(off.length, "picture")} of ${images.length - single.length} ${off.length === 1 ? "differs" : "differ"}` : "Yes: equal in every value",
			single.length ? `; ${count(single.length, "picture is", "pictures are")} on one side only` : "", ".",
			allowed !== null ? ` ${passed ? "All stay" : "Not all stay"} within ${number(allowed)}, as asked.` : ""]),
	];
	if (worst) {
		rows.push(row("where", "Where most?", "note", [to("pictures", worst.name), `: by ${figure(worst.max)} in ${worst.channel} at ${worst.at!.join(", ")}; PSNR ${figure(worst.psnr)} dB, SSIM ${figure(worst.ssim)}, FLIP ${figure(worst.flip)}.`]));
	}
	const { differences, times } = report.diff;
	if (differences) {
		const made = differences.filter((one) => one.kind !== "effect" && one.kind !== "pass");
		rows.push(row("made", "Made otherwise?", differences.length ? "note" : "good", differences.length ? nameDifferences(differences, to) : ["No: the same settings, variables, inputs, effects and passes."],
			made.slice(0, 6).map(showDifference)));
	}
	if (times) {
		rows.push(row("time", "Which is faster?", "good", [times.sentence[0].toUpperCase() + times.sentence.slice(1) + "."]));
	}
	return listAnswers(...rows);
}

function differenceTable(rows: Difference[]): HTMLElement {
	const quiet = (text: string) => el("span", { class: "quiet" }, text);
	const show = (line: Difference, text: string) => (line.kind === "input" ? text.slice(0, 8) : text) || quiet("none");
	return table<Difference>([
		{ title: "Name", cell: (line) => line.name },
		{ title: "A", cell: (line) => show(line, line.a) },
		{ title: "B", cell: (line) => show(line, line.b) },
	], rows);
}

function times(report: DiffReport): HTMLElement | null {
	const [a, b] = [report.a.timing, report.b.timing];
	if (!a || !b) {
		return null;
	}
	const rows = compareTimes(a, b).slice(0, 16);
	const most = Math.max(...rows.flatMap((line) => [line.a, line.b]), 0.001);
	const bar = (value: number) => el("span", { class: "bar", style: `--share:${value / most}` });
	return section("time", "Time", "The passes of one run each: most of what differs is noise.", table([
		{ title: "Pass", cell: (line) => line.name },
		{ title: "A", number: true, cell: (line) => (line.a ? ms(line.a) : "") },
		{ title: "", cell: (line) => bar(line.a) },
		{ title: "B", number: true, cell: (line) => (line.b ? ms(line.b) : "") },
		{ title: "", cell: (line) => bar(line.b) },
	], rows));
}

export class DiffPage {
	readonly parts: HTMLElement[];
	readonly sections: [string, string][];
	readonly picture: PicturePanel | null;

	constructor(private readonly report: DiffReport) {
		const first = largest(report)?.name ?? report.diff.images.find((image) => image.max !== undefined)?.name;
		const final = report.diff.images.find((image) => image.name === "final" && differs(image))?.name ?? first ?? "";
		this.picture = report.pictures.length ? new PicturePanel(report.pictures, {
			a: "a: " + final, b: "b: " + final, mode: "slider", title: "Both pictures",
		}) : null;
		const parts: [string, string, HTMLElement | null][] = [
			["picture", "Both pictures", beside(answer(report), this.picture)],
			["pictures", "Figures", this.makeFigures()],
			...kinds.map(([kind, title, none]): [string, string, HTMLElement | null] => {
				const rows = report.diff.differences?.filter((line) => line.kind === kind);
				return [sectionOf(kind), title, rows ? section(sectionOf(kind), title, rows.length ? "" : none, rows.length ? differenceTable(rows) : null, kind === "pass" ? this.makeWritten() : null) : null];
			}),
			["time", "Time", times(report)],
		];
		this.parts = parts.flatMap(([, , part]) => part ?? []);
		this.sections = parts.filter(([id, , part]) => id && part).map(([id, title]) => [id, title]);
	}

	private show(name: string, what: "b" | "error"): void {
		void this.picture?.choose((what === "error" ? "error: " : "a: ") + name, what === "error" ? "" : "b: " + name)
			.then(() => this.picture!.setMode(what === "error" ? "a" : "slider"));
		this.picture?.element.scrollIntoView();
	}

	private makeFigures(): HTMLElement {
		const button = (image: Compared, what: "b" | "error", label: string) =>
			el("button", { type: "button", class: "small", "data-show": what, onclick: () => this.show(image.name, what) }, label);
		return section("pictures", "Figures", "The figures are of the values as stored; the viewer shows eight bits.", table<Compared>([
			{ title: "Picture", cell: (image) => image.name },
			{ title: "Largest", number: true, cell: (image) => figure(image.max) },
			{ title: "RMS", number: true, cell: (image) => figure(image.rms) },
			{ title: "Relative", number: true, cell: (image) => figure(image.relative) },
			{ title: "PSNR dB", number: true, cell: (image) => figure(image.psnr) },
			{ title: "SSIM", number: true, cell: (image) => figure(image.ssim) },
			{ title: "FLIP", number: true, cell: (image) => figure(image.flip) },
			{ title: "Largest at", cell: (image) => (differs(image) ? `${image.at!.join(", ")} in ${image.channel}` : image.max === 0 ? "equal" : image.a ? "only in A" : "only in B") },
			{ title: "", cell: (image) => (differs(image) ? [button(image, "b", "A and B"), " ", button(image, "error", "Where")] : "") },
		], this.report.diff.images));
	}

	/** Passes that only wrote something else, of which the first one matters. */
	private makeWritten(): HTMLElement | null {
		const { a, b } = this.report;
		const wrote = a.run && b.run ? compareWritten(a.run, b.run) : [];
		return wrote.length ? el<HTMLElement>("details", {}, el("summary", {}, `${count(wrote.length, "pass is", "passes are")} the same and wrote something else, first ${wrote[0].name}`), table([
			{ title: "Pass", cell: (line) => line.name },
			{ title: "Shader", cell: (line) => line.shader },
			{ title: "Textures that differ", cell: (line) => line.textures.join(", ") },
		], wrote)) : el<HTMLElement>("p", { class: "note" }, "The textures that passes wrote are compared if both runs had --fingerprints.");
	}
}
