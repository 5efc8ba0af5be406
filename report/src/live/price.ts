// Shows the cost of each state that was tried: a dot of milliseconds against error, measured when the hand rests.
import { drawPanel, makeAxis } from "../chart";
import { el, refill, table } from "../dom";
import { ms, number } from "../format";
import { Dot, State } from "./data";
import { Refusal, post } from "./server";

export class PricePanel {
	readonly element: HTMLElement;
	private readonly plot = el("div", { class: "price-plot" });
	private readonly list = el("div", {});
	private readonly said = el("p", { class: "note", role: "status" });
	private readonly auto: HTMLInputElement;
	private dots: Dot[] = [];
	private revision = 0;
	private busy = false;
	private width = 0;

	constructor() {
		this.auto = el<HTMLInputElement>("input", { type: "checkbox", id: "price-auto", checked: true, onchange: () => this.rest() });
		this.element = el("div", {}, el("p", { class: "note" }, "Each dot is a state of this session: the time of its passes, and how far its picture is from the exact frame of the same state."),
			el("div", { class: "tools" }, el("button", { type: "button", id: "measure", onclick: () => void this.measure() }, "Measure now"),
				el("label", {}, this.auto, el("span", {}, "measure when the hand rests"))),
			this.said, this.plot, this.list);
		new ResizeObserver(() => this.plot.clientWidth !== this.width && this.draw()).observe(this.plot);
	}

	update(state: State): void {
		[this.dots, this.revision] = [state.dots, state.revision];
		this.draw();
	}

	/** The hand rests, the picture is drawn. */
	rest(): void {
		if (this.auto.checked && !document.hidden && !this.dots.some((dot) => dot.revision === this.revision)) {
			void this.measure();
		}
	}

	private async measure(): Promise<void> {
		if (this.busy) {
			return;
		}
		this.busy = true;
		this.said.textContent = "Measuring…";
		try {
			const dot = await post<Dot>("price");
			this.dots = [...this.dots.filter((other) => other.revision !== dot.revision), dot];
			this.said.textContent = "";
			this.draw();
		} catch (refusal) {
			this.said.textContent = (refusal as Refusal).message;
		} finally {
			this.busy = false;
		}
	}

	private draw(): void {
		const { dots } = this;
		this.width = this.plot.clientWidth;
		if (!dots.length || !this.width) {
			this.plot.replaceChildren(...(dots.length ? [] : [el("p", { class: "quiet" }, "There is no dot yet.")]));
			return;
		}
		const metric = dots[dots.length - 1].metric;
		const axis = (values: number[], name: string) => {
			const whole = makeAxis([0, ...values], 0.08, number);
			return { ...whole, low: 0, name, ticks: whole.ticks.filter((tick) => tick.value >= 0) };
		};
		this.plot.replaceChildren(drawPanel({
			title: `Milliseconds against ${metric}`, unit: "", x: axis(dots.map((dot) => dot.milliseconds), "ms of the passes"), y: axis(dots.map((dot) => dot.error), `error (${metric})`), limit: null,
			series: [{ name: "", color: "c1", line: [], steps: false, points: dots.map((dot) => ({ x: dot.milliseconds, y: dot.error, label: dot.label, now: dot.revision === this.revision, pale: dot.revision !== this.revision })) }],
		}, { width: this.width, height: 260, act: () => ({}) }));
		refill(this.list, [dots, this.revision], () => [table([
			{ title: "State", cell: (row) => (row.revision === this.revision ? el("strong", {}, row.label || "now") : row.label || `revision ${row.revision}`) },
			{ title: "Passes", number: true, cell: (row) => ms(row.milliseconds) },
			{ title: `Error, ${metric}`, number: true, cell: (row) => number(row.error) },
		], dots.toReversed())]);
	}
}
