// The canvas of the picture viewer: two pictures over or beside each other, moved and enlarged together, down to
// texels with their numbers drawn on them.
import { number } from "../format";
import { Pixels, getSize, readPixel } from "./pixels";
import { Difference, Look, mapTexel, plainLook, shade, subtract } from "./shade";

export type Mode = "a" | "b" | "slider" | "side" | "difference";

interface Layer {
	pixels: Pixels;
	canvas: HTMLCanvasElement;
}

/** A picture's place on the canvas, in CSS pixels. */
interface Box {
	x: number;
	y: number;
	width: number;
	height: number;
}

export interface Probe {
	x: number; // texel of A
	y: number;
	a: number[];
	b: number[] | null;
}

/** Setting the size of a canvas clears it and costs. */
function fitCanvas(canvas: HTMLCanvasElement, width: number, height: number): void {
	if (canvas.width !== width || canvas.height !== height) {
		[canvas.width, canvas.height] = [width, height];
	}
}

const largestTexel = 160; // CSS pixels
const numbersFrom = 46; // CSS pixels of a texel

export class Viewer {
	readonly canvas = document.createElement("canvas");
	look: Look = { ...plainLook };
	mode: Mode = "a";
	gain = 1;
	split = 0.5; // of the canvas
	onProbe: (probe: Probe | null) => void = () => undefined;
	onChange: () => void = () => undefined; // of the zoom or the split
	onPick: (x: number, y: number) => void = () => undefined; // a click or Enter on a texel of A

	private a: Layer | null = null;
	private b: Layer | null = null;
	private d: Layer | null = null;
	private subtracted: Difference | null = null; // A and B, where it was asked for
	private center = { x: 0.5, y: 0.5 }; // of the picture, in the middle of a pane
	private zoom = 1; // 1: the picture just fits
	private cursor: { x: number; y: number } | null = null; // texel of A
	private pending = 0;
	private quick = false;

	constructor() {
		this.canvas.id = "canvas";
		this.canvas.tabIndex = 0;
		this.canvas.setAttribute("role", "application");
		this.canvas.setAttribute("aria-label", "Picture. Arrows move it, plus and minus zoom, F fits, 1 shows texels as pixels, shift and arrows move the probe");
		this.listen();
		new ResizeObserver(() => this.draw()).observe(this.canvas);
	}

	setPictures(a: Pixels, b: Pixels | null): void {
		const layer = (old: Layer | null, pixels: Pixels) => ({ pixels, canvas: old?.canvas ?? document.createElement("canvas") });
		this.a = layer(this.a, a);
		this.b = b && layer(this.b, b);
		this.subtracted = this.d = null;
		if (this.cursor && (this.cursor.x >= getSize(a).width || this.cursor.y >= getSize(a).height)) {
			this.cursor = null;
		}
		this.shade();
	}

	get difference(): Difference | null {
		return (this.subtracted ??= this.a && this.b && subtract(this.a.pixels, this.b.pixels));
	}

	/** After the look, the mode or the gain changed. */
	shade(): void {
		const paint = (layer: Layer | null, look: Look) => {
			if (layer) {
				fitCanvas(layer.canvas, layer.pixels.width, layer.pixels.height);
				layer.canvas.getContext("2d")!.putImageData(shade(layer.pixels, look), 0, 0);
			}
		};
		if (this.mode === "difference") {
			this.d ??= this.difference && { pixels: this.difference.pixels, canvas: document.createElement("canvas") };
			paint(this.d, { ...this.look, exposure: Math.log2(this.gain), low: 0, high: 1, gamma: 1, odd: false });
		} else {
			paint(this.mode === "b" ? null : this.a, this.look);
			paint(this.mode === "a" ? null : this.b, this.look);
		}
		this.probe();
		this.draw();
	}

	fit(): void {
		this.zoom = 1;
		this.center = { x: 0.5, y: 0.5 };
		this.draw();
	}

	/** CSS pixels of a texel of A. */
	getTexel(): number {
		return this.a ? this.getBox(0).width / getSize(this.a.pixels).width : 1;
	}

	/** Texels of A, in a row, that at least fall on each pixel of the screen. */
	getStep(): number {
		return Math.min(Math.max(Math.floor(1 / (this.getTexel() * (devicePixelRatio || 1))), 1), 16);
	}

	setTexel(size: number, at?: { x: number; y: number }): void {
		this.setZoom((this.zoom * size) / this.getTexel(), at);
	}

	/** Keeps what is at this place of the canvas there. */
	setZoom(zoom: number, at?: { x: number; y: number }): void {
		if (!this.a) {
			return;
		}
		const pane = at && this.mode === "side" && at.x > this.canvas.clientWidth / 2 ? 1 : 0;
		const before = this.getBox(pane);
		const most = (this.zoom * largestTexel) / this.getTexel();
		const share = at && { x: (at.x - before.x) / before.width, y: (at.y - before.y) / before.height };
		this.zoom = Math.min(Math.max(zoom, 0.5), Math.max(most, 1));
		if (at && share) {
			const after = this.getBox(pane);
			this.center.x += share.x - (at.x - after.x) / after.width;
			this.center.y += share.y - (at.y - after.y) / after.height;
		}
		this.draw();
	}

