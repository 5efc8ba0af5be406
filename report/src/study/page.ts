// The page of a study: one sentence that says the result, the chart, a variant's pictures, two of them side by side.
import { drawPanel } from "../chart";
import { el, section, table } from "../dom";
import { ms, number } from "../format";
import { Metric, Point, StudyReport, gatherPoints, metricNames } from "./data";

const metrics: Metric[] = ["rms", "max", "relative", "psnr", "ssim", "flip"];

type Cost = "time" | "taps";

const size = { width: 860, height: 470 };

function cost(point: Point, by: Cost): number {
	return by === "taps" ? point.result.taps : point.timing.medianMs;
}

function times(factor: number): string {
	return factor >= 10 ? factor.toFixed(0) : factor.toFixed(1);
}

/** The result of a job. */
export function sayResult(report: StudyReport, job: number): string {
	const { referenceMs } = report.timing.jobs[job];
	const points = gatherPoints(report, job);
	const best = points.find((point) => point.recommended);
	const metric = report.study.metric;
	const limit = report.study.budget.max;
	if (!best) {
		return limit !== undefined ? `No variant stays within ${metricNames[metric]} ${number(limit)}` : "No variant is recommended";
	}
	const error = number(Number((best.result[metric] ?? NaN).toPrecision(3)));
	const current = points.find((point) => point.result.current && point !== best);
	return `${best.result.label} is enough: ${metricNames[metric]} ${error}, ${times(referenceMs / best.timing.medianMs)} times as fast as the reference` +
		(best.result.current ? ", and in use already" : current ? `, ${times(current.timing.medianMs / best.timing.medianMs)} times as fast as what is in use` : "");
}

export class StudyPanel {
	readonly element: HTMLElement;
	private job = 0;
	private metric: Metric;
	private cost: Cost = "time";
	private pinned: Point[] = [];
	private readonly title = el("h2", { id: "chart-title" });
	private readonly chart = el("div", { class: "study-chart" });
	private readonly side = el("aside", { class: "variant", id: "variant" });
	private readonly pins = el("div", { class: "pins", id: "pins" });
	private readonly list = el("div", { id: "variants" });
	private readonly panels = el("div", { class: "panels", id: "panels" });
	private readonly panelsShown: HTMLButtonElement;

	constructor(private readonly report: StudyReport) {
		this.metric = report.study.metric;
		const metric = el<HTMLSelectElement>("select", { id: "metric", onchange: () => {
			this.metric = metric.value as Metric;
			this.draw();
		} }, metrics.map((name) => el("option", { value: name, selected: name === this.metric }, metricNames[name])));
		const labels = report.study.jobs.map((job) => job.label);
		const chooseJob = (index: number) => {
			this.job = index;
			this.pinned = [];
			this.draw();
			this.show(this.best());
		};
		const list = el<HTMLSelectElement>("select", { id: "job", onchange: () => chooseJob(list.selectedIndex) }, labels.map((label) => el("option", {}, label)));
		const buttons = this.segments(labels, "Job", "job", chooseJob);
		const mostButtons = 6; // more are a list
		const jobs = labels.length > mostButtons ? el("label", {}, el("span", {}, "Job"), list) : labels.length > 1 ? buttons : null;
		const costs = this.segments(["Time", "Texture reads"], "Cost", "cost", (index) => {
			this.cost = index === 1 ? "taps" : "time";
			this.draw();
		});
		this.panelsShown = el("button", { type: "button", id: "show-panels", "aria-pressed": "false", "aria-controls": "panels", "data-tip": "The chart of every job, or where there is one of every error, small and to choose from (key G)", onclick: () => {
			this.panelsShown.setAttribute("aria-pressed", String(this.panelsShown.getAttribute("aria-pressed") !== "true"));
			this.drawPanels();
		} }, "Small panels");
		this.chooseMetric = (name) => {
			metric.value = this.metric = name;
		};
		this.chooseJob = (job) => {
			list.selectedIndex = job;
			(buttons.children[job] as HTMLElement).click();
		};
		this.element = section("chart", "", "", el("div", { class: "tools" }, jobs, costs, el("label", {}, el("span", {}, "Error"), metric), this.panelsShown),
			this.panels, el("div", { class: "study" }, this.chart, this.side), this.pins, this.list);
		this.element.querySelector("h2")!.replaceWith(this.title);
		this.draw();
		this.show(this.best());
		new ResizeObserver(() => this.drawChart()).observe(this.chart);
	}

