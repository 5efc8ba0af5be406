// Lists what differs in how two runs were made: settings, effects, passes with what they wrote, and the rest.
import { Effect, Run, RunPass, Timing, shortName } from "../data";
import { bytes, number, value } from "../format";

/** Something of both runs; empty where one has none. */
export interface Difference {
	name: string;
	a: string;
	b: string;
}

export interface PassDifference extends Difference {
	textures: string[]; // that both wrote, and not alike
}

export function compareHeads(a: Run, b: Run): Difference[] {
	const rows: [string, (run: Run) => string][] = [
		["Engine", (run) => run.engine], ["Precision", (run) => run.precision], ["Storage", (run) => run.storage], ["drydock", (run) => run.version],
		["Config", (run) => run.config], ["Scene", (run) => run.scene.file], ["View", (run) => run.scene.viewRect.join(", ")],
		["Exposure", (run) => number(run.exposure.scale)], ["Transient memory", (run) => bytes(run.memory.transientPeakBytes)],
		["Channels decoded", (run) => String(run.channels.filter((channel) => channel.decoded).length)],
		["Warnings", (run) => run.warnings.map((warning) => warning.code).join(", ") || "none"],
	];
	return rows.map(([name, read]) => ({ name, a: read(a), b: read(b) })).filter((row) => row.a !== row.b);
}

export function compareSettings(a: Run, b: Run): Difference[] {
	return [...new Set([...Object.keys(a.settings), ...Object.keys(b.settings)])]
		.filter((name) => JSON.stringify(a.settings[name]) !== JSON.stringify(b.settings[name]))
		.map((name) => ({ name, a: value(a.settings[name] ?? null), b: value(b.settings[name] ?? null) }));
}

export function compareEffects(a: Run, b: Run): Difference[] {
	const text = (effect: Effect | undefined) => (effect ? (effect.active ? "runs: " : "off: ") + effect.reason : "");
	const names = [...new Set([...a.effects, ...b.effects].map((effect) => effect.name))];
	return names.map((name) => {
		const [one, other] = [a, b].map((run) => run.effects.find((effect) => effect.name === name));
		return { name, a: text(one), b: text(other) };
	}).filter((row) => row.a !== row.b);
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

export function comparePasses(a: Run, b: Run): PassDifference[] {
	const [ofA, ofB] = [nameAll(a), nameAll(b)];
	const text = (pass: RunPass | undefined) => (!pass ? "is not there" : !pass.executed ? "left out: " + pass.reason : `${pass.shader || "no shader"}, ${number(pass.pixels)} pixels`);
	return [...new Set([...ofA.keys(), ...ofB.keys()])].map((name) => {
		const [one, other] = [ofA.get(name), ofB.get(name)];
		const [left, right] = [one?.written ?? {}, other?.written ?? {}];
		const textures = Object.keys(left).filter((texture) => texture in right && left[texture] !== right[texture]);
		return { name, a: text(one), b: text(other), textures };
	}).filter((row) => row.a !== row.b || row.textures.length > 0);
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
