// Sentences about passes and resources, for hints: what one is, why it is there or not, how long it lives.
import { GraphPass, Report, Resource, realPasses, shortName } from "../data";
import { bytes, count, ms } from "../format";

export interface GraphFacts {
	passes: GraphPass[];
	/** Resources that a pass uses, by first use. */
	resources: Resource[];
	milliseconds: Map<number, number>; // by pass
	byIndex: Map<number, GraphPass>;
	bound: Map<number, Set<string>>; // parameters that the shader of a pass uses
}

export function gatherFacts(report: Report): GraphFacts {
	const passes = realPasses(report);
	const firstUse = new Map<number, number>();
	for (const pass of passes) {
		for (const use of pass.uses) {
			if (!firstUse.has(use.resource)) {
				firstUse.set(use.resource, pass.index);
			}
		}
	}
	return {
		passes,
		resources: report.graph.resources.filter((resource) => firstUse.has(resource.index))
			.sort((a, b) => firstUse.get(a.index)! - firstUse.get(b.index)! || a.index - b.index),
		milliseconds: new Map(report.timing.passes.map((pass) => [pass.index, pass.ms])),
		byIndex: new Map(passes.map((pass) => [pass.index, pass])),
		bound: new Map(report.passes.flatMap((pass) => (pass.bound ? [[pass.index, new Set(pass.bound)] as [number, Set<string>]] : []))),
	};
}

/** A pass declares that it reads a resource, and its shader does not. */
export function isUnread(facts: GraphFacts, pass: GraphPass, resource: number): boolean {
	const bound = facts.bound.get(pass.index);
	const uses = pass.uses.filter((use) => use.resource === resource);
	return !!bound && !uses.some((use) => use.writes || bound.has(use.parameter));
}

export function isMerged(pass: GraphPass): boolean {
	return pass.renderPassBegin >= 0 && pass.renderPassBegin !== pass.renderPassEnd;
}

export function whyPass(facts: GraphFacts, pass: GraphPass): string {
	if (pass.culled) {
		return `${pass.name} is culled: ${pass.reason}`;
	}
	const readers = facts.passes.filter((other) => !other.culled && other.producers.includes(pass.index));
	const lines = [pass.name + " runs" + (facts.milliseconds.has(pass.index) ? `, ${ms(facts.milliseconds.get(pass.index)!)}` : "")];
	lines.push(readers.length
		? "what it writes is read by " + readers.slice(0, 4).map((reader) => shortName(reader.name)).join(", ") + (readers.length > 4 ? ", …" : "")
		: "what it writes leaves the graph");
	if (isMerged(pass)) {
		lines.push(`one render pass with passes ${pass.renderPassBegin} to ${pass.renderPassEnd}`);
	}
	return lines.join("; ");
}

export function whyResource(facts: GraphFacts, resource: Resource): string {
	const name = (index: number) => (facts.byIndex.has(index) ? `${index} ${shortName(facts.byIndex.get(index)!.name)}` : String(index));
	const life = resource.reason ? `not allocated: ${resource.reason}`
		: `lives from ${name(resource.firstPass)} to ${name(resource.lastPass)}`;
	const where = resource.external ? "comes from outside the graph"
		: resource.transient ? `at ${bytes(resource.heapOffset)} of the heap` : "not in the heap";
	return `${resource.name} · ${resource.shape} · ${bytes(resource.bytes)}; ${life}; ${where}` +
		(resource.extracted ? "; extracted" : "");
}

export function describeCounts(facts: GraphFacts): string {
	const culled = facts.passes.filter((pass) => pass.culled).length;
	return `${count(facts.passes.length - culled, "pass", "passes")} ran, ${culled} culled, ${count(facts.resources.length, "resource")}`;
}
