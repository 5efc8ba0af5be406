// The volumes: a list of what they say and how they act, and a view from above in which the camera can be moved.
import { el, refill } from "../dom";
import { number, percent } from "../format";
import { Control, ControlOptions, makeControl, makeFault, startDrag } from "./control";
import { Json, LiveVolume, State } from "./data";
import { SendEdits } from "./settings";

type Point = [number, number];

const colors = 10; // classes c0 to c9

/** The outline of a volume seen from above, cm. */
function outline(bounds: { [key: string]: any }): Point[] {
	const { type, min, max, radius, points, rotation } = bounds;
	const center: number[] = bounds.center ?? [0, 1].map((i) => (min[i] + max[i]) / 2);
	if (type === "convex") {
		const middle = [0, 1].map((axis) => points.reduce((sum: number, point: number[]) => sum + point[axis], 0) / points.length);
		const angle = ([x, y]: Point) => Math.atan2(y - middle[1], x - middle[0]);
		return points.map(([x, y]: number[]): Point => [x, y]).sort((a: Point, b: Point) => angle(a) - angle(b));
	}
	if (type === "sphere" || type === "capsule") {
		return Array.from({ length: 48 }, (_, i): Point => [center[0] + radius * Math.cos((i * Math.PI) / 24), center[1] + radius * Math.sin((i * Math.PI) / 24)]);
	}
	const [w, h] = min ? [0, 1].map((i) => (max[i] - min[i]) / 2) : bounds.extent;
	const yaw = (((Array.isArray(rotation) ? rotation[1] : rotation?.Yaw) ?? 0) * Math.PI) / 180;
	return [[-w, -h], [w, -h], [w, h], [-w, h]].map(([x, y]): Point => [center[0] + x * Math.cos(yaw) - y * Math.sin(yaw), center[1] + x * Math.sin(yaw) + y * Math.cos(yaw)]);
}

/** The camera's place in front of the volumes, from above: X to the right, Y down. */
class TopView {
	readonly element = el("div", { class: "top-view" });
	private readonly camera: SVGElement;
	private readonly weights: SVGElement[] = [];
	private location = [0, 0, 0];
	private path: number[][] = []; // of a sequence
	private span = 1; // cm over the width
	private origin: Point = [0, 0];
	private drag = "";

	constructor(private readonly move: (location: number[], drag?: string, at?: number) => void) {
		this.camera = el<SVGElement>("g", {
			class: "camera", tabindex: 0, role: "application", "data-tip": "Drag the camera, also along the dotted path, or move it with the arrow keys; with shift ten times as far",
			onkeydown: (event: KeyboardEvent) => {
				const steps: Record<string, Point> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
				const step = steps[event.key];
				if (step) {
					event.preventDefault();
					this.drag ||= startDrag();
					const size = 10 ** Math.floor(Math.log10(this.span / 30)) * (event.shiftKey ? 10 : 1);
					this.to([this.location[0] + step[0] * size, this.location[1] + step[1] * size, this.location[2]], event.timeStamp);
				}
			},
			onkeyup: () => (this.drag = ""),
		}, el("circle", { class: "hit", r: 20 }), el("circle", { class: "body", r: 6 }));
	}

	update(state: State, settled: boolean): void {
		const { volumes, view } = state;
		this.location = this.drag || !settled ? this.location : [...view.location];
		this.path = view.path ?? [];
		refill(this.element, [volumes.map(({ bounds, blendRadius, name, unbound }) => [bounds, blendRadius, name, unbound]), view.path], () => [this.draw(state)]);
		volumes.forEach((volume, i) => this.weights[i]?.setAttribute("fill-opacity", String(0.06 + 0.45 * volume.weight)));
		this.place();
	}

	private place(): void {
		const [x, y] = this.location;
		this.camera.setAttribute("transform", `translate(${((x - this.origin[0]) / this.span) * 600} ${((y - this.origin[1]) / this.span) * 600})`);
		this.camera.setAttribute("aria-label", `Camera at ${number(Math.round(x))}, ${number(Math.round(y))} cm. Arrow keys move it`);
	}

