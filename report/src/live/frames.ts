// The pictures of the session: now, the start, pins, and textures after a pass; the newest frame is drawn as it comes.
import { PictureData } from "../data";
import { PicturePanel } from "../picture/panel";
import { Pixels } from "../picture/pixels";
import { State } from "./data";
import { getPicture } from "./server";

/** A final picture: bytes as the display shows them, and numbers. */
async function getBoth(id: string | number): Promise<Pixels> {
	const [shown, exact] = await Promise.all([getPicture(id, "kind=final8"), getPicture(id, "kind=final")]);
	return { ...exact, bytes: shown.bytes };
}

export class Frames {
	readonly panel: PicturePanel;
	shown = -1; // revision
	private now: Promise<Pixels>;
	private wanted = -1;
	private refined = -1;
	private loading = false;
	private readonly kept = new Map<string, Promise<Pixels>>();
	private passes: PictureData[] = [];
	private states: PictureData[] = [];

	constructor(state: State, private readonly drawn: (revision: number) => void, private readonly failed: (message: string) => void) {
		this.now = getPicture("now", "kind=final8");
		this.shown = this.wanted = state.frame?.revision ?? -1;
		this.listStates(state);
		this.panel = new PicturePanel(this.states, { a: "now", b: "start", strip: false });
		this.panel.viewer.canvas.style.aspectRatio = state.frame ? `${state.frame.width / state.frame.height}` : "16 / 9"; // no jump when it comes
	}

	/** After the state's pins changed. */
	update(state: State): void {
		this.listStates(state);
		[...this.kept.keys()].filter((id) => !this.states.some((one) => one.id === id)).forEach((id) => this.kept.delete(id)); // pins that went
		this.panel.setList([...this.states, ...this.passes]);
	}

	/** A frame was computed: its picture is drawn, or that of a newer one. */
	async show(revision: number): Promise<void> {
		this.wanted = Math.max(this.wanted, revision);
		for (; !this.loading && this.shown < this.wanted; this.loading = false) {
			this.loading = true;
			const wanted = this.wanted;
			try {
				const step = this.panel.viewer.mode === "a" ? this.panel.viewer.getStep() : 1; // the screen does not show more
				const pixels = await getPicture(wanted, "kind=final8", step).catch(() => getPicture("now", "kind=final8", step));
				this.now = Promise.resolve(pixels);
				this.panel.update("now", pixels, true);
				this.shown = wanted;
				this.drawn(wanted);
			} catch (refusal) {
				this.shown = wanted;
				this.failed((refusal as Error).message);
			}
		}
	}

	/** The hand rests: the numbers of what is shown. */
	async refine(): Promise<void> {
		const revision = this.shown;
		if (revision === this.refined) {
			return;
		}
		this.refined = revision;
		const pixels = await getBoth(revision).catch(() => null);
		if (pixels && revision === this.shown) {
			this.now = Promise.resolve(pixels);
			this.panel.update("now", pixels, false);
		}
		for (const picture of this.passes.filter(({ id }) => id === this.panel.selectedA || id === this.panel.selectedB)) {
			await picture.load!().then((texture) => revision === this.shown && this.panel.update(picture.id, texture, false), () => undefined);
		}
	}

	/** Shows a texture as it is after a pass. */
	async showPass(pass: number, resource: string): Promise<void> {
		const id = `pass-${pass}-${resource}`;
		if (!this.passes.some((picture) => picture.id === id)) {
			const load = () => getPicture("now", `kind=pass&pass=${pass}&resource=${encodeURIComponent(resource)}`);
			try {
				await load();
			} catch (refusal) {
				this.failed((refusal as Error).message);
				return;
			}
			this.passes = [...this.passes.slice(-15), { ...this.make(id, `${pass} ${resource}`, load), role: "dump", pass, resource, encoding: "compressed" }];
			this.panel.setList([...this.states, ...this.passes]);
		}
		this.panel.show(id);
	}

	private make(id: string, label: string, load: () => Promise<Pixels>): PictureData {
		return { id, role: "state", label, pass: -1, resource: "", mip: 0, extent: [0, 0], corner: [0, 0], size: [0, 0], channels: ["R", "G", "B", "A"], encoding: "display", png: "", load };
	}

	private keep(id: string): () => Promise<Pixels> {
		return () => {
			const pixels = this.kept.get(id) ?? getBoth(id);
			this.kept.set(id, pixels);
			pixels.catch(() => this.kept.delete(id));
			return pixels;
		};
	}

	private listStates(state: State): void {
		this.states = [this.make("now", "now", () => this.now), this.make("start", "at the start", this.keep("start")),
			...state.pins.map(({ pin, name }) => this.make(`pin-${pin}`, name || `pin ${pin}`, this.keep(`pin-${pin}`)))];
	}
}
