// Draws panels of charts, as pipeline/Picture/ChartSvg.cpp draws them into files, and rows of them that share a cursor.
import { el } from "./dom";
import { number } from "./format";

export interface Axis {
	name: string;
	log: boolean;
	low: number;
	high: number;
	ticks: { value: number; text: string }[];
	valueNames: string[]; // of whole numbers
}

export interface Point {
	x: number;
	y: number;
	low?: number; // with high: whiskers
	high?: number;
	label?: string;
	pale?: boolean;
	now?: boolean;
	pick?: boolean;
}

export type Curve = [number, number][];

export interface Series {
	name: string;
	color: string; // a class
	line: Curve;
	steps: boolean; // nothing lies between two values
	points: Point[];
}

export interface Panel {
	title: string;
	unit: string;
	x: Axis;
	y: Axis;
	limit: number | null;
	series: Series[];
}

export interface Chart {
	markName: string;
	marks: { value: number; text: string }[];
	shades: { name: string; color: string; weights: Curve }[];
	panels: Panel[];
}

export interface DrawOptions {
	width: number;
	height: number;
	shades?: Chart["shades"];
	marks?: number[];
	act?: (name: string) => Record<string, string | number | undefined | ((event: any) => void)>; // attributes of a point by its series' name
}

const edges = { left: 62, right: 14, top: 12 };

function place(axis: Axis, value: number, from: number, to: number): number {
	const inside = Math.min(Math.max(value, axis.low), axis.high);
	return from + (axis.log ? Math.log(inside / axis.low) / Math.log(axis.high / axis.low) : (value - axis.low) / (axis.high - axis.low)) * (to - from);
}

/** A linear axis that covers the values. Room: at each end, of their span. */
export function makeAxis(values: number[], room: number, show = number): Axis {
	const [least, most] = [Math.min(...values), Math.max(...values)];
	const margin = (most - least || Math.abs(most) || 1) * room;
	const [low, high] = [least - margin, most + margin || 1];
	const rough = (high - low) / 5 || 1;
	const unit = 10 ** Math.floor(Math.log10(rough));
	const step = unit * [1, 2, 5, 10].find((factor) => factor * unit >= rough)!;
	const ticks = [];
	for (let at = Math.ceil(low / step); at * step <= high; ++at) {
		ticks.push({ value: at * step, text: show(Number((at * step).toPrecision(12))) });
	}
	return { name: "", log: false, low, high, ticks, valueNames: [] };
}

export function makeSeries(name: string, color: string, line: Curve, steps = false): Series {
	return { name, color, line, steps, points: [] };
}

