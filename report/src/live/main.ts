// Builds the page of `drydock live`: the picture at the left, all that can be changed at the right, the graph below.
import { Report } from "../data";
import { el, installTips, makeTheme, refill } from "../dom";
import { count, ms } from "../format";
import { GraphPanel } from "../graph/panel";
import { listenKeys, makeKeys } from "../sections/about";
import { Control, makeControl } from "./control";
import { Edit, Frame, Message, State } from "./data";
import { makeCopy, makeDownload, makeEnd, makeSave } from "./dialogs";
import { Frames } from "./frames";
import { PassesPanel } from "./passes";
import { PricePanel } from "./price";
import { Hand, Refusal, get, listen, post } from "./server";
import { SendEdits, SettingsPanel } from "./settings";
import { makeTabs } from "./tabs";
import { VariablesPanel } from "./variables";
import { VolumesPanel } from "./volumes";

const [restAfter, priceAfter, followAfter] = [250, 2500, 120]; // ms: without a new picture; at rest; between two looks at the weights

class LivePage {
	private readonly hand = new Hand();
	private readonly frames: Frames;
	private readonly settings: SettingsPanel;
	private readonly volumes: VolumesPanel;
	private readonly variables: VariablesPanel;
	private readonly passes: PassesPanel;
	private readonly price = new PricePanel();
	private readonly tabs: ReturnType<typeof makeTabs>;
	private readonly faults = el("div", { class: "faults", id: "faults", role: "alert" });
	private readonly notice = el("div", { class: "faults", id: "notice", role: "alert" });
	private readonly status = el("p", { class: "live-status", id: "status" });
	private readonly latency = el("span", { id: "latency" });
	private readonly figures = el("span", { id: "figures" });
	private readonly notesTitle = el("summary", {});
	private readonly notesBox = el("div", { class: "faults" });
	private readonly notes = el("details", { class: "frame-notes", hidden: true }, this.notesTitle, this.notesBox);
	private readonly sequence = el("div", { class: "tools", id: "sequence" });
	private frame: Control | null = null; // of the sequence
	private readonly pins = el("span", { class: "pins" });
	private readonly probeText = el("div", { class: "probe-text", id: "probe-text" }, el("p", { class: "quiet" }, "Click a texel, or mark one with shift and arrows and press Enter; once more: line by line."));
	private readonly probeFold = el<HTMLDetailsElement>("details", { id: "probe-fold" }, el("summary", {}, "How a texel came about"), this.probeText);
	private readonly buttons: Record<"undo" | "redo" | "reset", HTMLButtonElement>;
	private readonly title = el("h1", {});
	private readonly graphFold: HTMLDetailsElement;
	private graph: GraphPanel | null = null;
	private graphRevision = -1;
	private report: Report | null = null;
	private restTimer = 0;
	private priceTimer = 0;
	private followTimer = 0;
	private touched = false; // by this page, since the last measurement
	private asked = Promise.resolve();
	private probed = "";
	private readonly passTimes = new Map<number, number>(); // ms, by revision
	private readonly send: SendEdits;

