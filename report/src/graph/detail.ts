// Shows what the page knows of one pass: why, shader, parameters, cost, what it reads and writes, its pictures.
import { GraphPass, PictureData, Report, pictureUrl } from "../data";
import { el, table } from "../dom";
import { big, bytes, ms, number } from "../format";
import { GraphFacts, isMerged, isUnread, whyPass, whyResource } from "./why";

export interface DetailActions {
	showPicture: (id: string) => void;
	selectPass: (index: number) => void;
	selectTexture: (pass: number, resource: number) => void;
	close: () => void;
}

export function link(label: string, act: () => void, tip?: string): HTMLElement {
	return el("button", { type: "button", class: "link", onclick: act, "data-tip": tip }, label);
}

function uses(report: Report, facts: GraphFacts, pass: GraphPass, actions: DetailActions, write: boolean): HTMLElement {
	const groups = Map.groupBy(pass.uses.filter((use) => (write ? use.writes : use.reads)), (use) => use.resource);
	return el("ul", { class: write ? "writes" : "reads" }, [...groups.values()].map(([use, ...more]) => {
		const resource = report.graph.resources.find((resource) => resource.index === use.resource)!;
		const writers = facts.passes.filter((other) => !other.culled && other.index !== pass.index &&
			other.uses.some((theirs) => theirs.resource === use.resource && (write ? theirs.reads : theirs.writes)) &&
			(write ? other.index > pass.index : other.index < pass.index));
		const other = write ? writers[0] : writers[writers.length - 1];
		const unread = !write && isUnread(facts, pass, use.resource);
		return el("li", { class: unread ? "unread" : "" }, link(resource.name, () => actions.selectTexture(pass.index, use.resource), whyResource(facts, resource)), " ",
			el("span", { class: "quiet", "data-tip": [use, ...more].map((one) => one.parameter).join(", ") },
				use.parameter.split(/->|\./).pop() + (more.length ? ` +${more.length}` : "") + (unread ? ", not read" : "")), " ",
			other ? link(`${write ? "→" : "←"} ${other.index}`, () => actions.selectPass(other.index), other.name) : null);
	}));
}

function pictures(report: Report, pass: GraphPass, actions: DetailActions): HTMLElement | null {
	const own = report.pictures.filter((picture) => picture.pass === pass.index);
	const before = (resource: number): PictureData | undefined => {
		const name = report.graph.resources.find((one) => one.index === resource)?.name;
		return report.pictures.filter((picture) => picture.pass >= 0 && picture.pass < pass.index && picture.resource === name).pop();
	};
	const inputs = pass.uses.filter((use) => use.reads).map((use) => before(use.resource)).filter((picture) => picture !== undefined);
	const show = (title: string, list: PictureData[]) => (list.length ? [el("h4", {}, title), el("div", { class: "thumbs" }, list.map((picture) =>
		el("button", { type: "button", "data-tip": picture.label, onclick: () => actions.showPicture(picture.id) },
			el("img", { src: pictureUrl(picture), alt: picture.label, loading: "lazy" }))))] : []);
	const all = [...show("Out", own), ...show("In", [...new Map(inputs.map((picture) => [picture.id, picture])).values()])];
	return all.length ? el<HTMLElement>("div", {}, ...all) : null;
}

function shader(report: Report, pass: GraphPass): HTMLElement | null {
	const detail = report.passes.find((other) => other.index === pass.index);
	const run = report.run.passes.find((other) => other.index === pass.index);
	const name = pass.shader || run?.shader;
	if (!name) {
		return null;
	}
	const permutations = (detail?.permutations ?? []).filter((permutation) => Object.keys(permutation).length);
	return el<HTMLElement>("div", {}, el("h4", {}, "Shader"),
		el("p", {}, el("code", {}, name), " ", el("span", { class: "quiet" }, pass.entry || run?.entry || "")),
		detail?.shaderFile ? el("p", {}, el("code", {}, detail.shaderFile)) : null,
		run?.runsAs ? el("p", { class: "quiet" }, `Ran as: ${run.runsAs}`) : null,
		permutations.length ? el("details", {}, el("summary", {}, permutations.length === 1 ? "Permutation" : `${permutations.length} permutations of the class were asked for`),
			...permutations.map((permutation) => el("pre", {}, Object.entries(permutation).map(([key, value]) => `${key} = ${value}`).join("\n")))) : null);
}

export function describePass(report: Report, facts: GraphFacts, pass: GraphPass, actions: DetailActions): HTMLElement {
	const run = report.run.passes.find((other) => other.index === pass.index);
	const detail = report.passes.find((other) => other.index === pass.index);
	const time = facts.milliseconds.get(pass.index);
	const rows: [string, string | undefined][] = [
		["Time", time !== undefined ? ms(time) : undefined],
		["Pixels", run?.pixels ? big(run.pixels) : undefined],
		["Taps", run?.taps ? `${big(run.taps)} (${number(Number((run.taps / run.pixels).toPrecision(3)))} a pixel)` : undefined],
		["Read", run?.bytesRead ? bytes(run.bytesRead) : undefined],
		["Written", run?.bytesWritten ? bytes(run.bytesWritten) : undefined],
		["Speed", run && time ? `${number(Number(((run.bytesRead + run.bytesWritten) / time / 1e6).toPrecision(3)))} GB/s` : undefined],
		["Effect", pass.effect || undefined],
		["Added by", pass.owner || undefined],
		["Scope", pass.scope || undefined],
		["Flags", pass.flags || undefined],
		["Merged", isMerged(pass) ? `passes ${pass.renderPassBegin} to ${pass.renderPassEnd} are one render pass` : undefined],
		["Not merged", isMerged(pass) ? undefined : pass.mergeReason || undefined],
	];
	return el<HTMLElement>("div", { class: "detail", id: "pass-detail", tabindex: -1 },
		el("button", { type: "button", class: "close", "aria-label": "Close", onclick: actions.close }, "×"),
		el("h3", {}, el("span", { class: "quiet" }, pass.index), " ", pass.name),
		el("p", { class: pass.culled ? "why culled" : "why" }, whyPass(facts, pass)),
		el("dl", {}, rows.filter(([, text]) => text).flatMap(([name, text]) => [el("dt", {}, name), el("dd", {}, text)])),
		pictures(report, pass, actions),
		el("h4", {}, "Reads"), uses(report, facts, pass, actions, false),
		el("h4", {}, "Writes"), uses(report, facts, pass, actions, true),
		shader(report, pass),
		detail?.parameters.length ? el("div", {}, el("h4", {}, "Parameters"), table([
			{ title: "Name", cell: (row) => el("span", { "data-tip": row.type }, row.name) },
			{ title: "Value", number: true, cell: (row) => row.value },
		], detail.parameters)) : null);
}
