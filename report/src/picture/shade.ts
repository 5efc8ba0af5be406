// Turns a picture's values into what the viewer shows: exposure, range, gamma, one channel, false colour, odd values.
import { Pixels, linearToSrgb, srgbToLinear } from "./pixels";

export type Channel = "rgb" | "luminance" | "0" | "1" | "2" | "3";

export interface Look {
	exposure: number; // stops
	gamma: number; // 0: sRGB
	channel: Channel;
	falseColor: boolean;
	low: number; // of the range, after exposure, linear
	high: number;
	odd: boolean; // NaN, infinities and negative values stand out
}

export const plainLook: Look = { exposure: 0, gamma: 0, channel: "rgb", falseColor: false, low: 0, high: 1, odd: false };

/** Dark to light in equal steps to the eye, through hues that differ. */
const stops = [[13, 8, 51], [66, 28, 122], [129, 37, 129], [193, 58, 105], [238, 105, 68], [249, 171, 58], [245, 241, 160]];

export function falseColor(share: number): [number, number, number] {
	const at = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
	const low = Math.min(Math.floor(at), stops.length - 2);
	return [0, 1, 2].map((i) => stops[low][i] + (stops[low + 1][i] - stops[low][i]) * (at - low)) as [number, number, number];
}

export const oddColors = { nan: [255, 0, 220], infinite: [255, 230, 0], negative: [0, 150, 255] };

/** Reads one number of a pixel, linear: a channel, or the luminance of all. */
export function picker(pixels: Pixels, channel: Channel): (pixel: number) => number {
	const { data, channels } = pixels;
	const number = channels.length;
	const linear = pixels.display ? srgbToLinear : (value: number) => value;
	if (channel === "luminance" || channel === "rgb") {
		return number < 3
			? (pixel) => linear(data[pixel * number])
			: (pixel) => 0.2126 * linear(data[pixel * number]) + 0.7152 * linear(data[pixel * number + 1]) +
				0.0722 * linear(data[pixel * number + 2]);
	}
	const index = Math.min(Number(channel), number - 1);
	return (pixel) => linear(data[pixel * number + index]);
}

export function isPlain(look: Look): boolean {
	return look.exposure === 0 && look.low === 0 && look.high === 1 && look.gamma === 0;
}

/** Linear to a byte, for many values: a table over 0..1. */
function makeEncoder(gamma: number): (value: number) => number {
	const size = 4095;
	const table = Uint8Array.from({ length: size + 1 }, (_, i) =>
		Math.round(255 * (gamma ? Math.pow(i / size, 1 / gamma) : linearToSrgb(i / size))));
	return (value) => table[value > 0 ? Math.min(Math.round(value * size), size) : 0];
}

function findOdd(pixels: Pixels, pixel: number): number[] | null {
	const number = pixels.channels.length;
	let negative = false;
	for (let i = pixel * number; i < (pixel + 1) * number; ++i) {
		const value = pixels.data[i];
		if (Number.isNaN(value)) {
			return oddColors.nan;
		}
		if (Math.abs(value) === Infinity && pixels.precision !== "8 bit") {
			return oddColors.infinite;
		}
		negative ||= value < 0;
	}
	return negative ? oddColors.negative : null;
}

export function shade(pixels: Pixels, look: Look): ImageData {
	if (pixels.bytes && isPlain(look) && look.channel === "rgb" && !look.falseColor && !look.odd) {
		return new ImageData(pixels.bytes, pixels.width, pixels.height);
	}
	const image = new ImageData(pixels.width, pixels.height);
	const bytes = image.data;
	const { data, channels } = pixels;
	const number = channels.length;
	const colored = look.channel === "rgb" && number > 1 && !look.falseColor;
	const scale = 2 ** look.exposure / (look.high - look.low || 1);
	const offset = look.low / (look.high - look.low || 1);
	const encode = makeEncoder(look.gamma);
	const direct = pixels.display && isPlain(look);
	const linear = pixels.display ? srgbToLinear : (value: number) => value;
	const pick = picker(pixels, look.channel);
	for (let pixel = 0, out = 0; out < bytes.length; ++pixel, out += 4) {
		bytes[out + 3] = 255;
		const odd = look.odd ? findOdd(pixels, pixel) : null;
		if (odd) {
			[bytes[out], bytes[out + 1], bytes[out + 2]] = odd;
		} else if (look.falseColor) {
			const [r, g, b] = falseColor(pick(pixel) * scale - offset);
			[bytes[out], bytes[out + 1], bytes[out + 2]] = [r, g, b];
		} else if (colored) {
			for (let i = 0; i < 3; ++i) {
				const value = i < number ? data[pixel * number + i] : 0;
				bytes[out + i] = direct ? Math.round(value * 255) : encode(linear(value) * scale - offset);
			}
		} else {
			const byte = encode(pick(pixel) * scale - offset);
			bytes[out] = bytes[out + 1] = bytes[out + 2] = byte;
		}
	}
	return image;
}

/** The texel of B that lies where this one of A does. */
export function mapTexel(a: { width: number; height: number }, b: Pixels, x: number, y: number): number {
	const bx = Math.min(Math.floor(((x + 0.5) * b.width) / a.width), b.width - 1);
	const by = Math.min(Math.floor(((y + 0.5) * b.height) / a.height), b.height - 1);
	return by * b.width + bx;
}

export interface Difference {
	pixels: Pixels;
	changed: number; // pixels
	max: number;
	rms: number;
}

/** |A - B| of values as they are, of the channels that both have. */
export function subtract(a: Pixels, b: Pixels): Difference {
	const channels = a.channels.slice(0, Math.min(a.channels.length, b.channels.length));
	const data = new Float32Array(a.width * a.height * channels.length);
	const coarse = a.bytes && b.bytes && (a.precision === "8 bit" || b.precision === "8 bit"); // one is known no better
	const [first, second, unit] = coarse ? [a.bytes!, b.bytes!, 1 / 255] : [a.data, b.data, 1];
	const [firstStep, secondStep] = coarse ? [4, 4] : [a.channels.length, b.channels.length];
	const alike = a.width === b.width && a.height === b.height;
	let [changed, max, sum] = [0, 0, 0];
	for (let y = 0, pixel = 0; y < a.height; ++y) {
		for (let x = 0; x < a.width; ++x, ++pixel) {
			const other = alike ? pixel : mapTexel(a, b, x, y);
			let differs = false;
			for (let i = 0; i < channels.length; ++i) {
				const difference = unit * Math.abs(first[pixel * firstStep + i] - second[other * secondStep + i]);
				data[pixel * channels.length + i] = difference;
				differs ||= difference > 0;
				max = Math.max(max, difference);
				sum += difference * difference;
			}
			changed += Number(differs);
		}
	}
	return {
		pixels: { width: a.width, height: a.height, channels, data, display: false, precision: a.precision },
		changed, max, rms: Math.sqrt(sum / data.length),
	};
}
