// Tabs: one of several parts is shown; arrows move between their buttons.
import { el } from "../dom";

export function makeTabs(parts: [string, string, HTMLElement][]): { element: HTMLElement; shown: string; show: (id: string) => void } {
	const buttons = parts.map(([id, title], i) => el<HTMLButtonElement>("button", {
		type: "button", role: "tab", id: "tab-" + id, "aria-controls": id, onclick: () => tabs.show(id),
		onkeydown: (event: KeyboardEvent) => {
			const to = { ArrowLeft: i - 1, ArrowRight: i + 1, Home: 0, End: parts.length - 1 }[event.key];
			if (to !== undefined) {
				event.preventDefault();
				const button = buttons[(to + parts.length) % parts.length];
				button.click();
				button.focus();
			}
		},
	}, title));
	const panels = parts.map(([id, , element]) => el("section", { id, role: "tabpanel", "aria-labelledby": "tab-" + id }, element));
	const tabs = {
		element: el("div", { class: "tabs" }, el("div", { role: "tablist", "aria-label": "What can be changed and seen" }, buttons), panels),
		shown: "",
		show: (shown: string) => {
			tabs.shown = shown;
			parts.forEach(([id], i) => {
				panels[i].hidden = id !== shown;
				buttons[i].setAttribute("aria-selected", String(id === shown));
				buttons[i].tabIndex = id === shown ? 0 : -1;
			});
		},
	};
	tabs.show(parts[0][0]);
	return tabs;
}
