// The settings along the camera's path, over the volumes that act there.
import { Plot, Plots, makeAxis, makeSeries } from "../chart";
import { Walk } from "../data";
import { el } from "../dom";
import { count, number, percent } from "../format";

export class WalkPanel {
	readonly element: HTMLElement;
	private readonly plots: Plots;
	private readonly distances: number[];

	/** Follows: the cursor is moved from outside, with the frame. */
	constructor(private readonly walk: Walk, follows = false) {
		const { markName, marks, shades, panels } = walk.chart;
		const settings = panels.filter((panel) => panel.title); // the volumes' lanes have none
		this.distances = panels[0].series[0].line.map(([distance]) => distance);
		const x = { ...panels[0].x, ticks: panels[0].x.ticks.map(({ value, text }) => ({ value, text: text + " cm" })) };
		const plots: Plot[] = settings.map((panel) => ({
			id: panel.title, panel: { ...panel, x }, show: (value) => panel.y.valueNames[value] ?? number(value),
		}));
		if (shades.length) {
			const y = makeAxis([0, 1], 0.12, percent);
			plots.unshift({ id: "weights", show: percent, panel: {
				title: "Weights of the volumes", unit: "", x, y, limit: null, series: shades.map((shade) => makeSeries(shade.name, shade.color, shade.weights)),
			} });
		}
		this.plots = new Plots(this.distances, plots, {
			id: "walk", marks: marks.map((mark) => mark.value), shades, name: (index) => `${number(this.distances[index])} cm`,
		});
		this.move(walk.at);
		const length = this.distances[this.distances.length - 1] ?? 0;
		this.element = el("div", { class: "walk" }, el("h3", {}, "Along the camera's path"),
			el("p", { class: "note" }, `${count(settings.length, "setting")} on the way over ${number(Math.round(length))} cm, through the places of ${count(marks.length, markName)} (dotted)` +
				(follows ? "; the line follows the frame." : walk.at ? `; the line is where ${markName} ${walk.at} is.` : ".") + " Shades are the volumes, as strong as they act."),
			this.plots.element);
	}

	/** Sets the cursor to a mark. */
	move(label: string): void {
		const mark = this.walk.chart.marks.find((mark) => mark.text === label);
		this.plots.move(mark ? this.distances.findIndex((distance) => distance >= mark.value) : 0);
	}
}
