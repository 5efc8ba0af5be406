// All settings by the engine's categories, each a control that edits the camera or one of the volumes.
import { LedgerEntry } from "../data";
import { el, refill } from "../dom";
import { count, value as show } from "../format";
import { story } from "../sections/settings";
import { makeControl, makeFault } from "./control";
import { Edit, Json, LiveSetting, Message, State, pointTo } from "./data";
import { Refusal, get, getText, post } from "./server";

export type SendEdits = (edits: Edit[], refused: (messages: Message[]) => void, drag?: string, at?: number) => void;

interface Row {
	setting: LiveSetting;
	element: HTMLElement;
	update: (setting: LiveSetting, own: Json | undefined) => void;
}

export class SettingsPanel {
	readonly element: HTMLElement;
	private readonly rows = new Map<string, Row>();
	private readonly groups: { element: HTMLDetailsElement; note: HTMLElement; rows: Row[] }[] = [];
	private readonly search: HTMLInputElement;
	private readonly target: HTMLSelectElement;
	private readonly found = el("output", { class: "quiet", id: "settings-found" });
	private readonly list = el("div", { class: "settings" });
	private readonly onlyChanged: HTMLInputElement;
	private state!: State;
	private config: any = {}; // where a volume is edited: the config

	constructor(private readonly sendEdits: SendEdits) {
		this.search = el<HTMLInputElement>("input", { type: "search", id: "settings-search", placeholder: "Search settings  ( / )", "aria-label": "Search settings", oninput: () => this.filter() });
		this.target = el<HTMLSelectElement>("select", { id: "target", onchange: () => void this.readTarget() });
		this.onlyChanged = el<HTMLInputElement>("input", { type: "checkbox", id: "only-changed", onchange: () => this.filter() });
		this.element = el("div", {},
			el("div", { class: "tools" }, this.search,
				el("label", { "data-tip": "The part of the config into which a change is written" }, el("span", {}, "Edit"), this.target),
				el("label", {}, this.onlyChanged, el("span", {}, "only set or not default")), this.found),
			this.list);
	}

	get volume(): number {
		return Number(this.target.value || -1);
	}

	/** Edits a volume's settings from now on. */
	setTarget(volume: number): void {
		this.target.value = String(volume);
		void this.readTarget();
	}

	focusSearch(): void {
		this.search.focus();
		this.search.select();
	}

	update(state: State): void {
		const before = this.state?.settings.map(({ name }) => name).join();
		this.state = state;
		const chosen = this.target.value || "-1";
		refill(this.target, state.volumes.map(({ name }) => name), () => [el("option", { value: -1 }, "camera, over all"), ...state.volumes.map((volume, i) => el("option", { value: i }, `volume ${volume.name || i}`))]);
		this.target.value = this.target.querySelector(`[value="${chosen}"]`) ? chosen : "-1";
		if (state.settings.map(({ name }) => name).join() !== before) {
			this.build();
		}
		this.volume >= 0 ? void this.readTarget() : this.fill();
	}

