// A histogram of a picture's values: how many texels lie where, by channel, on a logarithmic axis upwards.
import { Axis, drawPanel, makeAxis, makeSeries } from "../chart";
import { Pixels, findRange } from "./pixels";
import { picker } from "./shade";

const bins = 96;
const colors = ["red", "green", "blue"];

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
	const x = makeAxis([low, high], 0);
	const y: Axis = { ...makeAxis([0, 1.1 * Math.max(1, ...counts.flatMap((list) => Math.log10(Math.max(...list) + 1)))], 0), ticks: ["1", "100", "10 k", "1 M"].map((text, i) => ({ value: 2 * i, text })) };
	const series = counts.map((list, channel) => makeSeries("", counts.length === 1 ? "grey" : colors[channel],
		Array.from(list, (value, i) => [low + ((i + 0.5) / bins) * (high - low), Math.log10(value + 1)]), true));
	into.replaceChildren(drawPanel({ title: "Histogram", unit: "", x, y, limit: null, series }, { width: into.clientWidth || 260, height: 150 }));
}
