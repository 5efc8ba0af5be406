// The picture section: the viewer with its controls, the values under the cursor, a histogram and the film strip.
import { PictureData, pictureUrl } from "../data";
import { el, fold, section } from "../dom";
import { count, number, percent } from "../format";
import { drawHistogram } from "./histogram";
import { Pixels, countOdd, findRange, loadPixels } from "./pixels";
import { Channel, falseColor, picker, plainLook } from "./shade";
import { Mode, Probe, Viewer } from "./viewer";

const modes: [Mode, string, string][] = [
	["a", "A", "Show A (key A)"],
	["b", "B", "Show B (key B); pressed again, A: flips in place"],
	["slider", "Slider", "A left of the line, B right of it; [ and ] move the line (key S)"],
	["side", "Side by side", "Both, moved together (key I)"],
	["difference", "Difference", "|A − B| times the gain (key D)"],
];

export interface PictureOptions {
	a?: string; // what is shown first; the first picture by default
	b?: string;
	mode?: Mode;
	/** The shape and format of a resource. */
	shape?: (resource: string) => string | undefined;
	title?: string;
	note?: string;
	onChoose?: (a: PictureData, b: PictureData | null) => void;
	strip?: boolean; // of all pictures; there is one by default
}

/** How the lists of pictures are parted. */
const groups: [string, PictureData["role"][]][] = [
	["Frame", ["final", "scene", "previous"]], ["Dumped passes", ["dump"]], ["Thumbnails", ["thumbnail"]], ["A", ["a"]], ["B", ["b"]],
	["Differences", ["error"]], ["Frames", ["frame"]], ["Engine versions", ["version"]], ["States", ["state"]],
];

/** Marks that tell pictures of one name apart in the strip. */
const marks: Partial<Record<PictureData["role"], string>> = { a: "A  ", b: "B  ", error: "≠  " };

export class PicturePanel {
	readonly element: HTMLElement;
	readonly viewer = new Viewer();
	/** Holds the picture, and what a page puts above and below it. */
	readonly stage = el("div", { class: "stage" }, this.viewer.canvas);
	private a: PictureData;
	private b: PictureData | null;
	private pixels: Pixels | null = null;
	private second: Pixels | null = null;
	private readonly selectA: HTMLSelectElement;
	private readonly selectB: HTMLSelectElement;
	private readonly modeButtons = new Map<Mode, HTMLButtonElement>();
	private readonly probe = el("div", { class: "probe", id: "probe", "aria-live": "off" });
	private readonly facts = el("div", { class: "facts", id: "facts" });
	private readonly plot = el("div", { class: "plot", id: "histogram" });
	private readonly scale = el("div", { class: "scale", id: "scale" });
	private readonly zoomLabel = el("output", { id: "zoom" });
	private readonly strip = el("div", { class: "strip", role: "listbox", "aria-label": "Pictures in the order of the passes" });
	private readonly inputs: Record<"exposure" | "low" | "high" | "gain", HTMLInputElement>;
	private readonly channel: HTMLSelectElement;
	private readonly gamma: HTMLSelectElement;
	private readonly toggles: Record<"falseColor" | "odd", HTMLButtonElement>;
	private turn = 0;

