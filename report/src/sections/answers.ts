// The five questions a report answers first, each with one sentence and the way to the section that says more.
import { Difference, PictureData, Report, realPasses, shortName } from "../data";
import { el } from "../dom";
import { bytes, count, ms, number, percent, time } from "../format";
import { loadPixels } from "../picture/pixels";
import { subtract } from "../picture/shade";

type Tone = "good" | "note" | "bad";

export function row(id: string, question: string, tone: Tone, answer: (Node | string)[], more: string[] = []): HTMLElement {
	return el("li", { id: "answer-" + id, class: tone },
		el("span", { class: "question" }, question),
		el("div", { class: "answer" }, el("p", {}, ...answer), more.length ? el("ul", {}, more.map((line) => el("li", {}, line))) : null));
}

export function to(section: string, label: string): HTMLElement {
	return el("a", { href: "#" + section }, label);
}

function whether(report: Report): HTMLElement {
	const { run, timing } = report;
	const [x0, y0, x1, y1] = run.scene.viewRect;
	const ran = run.passes.filter((pass) => pass.executed).length;
	const warnings = run.warnings.filter((message) => message.severity === "warning").length;
	const notes = run.warnings.length - warnings;
	const said = [warnings ? count(warnings, "warning") : "", notes ? count(notes, "note") : ""].filter(Boolean).join(" and ");
	return row("worked", "Did it work?", warnings ? "note" : "good", [
		`Yes: ${count(ran, "pass", "passes")} made a picture of ${x1 - x0} × ${y1 - y0} in ${ms(timing.wallMs)}, `,
		said ? to("messages", `with ${said}`) : "without a warning", ".",
	], run.warnings.slice(0, 3).map((warning) => `${warning.code}  ${warning.message}`));
}

function leftOut(report: Report): HTMLElement {
	const off = report.run.effects.filter((effect) => !effect.active);
	const culled = realPasses(report).filter((pass) => pass.culled);
	const { explain } = report;
	const saved = explain ? 1 - explain.cost.ms / explain.withoutSkipping.ms : 0;
	const spare = saved > 0.001 ? `, which saves ${percent(saved)} of the passes' time by estimate` : "";
	const groups = Map.groupBy(culled, (pass) => shortName(pass.name));
	const more = [...groups].slice(0, 4).map(([name, passes]) => {
		const reason = passes.map((pass) => pass.reason).reduce((a, b) => (b.length < a.length ? b : a));
		return `${name}${passes.length > 1 ? `, ${passes.length} passes` : ""}: ${reason}`;
	});
	return row("left-out", "What was left out?", "good", [
		to("effects", `${off.length} of ${report.run.effects.length} effects did not run`), " and ",
		to("graph", `${count(culled.length, "pass was", "passes were")} culled`), spare + "."], more);
}

function notFinite(report: Report): HTMLElement {
	const measured = report.pictures.filter((picture) => picture.figures);
	const odd = measured.filter((picture) => picture.figures!.nan + picture.figures!.infinite > 0);
	const { nonFinite } = report;
	const more = odd.slice(0, 3).map((picture) => `${picture.label}: ${picture.figures!.nan} NaN, ${picture.figures!.infinite} infinite`);
	for (const pass of nonFinite.passes.slice(-1)) {
		more.push(`spread furthest by ${shortName(pass.pass)}: ${percent(pass.pixels / pass.of)} of its pixels`);
	}
	const negative = measured.filter((picture) => picture.figures!.negative > 0).length;
	return odd.length
		? row("finite", "What is not finite?", "bad", [to("picture", `${count(odd.length, "picture")} of ${measured.length}`), " that were looked at hold NaN or infinities."], more)
		: row("finite", "What is not finite?", "good", ["Nothing in the final picture and the scene before the tonemapper",
			measured.length > 2 ? `, nor in ${count(measured.length - 2, "dumped picture")}` : "; of passes, those that are dumped are looked at",
			negative ? `; ${count(negative, "holds", "hold")} negative values.` : "."]);
}