	constructor(private state: State) {
		this.frames = new Frames(state, (revision) => this.drawn(revision), (message) => this.say(message));
		const { panel } = this.frames;
		const send = this.send = (edits: Edit[], refused: (messages: Message[]) => void, drag?: string, at?: number) => {
			this.touched = true;
			this.hand.edit(edits, refused, drag, at);
		};
		this.settings = new SettingsPanel(send);
		this.volumes = new VolumesPanel(send, (volume) => {
			this.settings.setTarget(volume);
			this.tabs.show("settings");
		});
		this.variables = new VariablesPanel(send);
		this.passes = new PassesPanel((index) => void this.openPass(index));
		this.tabs = makeTabs([["settings", "Settings", this.settings.element], ["volumes", "Volumes", this.volumes.element], ["variables", "Variables", this.variables.element],
			["passes", "Passes", this.passes.element], ["price", "Price", this.price.element]]);
		const action = (id: "undo" | "redo" | "reset", label: string, tip: string) => el<HTMLButtonElement>("button", { type: "button", id, "data-tip": tip, onclick: () => this.act(id) }, label);
		this.buttons = { undo: action("undo", "Undo", "One step back (Ctrl+Z)"), redo: action("redo", "Redo", "One step forward (Ctrl+Shift+Z)"), reset: action("reset", "Reset all", "Everything as it was at the start; can be undone") };
		this.graphFold = el<HTMLDetailsElement>("details", { class: "graph-fold", id: "graph-fold", ontoggle: () => void this.refreshGraph() }, el("summary", {}, "The frame's graph: why each pass runs or not"));
		this.status.append(this.figures, this.latency);
		panel.stage.prepend(this.notice, this.faults);
		panel.stage.append(this.status);
		panel.stage.after(this.sequence, el("div", { class: "tools pin-row" },
			el("button", { type: "button", id: "pin", "data-tip": "Keeps this state and its picture, to compare with", onclick: () => void this.try(post("pin")) }, "Pin"), this.pins), this.notes, this.probeFold);
		panel.viewer.onPick = (x, y) => void this.probe(x, y);
		this.build();
		this.update(state);
		this.showFrame();
		this.hand.onRevision = () => this.showMessages(this.notice, []);
		listen({
			state: (revision) => revision !== this.state.revision && this.later(),
			frame: (frame) => this.take(frame),
			fault: (revision, messages) => {
				this.hand.finish(revision);
				this.showMessages(this.faults, messages);
				this.later();
			},
			bye: () => this.say("drydock live has ended. Start it again, and open the address that it prints.", "note"),
			gone: () => this.say("drydock live does not answer. The last picture stays, and the page tries again."),
			back: () => {
				this.showMessages(this.notice, []);
				void this.refresh();
			},
		});
		void this.frames.refine();
	}

	private build(): void {
		const { panel } = this.frames;
		const say = (message: string) => this.say(message);
		const theme = makeTheme(() => panel.viewer.shade());
		const keys = makeKeys([["/", "search the settings"], ["Ctrl+Z  Ctrl+Shift+Z", "undo, redo"], ["arrows", "on a slider or the camera: move it"], ["Enter", "on the picture: probe the marked texel"]]);
		const name = () => this.state.config.split("/").pop()!.replace(/\.json$/, "");
		document.body.append(
			el("header", { class: "top" }, this.title,
				el("div", { class: "actions", role: "group", "aria-label": "The session" }, this.buttons.undo, this.buttons.redo, this.buttons.reset,
					makeSave(() => name() + "_live.json", (path) => this.say(`Saved as ${path}.`, "note")), makeCopy(), makeDownload(name, say)),
				theme, el("button", { type: "button", "data-tip": "Keys (key ?)", "aria-label": "Keys", id: "show-keys", onclick: () => keys.showModal() }, "?"), makeEnd(say)),
			el("main", { class: "live" }, el("div", { class: "live-left" }, panel.element), this.tabs.element, this.graphFold), keys);
		installTips();
		const search = () => {
			this.tabs.show("settings");
			this.settings.focusSearch();
		};
		listenKeys({ "/": search, t: () => theme.click(), "?": () => keys.showModal() }, panel);
		addEventListener("keydown", (event) => {
			const typed = event.target instanceof HTMLInputElement && /text|search/.test(event.target.type) && event.target.value !== event.target.defaultValue;
			const key = event.key.toLowerCase();
			if ((event.ctrlKey || event.metaKey) && (key === "z" || key === "y") && !typed && !document.querySelector("dialog[open]")) {
				event.preventDefault();
				this.act(key === "y" || event.shiftKey ? "redo" : "undo");
			}
		});
	}

	private act(what: "undo" | "redo" | "reset"): void {
		if (!this.buttons[what].disabled) {
			this.touched = true;
			void this.try(post("edit", { [what]: true }));
		}
	}

	private async try(request: Promise<unknown>): Promise<void> {
		try {
			await request;
			this.showMessages(this.notice, []);
			await this.refresh();
		} catch (refusal) {
			this.showMessages(this.notice, (refusal as Refusal).messages);
		}
	}

	private say(message: string, severity = "error"): void {
		this.showMessages(this.notice, [{ severity, code: "", message, where: "" }]);
	}