	constructor(private pictures: PictureData[], private readonly options: PictureOptions = {}) {
		this.a = this.find(options.a) ?? pictures[0];
		this.b = this.find(options.b);
		this.selectA = this.makeSelect("picture-a", (id) => this.choose(id, this.b?.id ?? ""));
		this.selectB = this.makeSelect("picture-b", (id) => this.choose(this.a.id, id));
		this.inputs = {
			exposure: this.makeRange("exposure", -10, 10, 0.25, 0, (value) => (this.viewer.look.exposure = value)),
			low: this.makeNumber("low", 0, (value) => (this.viewer.look.low = value)),
			high: this.makeNumber("high", 1, (value) => (this.viewer.look.high = value)),
			gain: this.makeRange("gain", 0, 10, 1, 0, (value) => (this.viewer.gain = 2 ** value)),
		};
		this.channel = this.makeOptions("channel", [["rgb", "RGB"], ["luminance", "Luminance"], ["0", "R"], ["1", "G"], ["2", "B"], ["3", "A"]],
			(value) => (this.viewer.look.channel = value as Channel));
		this.gamma = this.makeOptions("gamma", [["0", "sRGB"], ["1", "1.0"], ["1.8", "1.8"], ["2.2", "2.2"], ["2.4", "2.4"]],
			(value) => (this.viewer.look.gamma = Number(value)));
		this.toggles = {
			falseColor: this.makeToggle("false-color", "False colour", "One number of each texel as a colour; its scale is at the right (key C)", () => (this.viewer.look.falseColor = !this.viewer.look.falseColor)),
			odd: this.makeToggle("odd", "NaN Inf −", "NaN magenta, infinities yellow, negative values blue (key O)", () => (this.viewer.look.odd = !this.viewer.look.odd)),
		};
		this.element = this.build();
		this.viewer.onProbe = (probe) => this.showProbe(probe);
		this.viewer.onChange = () => (this.zoomLabel.textContent = `1 : ${number(Number(this.viewer.getTexel().toPrecision(2)))}`);
		this.fillLists();
		void this.choose(this.a.id, this.b?.id ?? "").then(() => options.mode && this.setMode(options.mode));
	}

	get selectedA(): string {
		return this.a.id;
	}

	get selectedB(): string {
		return this.b?.id ?? "";
	}

	private find(id: string | undefined): PictureData | null {
		return this.pictures.find((picture) => picture.id === id) ?? null;
	}

	/** Other pictures to choose from; those that are shown stay where they are still there. */
	setList(pictures: PictureData[]): void {
		const same = pictures.map(({ id }) => id).join() === this.pictures.map(({ id }) => id).join();
		this.pictures = pictures;
		if (!same) {
			this.fillLists();
		}
		[this.selectA.value, this.selectB.value] = [this.a.id, this.b?.id ?? ""];
	}

	/** A picture that is shown became another one. Quick: at once, and without what is written about it. */
	update(id: string, pixels: Pixels, quick: boolean): void {
		if (this.pixels && (id === this.a.id || id === this.b?.id)) {
			this.pixels = id === this.a.id ? pixels : this.pixels;
			this.second = id === this.b?.id ? pixels : this.second;
			this.viewer.setPictures(this.pixels, this.second);
			quick ? this.viewer.drawNow() : this.showFacts();
		}
	}

	/** Shows a picture as A, and the section. */
	show(id: string): void {
		void this.choose(id, this.b?.id ?? "");
		this.setMode("a");
		this.element.scrollIntoView();
	}

	async choose(a: string, b: string): Promise<void> {
		const turn = ++this.turn;
		this.a = this.find(a) ?? this.pictures[0];
		this.b = this.find(b);
		this.options.onChoose?.(this.a, this.b);
		[this.selectA.value, this.selectB.value] = [this.a.id, this.b?.id ?? ""];
		const [first, second] = [await loadPixels(this.a), this.b && (await loadPixels(this.b))];
		if (turn !== this.turn) {
			return; // another was chosen meanwhile
		}
		[this.pixels, this.second] = [first, second];
		if (!second && this.viewer.mode !== "a") {
			this.setMode("a");
		}
		for (const [mode, button] of this.modeButtons) {
			button.disabled = !second && mode !== "a";
		}
		for (const option of this.channel.options) {
			const index = Number(option.value);
			option.disabled = index >= first.channels.length;
			if (Number.isInteger(index)) {
				option.textContent = first.channels[index] ?? option.textContent;
			}
		}
		this.viewer.canvas.style.aspectRatio = String(Math.min(Math.max(first.width / first.height, 0.8), 4));
		this.viewer.setPictures(first, second);
		for (const image of this.strip.children) {
			image.setAttribute("aria-selected", String(image.getAttribute("data-id") === this.a.id));
		}
		this.showFacts();
	}

