// The page of a sequence: its frames to go through, exposure and figures over time, settings along the path.
import { Plot, Plots, Series, makeAxis, makeSeries } from "../chart";
import { el, section } from "../dom";
import { count, ms, number, percent } from "../format";
import { PicturePanel, beside } from "../picture/panel";
import { listAnswers, row, to } from "../sections/answers";
import { WalkPanel } from "../sections/walk";
import { SequenceReport } from "./data";

/** The place of the largest number; nulls count for nothing. */
function largest(values: (number | null)[]): number {
	return values.reduce<number>((best, value, i) => (value !== null && value > (values[best] ?? -Infinity) ? i : best), 0);
}

function known(values: (number | null)[]): number[] {
	return values.filter((value) => value !== null);
}

function answers(report: SequenceReport): HTMLElement {
	const { frames } = report.sequence;
	const { figures } = report;
	const range = (values: number[], show: (value: number) => string) => {
		const [low, high] = [show(Math.min(...values)), show(Math.max(...values))];
		return low === high ? low : `${low} to ${high}`;
	};
	const exposures = frames.map((frame) => frame.exposure.scale);
	const changes = figures.map((one) => one.change);
	const jump = largest(changes);
	const times = figures.map((one) => one.ms);
	const rest = known(changes).filter((change) => change !== changes[jump]).sort((a, b) => a - b);
	const usual = rest[rest.length >> 1] ?? 0;
	const jumps = changes[jump] !== null && changes[jump]! > 3 * usual && rest.length > 1;
	return listAnswers(
		row("steady", "Is it steady?", jumps ? "note" : "good", changes[jump] === null ? ["There is one frame."] : [
			"The largest step is from frame ", String(figures[jump - 1]?.frame), " to ", to("over-time", String(figures[jump].frame)), `: RMS ${number(Number(changes[jump]!.toPrecision(3)))}`,
			usual ? `, ${number(Number((changes[jump]! / usual).toPrecision(2)))} times the usual one.` : "."]),
		row("exposure", "How bright?", "good", [`Exposure ${range(exposures, (value) => number(Number(value.toPrecision(3))))}, mean luminance of the picture ${range(figures.map((one) => one.mean), (value) => value.toFixed(3))}, `,
			`${range(figures.map((one) => one.white), percent)} of the pixels at white.`]),
		row("varies", "What varies?", "good", [report.sequence.varying.length ? `${count(report.sequence.varying.length, "setting")}: ${report.sequence.varying.slice(0, 6).join(", ")}${report.sequence.varying.length > 6 ? ", ..." : ""}` : "No setting", "; ",
			range(frames.map((frame) => frame.passes.executed), String), " passes run."]),
		...(known(times).length ? [row("slowest", "Which is slowest?", "good", [`Frame ${figures[largest(times)].frame}, ${ms(times[largest(times)]!)} in its passes; the sum is ${ms(known(times).reduce((a, b) => a + b, 0))}.`])] : []));
}

export class SequencePage {
	readonly parts: HTMLElement[];
	readonly sections: [string, string][];
	readonly picture: PicturePanel;
	private readonly plots: Plots;
	private readonly walk: WalkPanel | null;
	private readonly scrubber: HTMLInputElement;
	private readonly where = el("output", { id: "where" });
	private readonly playing: HTMLButtonElement;
	private readonly follow: HTMLButtonElement;
	private timer = 0;

	constructor(private readonly report: SequenceReport) {
		const { frames } = report.sequence;
		this.scrubber = el("input", { type: "range", id: "scrubber", min: 0, max: frames.length - 1, step: 1, value: 0, "aria-label": "Frame", oninput: () => this.show(Number(this.scrubber.value)) });
		this.playing = el("button", { type: "button", id: "play", "aria-pressed": "false", "data-tip": "Through all frames (key P)", onclick: () => this.play() }, "Play");
		this.follow = el("button", { type: "button", id: "follow", "aria-pressed": "true", "data-tip": "B is always the frame before A, so that the difference shows what moves (key K)", onclick: () => {
			this.follow.setAttribute("aria-pressed", String(!this.follows()));
			this.show(this.at());
		} }, "B: frame before");
		this.picture = new PicturePanel(report.pictures, { title: "Frames", note: this.describePictures(), onChoose: (a) => this.chosen(a.id) });
		this.picture.element.querySelector(".probe")!.after(el("div", { class: "tools scrub" },
			this.playing, el("button", { type: "button", id: "earlier", "data-tip": "The frame before (key ,)", "aria-label": "The frame before", onclick: () => this.show(this.at() - 1) }, "‹"),
			el("button", { type: "button", id: "later", "data-tip": "The next frame (key .)", "aria-label": "The next frame", onclick: () => this.show(this.at() + 1) }, "›"),
			this.scrubber, this.where, this.follow));
		this.plots = new Plots(frames.map((frame) => frame.frame), this.makeCharts(), { id: "plots", name: (index) => `frame ${frames[index].frame}`, choose: (index) => this.show(index) });
		this.walk = report.walk ? new WalkPanel(report.walk, true) : null;
		this.parts = [beside(answers(report), this.picture),
			section("over-time", "Over time", "By frame. A click, or the arrows, choose one.", this.plots.element),
			...(this.walk ? [section("settings", "Settings", "", this.walk.element)] : [])];
		this.sections = [["picture", "Frames"], ["over-time", "Over time"], ...(this.walk ? [["settings", "Settings"] as [string, string]] : [])];
		this.show(0);
	}

