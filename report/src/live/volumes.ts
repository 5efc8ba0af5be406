// The volumes: a list of what they say and how they act, and a view from above in which the camera can be moved.
import { el } from "../dom";
import { number, percent } from "../format";
import { Control, makeControl, startDrag } from "./control";
import { Json, LiveVolume, Message, State, joinMessages } from "./data";
import { SendEdits } from "./settings";

type Point = [number, number];

const colors = 10; // classes c0 to c9

/** The outline of a volume seen from above, cm; round corners where it is round. */
function outline(bounds: { [key: string]: any }): { points: Point[] } | { center: Point; radius: number } {
	const { type, min, max, center, extent, radius, points, rotation } = bounds;
	if (type === "sphere" || type === "capsule") {
		return { center: [center[0], center[1]], radius: Number(radius) };
	}
	if (type === "convex") {
		const list = (points as number[][]).map(([x, y]): Point => [x, y]);
		const middle = [0, 1].map((axis) => list.reduce((sum, point) => sum + point[axis], 0) / list.length);
		const angle = ([x, y]: Point) => Math.atan2(y - middle[1], x - middle[0]);
		return { points: list.sort((a, b) => angle(a) - angle(b)) };
	}
	const [from, to] = min ? [min, max] : [[0, 1].map((i) => center[i] - extent[i]), [0, 1].map((i) => center[i] + extent[i])];
	const yaw = ((Array.isArray(rotation) ? rotation[1] : rotation?.Yaw) ?? 0) * Math.PI / 180;
	const [cx, cy] = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
	const turn = ([x, y]: Point): Point => [cx + (x - cx) * Math.cos(yaw) - (y - cy) * Math.sin(yaw), cy + (x - cx) * Math.sin(yaw) + (y - cy) * Math.cos(yaw)];
	return { points: ([[from[0], from[1]], [to[0], from[1]], [to[0], to[1]], [from[0], to[1]]] as Point[]).map(turn) };
}

/** The camera's place in front of the volumes, from above: X to the right, Y down. */
class TopView {
	readonly element = el("div", { class: "top-view" });
	private key = "";
	private readonly camera: SVGElement;
	private readonly weights: SVGElement[] = [];
	private location = [0, 0, 0];
	private span = 1; // cm over the width
	private origin: Point = [0, 0];
	private drag = "";

	constructor(private readonly move: (location: number[], drag?: string, at?: number) => void) {
		this.camera = el<SVGElement>("g", {
			class: "camera", tabindex: 0, role: "application", "data-tip": "Drag the camera, or move it with the arrow keys; with shift ten times as far",
			onkeydown: (event: KeyboardEvent) => {
				const steps: Record<string, Point> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
				const step = steps[event.key];
				if (step) {
					event.preventDefault();
					this.drag ||= startDrag();
					const size = 10 ** Math.floor(Math.log10(this.span / 30)) * (event.shiftKey ? 10 : 1);
					this.to([this.location[0] + step[0] * size, this.location[1] + step[1] * size], event.timeStamp);
				}
			},
			onkeyup: () => (this.drag = ""),
		}, el("circle", { class: "hit", r: 20 }), el("circle", { class: "body", r: 6 }));
	}

	update(state: State): void {
		const { volumes, view } = state;
		this.location = this.drag ? this.location : [...view.location];
		const key = JSON.stringify([volumes.map(({ bounds, blendRadius, name, unbound }) => [bounds, blendRadius, name, unbound]), view.path]);
		if (key !== this.key) {
			this.key = key;
			this.draw(state);
		}
		volumes.forEach((volume, i) => this.weights[i]?.setAttribute("fill-opacity", String(0.06 + 0.45 * volume.weight)));
		this.place();
	}

	private place(): void {
		const [x, y] = this.location;
		this.camera.setAttribute("transform", `translate(${((x - this.origin[0]) / this.span) * 600} ${((y - this.origin[1]) / this.span) * 600})`);
		this.camera.setAttribute("aria-label", `Camera at ${number(Math.round(x))}, ${number(Math.round(y))} cm. Arrow keys move it`);
	}

	private to(point: Point, at: number): void {
		this.location = [...point.map((value) => Number(value.toFixed(1))), this.location[2] ?? 0];
		this.place();
		this.move(this.location, this.drag, at);
	}

