// Shows one texture as it was at one pass: its picture, its values' histogram, who wrote it last.
import { GraphPass, PictureData, Report, Resource, pictureUrl, shortName } from "../data";
import { el } from "../dom";
import { bytes, number } from "../format";
import { drawHistogram } from "../picture/histogram";
import { loadPixels } from "../picture/pixels";
import { DetailActions, link } from "./detail";
import { GraphFacts, whyResource } from "./why";

/** The last pass up to this one that wrote the resource. */
function findWriter(facts: GraphFacts, pass: GraphPass, resource: Resource): GraphPass | undefined {
	return facts.passes.findLast((other) => !other.culled && other.index <= pass.index && other.uses.some((use) => use.resource === resource.index && use.writes));
}

function picture(report: Report, writer: GraphPass | undefined, resource: Resource): PictureData | undefined {
	return report.pictures.findLast((one) => one.resource === resource.name && one.pass === (writer?.index ?? 0));
}

export function describeTexture(report: Report, facts: GraphFacts, pass: GraphPass, resource: Resource, actions: DetailActions): HTMLElement {
	const writer = findWriter(facts, pass, resource);
	const shown = picture(report, writer, resource);
	const name = (of: GraphPass) => link(`${of.index} ${shortName(of.name)}`, () => actions.selectPass(of.index));
	const plot = el("div", { class: "plot" });
	if (shown) {
		void loadPixels(shown).then((pixels) => drawHistogram(plot, pixels));
	}
	const range = (list: (number | null)[]) => list.map((value) => number(value ?? NaN)).join("  ");
	const rows: [string, string][] = [
		["Texture", resource.shape], ["Size", bytes(resource.bytes)],
		...(shown?.figures ? [["Least", range(shown.figures.min)], ["Largest", range(shown.figures.max)],
			["NaN · Inf · neg.", `${shown.figures.nan} · ${shown.figures.infinite} · ${shown.figures.negative}`]] as [string, string][] : []),
	];
	return el<HTMLElement>("div", { class: "detail", id: "texture-detail", tabindex: -1 },
		el("button", { type: "button", class: "close", "aria-label": "Close", onclick: actions.close }, "×"),
		el("h3", { "data-tip": whyResource(facts, resource) }, resource.name),
		el("p", { class: "why" }, "At pass ", name(pass), ...(writer === pass ? [", which wrote it."] : writer ? [", written by ", name(writer), "."] : [", from outside the graph."])),
		shown ? el("button", { type: "button", class: "look", "data-tip": "In the viewer", onclick: () => actions.showPicture(shown.id) },
			el("img", { src: pictureUrl(shown), alt: shown.label }))
			: el("p", { class: "quiet" }, resource.kind === "buffer" ? "A buffer has no picture." : pass.culled ? "The pass did not run." : `The page has no picture of it; --dump '${writer ? "" : "External."}${resource.name}' adds one.`),
		shown?.role === "thumbnail" ? el("p", { class: "quiet" }, "A thumbnail, and its values in eight bits.") : null, plot,
		el("dl", {}, rows.flatMap(([title, text]) => [el("dt", {}, title), el("dd", {}, text)])));
}
