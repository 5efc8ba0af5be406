// Line charts over one another that share an axis to the right and a cursor, drawn by uPlot.
import uPlot from "uplot";
import { el } from "./dom";
import { number } from "./format";

export interface Line {
	label: string;
	values: (number | null)[];
	color?: string;
}

export interface Chart {
	id: string;
	title: string;
	unit?: string;
	lines: Line[];
	steps?: boolean; // nothing lies between two values
	show?: (value: number) => string;
}

export interface PlotsOptions {
	id: string;
	unit: string; // of the axis to the right, behind its last number
	name: (index: number) => string; // of a place on it
	marks?: number[]; // places that stand out
	shades?: { color: string; weights: number[] }[]; // behind all charts, 0..1 at each place
	choose?: (index: number) => void;
}

/** Told apart by colour-blind readers, too, and seen on light and dark. */
export const plotColors = ["#3f7fe8", "#de7a12", "#2fa06c", "#b061c0", "#b3922b", "#2a9fb5"];

const height = 138;

export class Plots {
	readonly element: HTMLElement;
	private readonly plots: { chart: Chart; plot: uPlot; values: HTMLElement; box: HTMLElement }[] = [];
	private at = 0;

	constructor(private readonly x: number[], charts: Chart[], private readonly options: PlotsOptions) {
		this.element = el("div", { class: "plots", id: options.id }, charts.map((chart) => this.make(chart)));
		new ResizeObserver(() => this.fit()).observe(this.element);
		this.move(0);
	}

	/** Sets the cursor. */
	move(index: number): void {
		this.at = Math.min(Math.max(index, 0), this.x.length - 1);
		this.show(this.at);
		this.plots.forEach(({ plot }) => plot.redraw(false));
	}

	/** After light became dark. */
	redraw(): void {
		this.plots.forEach(({ plot }) => plot.redraw());
	}

	private choose(index: number): void {
		this.move(index);
		this.options.choose?.(this.at);
	}

	private show(index: number): void {
		for (const { chart, values, box } of this.plots) {
			const text = (line: Line) => (line.values[index] === null ? "none" : (chart.show ?? number)(line.values[index]!));
			values.replaceChildren(...chart.lines.map((line, i) => el("span", {},
				chart.lines.length > 1 ? el("i", { style: `background:${line.color ?? plotColors[i % plotColors.length]}` }) : null,
				chart.lines.length > 1 ? line.label + " " : "", el("strong", {}, text(line)))));
			box.setAttribute("aria-valuenow", String(index));
			box.setAttribute("aria-valuetext", `${this.options.name(index)}: ${chart.lines.map((line) => `${line.label} ${text(line)}`).join(", ")}`);
		}
	}

	private fit(): void {
		for (const { plot, box } of this.plots) {
			if (box.clientWidth && plot.width !== box.clientWidth) {
				plot.setSize({ width: box.clientWidth, height });
			}
		}
	}

	private make(chart: Chart): HTMLElement {
		const values = el("output", {});
		const box = el("div", {
			class: "plot-box", tabindex: 0, role: "slider", "data-chart": chart.id, "aria-label": chart.title, "aria-valuemin": 0, "aria-valuemax": this.x.length - 1,
			onkeydown: (event: KeyboardEvent) => {
				const steps: Record<string, number> = { ArrowLeft: this.at - 1, ArrowRight: this.at + 1, Home: 0, End: this.x.length - 1 };
				if (event.key in steps) {
					event.preventDefault();
					event.stopPropagation();
					this.choose(steps[event.key]);
				}
			},
		});
		const plot = new uPlot(this.describe(chart), [this.x, ...chart.lines.map((line) => line.values)] as uPlot.AlignedData, box);
		const indexAt = (event: PointerEvent) => plot.posToIdx(event.clientX - plot.over.getBoundingClientRect().left);
		plot.over.addEventListener("pointerdown", (event) => this.choose(indexAt(event)));
		plot.over.addEventListener("pointermove", (event) => (event.buttons ? this.choose(indexAt(event)) : this.show(indexAt(event))));
		plot.over.addEventListener("pointerleave", () => this.show(this.at));
		this.plots.push({ chart, plot, values, box });
		return el("div", { class: "plot-cell" }, el("h3", {}, chart.title, chart.unit ? el("span", { class: "quiet" }, " " + chart.unit) : null, values), box);
	}

	private describe(chart: Chart): uPlot.Options {
		const color = (name: string) => getComputedStyle(document.documentElement).getPropertyValue(name);
		const axis = { stroke: () => color("--quiet"), grid: { stroke: () => color("--line"), width: 1 }, ticks: { show: false }, font: "11px system-ui, sans-serif" };
		const show = chart.show ?? ((value: number) => number(Number(value.toPrecision(4))));
		return {
			width: 480, height, padding: [8, 10, 0, 0], legend: { show: false }, cursor: { show: false },
			scales: { x: { time: false }, y: { range: (_, low, high) => {
				const margin = (high - low || Math.abs(high) || 1) * 0.12;
				return [low - margin, high + margin];
			} } },
			axes: [
				{ ...axis, size: 24, values: (_, ticks) => ticks.map((tick, i) => number(tick) + (i + 1 === ticks.length ? this.options.unit : "")) },
				{ ...axis, size: 62, space: 28, values: (_, ticks) => ticks.map((tick) => show(tick)) },
			],
			series: [{}, ...chart.lines.map((line, i): uPlot.Series => ({
				label: line.label, stroke: line.color ?? plotColors[i % plotColors.length], width: 2, spanGaps: false,
				points: { show: this.x.length <= 60, size: 5 },
				...(chart.steps ? { paths: uPlot.paths.stepped!({ align: 1 }) } : {}),
			}))],
			hooks: { drawClear: [(plot) => this.drawBehind(plot)], draw: [(plot) => this.drawCursor(plot)] },
		};
	}

	/** How strongly volumes act, as their colours, and the marks. */
	private drawBehind(plot: uPlot): void {
		const { ctx, bbox } = plot;
		ctx.save();
		const place = (index: number) => plot.valToPos(this.x[index], "x", true);
		for (const { color, weights } of this.options.shades ?? []) {
			ctx.fillStyle = color;
			for (let index = 0; index + 1 < this.x.length; ++index) {
				ctx.globalAlpha = 0.11 * (weights[index] + weights[index + 1]);
				ctx.fillRect(place(index), bbox.top, place(index + 1) - place(index), bbox.height);
			}
		}
		ctx.globalAlpha = 0.55;
		ctx.strokeStyle = getComputedStyle(document.documentElement).getPropertyValue("--quiet");
		ctx.setLineDash([2, 4]);
		for (const mark of this.options.marks ?? []) {
			const at = Math.round(plot.valToPos(mark, "x", true)) + 0.5;
			ctx.beginPath();
			ctx.moveTo(at, bbox.top);
			ctx.lineTo(at, bbox.top + bbox.height);
			ctx.stroke();
		}
		ctx.restore();
	}

	private drawCursor(plot: uPlot): void {
		const { ctx, bbox } = plot;
		const at = Math.round(plot.valToPos(this.x[this.at], "x", true)) + 0.5;
		ctx.save();
		ctx.strokeStyle = getComputedStyle(document.documentElement).getPropertyValue("--ink");
		ctx.lineWidth = devicePixelRatio;
		ctx.beginPath();
		ctx.moveTo(at, bbox.top);
		ctx.lineTo(at, bbox.top + bbox.height);
		ctx.stroke();
		ctx.restore();
	}
}