	private draw({ volumes, view }: State): void {
		const shapes = volumes.map((volume) => (volume.unbound || !volume.bounds ? null : outline(volume.bounds)));
		const reach = (shape: (typeof shapes)[0]): Point[] => (!shape ? [] : "points" in shape ? shape.points
			: [[shape.center[0] - shape.radius, shape.center[1] - shape.radius], [shape.center[0] + shape.radius, shape.center[1] + shape.radius]]);
		const all = [...shapes.flatMap(reach), ...(view.path ?? []), view.location].map((point) => [point[0], point[1]]);
		const [low, high] = [0, 1].map((axis) => all.map((point) => point[axis])).reduce(([lows, highs], values) =>
			[[...lows, Math.min(...values)], [...highs, Math.max(...values)]] as [number[], number[]], [[], []] as [number[], number[]]);
		const room = 60 + Math.max(0, ...volumes.map((volume) => (volume.unbound || !volume.bounds ? 0 : volume.blendRadius)));
		this.origin = [low[0] - room, low[1] - room];
		this.span = high[0] - low[0] + 2 * room;
		const scale = 600 / this.span;
		const height = Math.min(Math.max((high[1] - low[1] + 2 * room) * scale, 160), 520);
		this.origin[1] -= (height / scale - (high[1] - low[1] + 2 * room)) / 2;
		const at = ([x, y]: number[]) => `${(x - this.origin[0]) * scale} ${(y - this.origin[1]) * scale}`;
		this.weights.length = 0;
		const svg: SVGSVGElement = el<SVGSVGElement>("svg", {
			viewBox: `0 0 600 ${height}`, role: "group", "aria-label": "The volumes from above",
			onpointerdown: (event: PointerEvent) => {
				this.drag = startDrag();
				svg.setPointerCapture(event.pointerId);
				(this.camera as unknown as HTMLElement).focus({ preventScroll: true });
				this.to(this.pointAt(svg, event, scale), event.timeStamp);
			},
			onpointermove: (event: PointerEvent) => this.drag && event.buttons && this.to(this.pointAt(svg, event, scale), event.timeStamp),
			onpointerup: () => (this.drag = ""),
			onpointercancel: () => (this.drag = ""),
		});
		volumes.forEach((volume, i) => {
			const shape = shapes[i];
			if (!shape) {
				return;
			}
			const make = (css: string, grow: number) => ("points" in shape
				? el<SVGElement>("path", { class: css, d: "M" + shape.points.map(at).join("L") + "Z", ...(grow && { "stroke-width": 2 * grow * scale, "stroke-linejoin": "round" }) })
				: el<SVGElement>("circle", { class: css, cx: at(shape.center).split(" ")[0], cy: at(shape.center).split(" ")[1], r: (shape.radius + grow) * scale }));
			const body = make("volume-body", 0);
			this.weights[i] = body;
			const [x, y] = "points" in shape ? [Math.min(...shape.points.map((point) => point[0])), Math.min(...shape.points.map((point) => point[1]))] : [shape.center[0] - shape.radius / 2, shape.center[1]];
			svg.append(el("g", { class: "volume c" + (i % colors) }, volume.blendRadius >= 1 ? make("fade", volume.blendRadius) : null, body,
				el("text", { x: (x - this.origin[0]) * scale + 8, y: (y - this.origin[1]) * scale + 18 }, volume.name)));
		});
		const path = view.path ?? [];
		if (path.length) {
			svg.append(el("path", { class: "walked", d: "M" + path.map(at).join("L") }), ...path.map((point) => el("circle", { class: "step", cx: at(point).split(" ")[0], cy: at(point).split(" ")[1], r: 2.5 })));
		}
		const unit = 10 ** Math.floor(Math.log10(this.span / 3));
		svg.append(el("path", { class: "ruler", d: `M10 ${height - 10}h${unit * scale}` }), el("text", { class: "tick", x: 10, y: height - 15 }, `${number(unit)} cm · X to the right, Y down`), this.camera);
		this.element.replaceChildren(svg);
	}

	private pointAt(svg: SVGSVGElement, event: PointerEvent, scale: number): Point {
		const box = svg.getBoundingClientRect();
		const share = 600 / box.width / scale;
		return [this.origin[0] + (event.clientX - box.left) * share, this.origin[1] + (event.clientY - box.top) * share];
	}
}

interface Card {
	element: HTMLElement;
	update: (volume: LiveVolume) => void;
}

export class VolumesPanel {
	readonly element: HTMLElement;
	private readonly fault = el("p", { class: "refused", role: "alert", hidden: true });
	private readonly top: TopView;
	private readonly place: Control[];
	private readonly list = el("div", { class: "volumes" });
	private cards: Card[] = [];
	private names = "";
	private location = [0, 0, 0];

