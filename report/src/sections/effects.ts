// Shows which effects ran and which did not, why, and what that saved.
import { Effect, Report } from "../data";
import { Column, el, section, table } from "../dom";
import { bytes, ms } from "../format";

/** Whether an effect runs, its name, and why. */
export const effectColumns: Column<Effect>[] = [
	{ title: "", cell: (row) => el("span", { class: row.active ? "state on" : "state", role: "img", "aria-label": row.active ? "runs" : "does not run" }, row.active ? "●" : "○") },
	{ title: "Effect", cell: (row) => row.name },
	{ title: "Why", cell: (row) => row.reason },
];

export function makeEffects(report: Report): HTMLElement {
	const { explain } = report;
	const cost = (name: string) => [...(explain?.effects ?? []), ...(explain?.plugins ?? [])].find((effect) => effect.name === name);
	const plugins = (explain?.plugins ?? []).map((plugin) => ({ name: plugin.name, active: plugin.passes > 0, reason: plugin.passes ? "adds passes" : "its passes are culled" }));
	const rows: Effect[] = [...plugins, ...report.run.effects].sort((a, b) => Number(b.active) - Number(a.active));
	const compare = explain && explain.cost.ms !== explain.withoutSkipping.ms && [
		["Passes", String(explain.cost.passes), String(explain.withoutSkipping.passes)],
		["Channels decoded", String(explain.cost.channels), String(explain.withoutSkipping.channels)],
		["Transient memory", bytes(explain.cost.transientPeakBytes), bytes(explain.withoutSkipping.transientPeakBytes)],
		["Scene textures", bytes(explain.cost.sceneTextureBytes), bytes(explain.withoutSkipping.sceneTextureBytes)],
		["Passes' time", ms(explain.cost.ms), ms(explain.withoutSkipping.ms)],
	];
	return section("effects", "Effects", explain && !explain.measured ? "Times are estimates from earlier runs on this machine." : "",
		table<Effect>([
			...effectColumns,
			{ title: "Passes", number: true, cell: (row) => cost(row.name)?.passes || "" },
			{ title: "Time", number: true, cell: (row) => (cost(row.name)?.ms ? ms(cost(row.name)!.ms) : "") },
			{ title: "Writes", number: true, cell: (row) => (cost(row.name)?.megabytes ? bytes(cost(row.name)!.megabytes * 1e6) : "") },
		], rows, (row) => ({ class: row.active ? "" : "off" })),
		compare ? el("h3", {}, "Savings by leaving out") : null,
		compare ? table([
			{ title: "", cell: (row) => row[0] },
			{ title: "This run", number: true, cell: (row) => row[1] },
			{ title: "With nothing skipped", number: true, cell: (row) => row[2] },
		], compare) : null);
}