	setMode(mode: Mode): void {
		if (mode !== "a" && !this.b) {
			return;
		}
		this.viewer.mode = mode;
		for (const [other, button] of this.modeButtons) {
			button.setAttribute("aria-pressed", String(other === mode));
		}
		this.element.dataset.mode = mode;
		this.viewer.shade();
		this.showFacts();
	}

	/** Keys of the picture, wherever on the page the focus is; arrows belong to what has the focus. */
	press(key: string, shift: boolean): boolean {
		const look = this.viewer.look;
		const actions: Record<string, () => void> = {
			a: () => this.setMode("a"),
			b: () => this.setMode(this.viewer.mode === "b" ? "a" : "b"),
			s: () => this.setMode("slider"),
			i: () => this.setMode("side"),
			d: () => this.setMode("difference"),
			c: () => this.toggles.falseColor.click(),
			o: () => this.toggles.odd.click(),
			r: () => this.stretch(),
			e: () => this.setInput("exposure", look.exposure + 0.5),
			E: () => this.setInput("exposure", look.exposure - 0.5),
			x: () => this.reset(),
		};
		const known = Object.hasOwn(actions, key) ? (actions[key](), true) : !key.startsWith("Arrow") && this.viewer.press(key, shift);
		if (known) {
			this.viewer.canvas.scrollIntoView({ block: "nearest" });
		}
		return known;
	}

	private setInput(name: keyof PicturePanel["inputs"], value: number): void {
		this.inputs[name].value = String(value);
		this.inputs[name].dispatchEvent(new Event("input"));
	}

	private stretch(): void {
		if (this.pixels) {
			const [low, high] = findRange(this.pixels, picker(this.pixels, this.viewer.look.channel));
			const scale = 2 ** this.viewer.look.exposure;
			this.setInput("low", Number((low * scale).toPrecision(4)));
			this.setInput("high", Number((high * scale).toPrecision(4)));
		}
	}

	private reset(): void {
		this.viewer.look = { ...plainLook };
		this.channel.value = "rgb";
		this.gamma.value = "0";
		Object.values(this.toggles).forEach((toggle) => toggle.setAttribute("aria-pressed", "false"));
		this.setInput("exposure", 0);
		this.setInput("gain", 0);
		this.setInput("low", 0);
		this.setInput("high", 1);
		this.viewer.fit();
	}

	private changed(): void {
		this.viewer.shade();
		this.showFacts();
	}

	private makeSelect(id: string, choose: (id: string) => void): HTMLSelectElement {
		const select = el<HTMLSelectElement>("select", { id, onchange: () => choose(select.value) });
		return select;
	}

	private fillLists(): void {
		for (const select of [this.selectA, this.selectB]) {
			const members = (roles: PictureData["role"][]) => this.pictures.filter((picture) => roles.includes(picture.role));
			select.replaceChildren(...groups.filter(([, roles]) => members(roles).length).map(([label, roles]) =>
				el("optgroup", { label }, ...members(roles).map((picture) =>
					el("option", { value: picture.id }, (picture.pass > 0 ? picture.pass + "  " : "") + picture.label)))));
		}
		this.selectB.prepend(el("option", { value: "" }, "none"));
		if (this.options.strip !== false) {
			this.fillStrip();
		}
	}

	private makeOptions(id: string, options: [string, string][], set: (value: string) => void): HTMLSelectElement {
		const select = el<HTMLSelectElement>("select", { id, onchange: () => { set(select.value); this.changed(); } },
			...options.map(([value, label]) => el("option", { value }, label)));
		return select;
	}

	private makeRange(id: string, min: number, max: number, step: number, value: number, set: (value: number) => void): HTMLInputElement {
		const input = el<HTMLInputElement>("input", { id, type: "range", min, max, step, value, oninput: () => {
			set(Number(input.value));
			input.nextElementSibling!.textContent = id === "gain" ? "× " + 2 ** Number(input.value) : (Number(input.value) > 0 ? "+" : "") + input.value;
			this.changed();
		} });
		return input;
	}

	private makeNumber(id: string, value: number, set: (value: number) => void): HTMLInputElement {
		const input = el<HTMLInputElement>("input", { id, type: "number", step: "any", value, oninput: () => {
			if (Number.isFinite(input.valueAsNumber)) {
				set(input.valueAsNumber);
				this.changed();
			}
		} });
		return input;
	}

