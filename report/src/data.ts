// A report's data: the types of report.schema.json that the page reads, and the few questions asked of all of it.
import { unzlibSync } from "fflate";
import { Chart } from "./chart";
import { DiffReport } from "./diff/data";
import { MatrixReport } from "./matrix/data";
import { Pixels } from "./picture/pixels";
import { SequenceReport } from "./sequence/data";
import { StudyReport } from "./study/data";
import { SweepReport } from "./sweep/data";

export interface Use {
	resource: number;
	parameter: string;
	reads: boolean;
	writes: boolean;
}

export interface GraphPass {
	index: number;
	name: string;
	scope: string;
	flags: string;
	culled: boolean;
	reason: string;
	shader: string;
	entry: string;
	effect: string;
	owner: string;
	renderPassBegin: number;
	renderPassEnd: number;
	mergeReason: string;
	producers: number[];
	uses: Use[];
}

export interface Resource {
	index: number;
	name: string;
	kind: "texture" | "buffer";
	shape: string;
	bytes: number;
	external: boolean;
	extracted: boolean;
	transient: boolean;
	firstPass: number;
	lastPass: number;
	heapOffset: number;
	reason: string;
}

export interface RunPass {
	index: number;
	name: string;
	executed: boolean;
	reason: string;
	shader: string;
	entry: string;
	runsAs: string; // "native kernel", "shader", "interpreter", "Vulkan"; several with commas between; empty: no shader
	pixels: number;
	taps: number | null; // null: not known
	bytesRead: number;
	bytesWritten: number;
	written?: Record<string, string>; // fingerprints by texture, where they were asked for
}

export interface Effect {
	name: string;
	active: boolean;
	reason: string;
}

export interface Message {
	severity: "warning" | "note";
	code: string;
	message: string;
	where: string;
}

/** Something that differs in how two runs were made. */
export interface Difference {
	kind: "setting" | "variable" | "input" | "other" | "effect" | "pass";
	name: string;
	a: string; // empty: there is none
	b: string;
}

export interface Run {
	version: string;
	variables?: { name: string; value: string; setBy: string }[];
	config: string;
	engine: string;
	precision: string;
	storage: string;
	scene: { file: string; extent: number[]; viewRect: number[] };
	exposure: { scale: number };
	settings: Record<string, unknown>;
	effects: Effect[];
	extensionCalls: { hook: string; view: string; extension: string; did: string }[];
	passes: RunPass[];
	memory: { transientPeakBytes: number; withoutAliasingBytes: number };
	channels: { name: string; decoded: boolean }[];
	warnings: Message[];
}

export interface Timing {
	threads: number;
	cpu: string;
	passes: { index: number; name: string; ms: number }[];
	startMs: number;
	setupMs: number;
	loadMs: number;
	compileMs: number;
	executeMs: number;
	reportMs: number;
	saveMs: number;
	wallMs: number;
}

export interface Cost {
	passes: number;
	channels: number;
	transientPeakBytes: number;
	sceneTextureBytes: number;
	ms: number;
}

export interface Explain {
	measured: boolean;
	effects: { name: string; active: boolean; passes: number; culled: number; ms: number; megabytes: number }[];
	plugins?: { name: string; passes: number; culled: number; ms: number; megabytes: number }[];
	cost: Cost;
	withoutSkipping: Cost;
}

export interface LedgerEntry {
	source: string;
	kind: string;
	rule: string;
	weight: number | null;
	distance: number | null;
	before: unknown;
	after: unknown;
	skipped: string | null;
	detail?: string;
}

export interface Blend {
	location: number[];
	ledger: Record<string, LedgerEntry[]>;
	volumes: {
		name: string;
		Priority: number;
		bUnbound: boolean;
		distance: number | null;
		weight: number;
		skipped: string | null;
	}[];
}

export interface Setting {
	name: string;
	value: unknown;
	default: unknown;
	unit: string;
	category: string;
	doc: string;
	effect: string;
	unread: string;
}

export interface PassDetail {
	index: number;
	shaderFile: string;
	permutations?: Record<string, string>[];
	bound?: string[]; // parameters whose resources the shader uses; absent where that is not known
	parameters: { name: string; type: string; value: string }[];
}

export interface PictureData {
	id: string;
	role: "final" | "scene" | "dump" | "thumbnail" | "previous" | "a" | "b" | "error" | "frame" | "version" | "state";
	label: string;
	pass: number;
	resource: string;
	mip: number;
	extent: [number, number];
	corner: [number, number];
	size: [number, number];
	channels: string[];
	encoding: "display" | "srgb" | "compressed";
	figures?: {
		min: (number | null)[];
		max: (number | null)[];
		nan: number;
		infinite: number;
		negative: number;
	};
	png: string;
	values?: { type: "half" | "float"; zlib: string };
	load?: () => Promise<Pixels>; // where a server has the picture; png is then empty
}

/** The settings along a camera's path. */
export interface Walk {
	at: string; // text of the mark where the view is
	chart: Chart;
}

export interface Report {
	format: "drydock-report";
	formatVersion: number;
	kind: "run";
	name: string;
	written: string;
	run: Run;
	timing: Timing;
	graph: {
		name: string;
		passes: GraphPass[];
		resources: Resource[];
		memory: { transientPeakBytes: number; withoutAliasingBytes: number };
	};
	explain?: Explain;
	blend?: Blend;
	walk?: Walk;
	passes: PassDetail[];
	settings: Setting[];
	nonFinite: {
		passes: { pass: string; pixels: number; of: number }[];
		final?: { pixels: number; changed: number; white: number; notFinite: number };
	};
	previous?: { written: string; differences: Difference[]; run: Run; timing?: Timing };
	pictures: PictureData[];
	thumbnailsLeftOut: number;
}

export type AnyReport = Report | StudyReport | DiffReport | SequenceReport | MatrixReport | SweepReport;

export function fromBase64(text: string): Uint8Array {
	const binary = atob(text);
	const bytes = new Uint8Array(binary.length);
	for (let i = 0; i < binary.length; ++i) {
		bytes[i] = binary.charCodeAt(i);
	}
	return bytes;
}

/** Large data are packed. */
export function readReport(): AnyReport {
	const data = JSON.parse(document.getElementById("data")!.textContent!) as AnyReport | string;
	return typeof data === "string" ? (JSON.parse(new TextDecoder().decode(unzlibSync(fromBase64(data)))) as AnyReport) : data;
}

/** The passes somebody added: without the graph's prologue and epilogue. */
export function realPasses(report: Report): GraphPass[] {
	const real = new Set(report.run.passes.map((pass) => pass.index));
	return report.graph.passes.filter((pass) => real.has(pass.index));
}

/** "DOF Setup" of "DOF Setup 480x270 (PS)", "Upsample" of "Upsample(High) 8x8 (PS)". */
export function shortName(pass: string): string {
	return pass.replace(/\(.*$/, "").replace(/ \d+(x\d+)*\s*$/, "").trim() || pass;
}

export function pictureUrl(picture: PictureData): string {
	return "data:image/png;base64," + picture.png;
}
