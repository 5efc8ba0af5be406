// The graph as it flows: passes as boxes, what goes from one to the next as lines, placed by dagre.
import dagre from "@dagrejs/dagre";
import { el } from "../dom";
import { ms } from "../format";
import { shortName } from "../data";
import { cut } from "./order";
import { GraphFacts, whyPass } from "./why";

const size = { width: 176, height: 38 };

/** Made smaller to be as wide as there is room, as far as it stays readable. */
export function drawFlow(facts: GraphFacts, room: number, select: (pass: number) => void): SVGSVGElement {
	const { passes } = facts;
	const graph = new dagre.graphlib.Graph({ multigraph: false });
	graph.setGraph({ rankdir: "TB", nodesep: 22, ranksep: 34, marginx: 12, marginy: 12 });
	graph.setDefaultEdgeLabel(() => ({}));
	for (const pass of passes) {
		graph.setNode(String(pass.index), { ...size });
	}
	const written = new Map<number, number[]>(); // resource to passes that wrote it so far
	const carried = new Map<string, string[]>();
	for (const pass of facts.passes) {
		for (const use of pass.uses.filter((use) => use.reads)) {
			for (const producer of pass.producers.filter((index) => written.get(use.resource)?.includes(index))) {
				const key = `${producer} ${pass.index}`;
				const resource = facts.resources.find((resource) => resource.index === use.resource)!;
				carried.set(key, [...(carried.get(key) ?? []), resource.name]);
			}
		}
		for (const use of pass.uses.filter((use) => use.writes)) {
			written.set(use.resource, [...(written.get(use.resource) ?? []), pass.index]);
		}
		for (const producer of pass.producers) {
			if (facts.byIndex.has(producer)) {
				graph.setEdge(String(producer), String(pass.index));
			}
		}
	}
	dagre.layout(graph);

	const { width = 100, height = 100 } = graph.graph();
	const scale = Math.min(1, Math.max(room / width, 0.75));
	const svg = el<SVGSVGElement>("svg", { width: width * scale, height: height * scale, viewBox: `0 0 ${width} ${height}`, class: "flow", role: "group", "aria-label": "Passes and what flows between them" });
	for (const edge of graph.edges()) {
		const points = graph.edge(edge).points;
		const names = [...new Set(carried.get(`${edge.v} ${edge.w}`) ?? [])];
		svg.append(el("path", { class: "edge", d: curve(points), "data-from": edge.v, "data-to": edge.w,
			"data-tip": names.length ? names.join(", ") : "declared to come first" }));
	}
	for (const pass of passes) {
		const node = graph.node(String(pass.index));
		const open = () => select(pass.index);
		const time = facts.milliseconds.get(pass.index);
		svg.append(el("g", {
			class: "pass" + (pass.culled ? " culled" : ""), transform: `translate(${node.x - size.width / 2} ${node.y - size.height / 2})`,
			tabindex: 0, role: "button", "data-pass": pass.index, "aria-label": `Pass ${pass.index}, ${pass.name}`, "data-tip": whyPass(facts, pass),
			onclick: open,
			onkeydown: (event: KeyboardEvent) => {
				if (event.key === "Enter" || event.key === " ") {
					event.preventDefault();
					open();
				}
			},
		},
			el("rect", { class: "box", ...size, rx: 4 }),
			el("text", { x: 10, y: 16 }, cut(shortName(pass.name), 24)),
			el("text", { class: "index", x: 10, y: 30 }, `${pass.index}` + (pass.culled ? " · culled" : time !== undefined ? ` · ${ms(time)}` : ""))));
	}
	return svg;
}

/** Through the points, with round corners. */
function curve(points: { x: number; y: number }[]): string {
	const last = points[points.length - 1];
	const parts = [`M ${points[0].x} ${points[0].y}`];
	for (let i = 1; i + 1 < points.length; ++i) {
		const [at, next] = [points[i], points[i + 1]];
		parts.push(`Q ${at.x} ${at.y} ${(at.x + next.x) / 2} ${(at.y + next.y) / 2}`);
	}
	return parts.join(" ") + ` L ${last.x} ${last.y}`;
}
