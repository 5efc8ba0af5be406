// The transient heap over the frame: what lies where while which passes run.
import { el } from "../dom";
import { bytes, percent } from "../format";
import { Report } from "../data";
import { cut } from "./order";
import { GraphFacts, whyResource } from "./why";

export function drawHeap(report: Report, facts: GraphFacts): HTMLElement {
	const { transientPeakBytes: peak, withoutAliasingBytes: flat } = report.graph.memory;
	const placed = facts.resources.filter((resource) => resource.transient && resource.heapOffset >= 0 && resource.firstPass >= 0);
	if (!placed.length || peak <= 0) {
		return el("p", { class: "quiet" }, "Nothing of this frame lives in the transient heap.");
	}
	const alive = facts.passes.filter((pass) => !pass.culled);
	const [width, height] = [1000, 170];
	const last = alive.length;
	const at = (pass: number) => alive.filter((other) => other.index < pass).length;
	const x = (position: number) => (position / last) * width;
	const y = (offset: number) => height - (offset / peak) * height;
	const svg = el<SVGSVGElement>("svg", { class: "heap", viewBox: `0 0 ${width} ${height}`, preserveAspectRatio: "none", role: "img", "aria-label": "The transient heap: offset upwards, passes from left to right" });
	const labels = el("div", { class: "heap-labels" });
	placed.forEach((resource) => {
		const [from, to] = [at(resource.firstPass), at(resource.lastPass + 1)];
		const tip = whyResource(facts, resource);
		const box = { x: x(from), y: y(resource.heapOffset + resource.bytes), width: Math.max(x(to) - x(from), 2), height: Math.max(y(resource.heapOffset) - y(resource.heapOffset + resource.bytes), 1) };
		svg.append(el("rect", { ...box, class: "block", "data-resource": resource.index, "data-tip": tip, style: `--hue: ${(resource.index * 47) % 360}` }));
		if (box.width > 55 && box.height > 15) {
			labels.append(el("span", { style: `left:${box.x / 10}%;top:${(100 * box.y) / height}%;width:${box.width / 10}%;height:${(100 * box.height) / height}%` }, cut(resource.name, Math.floor(box.width / 7))));
		}
	});
	return el("div", { class: "heap-strip" },
		el("p", { class: "note" }, `Heap: ${bytes(peak)} in place of ${bytes(flat)} without aliasing (${percent(1 - peak / flat)} less). Offset upwards, passes from left to right.`),
		el("div", { class: "heap-box" }, svg, labels));
}
