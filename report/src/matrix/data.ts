// A matrix's data: the types of matrix.schema.json that the page reads.
import { PictureData } from "../data";

export interface MatrixMessage {
	code: string | null;
	file: string;
	line: number;
	where: string;
	text: string;
}

export interface MatrixVersion {
	engine: string;
	builds: boolean;
	firstError: MatrixMessage | null;
	compilerWarnings: MatrixMessage[];
	inEngine: { answer: string; messages: string[] }; // whether the engine of that version has all names
	notes: string[];
	library: string;
	log: string;
	run: { exitCode: number; end: string | null; firstError: MatrixMessage | null; warnings: MatrixMessage[]; extensions: string[]; folder: string } | null;
	picture: { fingerprint: string; before: string | null; same: boolean | null; max?: number | null; pixels?: number; first?: [number, number]; sameAs: string | null } | null;
	firstDifference: { pass: string; what: string } | null;
}

export interface MatrixReport {
	format: "drydock-report";
	formatVersion: number;
	kind: "matrix";
	name: string;
	version: string;
	written: string;
	matrix: { plugin: string; folder: string; config: string; versions: MatrixVersion[]; summary: string; advice: string[]; passed: boolean };
	pictures: PictureData[];
}

/** A message with the versions that it was said under. */
export interface Said {
	id: string; // of its row
	kind: string;
	message: MatrixMessage;
	engines: string[];
}

/** All messages, each once; what names the version that it was said under counts as one message under all of them. */
export function gatherMessages(report: MatrixReport): Said[] {
	const said = new Map<string, Said>();
	const add = (kind: string, message: MatrixMessage | null, engine: string) => {
		if (!message) {
			return;
		}
		const text = message.text.replaceAll("engine " + engine, "that engine");
		const key = [kind, message.code, message.file, message.line, message.where.replaceAll("engine " + engine, "that engine"), text].join("\n");
		const known = said.get(key) ?? { id: `message-${said.size}`, kind, message: { ...message, text }, engines: [] };
		if (!known.engines.includes(engine)) {
			known.engines.push(engine);
		}
		said.set(key, known);
	};
	for (const version of report.matrix.versions) {
		version.inEngine.messages.forEach((text) => add("not in the engine", { code: null, file: "", line: 0, where: "", text }, version.engine));
		version.notes.forEach((note) => add("note", { code: null, file: "", line: 0, where: "", text: note }, version.engine));
		add("does not build", version.firstError, version.engine);
		version.compilerWarnings.forEach((message) => add("the compiler warns", message, version.engine));
		add("does not run", version.run?.firstError ?? null, version.engine);
		version.run?.warnings.forEach((message) => add("the run warns", message, version.engine));
	}
	return [...said.values()];
}
