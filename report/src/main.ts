// Builds the page from its data.
import { readReport } from "./data";
import { el, installTips } from "./dom";
import { time } from "./format";
import { GraphPanel } from "./graph/panel";
import { PicturePanel } from "./picture/panel";
import { makeAbout, makeKeys } from "./sections/about";
import { makeAnswers } from "./sections/answers";
import { makeEffects } from "./sections/effects";
import { makeMessages } from "./sections/messages";
import { makeSettings } from "./sections/settings";
import { makeTime } from "./sections/time";

const sections: [string, string][] = [["picture", "Picture"], ["graph", "Graph"], ["settings", "Settings"], ["effects", "Effects"], ["time", "Time"], ["messages", "Messages"]];

function isDark(): boolean {
	const chosen = document.documentElement.dataset.theme;
	return chosen ? chosen === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
}

function main(): void {
	const report = readReport();
	document.title = `${report.name} · drydock`;
	const keys = makeKeys();
	const about = makeAbout(report, document.documentElement.outerHTML.length);
	const graph = new GraphPanel(report, (id) => picture.show(id));
	const picture = new PicturePanel(report);
	const openPass = (index: number) => graph.open(index);
	const theme = el("button", { type: "button", id: "theme", "data-tip": "Light or dark (key T)", onclick: () => {
		document.documentElement.dataset.theme = isDark() ? "light" : "dark";
		picture.viewer.shade();
		void picture.choose(picture.selectedA, picture.selectedB);
	} }, "Light / dark");

	document.body.append(
		el("header", { class: "top" },
			el("h1", {}, report.name),
			el("span", { class: "quiet" }, [report.run.config, report.run.scene.file, "UE " + report.run.engine, report.run.precision === "double" ? "double" : "", time(report.written)].filter(Boolean).join("  ·  ")),
			el("nav", { "aria-label": "Sections" }, sections.map(([id, title]) => el("a", { href: "#" + id }, title))),
			theme,
			el("button", { type: "button", "data-tip": "Keys (key ?)", "aria-label": "Keys", id: "show-keys", onclick: () => keys.showModal() }, "?"),
			el("button", { type: "button", id: "show-about", onclick: () => about.showModal() }, "About")),
		el("main", {},
			makeAnswers(report, () => {
				picture.setMode("difference");
				picture.element.scrollIntoView();
			}),
			picture.element, graph.element, makeSettings(report), makeEffects(report), makeTime(report, openPass), makeMessages(report, openPass)),
		keys, about);
	installTips();

	addEventListener("keydown", (event) => {
		const typing = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
		if (event.defaultPrevented || typing || event.ctrlKey || event.metaKey || event.altKey) {
			return;
		}
		const actions: Record<string, () => void> = {
			"/": () => graph.focusSearch(),
			t: () => theme.click(),
			"?": () => keys.showModal(),
			Escape: () => graph.select(-1),
		};
		if (actions[event.key]) {
			if (event.key !== "Escape") { // which also closes a dialog
				event.preventDefault();
			}
			actions[event.key]();
		}
	});
	document.documentElement.dataset.ready = "true";
}

main();
