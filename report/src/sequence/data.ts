// A sequence's data: the types of sequence.schema.json that the page reads.
import { PictureData, Walk } from "../data";

export interface SequenceFrame {
	frame: number;
	file: string;
	location: [number, number, number];
	volumes: Record<string, number>;
	exposure: { scale: number; preExposure: number };
	passes: { executed: number; culled: number };
	settings: Record<string, unknown>; // those that vary
}

export interface FrameFigures {
	frame: number;
	mean: number; // luminance that the display shows
	white: number; // share of pixels with a channel at its largest code
	change: number | null; // RMS from the frame before
	ms: number | null; // of the passes
}

export interface SequenceReport {
	format: "drydock-report";
	formatVersion: number;
	kind: "sequence";
	name: string;
	version: string;
	written: string;
	framesPerSecond: number;
	sequence: { version: string; config: string; scene: string; varying: string[]; frames: SequenceFrame[] };
	walk?: Walk;
	figures: FrameFigures[];
	pictures: PictureData[];
}
