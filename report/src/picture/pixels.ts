// Pictures of a report as numbers: from the values it carries, else from its PNG as far as eight bits tell.
import { unzlibSync } from "fflate";
import { PictureData, fromBase64, pictureUrl } from "../data";

export interface Pixels {
	width: number;
	height: number;
	channels: string[];
	/** Channels interleaved. */
	data: Float32Array;
	/** Whether values are encoded for a display, as a final picture's are. */
	display: boolean;
	/** "half", "float": as stored; "8 bit": decoded from the PNG. */
	precision: string;
	/** The size of the picture that this is a smaller copy of. */
	whole?: { width: number; height: number };
	/** RGBA, 8 bit: a final picture as a display shows it, which is shown as it is. */
	bytes?: Uint8ClampedArray;
}

/** A final picture of bytes alone; its numbers are made when somebody asks for them. */
export function fromBytes(width: number, height: number, bytes: Uint8ClampedArray): Pixels {
	let data: Float32Array | null = null;
	const decode = () => {
		data = new Float32Array(bytes.length);
		for (let i = 0; i < bytes.length; ++i) {
			data[i] = bytes[i] / 255;
		}
		return data;
	};
	return { width, height, channels: ["R", "G", "B", "A"], bytes, get data() { return data ?? decode(); }, display: true, precision: "8 bit" };
}

/** Width and height in texels, also where the pixels are fewer. */
export const getSize = (pixels: Pixels): { width: number; height: number } => pixels.whole ?? pixels;

/** The values of one pixel. */
export function readPixel(pixels: Pixels, pixel: number): number[] {
	const number = pixels.channels.length;
	return pixels.bytes && pixels.precision === "8 bit" ? Array.from(pixels.bytes.subarray(pixel * 4, pixel * 4 + 4), (byte) => byte / 255)
		: Array.from(pixels.data.subarray(pixel * number, (pixel + 1) * number));
}

export function srgbToLinear(code: number): number {
	return code <= 0.04045 ? code / 12.92 : Math.pow((code + 0.055) / 1.055, 2.4);
}

export function linearToSrgb(value: number): number {
	return value <= 0.0031308 ? value * 12.92 : 1.055 * Math.pow(value, 1 / 2.4) - 0.055;
}

/** The number of a half float's 16 bits. */
export function halfToNumber(bits: number): number {
	const sign = bits & 0x8000 ? -1 : 1;
	const exponent = (bits >> 10) & 31;
	const fraction = bits & 1023;
	if (exponent === 31) {
		return fraction ? NaN : sign * Infinity;
	}
	return sign * (exponent ? 2 ** (exponent - 25) * (1024 + fraction) : 2 ** -24 * fraction);
}

function fromValues(picture: PictureData): Pixels {
	const packed = unzlibSync(fromBase64(picture.values!.zlib));
	const [width, height] = picture.size;
	const [size, number] = [width * height, picture.channels.length];
	const data = new Float32Array(size * number);
	const half = picture.values!.type === "half";
	const word = new DataView(new ArrayBuffer(4));
	for (let channel = 0; channel < number; ++channel) {
		for (let i = 0; i < size; ++i) {
			const byte = (plane: number) => packed[(channel * (half ? 2 : 4) + plane) * size + i];
			if (half) {
				data[i * number + channel] = halfToNumber((byte(0) << 8) | byte(1));
			} else {
				[0, 1, 2, 3].forEach((plane) => word.setUint8(plane, byte(plane)));
				data[i * number + channel] = word.getFloat32(0);
			}
		}
	}
	return { width, height, channels: picture.channels, data, display: picture.encoding === "display", precision: picture.values!.type };
}

async function fromPng(picture: PictureData): Promise<Pixels> {
	const image = new Image();
	image.src = pictureUrl(picture);
	await image.decode();
	const [width, height] = [image.naturalWidth, image.naturalHeight];
	const canvas = document.createElement("canvas");
	[canvas.width, canvas.height] = [width, height];
	const context = canvas.getContext("2d", { willReadFrequently: true })!;
	context.drawImage(image, 0, 0);
	const codes = context.getImageData(0, 0, width, height).data;
	const decode = Float32Array.from({ length: 256 }, (_, code) => {
		const linear = srgbToLinear(code / 255);
		return picture.encoding === "display" ? code / 255
			: picture.encoding === "srgb" ? linear
			: code === 255 ? Infinity : linear / (1 - linear);
	});
	const channels = picture.channels.slice(0, 3); // a PNG has no more
	const number = channels.length;
	const data = new Float32Array(width * height * number);
	for (let pixel = 0; pixel < width * height; ++pixel) {
		for (let channel = 0; channel < number; ++channel) {
			data[pixel * number + channel] = decode[codes[pixel * 4 + channel]];
		}
	}
	return { width, height, channels, data, display: picture.encoding === "display", precision: "8 bit" };
}

const loaded = new WeakMap<PictureData, Promise<Pixels>>();

export function loadPixels(picture: PictureData): Promise<Pixels> {
	if (picture.load) {
		return picture.load();
	}
	let pixels = loaded.get(picture);
	if (!pixels) {
		pixels = picture.values ? Promise.resolve(fromValues(picture)) : fromPng(picture);
		loaded.set(picture, pixels);
	}
	return pixels;
}

export interface Counts {
	nan: number;
	infinite: number;
	negative: number;
}

/** Counts odd values: as the report measured them, else from the numbers here. */
export function countOdd(picture: PictureData, pixels: Pixels): Counts {
	if (picture.figures) {
		return picture.figures;
	}
	const counts = { nan: 0, infinite: 0, negative: 0 };
	for (const value of pixels.data) {
		counts.nan += Number(Number.isNaN(value));
		counts.negative += Number(value < 0);
	}
	return counts;
}

/** The part of the display's range that holds all but a hundredth at each end. */
export function findRange(pixels: Pixels, pick: (pixel: number) => number): [number, number] {
	const step = Math.max(1, Math.floor((pixels.width * pixels.height) / 50000));
	const values: number[] = [];
	for (let pixel = 0; pixel < pixels.width * pixels.height; pixel += step) {
		const value = pick(pixel);
		if (Number.isFinite(value)) {
			values.push(value);
		}
	}
	values.sort((a, b) => a - b);
	if (!values.length) {
		return [0, 1];
	}
	const [low, high] = [values[Math.floor(values.length * 0.01)], values[Math.floor(values.length * 0.99)]];
	return high > low ? [low, high] : [low, low + 1];
}
