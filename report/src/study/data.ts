// The data of a study's page: study.json and study_timing.json as they are, and pictures of some variants.
import { Panel } from "../chart";

export interface Figures {
	max: number | null;
	rms: number | null;
	relative: number | null;
	psnr: number | null;
	ssim: number | null;
	flip: number | null;
	taps: number;
}

export type Metric = "max" | "rms" | "relative" | "psnr" | "ssim" | "flip";

export interface VariantResult extends Figures {
	label: string;
	set: Record<string, string>;
	excluded: string;
	bytes: number;
	current: boolean;
	front: boolean;
	dominatedBy: string;
}

export interface VariantTiming {
	label: string;
	medianMs: number;
	lowMs: number;
	highMs: number;
	front: boolean;
	dominatedBy: string;
	withinNoiseOf: string[];
}

export interface Inset {
	title: string;
	subtitle: string;
	png: string;
	heat: string;
	heatTitle: string;
}

export interface StudyReport {
	format: "drydock-report";
	formatVersion: number;
	kind: "study";
	name: string;
	written: string;
	study: {
		version: string;
		config: string;
		scene: string;
		size: [number, number];
		subject: string;
		reference: string;
		metric: Metric;
		budget: { metric: Metric; max?: number; ms?: number; default: boolean };
		jobs: { label: string; reference: string; variants: VariantResult[] }[];
	};
	timing: {
		cpu: string;
		threads: number;
		repetitions: number;
		jobs: { label: string; referenceMs: number; recommended: string; recommendation: string; variants: VariantTiming[] }[];
	};
	charts: Record<"time" | "taps", Record<Metric, Panel>>[]; // by job
	insets: { title: string; pictures: Inset[] }[];
}

/** A variant of a job with all that is known of it. */
export interface Point {
	result: VariantResult;
	timing: VariantTiming;
	recommended: boolean;
	inset: Inset | undefined;
}

export const metricNames: Record<Metric, string> = { max: "largest error", rms: "RMS error", relative: "relative error", psnr: "PSNR", ssim: "SSIM", flip: "FLIP" };

export function gatherPoints(report: StudyReport, job: number): Point[] {
	const timing = report.timing.jobs[job];
	const pictures = report.insets.find((row) => row.title === timing.label)?.pictures ?? report.insets[report.timing.jobs.length === 1 ? 0 : -1]?.pictures ?? [];
	return report.study.jobs[job].variants.filter((result) => !result.excluded).map((result) => ({
		result,
		timing: timing.variants.find((variant) => variant.label === result.label)!,
		recommended: result.label === timing.recommended,
		inset: pictures.find((picture) => picture.title === result.label || picture.title.startsWith(result.label + " (")), // "(in use)"
	})).filter((point) => point.timing !== undefined);
}
