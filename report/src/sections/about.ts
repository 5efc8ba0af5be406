// Shows the parts of the page, and its keys, in two boxes that open on request.
import { el, table } from "../dom";
import { bytes, time } from "../format";
import { PicturePanel } from "../picture/panel";

/** Filled in by build.mjs: what each part weighs in the bundle, minified. */
declare const PARTS: { name: string; version: string; license: string; does: string; bytes: number }[];

const keys: [string, string][] = [
	["/", "search the graph"], ["T", "light or dark"], ["?", "this list"], ["Esc", "closes what is open"],
	["A  B", "show picture A, show B; B again flips back"], ["S  I  D", "slider, side by side, difference"],
	["E  shift+E", "half a stop brighter, darker"], ["C  O  R  X", "false colour, odd values, stretch, reset"],
	["+  −", "zoom"], ["arrows", "on the picture: move it"], ["F  1  N", "fit, texels as pixels, texels with numbers"],
	["shift+arrows", "on the picture: move the probe by a texel"], ["[  ]", "move the slider"],
	["arrows, Enter", "on the graph and a matrix: from one to the next, open"],
	["←  →", "on a plot: from place to place"], [",  .  P  K", "of a sequence: frame before, next, play, B follows"], ["G", "of a study: small panels"],
];

/** More: keys of the page alone. */
export function makeKeys(more: [string, string][] = []): HTMLDialogElement {
	return el<HTMLDialogElement>("dialog", { id: "keys", "aria-label": "Keys" }, el("h2", {}, "Keys"),
		el("dl", {}, [...more, ...keys.filter(([key]) => !more.some(([other]) => other === key))].flatMap(([key, does]) => [el("dt", {}, key), el("dd", {}, does)])),
		el("form", { method: "dialog" }, el("button", {}, "Close")));
}

export function makeAbout(version: string, written: string, size: number): HTMLDialogElement {
	const total = PARTS.reduce((sum, part) => sum + part.bytes, 0);
	return el<HTMLDialogElement>("dialog", { id: "about", "aria-label": "About" }, el("h2", {}, "About this page"),
		el("p", {}, `Written by drydock ${version} on ${time(written)}. ${bytes(size)}, of which ${bytes(total)} are the page itself; it asks for nothing from the network.`),
		el("p", {}, "Its data are one JSON, in the element #data; docs/report.md describes it."),
		table([
			{ title: "Part", cell: (part) => part.name }, { title: "Version", cell: (part) => part.version }, { title: "Licence", cell: (part) => part.license },
			{ title: "Does", cell: (part) => part.does }, { title: "Size", number: true, cell: (part) => bytes(part.bytes) },
		], PARTS),
		el("form", { method: "dialog" }, el("button", {}, "Close")));
}

/** Keys act wherever on the page the focus is, but in a field; those that are not in actions are the picture's. */
export function listenKeys(actions: Record<string, () => void>, picture?: PicturePanel | null): void {
	addEventListener("keydown", (event) => {
		const { target } = event;
		const typing = (target instanceof HTMLInputElement && target.type !== "range") || target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement;
		if (event.defaultPrevented || typing || event.ctrlKey || event.metaKey || event.altKey) {
			return;
		}
		if (actions[event.key]) {
			if (event.key !== "Escape") { // which also closes a dialog
				event.preventDefault();
			}
			actions[event.key]();
		} else if (picture?.press(event.key, event.shiftKey)) {
			event.preventDefault();
		}
	});
}