function whereTime(report: Report): HTMLElement {
	const { timing } = report;
	const parts: [string, number][] = [["start", timing.startMs], ["setup", timing.setupMs], ["loading the scene", timing.loadMs],
		["building the graph and its shaders", timing.compileMs], ["the passes", timing.executeMs], ["reports", timing.reportMs], ["writing pictures", timing.saveMs]];
	parts.sort((a, b) => b[1] - a[1]);
	const passes = [...timing.passes].sort((a, b) => b.ms - a.ms).slice(0, 3);
	return row("time", "Where did the time go?", "good", [
		`${ms(timing.wallMs)}: `, to("time", parts.slice(0, 3).map(([name, part]) => `${name} ${ms(part)}`).join(", ")),
		`; longest passes ${passes.map((pass) => `${shortName(pass.name)} ${ms(pass.ms)}`).join(", ")}.`,
	], [`Heap ${bytes(report.run.memory.transientPeakBytes)} at its peak`]);
}

const kindNames: [Difference["kind"], string, string][] = [["setting", "setting", "settings"], ["variable", "console variable", "console variables"], ["input", "input", "inputs"],
	["other", "other thing", "other things"], ["effect", "effect", "effects"], ["pass", "pass", "passes"]];

export function sectionOf(kind: Difference["kind"]): string {
	return kind === "pass" ? "passes" : kind === "other" ? kind : kind + "s";
}

/** "2 settings and 7 passes differ." link: to the section of a kind. */
export function nameDifferences(differences: Difference[], link?: (section: string, label: string) => HTMLElement): (Node | string)[] {
	const parts = kindNames.flatMap(([kind, one, many]): (Node | string)[] => {
		const found = differences.filter((line) => line.kind === kind).length;
		const label = count(found, one, many);
		return found ? [link ? link(sectionOf(kind), label) : label] : [];
	});
	return [...parts.flatMap((part, i) => (i === 0 ? [part] : [i === parts.length - 1 ? " and " : ", ", part])), differences.length === 1 ? " differs." : " differ."];
}

export function showDifference({ kind, name, a, b }: Difference): string {
	return kind === "input" ? `${name}: ${a ? (b ? "another content" : "gone") : "new"}` : `${name}: ${a || "none"} → ${b || "none"}`;
}

function changed(report: Report, showPictures: () => void): HTMLElement {
	const { previous } = report;
	if (!previous) {
		return row("changed", "What changed?", "good", ["There is no earlier run in this folder to compare with."]);
	}
	const { differences } = previous;
	const picture = el("span", {}, "the pictures are being compared");
	const final = report.pictures.find((one) => one.role === "final");
	const before = report.pictures.find((one) => one.role === "previous");
	if (final && before) {
		void comparePictures(final, before).then((text) =>
			picture.replaceChildren(el("button", { type: "button", class: "link", onclick: showPictures }, text)));
	}
	return row("changed", "What changed?", "note", [`Since the run of ${time(previous.written)}: `, picture, "; ",
		...(differences.length ? nameDifferences(differences) : ["made from the same settings, variables, inputs, effects and passes."])], differences.slice(0, 6).map(showDifference));
}

async function comparePictures(a: PictureData, b: PictureData): Promise<string> {
	const [first, second] = [await loadPixels(a), await loadPixels(b)];
	if (first.width !== second.width || first.height !== second.height) {
		return `the picture had ${second.width} × ${second.height}`;
	}
	const difference = subtract(first, second);
	return difference.changed === 0 || difference.max < 0.001 ? "the same picture"
		: `${percent(difference.changed / (first.width * first.height))} of the pixels differ, by ${number(Math.round(difference.max * 255))}/255 at most`;
}

export function listAnswers(...rows: HTMLElement[]): HTMLElement {
	return el("ol", { class: "answers", id: "answers" }, rows);
}

export function makeAnswers(report: Report, showPictures: () => void): HTMLElement {
	return listAnswers(whether(report), leftOut(report), notFinite(report), whereTime(report), changed(report, showPictures));
}
