// The dialogs: save as a config, copy as text, end the server; and the download of the session.
import { el } from "../dom";
import { makeFault } from "./control";
import { Refusal, getText, post } from "./server";

function makeDialog(id: string, title: string, ...parts: (Node | string)[]): HTMLDialogElement {
	const dialog = el<HTMLDialogElement>("dialog", { id, "aria-labelledby": id + "-title" }, el("h2", { id: id + "-title" }, title), ...parts);
	document.body.append(dialog);
	return dialog;
}

/** A button that opens a dialog. */
export function opener(id: string, label: string, tip: string, dialog: HTMLDialogElement, before?: () => void): HTMLElement {
	return el("button", { type: "button", id, "data-tip": tip, onclick: () => {
		before?.();
		dialog.showModal();
	} }, label);
}

/** Saved: is told the path of the config that was written. */
export function makeSave(suggest: () => string, saved: (path: string) => void): HTMLElement {
	const fault = makeFault();
	const path = el<HTMLInputElement>("input", { type: "text", id: "save-path", class: "text-box", autocomplete: "off", oninput: () => ask("", false) });
	const again = el("button", { id: "save-again", type: "button", hidden: true, onclick: () => void save(true) }, "Save over it");
	const ask = (message: string, exists: boolean) => {
		fault.say(message);
		again.hidden = !exists; // a second question, about this file
	};
	const save = async (over: boolean) => {
		try {
			const answer = await post<{ saved: string }>("save", { path: path.value, again: over });
			dialog.close();
			saved(answer.saved);
		} catch (refusal) {
			const exists = (refusal as Refusal).status === 409;
			ask(exists ? `${path.value} exists already. Save over it?` : (refusal as Refusal).message, exists);
		}
	};
	const dialog = makeDialog("save", "Save as a config",
		el("form", { class: "dialog-form", onsubmit: (event: Event) => {
			event.preventDefault();
			void save(false);
		} },
			el("label", { for: "save-path" }, "File, beside the config or below --out"), path, fault.element,
			el("div", { class: "dialog-buttons" }, el("button", { type: "button", onclick: () => dialog.close() }, "Cancel"), again, el("button", { type: "submit", id: "save-now" }, "Save"))));
	return opener("show-save", "Save…", "Writes this state as a config that `drydock run` takes", dialog, () => {
		path.value ||= suggest();
		ask("", false);
	});
}

export function makeCopy(): HTMLElement {
	const kinds: [string, string][] = [["engine", "Engine text, for the editor"], ["config", "Config"], ["lines", "JSON lines of what differs"], ["variables", "Console variables"]];
	const text = el<HTMLTextAreaElement>("textarea", { id: "copy-text", readonly: true, rows: 14, "aria-label": "Text to copy" });
	const said = el("span", { role: "status", class: "quiet" });
	const as = el<HTMLSelectElement>("select", { id: "copy-as", onchange: () => void read() }, kinds.map(([value, label]) => el("option", { value }, label)));
	const read = async () => {
		said.textContent = "";
		text.value = await getText("text?as=" + as.value).catch((refusal: Error) => refusal.message);
	};
	const dialog = makeDialog("copy", "Copy as text", el("label", { class: "tools" }, el("span", {}, "As"), as), text,
		el("div", { class: "dialog-buttons" }, said, el("button", { type: "button", id: "copy-now", onclick: async () => {
			text.select();
			const copied = await navigator.clipboard?.writeText(text.value).then(() => true, () => false) || document.execCommand("copy");
			said.textContent = copied ? "Copied." : "The browser did not allow it: press Ctrl+C.";
		} }, "Copy"), el("button", { type: "button", onclick: () => dialog.close() }, "Close")));
	return opener("show-copy", "Copy…", "As text for the editor, as JSON lines, as console variables", dialog, () => void read());
}

export function makeDownload(name: () => string, failed: (message: string) => void): HTMLElement {
	return el("button", { type: "button", id: "session", "data-tip": "The session as a file, for `drydock live --replay FILE`", onclick: async () => {
		try {
			const address = URL.createObjectURL(new Blob([await getText("session")], { type: "application/x-ndjson" }));
			el("a", { href: address, download: `${name()}.session.jsonl` }).click();
			setTimeout(() => URL.revokeObjectURL(address), 1000);
		} catch (refusal) {
			failed((refusal as Refusal).message);
		}
	} }, "Session");
}

export function makeEnd(failed: (message: string) => void): HTMLElement {
	const dialog = makeDialog("end", "End drydock live?", el("p", {}, "The server stops. Changes that were not saved are lost."),
		el("div", { class: "dialog-buttons" }, el("button", { type: "button", onclick: () => dialog.close() }, "Cancel"),
			el("button", { type: "button", id: "end-now", onclick: () => {
				dialog.close();
				void post("end").catch((refusal: Error) => failed(refusal.message));
			} }, "End")));
	return opener("show-end", "End", "Stops the server", dialog);
}
