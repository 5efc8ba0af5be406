// Console variables and show flags: those that matter for the config first, the others by search.
import { el, refill } from "../dom";
import { count } from "../format";
import { Control, makeControl, makeFault } from "./control";
import { State, Variable, escapeKey } from "./data";
import { SendEdits } from "./settings";

export class VariablesPanel {
	readonly element: HTMLElement;
	private readonly search: HTMLInputElement;
	private readonly found = el("output", { class: "quiet" });
	private readonly lists = { cvars: el("div", {}), showFlags: el("div", {}) };
	private readonly rows = new Map<string, { element: HTMLElement; update: (variable: Variable) => void }>();
	private state: State | null = null;

	constructor(private readonly sendEdits: SendEdits) {
		this.search = el<HTMLInputElement>("input", { type: "search", id: "variables-search", placeholder: "Search all of them", "aria-label": "Search variables and show flags", oninput: () => this.fill() });
		this.element = el("div", {}, el("div", { class: "tools" }, this.search, this.found),
			el("h3", {}, "Console variables"), this.lists.cvars, el("h3", {}, "Show flags"), this.lists.showFlags);
	}

	update(state: State): void {
		this.state = state;
		this.fill();
	}

	private fill(): void {
		if (!this.state) {
			return;
		}
		const wanted = this.search.value.trim().toLowerCase();
		const shown = (list: Variable[]) => list.filter((one) => (wanted ? one.name.toLowerCase().includes(wanted) : one.matters || JSON.stringify(one.value) !== JSON.stringify(one.default)))
			.toSorted((a, b) => Number(a.name.startsWith("r.Drydock")) - Number(b.name.startsWith("r.Drydock")) || Number(b.matters) - Number(a.matters)).slice(0, 80);
		let sum = 0;
		for (const [key, list, none] of [["cvars", this.state.variables, "No variable matters for this config and is set."], ["showFlags", this.state.showFlags, "No show flag is off."]] as const) {
			const rows = shown(list).map((variable) => {
				const id = `${key}-${variable.name}`;
				const row = this.rows.get(id) ?? this.makeRow(key, id, variable);
				this.rows.set(id, row);
				row.update(variable);
				return row.element;
			});
			sum += rows.length;
			refill(this.lists[key], [rows.map((row) => row.dataset.variable), !wanted], () => (rows.length ? rows : [el("p", { class: "quiet" }, wanted ? "Nothing has this name." : none)]));
		}
		this.found.textContent = `${sum} of ${count(this.state.variables.length + this.state.showFlags.length, "name")}`;
	}

	private makeRow(key: "cvars" | "showFlags", id: string, first: Variable): { element: HTMLElement; update: (variable: Variable) => void } {
		const fault = makeFault();
		const pointer = `/${key}/${escapeKey(first.name)}`;
		const read = ({ value }: Variable) => (/^(true|false)$/.test(String(value)) ? String(value) === "true" : String(value)); // a switch, or text
		const control: Control = makeControl({
			id, label: first.name, type: "text", value: read(first), refuse: fault.say,
			send: (now) => {
				fault.say("");
				this.sendEdits([{ set: pointer, value: typeof now === "string" && Number.isFinite(Number(now)) ? Number(now) : now }], fault.refused);
			},
		});
		const note = el("span", { class: "quiet note-default" });
		const reset = el("button", { type: "button", class: "small", "aria-label": `Reset ${first.name}`, "data-tip": "Not set by the config", onclick: () =>
			this.sendEdits([{ remove: pointer }], fault.refused) }, "↺");
		const element = el("div", { class: "setting", "data-variable": first.name },
			el("div", { class: "setting-head" }, el("label", { for: id, "data-tip": first.doc }, first.name), note, reset), control.element, fault.element);
		return {
			element, update: (variable) => {
				const same = JSON.stringify(variable.value) === JSON.stringify(variable.default);
				control.show(read(variable));
				element.classList.toggle("differs", !same);
				note.textContent = same ? "" : `default ${variable.default}` + (variable.setBy ? `, set by ${variable.setBy}` : "");
				reset.hidden = same;
			},
		};
	}
}
