// The passes of the last frame and its effects: what ran, what was taken from the frame before, and why.
import { shortName } from "../data";
import { el, refill, table } from "../dom";
import { count, ms } from "../format";
import { effectColumns } from "../sections/effects";
import { Frame } from "./data";

export class PassesPanel {
	readonly element: HTMLElement;
	private readonly note = el("p", { class: "note" });
	private readonly box = el("div", {});
	private readonly effects = el("div", {});

	constructor(private readonly openPass: (index: number) => void) {
		this.element = el("div", {}, this.note, this.box, el("h3", {}, "Effects"), this.effects);
	}

	update(frame: Frame): void {
		this.note.textContent = `${count(frame.passesRun, "pass", "passes")} ran, ${frame.passesReused} taken from the last frame, ${ms(frame.milliseconds.passes)} in all. A pass opens in the graph below.`;
		const longest = Math.max(0.001, ...frame.passes.map((pass) => pass.ms));
		refill(this.box, frame.passes, () => [table([
			{ title: "Pass", cell: (row) => el("button", { type: "button", class: "link", onclick: () => this.openPass(row.index) }, `${row.index}  ${shortName(row.name)}`) },
			{ title: "Time", number: true, cell: (row) => (row.reused ? el("span", { class: "quiet" }, "reused") : ms(row.ms)) },
			{ title: "Share", wide: true, cell: (row) => el("span", { class: "bar", style: `--share:${row.reused ? 0 : row.ms / longest}` }) },
		], frame.passes, (row) => ({ class: row.reused ? "off" : "" }))]);
		refill(this.effects, frame.effects, () => [table(effectColumns, [...frame.effects].sort((a, b) => Number(b.active) - Number(a.active)), (row) => ({ class: row.active ? "" : "off" }))]);
	}
}
