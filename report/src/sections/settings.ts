// Settings that are not at their defaults, each with its story, and the volumes that gave them.
import { LedgerEntry, Report, Setting } from "../data";
import { el, section, table } from "../dom";
import { count, number, value } from "../format";
import { WalkPanel } from "./walk";

/** The steps that gave a setting its value. */
export function story(entries: LedgerEntry[]): HTMLElement {
	return el("ol", { class: "ledger" }, entries.map((entry) => el("li", { class: entry.skipped ? "skipped" : "" },
		el("span", { class: "source" }, entry.source), " ",
		el("span", { class: "quiet" }, [entry.kind, entry.rule, entry.weight !== null && entry.weight !== 1 ? `weight ${number(entry.weight)}` : "",
			entry.distance ? `${number(entry.distance)} cm away` : "", entry.detail ?? ""].filter(Boolean).join(" · ")), " ",
		entry.skipped ? el("em", {}, entry.skipped) : el("span", { class: "change" }, `${value(entry.before)} → ${value(entry.after)}`))));
}

function name(report: Report, setting: Setting): HTMLElement {
	const entries = report.blend?.ledger[setting.name] ?? [];
	const label = el("span", { "data-tip": setting.doc }, setting.name);
	return entries.length ? el("details", {}, el("summary", {}, label), story(entries)) : label;
}

export function makeSettings(report: Report): HTMLElement {
	const rows = report.settings;
	const variables = report.run.variables ?? [];
	const volumes = report.blend?.volumes ?? [];
	return section("settings", "Settings", `${count(rows.length, "setting")} of ${Object.keys(report.run.settings).length} differ from their defaults. Open one for its story.`,
		rows.length ? table<Setting>([
			{ title: "Setting", cell: (row) => name(report, row) },
			{ title: "Value", number: true, cell: (row) => el("strong", {}, value(row.value) + (row.unit ? " " + row.unit : "")) },
			{ title: "Default", number: true, cell: (row) => value(row.default) },
			{ title: "Read by", cell: (row) => (row.unread ? el("em", {}, row.unread) : row.effect || el("span", { class: "quiet" }, "no effect")) },
		], rows) : null,
		variables.length ? el("h3", {}, "Console variables that were set") : null,
		variables.length ? table([
			{ title: "Variable", cell: (row) => row.name },
			{ title: "Value", number: true, cell: (row) => el("strong", {}, row.value) },
			{ title: "Set by", cell: (row) => row.setBy },
		], variables) : null,
		volumes.length ? el("h3", {}, "Volumes") : null,
		volumes.length ? table([
			{ title: "Volume", cell: (row) => row.name },
			{ title: "Priority", number: true, cell: (row) => number(row.Priority) },
			{ title: "Reach", cell: (row) => (row.bUnbound ? "unbound" : row.distance === null ? "" : `${number(row.distance)} cm away`) },
			{ title: "Weight", cell: (row) => el("span", { class: "weight", style: `--share:${row.weight}` }, number(row.weight)) },
			{ title: "", cell: (row) => el("em", {}, row.skipped ?? "") },
		], volumes) : null,
		report.walk ? new WalkPanel(report.walk).element : null);
}