	moveCursor(x: number, y: number): void {
		if (this.a) {
			const { width, height } = getSize(this.a.pixels);
			const from = this.cursor ?? { x: width >> 1, y: height >> 1 };
			this.cursor = {
				x: Math.min(Math.max(from.x + x, 0), width - 1),
				y: Math.min(Math.max(from.y + y, 0), height - 1),
			};
			this.probe();
			this.draw();
		}
	}

	setCursor(x: number, y: number): void {
		this.cursor = { x, y };
		this.moveCursor(0, 0);
	}

	private getBox(pane: number): Box {
		const panes = this.mode === "side" ? 2 : 1;
		const [width, height] = [this.canvas.clientWidth / panes, this.canvas.clientHeight];
		const whole = getSize(this.a!.pixels);
		const free = Math.min(width / whole.width, height / whole.height) * this.zoom;
		const size = Math.abs(free - Math.round(free)) < 1e-6 ? Math.round(free) : free;
		const [w, h] = [whole.width * size, whole.height * size];
		const snap = size >= 1 ? Math.round : (at: number) => at; // texels as pixels: exactly those
		return { x: snap(pane * width + width / 2 - this.center.x * w), y: snap(height / 2 - this.center.y * h), width: w, height: h };
	}

	private probe(): void {
		if (!this.a || !this.cursor) {
			this.onProbe(null);
			return;
		}
		const { x, y } = this.cursor;
		const { pixels } = this.a;
		const size = getSize(pixels);
		this.onProbe({
			x, y,
			a: readPixel(pixels, mapTexel(size, pixels, x, y)),
			b: this.b && readPixel(this.b.pixels, mapTexel(size, this.b.pixels, x, y)),
		});
	}

	private draw(): void {
		cancelAnimationFrame(this.pending);
		this.pending = requestAnimationFrame(() => this.paint());
		this.onChange();
	}

	/** Draws what is due now and not with the next frame of the screen. */
	drawNow(): void {
		cancelAnimationFrame(this.pending);
		this.quick = true; // finely takes longer than all else
		this.paint();
		this.quick = false;
	}

	private paint(): void {
		const ratio = devicePixelRatio || 1;
		const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
		fitCanvas(this.canvas, Math.round(width * ratio), Math.round(height * ratio));
		const context = this.canvas.getContext("2d")!;
		context.setTransform(1, 0, 0, 1, 0, 0);
		context.clearRect(0, 0, this.canvas.width, this.canvas.height);
		context.scale(ratio, ratio);
		if (!this.a || width === 0) {
			return;
		}
		const layers: Record<Mode, [Layer | null, number, number, number][]> = {
			a: [[this.a, 0, 0, width]],
			b: [[this.b, 0, 0, width]],
			difference: [[this.d, 0, 0, width]],
			slider: [[this.a, 0, 0, width * this.split], [this.b, 0, width * this.split, width]],
			side: [[this.a, 0, 0, width / 2], [this.b, 1, width / 2, width]],
		};
		for (const [layer, pane, from, to] of layers[this.mode]) {
			if (layer) {
				context.save();
				context.beginPath();
				context.rect(from, 0, to - from, height);
				context.clip();
				this.paintLayer(context, layer, this.getBox(pane), from, to);
				context.restore();
			}
		}
		if (this.mode === "slider" || this.mode === "side") {
			const x = Math.round(width * (this.mode === "side" ? 0.5 : this.split));
			context.fillStyle = "#000a";
			context.fillRect(x - 1.5, 0, 3, height);
			context.fillStyle = "#fff";
			context.fillRect(x - 0.5, 0, 1, height);
		}
	}

	private paintLayer(context: CanvasRenderingContext2D, layer: Layer, box: Box, from: number, to: number): void {
		const texel = box.width / layer.pixels.width;
		context.imageSmoothingEnabled = texel < 1;
		context.imageSmoothingQuality = this.quick ? "low" : "high";
		context.drawImage(layer.canvas, box.x, box.y, box.width, box.height);
		if (texel >= numbersFrom) {
			this.paintNumbers(context, layer.pixels, box, texel, from, to);
		}
		if (this.cursor && texel >= 4) {
			const size = box.width / getSize(this.a!.pixels).width;
			context.strokeStyle = "#000";
			context.lineWidth = 3;
			const mark: [number, number, number, number] = [box.x + this.cursor.x * size, box.y + this.cursor.y * size, size, size];
			context.strokeRect(...mark);
			context.strokeStyle = "#fff";
			context.lineWidth = 1;
			context.strokeRect(...mark);
		}
	}