	private makeToggle(id: string, label: string, tip: string, flip: () => void): HTMLButtonElement {
		const button = el<HTMLButtonElement>("button", { id, type: "button", "data-tip": tip, "aria-pressed": "false", onclick: () => {
			flip();
			button.setAttribute("aria-pressed", String(button.getAttribute("aria-pressed") !== "true"));
			this.changed();
		} }, label);
		return button;
	}

	private build(): HTMLElement {
		const mode = el("div", { class: "segments", role: "group", "aria-label": "How A and B are shown" }, modes.map(([name, label, tip]) => {
			const button = el<HTMLButtonElement>("button", { type: "button", id: "mode-" + name, "data-tip": tip, "aria-pressed": String(name === "a"), onclick: () => this.setMode(name) }, label);
			this.modeButtons.set(name, button);
			return button;
		}));
		const labeled = (label: string, ...parts: Node[]) => el("label", {}, el("span", {}, label), ...parts);
		const tools = el("div", { class: "tools" },
			labeled("A", this.selectA), labeled("B", this.selectB), mode,
			el("span", { class: "group only-difference" }, labeled("Gain", this.inputs.gain, el("output", {}, "× 1"))),
			el("span", { class: "group right" },
				el("button", { type: "button", id: "fit", "data-tip": "The whole picture (key F)", onclick: () => this.viewer.fit() }, "Fit"),
				el("button", { type: "button", id: "pixels", "data-tip": "Texels with their numbers (key N, or a double click)", onclick: () => this.viewer.setTexel(64) }, "Numbers"),
				this.zoomLabel));
		const looks = el("div", { class: "tools" },
			labeled("Exposure", this.inputs.exposure, el("output", {}, "0")),
			labeled("Gamma", this.gamma), labeled("Channel", this.channel),
			el("span", { class: "group" }, labeled("Range", this.inputs.low), labeled("to", this.inputs.high),
				el("button", { type: "button", id: "stretch", "data-tip": "From the darkest to the brightest hundredth: depth, masks (key R)", onclick: () => this.stretch() }, "Stretch")),
			this.toggles.falseColor, this.toggles.odd, el("button", { type: "button", id: "reset", "data-tip": "As it was (key X)", onclick: () => this.reset() }, "Reset"));
		const element = section("picture", this.options.title ?? "Picture", this.options.note ?? "", this.stage, this.scale, this.probe,
			fold("Controls", tools, looks), this.options.strip === false ? null : fold(`All ${count(this.pictures.length, "picture")}`, this.strip),
			fold("Figures", el("div", { class: "figures-of" }, this.facts, this.plot)));
		element.dataset.mode = "a";
		return element;
	}

	private fillStrip(): void {
		const place = (picture: PictureData) => (picture.role === "previous" ? Infinity : picture.pass);
		this.strip.replaceChildren();
		for (const picture of this.pictures.toSorted((a, b) => place(a) - place(b) || 0)) {
			const choose = (event: { shiftKey: boolean }) =>
				event.shiftKey ? this.choose(this.a.id, picture.id) : this.choose(picture.id, this.b?.id ?? "");
			this.strip.append(el("button", { type: "button", role: "option", "data-id": picture.id, "data-tip": picture.label + "; with shift as B", onclick: choose },
				el("img", { src: pictureUrl(picture), alt: "", loading: "lazy", decoding: "async" }),
				el("span", {}, picture.pass > 0 ? `${picture.pass} ${picture.resource}` : (marks[picture.role] ?? "") + picture.label)));
		}
	}