	private async readTarget(): Promise<void> {
		if (this.volume >= 0) {
			const text = await getText("text?as=config").catch(() => "{}");
			this.config = JSON.parse(text.replace(/("(?:[^"\\]|\\.)*")|\/\/[^\n]*|\/\*[^]*?\*\//g, (_, string) => string ?? "").replace(/,(\s*[\]}])/g, "$1"));
		}
		this.fill();
	}

	private fill(): void {
		for (const setting of this.state.settings) {
			const own = this.volume < 0 ? (setting.overridden ? setting.value : undefined) : this.config?.volumes?.[this.volume]?.Settings?.[setting.name] as Json | undefined;
			this.rows.get(setting.name)!.update(setting, own);
		}
		for (const { note, rows } of this.groups) {
			const set = rows.filter(({ element }) => element.dataset.set === "true").length;
			note.textContent = `${rows.length}${set ? ` · ${set} set or not default` : ""}`;
		}
		this.filter();
	}

	private build(): void {
		this.rows.clear();
		this.groups.length = 0;
		const isUsed = (setting: LiveSetting) => setting.overridden || (setting.inVolumes.length > 0 && !setting.unread);
		const categories = [...Map.groupBy(this.state.settings, (setting) => setting.category)];
		for (const [category, settings] of categories.sort(([, a], [, b]) => Number(b.some(isUsed)) - Number(a.some(isUsed)))) {
			const rows = settings.map((setting) => this.makeRow(setting));
			const note = el("span", { class: "quiet" });
			const isOpen = settings.some(isUsed);
			const element = el<HTMLDetailsElement>("details", { class: "category", open: isOpen }, el("summary", {}, category.replaceAll("|", " › ") || "Other", " ", note), rows.map((row) => row.element));
			rows.forEach((row) => this.rows.set(row.setting.name, row));
			this.groups.push({ element, note, rows });
		}
		this.list.replaceChildren(...this.groups.map((group) => group.element));
	}

	private filter(): void {
		const words = this.search.value.trim().toLowerCase().split(/\s+/).filter(Boolean);
		const only = this.onlyChanged.checked;
		let found = 0;
		for (const { element, rows } of this.groups) {
			let shown = 0;
			for (const row of rows) {
				const { name, display, category, effect, plugin } = row.setting;
				const text = words.length ? [name, display, category, effect, plugin].join(" ").toLowerCase() : "";
				row.element.hidden = !words.every((word) => text.includes(word)) || (only && row.element.dataset.set !== "true");
				shown += Number(!row.element.hidden);
			}
			element.hidden = !shown;
			if (words.length || only) {
				element.open = true;
			}
			found += shown;
		}
		this.found.textContent = words.length || only ? `${found} of ${count(this.rows.size, "setting")}` : "";
	}

	private makeRow(first: LiveSetting): Row {
		const { name } = first;
		let setting = first;
		const id = "set-" + name;
		const fault = makeFault();
		const send = (edit: (pointer: string) => Edit, drag?: string, at?: number) => {
			fault.say("");
			this.sendEdits([edit(pointTo(this.volume, name))], fault.refused, drag, at);
		};
		const control = makeControl({
			id, label: first.display || name, type: first.type, value: first.value, range: first.range, enum: first.enum, objectClass: first.class, refuse: fault.say,
			guess: typeof first.default === "number" ? first.default : undefined,
			send: (value, drag, at) => send((set) => ({ set, value }), drag, at),
		});
		const tick = el<HTMLInputElement>("input", {
			type: "checkbox", "aria-label": `Override ${first.display || name}`, onchange: () => send((pointer) => (tick.checked ? { set: pointer, value: setting.value } : { remove: pointer })),
		});
		const blended = el("button", { type: "button", class: "link blended", "aria-expanded": "false", onclick: async () => {
			const open = why.hidden;
			blended.setAttribute("aria-expanded", String(open));
			why.hidden = !open;
			if (open) {
				const entries = await get<{ ledger: Record<string, LedgerEntry[]> }>("ledger?setting=" + encodeURIComponent(name)).then(({ ledger }) => ledger[name] ?? [], (refusal: Error) => refusal.message);
				why.replaceChildren(typeof entries === "string" ? entries : entries.length ? story(entries) : "Nothing sets it: it has its default.");
			}
		} });
		const why = el("div", { class: "why-value", hidden: true });
		const reset = el("button", { type: "button", class: "small", "aria-label": `Reset ${first.display || name}`, "data-tip": "As it was at the start", onclick: () => {
			fault.say("");
			void post("edit", { reset: pointTo(this.volume, name) }).catch((refusal: Refusal) => fault.refused(refusal.messages));
		} }, "↺");
		const unread = el("p", { class: "unread-note" });
		const note = el("span", { class: "quiet note-default" });
		const element = el("div", { class: "setting", "data-setting": name },
			el("div", { class: "setting-head" }, tick, el("label", { for: id, "data-tip": `${name}: ${first.doc}` }, first.display || name),
				first.plugin ? el("span", { class: "tag", "data-tip": "A plugin added this setting" }, first.plugin) : null, note, blended, reset),
			control.element, fault.element, unread, why);
		const update = (now: LiveSetting, own: Json | undefined) => {
			const same = JSON.stringify(now.value) === JSON.stringify(now.default);
			setting = row.setting = now;
			tick.checked = own !== undefined;
			control.show(own ?? now.value);
			element.dataset.set = String(!same || own !== undefined);
			element.classList.toggle("differs", !same);
			note.textContent = same ? "" : `default ${show(now.default)}`;
			blended.textContent = show(now.value) + (now.unit ? " " + now.unit : "");
			blended.setAttribute("data-tip", `${same ? "The default" : `Differs from the default, ${show(now.default)}`}. A click tells who gave it this value.` + (now.inVolumes.length ? ` Set by ${now.inVolumes.join(", ")}.` : ""));
			blended.setAttribute("aria-label", `Why is ${now.display || name} ${blended.textContent}`);
			reset.hidden = JSON.stringify(now.value) === JSON.stringify(now.start);
			unread.textContent = now.unread;
			unread.hidden = !now.unread;
			element.classList.toggle("pale", !!now.unread);
		};
		const row: Row = { setting, element, update };
		return row;
	}
}