	private readonly chooseMetric: (metric: Metric) => void;
	private readonly chooseJob: (job: number) => void;

	readonly keys: Record<string, () => void> = { g: () => this.panelsShown.click() };

	/** Draws one panel for every job, or for every error where there is one job. */
	private drawPanels(): void {
		const shown = this.panelsShown.getAttribute("aria-pressed") === "true";
		this.panels.hidden = !shown;
		const { jobs } = this.report.study;
		const panels = jobs.length > 1 ? jobs.map((job, index) => this.makePanel(job.label, index, this.metric)) : metrics.map((name) => this.makePanel("", 0, name));
		this.panels.replaceChildren(...(shown ? panels : []));
	}

	private makePanel(label: string, job: number, metric: Metric): HTMLElement {
		const chosen = job === this.job && metric === this.metric;
		return el("button", { type: "button", class: "panel", "data-panel": `${job} ${metric}`, "aria-pressed": String(chosen), onclick: () => {
			this.chooseMetric(metric);
			job === this.job ? this.draw() : this.chooseJob(job);
			this.panels.querySelector<HTMLElement>(`[data-panel="${job} ${metric}"]`)?.focus();
		} },
			el("span", {}, label || metricNames[metric]), " ", el("span", { class: "quiet" }, label ? this.report.timing.jobs[job].recommended : ""),
			drawPanel(this.report.charts[job][this.cost][metric], { ...size, act: () => ({}) }));
	}

	private best(): Point | undefined {
		const points = gatherPoints(this.report, this.job);
		return points.find((point) => point.recommended) ?? points[0];
	}

	private segments(labels: string[], name: string, id: string, choose: (index: number) => void): HTMLElement {
		const group = el("div", { class: "segments", role: "group", "aria-label": name }, labels.map((label, i) =>
			el("button", { type: "button", id: `${id}-${i}`, "aria-pressed": String(i === 0), onclick: () => {
				[...group.children].forEach((button, other) => button.setAttribute("aria-pressed", String(other === i)));
				choose(i);
			} }, label)));
		return group;
	}

	private draw(): void {
		const points = gatherPoints(this.report, this.job);
		this.title.textContent = sayResult(this.report, this.job);
		this.drawChart();
		this.drawPins();
		this.drawPanels();
		const front = (point: Point) => (this.cost === "taps" ? point.result : point.timing).front;
		this.list.replaceChildren(el("details", {}, el("summary", {}, `All ${points.length} variants`), table<Point>([
			{ title: "Variant", cell: (row) => row.result.label },
			{ title: "CPU time", number: true, cell: (row) => ms(row.timing.medianMs) },
			{ title: "Reads", number: true, cell: (row) => number(Number(row.result.taps.toPrecision(3))) },
			...metrics.map((name) => ({ title: metricNames[name], number: true, cell: (row: Point) => number(row.result[name] ?? NaN) })),
			{ title: "", cell: (row) => (row.recommended ? "recommended" : front(row) ? "front" : `dominated by ${(this.cost === "taps" ? row.result : row.timing).dominatedBy}`) },
		], [...points].sort((a, b) => cost(a, this.cost) - cost(b, this.cost)))));
	}

