// The graph in order: a row for each pass, a column for each resource with its life, reads and writes where they meet.
import { el, narrow } from "../dom";
import { ms } from "../format";
import { GraphPass, Resource, shortName } from "../data";
import { GraphFacts, isMerged, isUnread, whyPass, whyResource } from "./why";

const row = 22;

/** Names stay in sight: those of the resources at the top, those of the passes at the left (--scrolled of the style). In a
 * narrow window columns are narrow, too, and have no names. */
export function drawOrder(facts: GraphFacts, select: (pass: number) => void, selectTexture: (pass: number, resource: number) => void): HTMLElement {
	const { passes, resources, milliseconds } = facts;
	const names = narrow.matches ? 120 : 250; // width of the names of passes
	const bar = narrow.matches ? 0 : 70;
	const left = names + bar + (narrow.matches ? 0 : 18);
	const column = narrow.matches ? Math.min(Math.max((innerWidth - 66 - left) / resources.length, 3), 17) : 17;
	const size = Math.min(column / 1.7, 10); // of a mark
	const longestName = Math.max(...resources.map((resource) => resource.name.length), 0);
	const head = column < 14 ? 0 : Math.min(24 + longestName * 5.4, 300); // height of the names of resources
	const width = left + resources.length * column + (narrow.matches ? 0 : 90);
	const height = passes.length * row + 8;
	const heading = el<SVGSVGElement>("svg", { width, height: head, class: "names", "aria-hidden": "true" });
	const svg = el<SVGSVGElement>("svg", { width, height, role: "group", "aria-label": "Passes in order, and the resources they read and write" });
	const rowOf = new Map(passes.map((pass, i) => [pass.index, i * row + row / 2]));
	const longest = Math.max(...milliseconds.values(), 0.001);
	const nameAt = narrow.matches ? 30 : 44;
	/** The resource lives at the pass, or the pass names it. */
	const touches = (pass: GraphPass, resource: Resource | undefined) => resource &&
		((resource.firstPass >= 0 && resource.firstPass <= pass.index && pass.index <= resource.lastPass) || pass.uses.some((use) => use.resource === resource.index));

	resources.forEach((resource, i) => {
		const x = left + i * column + column / 2;
		const uses = passes.filter((pass) => pass.uses.some((use) => use.resource === resource.index)).map((pass) => rowOf.get(pass.index)!);
		const kind = resource.reason ? "unused" : resource.external ? "external" : resource.transient ? "transient" : "pooled";
		const attributes = { class: `resource ${kind}`, "data-resource": resource.index, "data-tip": whyResource(facts, resource) };
		heading.append(el("g", attributes, el("text", { transform: `translate(${x + 3} ${head - 8}) rotate(-55)` }, resource.name)));
		svg.append(el("g", attributes,
			el("rect", { class: "hit", x: x - column / 2, y: 0, width: column, height }),
			el("rect", { class: "life", x: x - size / 4, y: Math.min(...uses) - 4, width: size / 2, height: Math.max(...uses) - Math.min(...uses) + 8, rx: 2.5 })));
	});

	passes.forEach((pass, i) => {
		const y = i * row + row / 2;
		const time = milliseconds.get(pass.index);
		const open = () => select(pass.index);
		const group = el<SVGGElement>("g", {
			class: "pass" + (pass.culled ? " culled" : ""), tabindex: 0, role: "button", "data-pass": pass.index,
			"aria-label": `Pass ${pass.index}, ${pass.name}${pass.culled ? ", culled" : ""}`, "data-tip": whyPass(facts, pass),
			onclick: (event: MouseEvent) => {
				const at = Math.floor((event.clientX - svg.getBoundingClientRect().left - left) / column);
				const inLabel = (event.target as Element).closest?.(".label");
				!inLabel && touches(pass, resources[at]) ? selectTexture(pass.index, resources[at].index) : open();
			},
			onkeydown: (event: KeyboardEvent) => {
				if (event.key === "Enter" || event.key === " ") {
					event.preventDefault();
					open();
				} else if (event.key === "ArrowDown" || event.key === "ArrowUp") {
					event.preventDefault();
					let next = event.key === "ArrowDown" ? group.nextElementSibling : group.previousElementSibling;
					while (next && !next.classList.contains("pass")) {
						next = event.key === "ArrowDown" ? next.nextElementSibling : next.previousElementSibling;
					}
					(next as SVGElement | null)?.focus();
				}
			},
		},
			el("rect", { class: "back", x: 0, y: y - row / 2, width, height: row }),
			el("title", {}, pass.name + (time !== undefined ? `, ${ms(time)}` : "")));
		for (const use of pass.uses) {
			const at = resources.findIndex((resource) => resource.index === use.resource);
			const x = left + at * column + column / 2;
			if (use.writes) {
				group.append(el("rect", { class: "write", x: x - size / 2, y: y - 5, width: size, height: 10, rx: 1 }));
			}
		}
		const written = new Set(pass.uses.filter((use) => use.writes).map((use) => use.resource));
		for (const resource of new Set(pass.uses.filter((use) => use.reads).map((use) => use.resource))) {
			const x = left + resources.findIndex((other) => other.index === resource) * column + column / 2;
			const both = written.has(resource);
			const unread = isUnread(facts, pass, resource);
			group.append(el("circle", { class: both ? "read both" : unread ? "read unread" : "read", cx: x, cy: y, r: (both ? 0.3 : unread ? 0.37 : 0.45) * size }));
		}
		group.append(el("g", { class: "label" },
			el("rect", { class: "cover", x: 0, y: y - row / 2, width: left - 8, height: row }),
			el("rect", { class: "back", x: 0, y: y - row / 2, width: left - 8, height: row }),
			el("text", { class: "index", x: nameAt - 8, y: y + 4, "text-anchor": "end" }, pass.index),
			el("text", { x: nameAt, y: y + 4 }, cut(shortName(pass.name), narrow.matches ? 13 : 27)),
			pass.culled ? el("rect", { class: "outline", x: nameAt - 5, y: y - row / 2 + 2, width: names - nameAt - 2, height: row - 4, rx: 3 }) : null,
			time !== undefined && bar ? el("rect", { class: "time", x: names, y: y - 4, width: Math.max((time / longest) * bar, 1), height: 8, rx: 1 }) : null));
		svg.append(group);
	});

	for (const pass of passes) {
		if (isMerged(pass) && pass.index === pass.renderPassBegin) {
			const [from, to] = [rowOf.get(pass.renderPassBegin)!, rowOf.get(pass.renderPassEnd) ?? rowOf.get(pass.index)!];
			svg.append(el("path", { class: "bracket", d: `M 8 ${from - 7} H 3 V ${to + 7} H 8`, "data-tip": `Passes ${pass.renderPassBegin} to ${pass.renderPassEnd} are one render pass` }));
		}
	}
	heading.append(el("g", { class: "label" }, el("rect", { class: "cover", x: 0, y: 0, width: left - 8, height: head })));
	return el("div", { class: "order", style: `width:${width}px` }, head ? heading : null, svg);
}

export function cut(text: string, length: number): string {
	return text.length > length ? text.slice(0, length - 1) + "…" : text;
}