	private showMessages(box: HTMLElement, messages: Message[]): void {
		const serious = (message: Message) => Number(message.severity === "error");
		box.tabIndex = messages.length ? 0 : -1; // it may scroll
		refill(box, messages, () => messages.toSorted((a, b) => serious(b) - serious(a)).map(({ severity, code, message, where, file, line }) => {
			const [said, ...source] = message.split("\n");
			return el("div", { class: severity === "error" ? "bad" : severity },
				el("code", {}, [file ? file + (line && line > 0 ? `:${line}` : "") : "", where].filter(Boolean).join(" at ")), " ", code ? el("strong", {}, code + " ") : null, said,
				source.length ? el("pre", {}, source.join("\n")) : null);
		}));
		this.frames?.panel.stage.classList.toggle("failed", !!this.faults.childElementCount);
	}

	private take(frame: Frame): void {
		this.state.frame = frame;
		this.passTimes.set(frame.revision, frame.milliseconds.passes);
		this.passTimes.delete(frame.revision - 100); // long drawn
		this.hand.finish(frame.revision);
		this.showMessages(this.faults, []);
		void this.frames.show(frame.revision);
		if (this.tabs.shown === "volumes" && !this.followTimer) { // the weights follow, at a pace that leaves the frames room
			this.followTimer = window.setTimeout(() => {
				this.followTimer = 0;
				void this.refresh();
			}, followAfter);
		}
	}

	private drawn(revision: number): void {
		const wait = this.hand.drawn(revision);
		if (wait) {
			const beside = wait.ms - (this.passTimes.get(revision) ?? 0);
			this.latency.textContent = `hand to picture ${ms(wait.ms)}, ${ms(beside)} beside the passes` + (wait.count > 1 ? `, median of this drag ${ms(wait.median)} (${wait.count} pictures)` : "");
			Object.assign(this.latency.dataset, { ms: wait.ms, median: wait.median, count: wait.count, beside });
		}
		this.showFrame();
		this.later();
	}

	private showFrame(): void {
		const { frame } = this.state;
		if (frame) {
			document.documentElement.dataset.revision = String(this.frames.shown);
			this.figures.textContent = `${frame.width} × ${frame.height} · passes ${ms(frame.milliseconds.passes)}, frame ${ms(frame.milliseconds.whole)} · ${frame.passesRun} of ${count(frame.passesRun + frame.passesReused, "pass", "passes")} ran`;
		}
	}

	/** Soon, when no hand moves. */
	private later(): void {
		clearTimeout(this.restTimer);
		clearTimeout(this.priceTimer);
		this.restTimer = window.setTimeout(() => (this.hand.rests ? this.rest() : this.later()), restAfter);
	}

	private rest(): void {
		void this.refresh().then(() => this.frames.refine()).then(() => this.refreshGraph());
		if (this.touched) {
			clearTimeout(this.priceTimer);
			this.priceTimer = window.setTimeout(() => {
				this.touched = false;
				this.price.rest();
			}, priceAfter);
		}
	}

	private refresh(): Promise<void> {
		return (this.asked = this.asked.then(() => get<State>("state")).then((state) => this.update(state)).catch((refusal: Error) => this.say(refusal.message)));
	}

	private update(state: State): void {
		if (state.revision < this.frames.shown) {
			location.reload(); // the server began again after a crash, and counts anew
		}
		this.state = state;
		this.title.replaceChildren(state.name, el("span", { class: "quiet", "data-tip": "Differs from the start" }, state.changed ? " •" : ""));
		document.title = `${state.changed ? "• " : ""}${state.name} · drydock live`;
		this.buttons.undo.disabled = !state.canUndo;
		this.buttons.redo.disabled = !state.canRedo;
		this.buttons.reset.disabled = !state.changed && !state.canUndo;
		const settled = this.hand.knows(state.revision);
		this.volumes.update(state, settled);
		if (settled) {
			this.settings.update(state);
			this.variables.update(state);
		}
		this.updateSequence(state, settled);
		this.price.update(state);
		this.frames.update(state);
		const { panel } = this.frames;
		refill(this.pins, state.pins, () => state.pins.map(({ pin, name }) => el("span", { class: "pin" },
			el("button", { type: "button", "data-tip": "B is this picture, beside A by the slider", onclick: () => void panel.choose(panel.selectedA, `pin-${pin}`).then(() => panel.setMode("slider")) }, name || `pin ${pin}`),
			el("button", { type: "button", "aria-label": `Remove ${name || `pin ${pin}`}`, onclick: () => void this.try(post("unpin", { pin })) }, "×"))));
		if (state.frame) {
			this.passes.update(state.frame);
			const { messages } = state.frame;
			this.notes.hidden = !messages.length;
			this.notesTitle.textContent = count(messages.length, "note") + " on this frame";
			this.showMessages(this.notesBox, messages);
			if (state.frame.revision > this.frames.shown) {
				void this.frames.show(state.frame.revision);
			}
		}
		this.showMessages(this.faults, state.fault?.messages ?? []);
	}