	/** A place at the recorded path is on it, at its height. */
	private snap([x, y]: Point): number[] {
		for (const [i, to] of this.path.entries()) {
			const from = this.path[Math.max(i - 1, 0)];
			const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
			const share = Math.min(Math.max(((x - from[0]) * dx + (y - from[1]) * dy) / (dx * dx + dy * dy || 1), 0), 1);
			const at = from.map((value, axis) => value + share * (to[axis] - value));
			if (Math.hypot(at[0] - x, at[1] - y) < this.span / 60) {
				return at;
			}
		}
		return [x, y, this.location[2]];
	}

	private to(location: number[], at: number): void {
		this.location = location.map((value) => Number(value.toFixed(1)));
		this.place();
		this.move(this.location, this.drag, at);
	}

	private draw({ volumes, view }: State): SVGSVGElement {
		const shapes = volumes.map((volume) => (volume.unbound || !volume.bounds ? [] : outline(volume.bounds)));
		const all = [...shapes.flat(), ...this.path, view.location];
		const ends = (axis: number) => [Math.min(...all.map((point) => point[axis])), Math.max(...all.map((point) => point[axis]))];
		const [[left, right], [low, high]] = [ends(0), ends(1)];
		const room = 60 + Math.max(0, ...volumes.map((volume, i) => (shapes[i].length ? volume.blendRadius : 0)));
		this.origin = [left - room, low - room];
		this.span = right - left + 2 * room;
		const scale = 600 / this.span;
		const height = Math.min(Math.max((high - low + 2 * room) * scale, 160), shapes.some((shape) => shape.length) || this.path.length ? 520 : 160);
		this.origin[1] -= (height / scale - (high - low + 2 * room)) / 2;
		const at = ([x, y]: number[]) => `${(x - this.origin[0]) * scale} ${(y - this.origin[1]) * scale}`;
		this.weights.length = 0;
		const follow = (event: PointerEvent) => {
			const box = svg.getBoundingClientRect();
			const cm = this.span / box.width; // of a pixel
			this.to(this.snap([this.origin[0] + (event.clientX - box.left) * cm, this.origin[1] + (event.clientY - box.top) * cm]), event.timeStamp);
		};
		const svg: SVGSVGElement = el<SVGSVGElement>("svg", {
			viewBox: `0 0 600 ${height}`, role: "group", "aria-label": "The volumes from above",
			onpointerdown: (event: PointerEvent) => {
				this.drag = startDrag();
				svg.setPointerCapture(event.pointerId);
				(this.camera as unknown as HTMLElement).focus({ preventScroll: true });
				follow(event);
			},
			onpointermove: (event: PointerEvent) => this.drag && event.buttons && follow(event),
			onpointerup: () => (this.drag = ""),
			onpointercancel: () => (this.drag = ""),
		});
		volumes.forEach((volume, i) => {
			const shape = shapes[i];
			if (shape.length) {
				const d = "M" + shape.map(at).join("L") + "Z";
				this.weights[i] = el<SVGElement>("path", { class: "volume-body", d });
				const [x, y] = [0, 1].map((axis) => (Math.min(...shape.map((point) => point[axis])) - this.origin[axis]) * scale);
				svg.append(el("g", { class: "volume c" + (i % colors) },
					volume.blendRadius >= 1 ? el("path", { class: "fade", d, "stroke-width": 2 * volume.blendRadius * scale, "stroke-linejoin": "round" }) : null,
					this.weights[i], el("text", { x: x + 8, y: y + 18 }, volume.name)));
			}
		});
		if (this.path.length) {
			svg.append(el("path", { class: "walked", d: "M" + this.path.map(at).join("L") }), ...this.path.map((point) => el("circle", { class: "step", transform: `translate(${at(point)})`, r: 2.5 })));
		}
		const unit = 10 ** Math.floor(Math.log10(this.span / 3));
		svg.append(el("path", { class: "ruler", d: `M10 ${height - 10}h${unit * scale}` }), el("text", { class: "tick", x: 10, y: height - 15 }, `${number(unit)} cm · X to the right, Y down`), this.camera);
		return svg;
	}
}