	readonly keys: Record<string, () => void> = {
		",": () => this.show(this.at() - 1), ".": () => this.show(this.at() + 1), p: () => this.play(), k: () => this.follow.click(),
	};

	private at(): number {
		return Number(this.scrubber.value);
	}

	private follows(): boolean {
		return this.follow.getAttribute("aria-pressed") === "true";
	}

	/** The page may hold pictures of some frames only, and smaller ones. */
	private describePictures(): string {
		const { pictures, sequence } = this.report;
		const some = pictures.length < sequence.frames.length ? `Pictures of ${pictures.length} of the ${count(sequence.frames.length, "frame")}, evenly spread` : "";
		const [width] = pictures[0].size;
		const small = atob(pictures[0].png.slice(0, 32)); // its width, big-endian, from byte 16 on
		const shown = [16, 17, 18, 19].reduce((sum, i) => sum * 256 + small.charCodeAt(i), 0);
		const smaller = shown < width ? `made ${shown} pixels wide of ${width}` : "";
		const both = [some, smaller].filter(Boolean).join(", ");
		return both ? `${some ? both : both[0].toUpperCase() + both.slice(1)}, so that the page stays small; all are in frames/.` : "";
	}

	/** The picture of a frame, or of the nearest before it that has one. */
	private findPicture(index: number): string {
		const { frames } = this.report.sequence;
		for (let at = index; at >= 0; --at) {
			const picture = this.report.pictures.find((one) => one.id === String(frames[at].frame));
			if (picture) {
				return picture.id;
			}
		}
		return "";
	}

	private show(index: number): void {
		const { frames } = this.report.sequence;
		const at = Math.min(Math.max(index, 0), frames.length - 1);
		this.scrubber.value = String(at);
		const frame = frames[at];
		const picture = this.findPicture(at);
		this.where.textContent = `Frame ${frame.frame}, ${(frame.frame / this.report.framesPerSecond).toFixed(2)} s` + (picture === String(frame.frame) ? "" : `, the picture is of ${picture}`);
		const before = this.report.pictures.findIndex((one) => one.id === picture) - 1;
		void this.picture.choose(picture, this.follows() ? this.report.pictures[Math.max(before, 0)].id : this.picture.selectedB);
		this.plots.move(at);
		this.walk?.move(String(frame.frame));
	}

	/** The strip or the list chose a picture. */
	private chosen(id: string): void {
		const index = this.report.sequence.frames.findIndex((frame) => String(frame.frame) === id);
		if (this.plots && index >= 0 && id !== this.findPicture(this.at())) {
			this.show(index);
		}
	}

	private play(): void {
		const plays = this.timer !== 0;
		clearInterval(this.timer);
		this.timer = plays ? 0 : window.setInterval(() => this.show((this.at() + 1) % this.report.sequence.frames.length), Math.max(1000 / this.report.framesPerSecond, 40));
		this.playing.setAttribute("aria-pressed", String(!plays));
		this.playing.textContent = plays ? "Play" : "Stop";
	}

	private makeCharts(): Plot[] {
		const { frames, varying } = this.report.sequence;
		const { figures } = this.report;
		const x = makeAxis(frames.map((frame) => frame.frame), 0);
		const line = (name: string, color: string, values: (number | null)[], steps = false) =>
			makeSeries(name, color, values.flatMap((value, i): [number, number][] => (value === null ? [] : [[frames[i].frame, value]])), steps);
		const many = (id: string, title: string, series: Series[], show = number, unit = ""): Plot => ({
			id, show, panel: { title, unit, x, y: makeAxis(series.flatMap(({ line }) => line.map(([, value]) => value)), 0.12, show), limit: null, series },
		});
		const one = (id: string, title: string, values: (number | null)[], show = number, unit = "", steps = false) => many(id, title, [line(title, "c1", values, steps)], show, unit);
		const charts = [
			one("exposure", "Exposure", frames.map((frame) => frame.exposure.scale)),
			one("mean", "Mean luminance", figures.map((figure) => figure.mean)),
			one("change", "Change from the frame before", figures.map((figure) => figure.change), number, "RMS"),
			one("white", "Pixels at white", figures.map((figure) => figure.white), percent),
		];
		if (figures.some((figure) => figure.ms !== null)) {
			charts.push(one("ms", "Passes' time", figures.map((figure) => figure.ms), ms));
		}
		if (frames.some((frame) => frame.passes.executed !== frames[0].passes.executed)) {
			charts.push(one("passes", "Passes that ran", frames.map((frame) => frame.passes.executed), number, "", true));
		}
		if (this.report.walk) {
			return charts; // which draws settings and volumes, finer than by frames
		}
		const volumes = [...new Set(frames.flatMap((frame) => Object.keys(frame.volumes)))];
		if (volumes.length) {
			charts.push(many("volumes", "Weights of the volumes", volumes.map((name, i) => line(name, "c" + (i % 10), frames.map((frame) => frame.volumes[name] ?? 0))), percent));
		}
		return [...charts, ...varying.filter((name) => frames.every((frame) => typeof frame.settings[name] === "number"))
			.map((name) => one(name, name, frames.map((frame) => frame.settings[name] as number)))];
	}
}
