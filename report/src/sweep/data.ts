// A sweep's data: the types of sweep.schema.json that the page reads.
import { Panel } from "../chart";
import { PictureData } from "../data";

export interface SweepRow {
	task: string;
	values: string[]; // by axis
	set: Record<string, string>;
	frames?: string;
	figures: Record<string, number | null>;
	pictures: string[]; // files
	messages: string[];
}

export interface SweepPiece {
	task: string;
	frames: string;
	lead: string;
	different: number;
	max: number | null;
	rms: number | null;
}

export interface SweepReport {
	format: "drydock-report";
	formatVersion: number;
	kind: "sweep";
	name: string;
	version: string;
	written: string;
	sweep: {
		version: string; config: string; task: string; axes: { name: string; values: string[] }[]; against: Record<string, string>;
		comparedBy: string; figures: string[]; rows: SweepRow[]; pieces: SweepPiece[]; notes: string[];
	};
	seconds: number[]; // by row
	plots: { axis: string; panels: Panel[] }[];
	pictures: PictureData[]; // id: index of the row
}
