// The settings along the camera's path, over the volumes that act there.
import { Walk } from "../data";
import { el } from "../dom";
import { count, number, percent } from "../format";
import { Chart, Plots, plotColors } from "../plots";

const componentColors: Record<string, string> = { R: "#d9503f", G: "#3d9a50", B: "#4a7bd8" };

/** Colour of each volume; those that act everywhere have none. */
function colorVolumes(walk: Walk): (string | null)[] {
	let bounded = 0;
	return walk.volumes.map((volume) => (volume.unbound ? null : plotColors[bounded++ % plotColors.length]));
}

function findPlace(walk: Walk, label: string): number {
	const mark = walk.marks.find((mark) => mark.label === label);
	return mark ? walk.distances.findIndex((distance) => distance >= mark.distance) : 0;
}

export class WalkPanel {
	readonly element: HTMLElement;
	readonly plots: Plots;

	/** Follows: the cursor is moved from outside, with the frame. */
	constructor(private readonly walk: Walk, follows = false) {
		const colors = colorVolumes(walk);
		const inside = walk.volumes.map((volume, i) => ({ volume, color: colors[i] })).filter(({ color }) => color !== null);
		const charts: Chart[] = walk.rows.map((row) => ({
			id: row.name, title: row.name, unit: row.unit, steps: row.steps,
			lines: row.lines.map((line, i) => ({ ...line, color: row.lines.length > 1 ? componentColors[line.label] ?? plotColors[i % plotColors.length] : "#7f8894" })),
			show: row.valueNames.length ? (value) => row.valueNames[value] ?? "" : undefined,
		}));
		if (inside.length) {
			charts.unshift({ id: "weights", title: "Weights of the volumes", lines: inside.map(({ volume, color }) => ({ label: volume.name, values: volume.weights, color: color! })), show: (value) => percent(value) });
		}
		this.plots = new Plots(walk.distances, charts, {
			id: "walk", unit: " cm", marks: walk.marks.map((mark) => mark.distance),
			name: (index) => `${number(walk.distances[index])} cm`,
			shades: inside.map(({ volume, color }) => ({ color: color!, weights: volume.weights })),
		});
		this.plots.move(findPlace(walk, walk.at));
		const length = walk.distances[walk.distances.length - 1] ?? 0;
		this.element = el("div", { class: "walk" }, el("h3", {}, "Along the camera's path"),
			el("p", { class: "note" }, `${count(walk.rows.length, "setting")} on the way over ${number(Math.round(length))} cm, through the places of ${count(walk.marks.length, walk.markName)} (dotted)` +
				(follows ? "; the line follows the frame." : walk.at ? `; the line is where ${walk.markName} ${walk.at} is.` : ".") + " Shades are the volumes, as strong as they act."),
			this.plots.element);
	}

	/** Sets the cursor to a mark. */
	move(label: string): void {
		this.plots.move(findPlace(this.walk, label));
	}
}
