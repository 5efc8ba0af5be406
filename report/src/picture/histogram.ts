// A histogram of a picture's values: how many texels lie where, by channel, on a logarithmic axis upwards.
import uPlot from "uplot";
import { number } from "../format";
import { Pixels, findRange } from "./pixels";
import { picker } from "./shade";

const bins = 96;
const colors = ["#d9503f", "#3d9a50", "#4a7bd8", "#8a8f98"];
const plots = new WeakMap<HTMLElement, uPlot>();

export function drawHistogram(into: HTMLElement, pixels: Pixels): void {
	const number_ = pixels.channels.length;
	let [low, high] = pixels.display ? [0, 1] : findRange(pixels, picker(pixels, "luminance"));
	low = Math.min(low, 0);
	const counts = pixels.channels.slice(0, 3).map(() => new Float64Array(bins));
	for (let i = 0; i < pixels.data.length; i += number_) {
		for (let channel = 0; channel < counts.length; ++channel) {
			const value = pixels.data[i + channel];
			if (Number.isFinite(value)) {
				++counts[channel][Math.min(Math.max(Math.floor(((value - low) / (high - low)) * bins), 0), bins - 1)];
			}
		}
	}
	const style = getComputedStyle(document.documentElement);
	const [ink, grid] = [style.getPropertyValue("--quiet"), style.getPropertyValue("--line")];
	const data = [
		Array.from({ length: bins }, (_, i) => low + ((i + 0.5) / bins) * (high - low)),
		...counts.map((list) => Array.from(list, (value) => Math.log10(value + 1))),
	] as uPlot.AlignedData;
	plots.get(into)?.destroy();
	const axis = { stroke: ink, grid: { stroke: grid, width: 1 }, ticks: { show: false }, font: "11px system-ui, sans-serif" };
	plots.set(into, new uPlot({
		width: into.clientWidth || 260,
		height: 150,
		padding: [10, 8, 0, 0],
		legend: { show: false },
		cursor: { show: false },
		scales: { x: { time: false, range: [low, high] }, y: { range: (_, __, max) => [0, Math.max(max, 1) * 1.1] } },
		axes: [
			{ ...axis, size: 24, values: (_, ticks) => ticks.map((tick) => number(tick)) },
			{ ...axis, size: 38, splits: [0, 2, 4, 6], values: (_, ticks) => ticks.map((tick) => ["1", "", "100", "", "10 k", "", "1 M"][tick] ?? "") },
		],
		series: [{}, ...counts.map((_, channel) => {
			const color = counts.length === 1 ? colors[3] : colors[channel];
			return { stroke: color, fill: color + "30", width: 1, points: { show: false }, paths: uPlot.paths.stepped!({ align: 1 }) };
		})],
	}, data, into));
}