export function drawPanel(panel: Panel, options: DrawOptions): SVGSVGElement {
	const { width, height } = options;
	const box = { ...edges, right: width - edges.right, bottom: height - (panel.x.name ? 48 : 22) };
	const x = (value: number) => place(panel.x, value, box.left, box.right);
	const y = (value: number) => place(panel.y, value, box.bottom, box.top);
	const line = (css: string, x1: number, y1: number, x2: number, y2: number) => el("line", { class: css, x1, y1, x2, y2 });
	const text = (css: string, at: number, height: number, words: string, anchor = "start") => el("text", { class: css, x: at, y: height, "text-anchor": anchor }, words);
	const svg = el<SVGSVGElement>("svg", { class: "chart", viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": panel.title });

	for (const { color, weights } of options.shades ?? []) {
		weights.slice(1).forEach(([to, weight], i) => svg.append(el("rect", {
			class: "shade " + color, x: x(weights[i][0]), width: x(to) - x(weights[i][0]), y: box.top, height: box.bottom - box.top, "fill-opacity": 0.11 * (weights[i][1] + weight),
		})));
	}
	let free = 0;
	for (const { value, text: words } of panel.x.ticks) {
		const half = words.length * 3.5;
		svg.append(line("grid", x(value), box.top, x(value), box.bottom));
		if (x(value) - half > free) {
			free = x(value) + half + 6;
			svg.append(text("tick", x(value), box.bottom + 16, words, "middle"));
		}
	}
	for (const { value, text: words } of panel.y.ticks) {
		svg.append(line("grid", box.left, y(value), box.right, y(value)), text("tick", box.left - 8, y(value) + 4, words, "end"));
	}
	svg.append(text("tick", (box.left + box.right) / 2, box.bottom + 36, panel.x.name, "middle"),
		el("text", { class: "tick", transform: `translate(12 ${(box.top + box.bottom) / 2}) rotate(-90)`, "text-anchor": "middle" }, panel.y.name));
	for (const mark of options.marks ?? []) {
		svg.append(line("mark", x(mark), box.top, x(mark), box.bottom));
	}
	if (panel.limit !== null) {
		svg.append(line("limit", box.left, y(panel.limit), box.right, y(panel.limit)), text("limit-name", box.right - 4, y(panel.limit) - 6, `budget ${number(panel.limit)}`, "end"));
	}
	for (const series of panel.series) {
		const to = series.steps ? (at: number, height: number) => `H${at}V${height}` : (at: number, height: number) => `L${at} ${height}`;
		svg.append(el("path", { class: "line " + series.color, d: series.line.map(([at, value], i) => (i ? to(x(at), y(value)) : `M${x(at)} ${y(value)}`)).join("") }));
		const few = series.line.length <= 60 && series.color !== "front" ? series.line : [];
		svg.append(...few.map(([at, value]) => el("circle", { class: "place " + series.color, cx: x(at), cy: y(value), r: 2.5 })));
	}

	const importance = (point: Point) => (point.pick ? 4 : 0) + (point.now ? 2 : 0) - (point.pale ? 1 : 0);
	const all = panel.series.flatMap((series) => series.points.filter(() => options.act).map((point) => ({ series, point })));
	const taken = all.map(({ point }) => ({ x: x(point.x) - 8, y: y(point.y) + 4, width: 16 })); // by dots, then by names
	for (const { series, point } of all.sort((a, b) => importance(b.point) - importance(a.point))) {
		const at = { cx: x(point.x), cy: y(point.y) };
		const name = (point.label ?? "") + (point.pick ? " · recommended" : "") + (point.now ? " · in use" : "");
		const width = name.length * 6.4;
		const spots = [-8, 17, -26, 35].flatMap((below) => [at.cx + 13, at.cx - 13 - width].map((left) => ({ x: left, y: at.cy + below, width })));
		const spot = spots.find((spot) => spot.x > box.left && spot.y > box.top && spot.x + width < box.right + 10 &&
			!taken.some((other) => Math.abs(other.y - spot.y) < 14 && spot.x < other.x + other.width && other.x < spot.x + width));
		if (spot) {
			taken.push(spot);
		}
		svg.append(el("g", { class: ["point", series.color, point.pale ? "pale" : ""].join(" "), ...options.act!(series.name) },
			point.low !== undefined ? line("spread", x(point.low), at.cy, x(point.high!), at.cy) : null,
			point.pick ? el("circle", { class: "ring", ...at, r: 12 }) : null,
			el("circle", { class: "dot", ...at, r: 6 }),
			spot ? text("", spot.x, spot.y, name) : null));
	}
	return svg;
}

export interface Plot {
	id: string;
	panel: Panel;
	show?: (value: number) => string;
}

export interface PlotsOptions {
	id: string;
	name: (index: number) => string; // of a place on the axis to the right
	marks?: number[];
	shades?: Chart["shades"];
	choose?: (index: number) => void;
}

/** Panels of lines over the same places, with a cursor. */
export class Plots {
	readonly element: HTMLElement;
	private readonly cells: { plot: Plot; values: HTMLElement; box: HTMLElement; cursor: Element }[] = [];
	private at = 0;
	private width = 0;

	constructor(private readonly places: number[], plots: Plot[], private readonly options: PlotsOptions) {
		this.element = el("div", { class: "plots", id: options.id }, plots.map((plot) => this.make(plot)));
		new ResizeObserver(() => this.draw()).observe(this.element);
		this.move(0);
	}

	/** Sets the cursor. */
	move(index: number): void {
		this.at = Math.min(Math.max(index, 0), this.places.length - 1);
		this.show(this.at);
		this.drawCursor();
	}

	private choose(index: number): void {
		this.move(index);
		this.options.choose?.(this.at);
	}

	private show(index: number): void {
		for (const { plot, values, box } of this.cells) {
			const { series } = plot.panel;
			const texts = series.map(({ line }) => {
				const value = line.find(([place]) => place === this.places[index])?.[1];
				return value === undefined ? "none" : (plot.show ?? number)(value);
			});
			values.replaceChildren(...series.map(({ name, color }, i) => el("span", {},
				series.length > 1 ? el("i", { class: color }) : null, series.length > 1 ? name + " " : "", el("strong", {}, texts[i]))));
			box.setAttribute("aria-valuenow", String(index));
			box.setAttribute("aria-valuetext", `${this.options.name(index)}: ${series.map(({ name }, i) => `${name} ${texts[i]}`).join(", ")}`);
		}
	}

	private make(plot: Plot): HTMLElement {
		const { title, unit, x } = plot.panel;
		const values = el("output", {});
		const indexAt = (event: PointerEvent) => {
			const from = box.getBoundingClientRect().left + edges.left;
			const value = x.low + ((event.clientX - from) / (this.width - edges.left - edges.right)) * (x.high - x.low);
			return this.places.reduce((best, place, i) => (Math.abs(place - value) < Math.abs(this.places[best] - value) ? i : best), 0);
		};
		const box: HTMLElement = el("div", {
			class: "plot-box", tabindex: 0, role: "slider", "data-chart": plot.id, "aria-label": title, "aria-valuemin": 0, "aria-valuemax": this.places.length - 1,
			onkeydown: (event: KeyboardEvent) => {
				const steps: Record<string, number> = { ArrowLeft: this.at - 1, ArrowRight: this.at + 1, Home: 0, End: this.places.length - 1 };
				if (event.key in steps) {
					event.preventDefault();
					event.stopPropagation();
					this.choose(steps[event.key]);
				}
			},
			onpointerdown: (event: PointerEvent) => this.choose(indexAt(event)),
			onpointermove: (event: PointerEvent) => (event.buttons ? this.choose(indexAt(event)) : this.show(indexAt(event))),
			onpointerleave: () => this.show(this.at),
		});
		this.cells.push({ plot, values, box, cursor: el("path", { class: "cursor" }) });
		return el("div", { class: "plot-cell" }, el("h3", {}, title, unit ? el("span", { class: "quiet" }, " " + unit) : null, values), box);
	}

	private draw(): void {
		const width = this.cells[0]?.box.clientWidth ?? 0;
		if (width !== this.width && width) {
			this.width = width;
			for (const { plot, box, cursor } of this.cells) {
				box.replaceChildren(drawPanel(plot.panel, { width, height: 138, ...this.options }));
				box.firstElementChild!.append(cursor);
			}
			this.drawCursor();
		}
	}

	private drawCursor(): void {
		for (const { plot, cursor } of this.cells) {
			cursor.setAttribute("d", `M${place(plot.panel.x, this.places[this.at], edges.left, Math.max(this.width - edges.right, edges.left))} ${edges.top}V116`);
		}
	}
}