	private paintNumbers(context: CanvasRenderingContext2D, pixels: Pixels, box: Box, texel: number, from: number, to: number): void {
		const channels = pixels.channels.length;
		const size = Math.min(texel / (channels + 1), texel / 5, 15);
		context.font = `${size}px ui-monospace, "DejaVu Sans Mono", monospace`;
		context.textAlign = "center";
		context.textBaseline = "middle";
		context.lineJoin = "round";
		const first = { x: Math.max(0, Math.floor((from - box.x) / texel)), y: Math.max(0, Math.floor(-box.y / texel)) };
		const last = {
			x: Math.min(pixels.width, Math.ceil((to - box.x) / texel)),
			y: Math.min(pixels.height, Math.ceil((this.canvas.clientHeight - box.y) / texel)),
		};
		for (let y = first.y; y < last.y; ++y) {
			for (let x = first.x; x < last.x; ++x) {
				const values = readPixel(pixels, y * pixels.width + x);
				for (let i = 0; i < channels; ++i) {
					const text = number(values[i]);
					const at: [number, number] = [
						box.x + (x + 0.5) * texel, box.y + (y + 0.5) * texel + (i - (channels - 1) / 2) * size * 1.15];
					context.strokeStyle = "#000c";
					context.lineWidth = 3;
					context.strokeText(text, ...at);
					context.fillStyle = ["#ffb4a8", "#b7f0b0", "#b5cdff", "#eee"][channels === 1 ? 3 : i];
					context.fillText(text, ...at);
				}
			}
		}
	}

	private toTexel(x: number, y: number): { x: number; y: number } | null {
		if (!this.a) {
			return null;
		}
		const box = this.getBox(this.mode === "side" && x > this.canvas.clientWidth / 2 ? 1 : 0);
		const { width, height } = getSize(this.a.pixels);
		const texel = {
			x: Math.floor(((x - box.x) / box.width) * width),
			y: Math.floor(((y - box.y) / box.height) * height),
		};
		const inside = texel.x >= 0 && texel.y >= 0 && texel.x < width && texel.y < height;
		return inside ? texel : null;
	}

	private pan(x: number, y: number): void {
		const box = this.getBox(0);
		this.center.x = Math.min(Math.max(this.center.x + x / box.width, 0), 1);
		this.center.y = Math.min(Math.max(this.center.y + y / box.height, 0), 1);
		this.draw();
	}

	private listen(): void {
		const canvas = this.canvas;
		let drag: "pan" | "split" | null = null;
		let way = 0; // of a drag, CSS pixels
		canvas.addEventListener("pointerdown", (event) => {
			const near = Math.abs(event.offsetX - this.split * canvas.clientWidth) < 12;
			drag = this.mode === "slider" && near ? "split" : "pan";
			way = 0;
			canvas.setPointerCapture(event.pointerId);
		});
		canvas.addEventListener("pointerup", (event) => {
			const texel = drag === "pan" && way < 4 && this.toTexel(event.offsetX, event.offsetY);
			drag = null;
			if (texel) {
				this.setCursor(texel.x, texel.y);
				this.onPick(texel.x, texel.y);
			}
		});
		canvas.addEventListener("pointercancel", () => (drag = null));
		canvas.addEventListener("pointermove", (event) => {
			way += Math.abs(event.movementX) + Math.abs(event.movementY);
			if (drag === "pan") {
				this.pan(-event.movementX, -event.movementY);
			} else if (drag === "split") {
				this.setSplit(event.offsetX / canvas.clientWidth);
			}
			this.cursor = this.toTexel(event.offsetX, event.offsetY) ?? this.cursor;
			this.probe();
			this.draw();
		});
		canvas.addEventListener("dblclick", (event) => this.setTexel(64, { x: event.offsetX, y: event.offsetY }));
		canvas.addEventListener("wheel", (event) => {
			event.preventDefault();
			this.setZoom(this.zoom * 2 ** (-event.deltaY / 240), { x: event.offsetX, y: event.offsetY });
		}, { passive: false });
		canvas.addEventListener("keydown", (event) => {
			if (this.press(event.key, event.shiftKey)) {
				event.preventDefault();
				event.stopPropagation();
			}
		});
	}

	setSplit(split: number): void {
		this.split = Math.min(Math.max(split, 0), 1);
		this.draw();
	}

	press(key: string, shift: boolean): boolean {
		const arrows: Record<string, [number, number]> = {
			ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
		const arrow = arrows[key];
		if (arrow) {
			const step = this.canvas.clientWidth / 12;
			shift ? this.moveCursor(...arrow) : this.pan(arrow[0] * step, arrow[1] * step);
		} else if (key === "Enter" && this.cursor) {
			this.onPick(this.cursor.x, this.cursor.y);
		} else if (key === "+" || key === "=") {
			this.setZoom(this.zoom * 1.5);
		} else if (key === "-") {
			this.setZoom(this.zoom / 1.5);
		} else if (key === "f") {
			this.fit();
		} else if (key === "1") {
			this.setTexel(1);
		} else if (key === "n") {
			this.setTexel(64);
		} else if (key === "[" || key === "]") {
			this.setSplit(this.split + (key === "[" ? -0.05 : 0.05));
		} else {
			return false;
		}
		return true;
	}
}