	/** As wide as there is room, so that its words stay as large as the page's. */
	private drawChart(): void {
		const points = gatherPoints(this.report, this.job);
		const width = this.chart.clientWidth || size.width;
		this.chart.replaceChildren(drawPanel(this.report.charts[this.job][this.cost][this.metric], {
			width, height: Math.min(size.height, 0.85 * width), act: (name) => this.describePoint(points.find((point) => point.result.label === name)!),
		}));
	}

	/** The attributes by which a point of the chart is a button. */
	private describePoint(point: Point) {
		const { label } = point.result;
		return {
			tabindex: 0, role: "button", "data-variant": label, "aria-pressed": String(this.pinned.some((other) => other.result.label === label)),
			"aria-label": `${label}: ${metricNames[this.metric]} ${number(point.result[this.metric] ?? NaN)}, ${number(Number(cost(point, this.cost).toPrecision(3)))} ${this.cost === "taps" ? "reads a pixel" : "ms"}`,
			onpointerenter: () => this.show(point), onfocus: () => this.show(point), onclick: () => this.pin(point),
			onkeydown: (event: KeyboardEvent) => {
				if (event.key === "Enter" || event.key === " ") {
					event.preventDefault();
					this.pin(point);
				}
			},
		};
	}

	private show(point: Point | undefined): void {
		if (point) {
			this.side.replaceChildren(...this.describe(point));
		}
	}

	private describe(point: Point): Node[] {
		const { result, timing, inset } = point;
		const reference = this.report.timing.jobs[this.job].referenceMs;
		const rows: [string, string][] = [
			["CPU time", `${ms(timing.medianMs)} (${ms(timing.lowMs)} to ${ms(timing.highMs)})`],
			["Beside the reference", `${times(reference / timing.medianMs)} times as fast`],
			["Reads a pixel", number(Number(result.taps.toPrecision(3)))],
			...metrics.map((name): [string, string] => [metricNames[name], number(result[name] ?? NaN)]),
		];
		if (timing.withinNoiseOf.length) {
			rows.push(["Within noise of", timing.withinNoiseOf.join("; ")]);
		}
		const image = (png: string, title: string) => el("figure", {}, el("img", { src: "data:image/png;base64," + png, alt: title }), el("figcaption", {}, title));
		return [el("h3", {}, result.label, point.recommended ? el("span", { class: "tag" }, "recommended") : null, result.current ? el("span", { class: "tag" }, "in use") : null),
			el("dl", {}, rows.flatMap(([name, text]) => [el("dt", {}, name), el("dd", {}, text)])),
			inset ? el("div", { class: "figures" }, image(inset.png, "where its error is largest"), inset.heat ? image(inset.heat, inset.heatTitle) : null)
				: el("p", { class: "quiet" }, "No picture of this variant was kept.")];
	}

	private pin(point: Point): void {
		const known = this.pinned.some((other) => other.result.label === point.result.label);
		this.pinned = known ? this.pinned.filter((other) => other.result.label !== point.result.label) : [...this.pinned, point].slice(-2);
		this.draw();
		(this.chart.querySelector(`[data-variant="${CSS.escape(point.result.label)}"]`) as SVGElement | null)?.focus();
	}

	private drawPins(): void {
		const [a, b] = this.pinned;
		const metric = this.metric;
		const sentence = a && b ? `${b.result.label} takes ${times((100 * cost(b, this.cost)) / cost(a, this.cost))} % of the ${this.cost === "taps" ? "reads" : "time"} of ${a.result.label}; ` +
			`${metricNames[metric]} ${number(Number((b.result[metric] ?? NaN).toPrecision(3)))} beside ${number(Number((a.result[metric] ?? NaN).toPrecision(3)))}.` : "";
		this.pins.replaceChildren(...(this.pinned.length ? [el("h3", {}, "Pinned"), el("p", { class: "note" }, sentence || "Click a second one to compare; a click on a pinned one lets it go."),
			el("div", { class: "pair" }, this.pinned.map((point) => el("div", { class: "variant" }, ...this.describe(point))))] : []));
	}
}
