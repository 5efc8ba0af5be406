// Builds the page from its data.
import { AnyReport, Report, readReport } from "./data";
import { DiffReport } from "./diff/data";
import { DiffPage } from "./diff/page";
import { el, installTips, makeTheme } from "./dom";
import { time } from "./format";
import { GraphPanel } from "./graph/panel";
import { MatrixReport } from "./matrix/data";
import { MatrixPage, nameConfig } from "./matrix/page";
import { PicturePanel, beside } from "./picture/panel";
import { listenKeys, makeAbout, makeKeys } from "./sections/about";
import { makeAnswers } from "./sections/answers";
import { makeEffects } from "./sections/effects";
import { makeMessages } from "./sections/messages";
import { makeSettings } from "./sections/settings";
import { makeTime } from "./sections/time";
import { SequenceReport } from "./sequence/data";
import { SequencePage } from "./sequence/page";
import { StudyReport } from "./study/data";
import { StudyPanel } from "./study/page";
import { SweepReport } from "./sweep/data";
import { SweepPage } from "./sweep/page";

/** The contents of a kind of page: what it is, its sections, the line under that, and its own keys. */
interface Contents {
	intro: string; // for somebody who never heard of drydock
	note: string[];
	sections: [string, string][];
	parts: HTMLElement[];
	keys: Record<string, () => void>;
	picture?: PicturePanel | null; // whose keys act anywhere on the page
}

/** Names drydock and says its purpose. */
const program = "drydock, which runs Unreal Engine post-processing on the CPU";

function makeRun(report: Report): Contents {
	const graph = new GraphPanel(report, (id) => picture.show(id));
	const picture = new PicturePanel(report.pictures, {
		b: report.pictures.find((one) => one.role === "previous")?.id,
		note: report.thumbnailsLeftOut ? `${report.thumbnailsLeftOut} thumbnails of passes were left out: together they weigh too much` : "",
		shape: (name) => report.graph.resources.find((resource) => resource.name === name)?.shape,
	});
	const openPass = (index: number) => graph.open(index);
	const showDifference = () => {
		picture.setMode("difference");
		picture.element.scrollIntoView();
	};
	return {
		intro: `This page shows one frame made by ${program}: A is its picture` + (report.previous ? ", B the picture of the run before" : "") + ", and below is how it came about.",
		note: [report.run.config, report.run.scene.file, "UE " + report.run.engine, report.run.precision === "double" ? "double" : ""],
		sections: [["picture", "Picture"], ["graph", "Graph"], ["settings", "Settings"], ["effects", "Effects"], ["time", "Time"], ["messages", "Messages"]],
		parts: [beside(makeAnswers(report, showDifference), picture), graph.element, makeSettings(report), makeEffects(report), makeTime(report, openPass), makeMessages(report, openPass)],
		keys: { "/": () => graph.focusSearch(), Escape: () => graph.select(-1) },
		picture,
	};
}

function makeStudy(report: StudyReport): Contents {
	const { study, timing } = report;
	const panel = new StudyPanel(report);
	return {
		intro: `This page shows how much time each way to make one effect costs, and how far its picture is from the exact one, as measured by ${program}.`,
		note: [study.config, study.scene, study.size.join(" × "), `medians of ${timing.repetitions} runs, ${timing.threads} threads on ${timing.cpu}`],
		sections: [], parts: [panel.element], keys: panel.keys,
	};
}

function makeDiff(report: DiffReport): Contents {
	const page = new DiffPage(report);
	return {
		intro: `This page compares two results of ${program}: A is ${report.a.path}, B is ${report.b.path}.`,
		note: [], sections: page.sections, parts: page.parts, keys: {}, picture: page.picture,
	};
}

function makeSequence(report: SequenceReport): Contents {
	const page = new SequencePage(report);
	const { config, scene, frames } = report.sequence;
	return {
		intro: `This page shows ${frames.length} frames of a sequence made by ${program}: A is the chosen frame, B the one before.`,
		note: [config, scene, `${frames.length} frames, ${report.framesPerSecond} a second`],
		sections: page.sections, parts: page.parts, keys: page.keys, picture: page.picture,
	};
}

function makeMatrix(report: MatrixReport): Contents {
	const page = new MatrixPage(report);
	return {
		intro: `This page shows one plugin, built for and run under several engine versions by ${program}.`,
		note: [`${report.matrix.versions.length} engine versions`, nameConfig(report)], sections: page.sections, parts: page.parts, keys: {}, picture: page.picture,
	};
}

function makeSweep(report: SweepReport): Contents {
	const page = new SweepPage(report);
	const { config, rows, axes } = report.sweep;
	return {
		intro: `This page shows what changes over ${axes.map((axis) => axis.name).join(", ")}, as computed by ${program}.`,
		note: [config, `${rows.length} tasks`], sections: page.sections, parts: page.parts, keys: {}, picture: page.picture,
	};
}

function makeContents(report: AnyReport): Contents {
	switch (report.kind) {
		case "study": return makeStudy(report);
		case "diff": return makeDiff(report);
		case "sequence": return makeSequence(report);
		case "matrix": return makeMatrix(report);
		case "sweep": return makeSweep(report);
		default: return makeRun(report);
	}
}

/** The version of the drydock that made the data. */
function getVersion(report: AnyReport): string {
	return report.kind === "study" ? report.study.version : report.kind === "run" ? report.run.version : report.version;
}

function main(): void {
	const report = readReport();
	document.title = `${report.name} · drydock`;
	const contents = makeContents(report);
	const keys = makeKeys();
	const about = makeAbout(getVersion(report), report.written, document.documentElement.outerHTML.length);
	const theme = makeTheme(() => void contents.picture?.choose(contents.picture.selectedA, contents.picture.selectedB));

	document.body.append(
		el("header", { class: "top" },
			el("h1", {}, report.name),
			el("nav", { "aria-label": "Sections" }, contents.sections.map(([id, title]) => el("a", { href: "#" + id }, title))),
			theme,
			el("button", { type: "button", "data-tip": "Keys (key ?)", "aria-label": "Keys", id: "show-keys", onclick: () => keys.showModal() }, "?"),
			el("button", { type: "button", id: "show-about", onclick: () => about.showModal() }, "About")),
		el("main", {},
			el("div", { class: "intro" }, el("p", {}, contents.intro), el("p", { class: "quiet" }, [...contents.note, time(report.written)].filter(Boolean).join("  ·  "))),
			...contents.parts),
		keys, about);
	installTips();

	listenKeys({ ...contents.keys, t: () => theme.click(), "?": () => keys.showModal() }, contents.picture);
	document.documentElement.dataset.ready = "true";
}

main();