	constructor(private readonly sendEdits: SendEdits, private readonly editSettings: (volume: number) => void) {
		const move = (location: number[], drag?: string, at?: number) => this.send("/view/location", location, drag, at);
		this.top = new TopView(move);
		const refuse = (message: string) => this.refuse(message);
		this.place = [0, 1, 2].map((axis) => makeControl({
			id: "place-" + "xyz"[axis], label: `Camera ${"XYZ"[axis]}`, type: "text", value: "0", refuse,
			send: (value) => (Number.isFinite(Number(value ?? NaN)) ? move(this.location.with(axis, Number(value))) : refuse(`"${value}" is not a number of cm.`)),
		}));
		this.element = el("div", {}, this.top.element,
			el("div", { class: "tools place" }, el("span", { class: "quiet" }, "Camera"), this.place.map((control, i) => el("label", {}, el("span", {}, "XYZ"[i]), control.element)), el("span", { class: "quiet" }, "cm")),
			this.fault, this.list);
	}

	update(state: State): void {
		const { volumes } = state;
		this.location = state.view.location;
		this.location.forEach((value, i) => this.place[i]?.show(String(Number(value.toFixed(2)))));
		this.top.update(state);
		const names = JSON.stringify(volumes.map(({ name }) => name));
		if (names !== this.names) {
			this.names = names;
			this.cards = volumes.map((volume, i) => this.makeCard(volume, i));
			this.list.replaceChildren(...(volumes.length ? this.cards.map((card) => card.element) : [el("p", { class: "quiet" }, "The config has no volumes.")]));
		}
		volumes.forEach((volume, i) => this.cards[i].update(volume));
	}

	private refuse(message: string): void {
		this.fault.textContent = message;
		this.fault.hidden = !message;
	}

	private send(set: string, value: Json, drag?: string, at?: number): void {
		this.refuse("");
		this.sendEdits([{ set, value }], (messages: Message[]) => this.refuse(joinMessages(messages)), drag, at);
	}

	private makeCard(first: LiveVolume, index: number): Card {
		const part = (key: string, label: string, unit: string, value: Json, range?: [number | null, number | null, number, number]) => {
			const control = makeControl({
				id: `volume-${index}-${key}`, label: `${label} of ${first.name}`, type: "float", value,
				range: range && { clampMin: range[0], clampMax: range[1], uiMin: range[2], uiMax: range[3] },
				send: (now, drag, at) => this.send(`/volumes/${index}/${key}`, now, drag, at), refuse: (message) => this.refuse(message),
			});
			return { control, element: el("div", { class: "volume-part" }, el("label", { for: `volume-${index}-${key}` }, label, unit ? el("span", { class: "quiet" }, " " + unit) : null), control.element) };
		};
		const parts = {
			bEnabled: part("bEnabled", "Enabled", "", first.enabled), bUnbound: part("bUnbound", "Unbound", "", first.unbound),
			Priority: part("Priority", "Priority", "", first.priority, [null, null, -10, 10]), BlendWeight: part("BlendWeight", "Weight", "", first.blendWeight, [0, 1, 0, 1]),
			BlendRadius: part("BlendRadius", "Blend radius", "cm", first.blendRadius, [0, null, 0, Math.max(500, 2 * first.blendRadius)]),
		};
		const acts = el("span", { class: "weight" });
		const why = el("span", { class: "quiet" });
		return {
			element: el("div", { class: "volume-card" },
				el("div", { class: "setting-head" }, el("i", { class: "c" + (index % colors) }), el("strong", {}, first.name || `volume ${index}`), why, acts,
					el("button", { type: "button", class: "small", onclick: () => this.editSettings(index) }, "Its settings")),
				Object.values(parts).map(({ element }) => element)),
			update: (volume) => {
				const values = { bEnabled: volume.enabled, bUnbound: volume.unbound, Priority: volume.priority, BlendWeight: volume.blendWeight, BlendRadius: volume.blendRadius };
				Object.entries(values).forEach(([key, value]) => parts[key as keyof typeof parts].control.show(value));
				acts.textContent = volume.weight ? "acts " + percent(volume.weight) : "does not act";
				acts.style.setProperty("--share", String(volume.weight));
				why.textContent = volume.skipped || (volume.unbound ? "everywhere" : volume.distance === null ? "" : volume.distance === 0 ? "the camera is inside" : `${number(Number(volume.distance.toPrecision(4)))} cm away`);
			},
		};
	}
}
