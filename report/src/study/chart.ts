// The chart of a study: a point for each variant, what it costs to the right, its error upwards.
import { el } from "../dom";
import { number } from "../format";
import { Metric, Point, isQuality, metricNames } from "./data";

const size = { width: 860, height: 470 };
const box = { left: 76, right: 26, top: 22, bottom: 52 };

export interface ChartOptions {
	metric: Metric;
	taps: boolean; // the cost, in place of time
	limit: number | undefined; // of the metric: what the budget allows
	pinned: string[]; // labels
	show: (point: Point) => void;
	pin: (point: Point) => void;
	small?: boolean; // one of many: points have no names and take no focus
}

function ticks(low: number, high: number, log: boolean): number[] {
	const list: number[] = [];
	if (log) {
		const steps = Math.log10(high / low) > 2.5 ? [1] : Math.log10(high / low) > 1.2 ? [1, 3] : [1, 2, 5];
		for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power) {
			list.push(...steps.map((step) => step * 10 ** power));
		}
	} else {
		const rough = (high - low) / 5;
		const unit = 10 ** Math.floor(Math.log10(rough));
		const step = unit * (rough / unit > 5 ? 10 : rough / unit > 2 ? 5 : rough / unit > 1 ? 2 : 1);
		for (let at = Math.ceil(low / step) * step; at <= high; at += step) {
			list.push(Number(at.toPrecision(12)));
		}
	}
	return list.filter((at) => at >= low && at <= high);
}

function makeAxis(values: number[], log: boolean, from: number, to: number) {
	let [low, high] = [Math.min(...values), Math.max(...values)];
	if (log) {
		[low, high] = [low / 1.35, high * 1.35];
	} else {
		const margin = (high - low || Math.abs(high) || 1) * 0.08;
		[low, high] = [low - margin, high + margin];
	}
	const share = (value: number) => (log ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low));
	return { ticks: ticks(low, high, log), place: (value: number) => from + share(Math.min(Math.max(value, low), high)) * (to - from) };
}

export function cost(point: Point, taps: boolean): number {
	return taps ? point.result.taps : point.timing.medianMs;
}

export function drawChart(points: Point[], options: ChartOptions): SVGSVGElement {
	const { metric, taps } = options;
	const error = (point: Point) => point.result[metric];
	const shown = points.filter((point) => error(point) !== null && Number.isFinite(cost(point, taps)) && cost(point, taps) > 0);
	const log = !isQuality(metric) && shown.some((point) => error(point)! > 0);
	const least = Math.min(...shown.map((point) => error(point)!).filter((value) => value > 0));
	const height = (point: Point) => (log ? Math.max(error(point)!, least / 2) : error(point)!); // 0 has no logarithm
	const limits = options.limit !== undefined && (!log || options.limit > 0) ? [options.limit] : [];
	const x = makeAxis(shown.flatMap((point) => (taps ? [point.result.taps] : [point.timing.lowMs, point.timing.highMs, point.timing.medianMs])), true, box.left, size.width - box.right);
	const y = makeAxis([...shown.map(height), ...limits], log, size.height - box.bottom, box.top);
	const svg = el<SVGSVGElement>("svg", { class: "chart", viewBox: `0 0 ${size.width} ${size.height}`, role: "group", "aria-label": `Variants by cost and ${metricNames[metric]}` });

	for (const tick of x.ticks) {
		svg.append(el("line", { class: "grid", x1: x.place(tick), x2: x.place(tick), y1: box.top, y2: size.height - box.bottom }),
			el("text", { class: "tick", x: x.place(tick), y: size.height - box.bottom + 18, "text-anchor": "middle" }, number(tick)));
	}
	for (const tick of y.ticks) {
		svg.append(el("line", { class: "grid", x1: box.left, x2: size.width - box.right, y1: y.place(tick), y2: y.place(tick) }),
			el("text", { class: "tick", x: box.left - 9, y: y.place(tick) + 4, "text-anchor": "end" }, number(tick)));
	}
	svg.append(el("text", { class: "axis", x: size.width - box.right, y: size.height - 10, "text-anchor": "end" }, taps ? "texture reads a pixel →" : "CPU milliseconds →"),
		el("text", { class: "axis", transform: `translate(18 ${box.top}) rotate(-90)`, "text-anchor": "end" }, `${metricNames[metric]} →`));
	for (const limit of limits) {
		svg.append(el("line", { class: "limit", x1: box.left, x2: size.width - box.right, y1: y.place(limit), y2: y.place(limit) }),
			el("text", { class: "limit-name", x: size.width - box.right - 4, y: y.place(limit) - 6, "text-anchor": "end" }, `budget ${number(limit)}`));
	}

	const isFront = (point: Point) => (taps ? point.result.front : point.timing.front);
	const front = shown.filter(isFront).sort((a, b) => cost(a, taps) - cost(b, taps));
	svg.append(el("polyline", { class: "front", points: front.map((point) => `${x.place(cost(point, taps))},${y.place(height(point))}`).join(" ") }));

	const taken: { x: number; y: number; width: number }[] = [];
	for (const point of [...shown].sort((a, b) => Number(b.recommended) - Number(a.recommended) || Number(isFront(b)) - Number(isFront(a)))) {
		const at = { x: x.place(cost(point, taps)), y: y.place(height(point)) };
		const name = point.result.label + (point.recommended ? " · recommended" : "") + (point.result.current ? " · in use" : "");
		const width = name.length * 6.4;
		const spots = [{ x: at.x + 13, y: at.y - 8 }, { x: at.x + 13, y: at.y + 17 }, { x: at.x - 13 - width, y: at.y - 8 }, { x: at.x - 13 - width, y: at.y + 17 }];
		const spot = spots.find((spot) => spot.x > box.left && spot.x + width < size.width - 4 &&
			!taken.some((other) => Math.abs(other.y - spot.y) < 14 && spot.x < other.x + other.width && other.x < spot.x + width));
		if (spot) {
			taken.push({ ...spot, width });
		}
		const kind = ["point", isFront(point) ? "on-front" : "off-front", options.pinned.includes(point.result.label) ? "pinned" : ""].join(" ");
		svg.append(el("g", {
			class: kind, tabindex: options.small ? undefined : 0, role: options.small ? "img" : "button", "data-variant": point.result.label,
			"aria-label": `${name}: ${metricNames[metric]} ${number(error(point)!)}, ${number(Number(cost(point, taps).toPrecision(3)))} ${taps ? "reads a pixel" : "ms"}`,
			onpointerenter: () => options.show(point), onfocus: () => options.show(point), onclick: () => options.pin(point),
			onkeydown: (event: KeyboardEvent) => {
				if (event.key === "Enter" || event.key === " ") {
					event.preventDefault();
					options.pin(point);
				}
			},
		},
			taps ? null : el("line", { class: "spread", x1: x.place(point.timing.lowMs), x2: x.place(point.timing.highMs), y1: at.y, y2: at.y }),
			point.recommended ? el("circle", { class: "ring", cx: at.x, cy: at.y, r: 12 }) : null,
			el("circle", { class: "dot", cx: at.x, cy: at.y, r: 6 }),
			spot && !options.small ? el("text", { x: spot.x, y: spot.y }, name) : null));
	}
	return svg;
}
