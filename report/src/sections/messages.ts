// Shows the messages of the run, with links to what they name; and who called which hook.
import { Message, Report, realPasses, shortName } from "../data";
import { el, section, table } from "../dom";

/** The text, with the names of passes in it as buttons. */
function withLinks(report: Report, text: string, openPass: (index: number) => void): Node[] {
	const passes = new Map(realPasses(report).map((pass) => [shortName(pass.name), pass.index]));
	return text.split(/([A-Za-z][A-Za-z0-9_.]+)/).map((word) => (passes.has(word)
		? el("button", { type: "button", class: "link", onclick: () => openPass(passes.get(word)!) }, word)
		: document.createTextNode(word)));
}

export function makeMessages(report: Report, openPass: (index: number) => void): HTMLElement {
	const { warnings, extensionCalls } = report.run;
	return section("messages", "Messages", warnings.length ? "" : "The run had nothing to say.",
		warnings.length ? table<Message>([
			{ title: "Number", cell: (row) => el("code", {}, row.code) },
			{ title: "Message", cell: (row) => withLinks(report, row.message, openPass) },
			{ title: "Where", cell: (row) => withLinks(report, row.where, openPass) },
		], warnings) : null,
		extensionCalls.length ? el("h3", {}, "View extensions") : null,
		extensionCalls.length ? table([
			{ title: "Hook", cell: (row) => row.hook },
			{ title: "View", cell: (row) => row.view },
			{ title: "Extension", cell: (row) => row.extension },
			{ title: "Did", cell: (row) => row.did },
		], extensionCalls) : null);
}
