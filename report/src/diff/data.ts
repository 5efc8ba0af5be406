// A comparison's data: the types of diff.schema.json that the page reads.
import { Difference, PictureData, Run, Timing } from "../data";

export interface Compared {
	name: string;
	a: string; // file; empty: this side has none
	b: string;
	max?: number | null; // null: not finite
	rms?: number | null;
	relative?: number | null;
	psnr?: number | null;
	ssim?: number | null;
	flip?: number | null;
	nonFinite?: number;
	at?: [number, number];
	channel?: string;
}

export interface Side {
	path: string;
	run?: Run;
	timing?: Timing;
}

export interface DiffReport {
	format: "drydock-report";
	formatVersion: number;
	kind: "diff";
	name: string;
	version: string;
	written: string;
	diff: { allowed: number | null; passed: boolean; images: Compared[]; differences?: Difference[]; times?: { repeats: number; sentence: string } };
	a: Side;
	b: Side;
	pictures: PictureData[];
}

/** Whether both sides have it, and it is not the same. */
export function differs(image: Compared): boolean {
	return image.max !== undefined && image.max !== 0;
}
