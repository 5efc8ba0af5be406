// Shows where the time of the process and of the passes went, beside the run before.
import { Report, Timing, shortName } from "../data";
import { el, section, table } from "../dom";
import { big, bytes, ms, number, percent } from "../format";

const parts: [keyof Timing, string, string][] = [
	["startMs", "Start", "loading libraries, before the run"],
	["setupMs", "Setup", "config, settings, plugins"],
	["loadMs", "Load", "reading and converting scene channels"],
	["compileMs", "Graph", "building and compiling the graph, and its shaders"],
	["executeMs", "Passes", "the passes themselves"],
	["reportMs", "Report", "looking for what is not finite, run.json"],
	["saveMs", "Save", "writing pictures"],
];

function stack(timing: Timing, label: string): HTMLElement {
	const sum = parts.reduce((total, [key]) => total + (timing[key] as number), 0);
	return el("div", { class: "stack-row" }, el("span", { class: "quiet" }, label),
		el("div", { class: "stack", role: "img", "aria-label": parts.map(([key, name]) => `${name} ${ms(timing[key] as number)}`).join(", ") },
			parts.map(([key, name, tip], i) => {
				const part = timing[key] as number;
				return el("span", { class: "part part-" + i, style: `flex-grow:${part / sum}`, "data-tip": `${name}: ${ms(part)}, ${percent(part / sum)} (${tip})` },
					part / sum > 0.07 ? el("span", {}, `${name} ${ms(part)}`) : "");
			})),
		el("span", { class: "number" }, ms(timing.wallMs)));
}

export function makeTime(report: Report, openPass: (index: number) => void): HTMLElement {
	const { timing, run, previous } = report;
	const old = new Map(previous?.timing?.passes.map((pass) => [pass.name, pass.ms]) ?? []);
	const rows = [...timing.passes].sort((a, b) => b.ms - a.ms);
	const shown = 16; // the others on request
	const longest = Math.max(...rows.map((row) => row.ms), ...old.values(), 0.001);
	const counters = (index: number) => run.passes.find((pass) => pass.index === index)!;
	return section("time", "Time", `${timing.threads} threads on ${timing.cpu}`,
		el("p", { class: "note narrow" }, parts.map(([key, name]) => `${name} ${ms(timing[key] as number)}`).join(", ")),
		stack(timing, "this run"), previous?.timing ? stack(previous.timing, "before") : null,
		table([
			{ title: "Pass", cell: (row) => el("button", { type: "button", class: "link", onclick: () => openPass(row.index) }, `${row.index}  ${shortName(row.name)}`) },
			{ title: "Time", number: true, cell: (row) => ms(row.ms) },
			{
				title: old.size ? "mark: the run before" : "", cell: (row) => el("span", { class: "bar", style: `--share:${row.ms / longest}` },
					old.has(row.name) ? el("i", { style: `left:${(100 * old.get(row.name)!) / longest}%`, "data-tip": `before: ${ms(old.get(row.name)!)}` }) : null),
			},
			{ title: "of passes", wide: true, number: true, cell: (row) => percent(row.ms / timing.executeMs) },
			{ title: "ns a pixel", wide: true, number: true, cell: (row) => (counters(row.index).pixels ? number(Number(((row.ms * 1e6) / counters(row.index).pixels).toPrecision(3))) : "") },
			{ title: "Taps", wide: true, number: true, cell: (row) => (counters(row.index).taps ? big(counters(row.index).taps!) : "") },
			{ title: "Moved", wide: true, number: true, cell: (row) => bytes(counters(row.index).bytesRead + counters(row.index).bytesWritten) },
			{ title: "GB/s", wide: true, number: true, cell: (row) => (row.ms ? number(Number(((counters(row.index).bytesRead + counters(row.index).bytesWritten) / row.ms / 1e6).toPrecision(3))) : "") },
		], rows, (row) => ({ hidden: rows.indexOf(row) >= shown })),
		rows.length > shown ? el("p", {}, el("button", { type: "button", class: "link", onclick: (event: Event) => {
			document.querySelectorAll("#time tr[hidden]").forEach((row) => row.removeAttribute("hidden"));
			(event.target as HTMLElement).remove();
		} }, `all ${rows.length} passes`)) : null);
}