const parts: { field: "enabled" | "unbound" | "priority" | "blendWeight" | "blendRadius"; key: string; label: string; unit: string; range?: ControlOptions["range"] }[] = [
	{ field: "enabled", key: "bEnabled", label: "Enabled", unit: "" }, { field: "unbound", key: "bUnbound", label: "Unbound", unit: "" },
	{ field: "priority", key: "Priority", label: "Priority", unit: "", range: { clampMin: null, clampMax: null, uiMin: -10, uiMax: 10 } },
	{ field: "blendWeight", key: "BlendWeight", label: "Weight", unit: "", range: { clampMin: 0, clampMax: 1, uiMin: 0, uiMax: 1 } },
	{ field: "blendRadius", key: "BlendRadius", label: "Blend radius", unit: "cm", range: { clampMin: 0, clampMax: null, uiMin: 0, uiMax: null } },
];

export class VolumesPanel {
	readonly element: HTMLElement;
	private readonly fault = makeFault();
	private readonly top: TopView;
	private readonly place: Control;
	private readonly list = el("div", { class: "volumes" });
	private cards: ReturnType<VolumesPanel["makeCard"]>[] = [];

	constructor(private readonly sendEdits: SendEdits, private readonly editSettings: (volume: number) => void) {
		const move = (location: number[], drag?: string, at?: number) => this.send("/view/location", location, drag, at);
		this.top = new TopView(move);
		this.place = makeControl({ id: "place", label: "Camera", type: "vector", value: [0, 0, 0], refuse: this.fault.say, send: (value) => move(value as number[]) });
		this.element = el("div", {}, this.top.element,
			el("div", { class: "tools place" }, el("span", { class: "quiet" }, "Camera"), this.place.element, el("span", { class: "quiet" }, "cm")),
			this.fault.element, this.list);
	}

	/** Settled: no hand is at work, and the controls take the values. */
	update(state: State, settled: boolean): void {
		const { volumes } = state;
		if (settled) {
			this.place.show(state.view.location.map((value) => Number(value.toFixed(2))));
		}
		this.top.update(state, settled);
		refill(this.list, volumes.map(({ name }) => name), () => {
			this.cards = volumes.map((volume, i) => this.makeCard(volume, i));
			return volumes.length ? this.cards.map((card) => card.element) : [el("p", { class: "quiet" }, "The config has no volumes.")];
		});
		volumes.forEach((volume, i) => this.cards[i].update(volume, settled));
	}

	private send(set: string, value: Json, drag?: string, at?: number): void {
		this.fault.say("");
		this.sendEdits([{ set, value }], this.fault.refused, drag, at);
	}

	private makeCard(first: LiveVolume, index: number) {
		const controls = parts.map(({ field, key, label, unit, range }) => makeControl({
			id: `volume-${index}-${key}`, label: `${label} of ${first.name}` + (unit && `, ${unit}`), type: "float", value: first[field], range, guess: first.blendRadius,
			send: (now, drag, at) => this.send(`/volumes/${index}/${key}`, now, drag, at), refuse: this.fault.say,
		}));
		const acts = el("span", { class: "weight" });
		const why = el("span", { class: "quiet" });
		return {
			element: el("div", { class: "volume-card" },
				el("div", { class: "setting-head" }, el("i", { class: "c" + (index % colors) }), el("strong", {}, first.name || `volume ${index}`), why, acts,
					el("button", { type: "button", class: "small", onclick: () => this.editSettings(index) }, "Its settings")),
				parts.map(({ key, label, unit }, i) => el("div", { class: "volume-part" }, el("label", { for: `volume-${index}-${key}` }, label, el("span", { class: "quiet" }, " " + unit)), controls[i].element))),
			update: (volume: LiveVolume, settled: boolean) => {
				parts.forEach(({ field }, i) => settled && controls[i].show(volume[field]));
				acts.textContent = volume.weight ? "acts " + percent(volume.weight) : "does not act";
				acts.style.setProperty("--share", String(volume.weight));
				why.textContent = volume.skipped || (volume.unbound ? "everywhere" : volume.distance === null ? "" : volume.distance === 0 ? "camera inside" : `${number(Number(volume.distance.toPrecision(4)))} cm away`);
			},
		};
	}
}
