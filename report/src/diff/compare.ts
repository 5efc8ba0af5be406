// Lists the passes of two runs that are the same and wrote other texels, and the times of passes.
import { Run, RunPass, Timing, shortName } from "../data";

/** A pass that both ran alike. */
export interface WroteOtherwise {
	name: string;
	shader: string;
	textures: string[]; // that both wrote, and not alike
}

/** By short name, and where there are several of one name their turn. */
function nameAll(run: Run): Map<string, RunPass> {
	const turns = new Map<string, number>();
	return new Map(run.passes.map((pass) => {
		const name = shortName(pass.name);
		const turn = (turns.get(name) ?? 0) + 1;
		turns.set(name, turn);
		return [turn > 1 ? `${name} #${turn}` : name, pass];
	}));
}

export function compareWritten(a: Run, b: Run): WroteOtherwise[] {
	const [ofA, ofB] = [nameAll(a), nameAll(b)];
	return [...ofA].flatMap(([name, one]) => {
		const other = ofB.get(name);
		const textures = Object.keys(one.written ?? {}).filter((texture) => other?.written?.[texture] !== undefined && other.written[texture] !== one.written![texture]);
		return textures.length && one.shader === other!.shader && one.pixels === other!.pixels ? [{ name, shader: one.shader, textures }] : [];
	});
}

/** Milliseconds of passes of one name, of which both runs have some. */
export function compareTimes(a: Timing, b: Timing): { name: string; a: number; b: number }[] {
	const sum = (timing: Timing) => {
		const sums = new Map<string, number>();
		for (const pass of timing.passes) {
			sums.set(shortName(pass.name), (sums.get(shortName(pass.name)) ?? 0) + pass.ms);
		}
		return sums;
	};
	const [ofA, ofB] = [sum(a), sum(b)];
	return [...new Set([...ofA.keys(), ...ofB.keys()])].map((name) => ({ name, a: ofA.get(name) ?? 0, b: ofB.get(name) ?? 0 }))
		.sort((one, other) => Math.abs(other.b - other.a) - Math.abs(one.b - one.a));
}