	private updateSequence({ sequence }: State, settled: boolean): void {
		refill(this.sequence, sequence?.frames, () => {
			if (!sequence) {
				return [];
			}
			const { frames } = sequence;
			const [uiMin, uiMax] = [frames[0], frames.at(-1)!];
			this.frame = makeControl({
				id: "frame", label: "Frame", type: "int", value: sequence.frame, range: { clampMin: uiMin, clampMax: uiMax, uiMin, uiMax }, refuse: (fault) => fault && this.say(fault),
				send: (value, drag, at) => this.send([{ set: "/scene/frames", value: String(frames.findLast((frame) => frame <= Number(value))) }], (messages) => this.showMessages(this.notice, messages), drag, at),
			});
			return [el("label", { for: "frame" }, "Frame"), this.frame.element];
		});
		if (settled && sequence) {
			this.frame?.show(sequence.frame);
		}
	}

	private async refreshGraph(): Promise<void> {
		if (!this.graphFold.open || this.graphRevision === this.state.revision) {
			return;
		}
		try {
			const revision = this.state.revision;
			this.report = await get<Report>("report/now");
			this.graphRevision = revision;
			this.graph?.setReport(this.report);
			this.graph ??= new GraphPanel(this.report, (id) => {
				const { pass, resource } = this.report!.pictures.find((one) => one.id === id)!;
				void this.frames.showPass(pass, resource);
			});
			this.graphFold.append(this.graph.element);
		} catch (refusal) {
			this.say((refusal as Refusal).message);
		}
	}

	private async openPass(index: number): Promise<void> {
		this.graphFold.open = true;
		await this.refreshGraph();
		this.graph?.open(index);
	}

	private async probe(x: number, y: number): Promise<void> {
		if (!this.probeFold.open) {
			return;
		}
		const index = /^pass-(\d+)-/.exec(this.frames.panel.selectedA)?.[1];
		const passes = this.state.frame?.passes ?? [];
		const place = `x=${x}&y=${y}`;
		const trace = place === this.probed;
		const pass = passes.find((one) => one.index === Number(index)) ?? (trace ? passes.at(-1) : undefined);
		const title = `${trace ? "Trace" : "Probe"} of texel ${x}, ${y}` + (pass ? ` of ${pass.name}` : "");
		this.probed = trace ? "" : place;
		this.probeText.replaceChildren(el("h3", {}, title), el("p", { class: "quiet" }, "…"));
		const { text } = await get<{ text: string }>((trace ? "trace?" : "probe?") + place + (pass ? `&pass=${encodeURIComponent(pass.name)}` : "")).catch((refusal: Error) => ({ text: refusal.message }));
		this.probeText.replaceChildren(el("h3", {}, title), el("pre", { tabindex: 0 }, text.trim()),
			trace ? "" : el("button", { type: "button", id: "trace", onclick: () => void this.probe(x, y) }, "Line by line"));
	}
}

async function start(): Promise<void> {
	const waiting = el("p", { class: "waiting", role: "status" }, "Waiting for drydock live…"); // also where the first frame has a fault
	document.body.append(waiting);
	let state: State | null = null;
	while (!state?.frame) {
		await new Promise((done) => setTimeout(done, state ? 500 : 0));
		state = await get<State>("state").catch((refusal: Refusal) => ({ fault: { messages: refusal.messages } }) as State);
		waiting.textContent = state.fault?.messages.map(({ code, message, file, line }) => [file && `${file}:${line}`, code, message].filter(Boolean).join(" ")).join("\n") ?? "Waiting for the first frame…";
	}
	waiting.remove();
	new LivePage(state);
	document.documentElement.dataset.ready = "true";
}

void start();