	private showProbe(probe: Probe | null): void {
		if (!probe || !this.pixels) {
			this.probe.replaceChildren(el("p", { class: "quiet" }, "Move over the picture for values."));
			return;
		}
		const { channels, precision } = this.pixels;
		const show = (value: number, exact: boolean) => (exact ? "" : "≈ ") + number(value) +
			(precision === "8 bit" && this.a.encoding === "display" ? ` (${Math.round(value * 255)})` : "");
		const exact = precision !== "8 bit" || this.a.encoding === "display";
		// The texel in the middle, for a picture that was made smaller for the page.
		const place = (at: number, shown: number, whole: number) => (whole > shown ? Math.floor(((at + 0.5) * whole) / shown) : at);
		const x = this.a.corner[0] + place(probe.x, this.pixels.width, this.a.size[0]);
		const y = this.a.corner[1] + place(probe.y, this.pixels.height, this.a.size[1]);
		const { a, b } = probe;
		const row = (name: string, cell: (i: number) => string, attributes: (i: number) => Record<string, string | number> = () => ({})) =>
			el("tr", {}, el("th", { scope: "row" }, name), channels.map((_, i) => el("td", attributes(i), cell(i))));
		const ofB = (cell: (i: number) => string) => (i: number) => (b && i < b.length ? cell(i) : "");
		this.probe.replaceChildren(
			el("h3", {}, `Texel ${x}, ${y}`),
			el("table", {},
				el("thead", {}, el("tr", {}, el("th", {}), channels.map((name) => el("th", { scope: "col" }, name)))),
				el("tbody", {}, row("A", (i) => show(a[i], exact), (i) => ({ "data-channel": channels[i], "data-value": a[i] })),
					b ? row("B", ofB((i) => show(b[i], exact))) : null, b ? row("A − B", ofB((i) => number(a[i] - b[i]))) : null)));
	}

	private showFacts(): void {
		if (!this.pixels) {
			return;
		}
		const odd = countOdd(this.a, this.pixels);
		const [whole] = this.a.size;
		const scaled = whole > this.pixels.width && this.a.role !== "thumbnail" ? `, of ${whole} × ${this.a.size[1]}` : "";
		const lines: [string, string][] = [
			["Picture", `${this.pixels.width} × ${this.pixels.height}${scaled}`],
			["Texture", this.options.shape?.(this.a.resource) ?? ""],
			["Values", this.pixels.precision === "8 bit" ? (this.a.role === "thumbnail" ? "thumbnail, 8 bit" : "from the PNG, 8 bit") : `as stored, ${this.pixels.precision}`],
		];
		if (this.a.figures) {
			const range = (list: (number | null)[]) => list.map((value) => number(value ?? NaN)).join("  ");
			lines.push(["Least", range(this.a.figures.min)], ["Largest", range(this.a.figures.max)]);
			lines.push(["NaN · Inf · neg.", `${odd.nan} · ${odd.infinite} · ${odd.negative}`]);
		}
		const { difference, mode } = this.viewer;
		if (difference && mode !== "a") {
			const share = difference.changed / (this.pixels.width * this.pixels.height);
			lines.push(["A − B", difference.changed === 0 ? "the same in every pixel" : `${count(difference.changed, "pixel")} (${percent(share)})`],
				["Largest · RMS", `${number(difference.max)} · ${number(difference.rms)}`]);
		}
		this.facts.replaceChildren(el("dl", {}, lines.filter(([, text]) => text).flatMap(([name, text]) => [el("dt", {}, name), el("dd", {}, text)])));
		this.showScale();
		drawHistogram(this.plot, this.pixels);
	}

	private showScale(): void {
		const { look } = this.viewer;
		this.scale.hidden = !look.falseColor;
		const colors = Array.from({ length: 9 }, (_, i) => `rgb(${falseColor(i / 8).map(Math.round).join(" ")})`);
		const ends = [look.low, (look.low + look.high) / 2, look.high].map((end) => number(Number((end / 2 ** look.exposure).toPrecision(4))));
		this.scale.replaceChildren(
			el("div", { class: "ramp", style: `background: linear-gradient(90deg, ${colors.join(",")})` }),
			el("div", { class: "ends" }, ends.map((end) => el("span", {}, end))));
	}
}

/** The answers, with the picture at their side where there is room. */
export function beside(answers: HTMLElement, picture: PicturePanel | null): HTMLElement {
	return picture ? el("div", { class: "beside" }, answers, picture.element) : answers;
}
