// The graph section: in order or as it flows, with search, the heap, and the pass that was chosen.
import { Report } from "../data";
import { el, narrow, section } from "../dom";
import { describePass } from "./detail";
import { drawFlow } from "./flow";
import { drawHeap } from "./heap";
import { drawOrder } from "./order";
import { describeTexture } from "./texture";
import { GraphFacts, describeCounts, gatherFacts } from "./why";

export class GraphPanel {
	readonly element: HTMLElement;
	private facts: GraphFacts;
	private heap: HTMLElement;
	private readonly note: Element;
	private readonly view = el("div", { class: "graph-view", id: "graph-view" });
	private readonly side = el("aside", { class: "graph-side" });
	private readonly search: HTMLInputElement;
	private readonly found = el("output", { id: "found" });
	private readonly views: Record<"order" | "flow", HTMLButtonElement>;
	private selected = -1; // pass
	private resource = -1; // where a texture is shown: its
	private flow = false;

	constructor(private report: Report, private readonly showPicture: (id: string) => void) {
		this.facts = gatherFacts(report);
		this.heap = drawHeap(report, this.facts);
		this.search = el<HTMLInputElement>("input", { type: "search", id: "search", placeholder: "Pass, resource, shader  ( / )", "aria-label": "Search the graph", oninput: () => this.mark() });
		this.search.addEventListener("keydown", (event) => {
			if (event.key === "Enter") {
				(this.view.querySelector(".pass.match") as SVGElement | null)?.dispatchEvent(new Event("click"));
			}
		});
		const choose = (flow: boolean) => () => {
			this.flow = flow;
			this.draw();
		};
		this.views = {
			order: el("button", { type: "button", id: "view-order", onclick: choose(false) }, "In order"),
			flow: el("button", { type: "button", id: "view-flow", onclick: choose(true) }, "As it flows"),
		};
		this.element = section("graph", "Graph", describeCounts(this.facts),
			el("div", { class: "tools" },
				el("div", { class: "segments", role: "group", "aria-label": "How the graph is drawn" }, this.views.order, this.views.flow),
				this.search, this.found,
				el("span", { class: "legend right" }, el("i", { class: "key read" }), "reads", el("i", { class: "key unread" }), "declares and does not read", el("i", { class: "key write" }), "writes", el("i", { class: "key culled" }), "culled", el("i", { class: "key bracket" }), "merged")),
			el("div", { class: "graph" }, this.view, this.side),
			this.heap);
		this.note = this.element.querySelector(".note")!;
		narrow.addEventListener("change", () => this.draw());
		this.view.addEventListener("scroll", () => this.view.style.setProperty("--scrolled", this.view.scrollLeft + "px"));
		this.draw();
	}

	/** Another frame's graph; the pass that is open stays open where the frame has it. */
	setReport(report: Report): void {
		const name = this.facts.byIndex.get(this.selected)?.name;
		this.report = report;
		this.facts = gatherFacts(report);
		this.note.textContent = describeCounts(this.facts);
		const heap = drawHeap(report, this.facts);
		this.heap.replaceWith(heap);
		this.heap = heap;
		const same = this.facts.passes.find((pass) => pass.name === name)?.index ?? -1;
		const focus = document.activeElement;
		if (name !== undefined) {
			this.select(same, same === this.selected ? this.resource : -1);
			(focus as HTMLElement | null)?.focus({ preventScroll: true });
		}
		this.draw();
	}

	focusSearch(): void {
		this.search.focus();
		this.search.scrollIntoView({ block: "center" });
	}

	/** Opens a pass, or with a resource that texture as it was at the pass; -1 closes what is open. */
	select(index: number, resource = -1): void {
		[this.selected, this.resource] = [index, resource];
		const pass = this.facts.byIndex.get(index);
		const texture = this.facts.resources.find((one) => one.index === resource);
		const actions = {
			showPicture: this.showPicture,
			selectPass: (other: number) => this.select(other),
			selectTexture: (other: number, of: number) => this.select(other, of),
			close: () => {
				this.select(-1);
				(this.view.querySelector(`.pass[data-pass="${index}"]`) as SVGElement | null)?.focus();
			},
		};
		this.side.replaceChildren(...(pass ? [texture ? describeTexture(this.report, this.facts, pass, texture, actions) : describePass(this.report, this.facts, pass, actions)] : []));
		this.element.classList.toggle("open", !!pass);
		if (pass) {
			(this.side.firstElementChild as HTMLElement).focus({ preventScroll: !narrow.matches });
		}
		this.mark();
	}

	/** Opens a pass, by name, from elsewhere on the page. */
	open(index: number): void {
		this.select(index);
		this.element.scrollIntoView();
	}

	private draw(): void {
		const select = (index: number) => this.select(index);
		this.view.replaceChildren(this.flow ? drawFlow(this.facts, this.view.clientWidth - 20, select) : drawOrder(this.facts, select, (pass, resource) => this.select(pass, resource)));
		const first = this.flow && this.view.querySelector(".pass");
		if (first) {
			const [node, view] = [first.getBoundingClientRect(), this.view.getBoundingClientRect()];
			this.view.scrollTo({ left: (node.left + node.right - view.left - view.right) / 2, top: 0, behavior: "instant" });
		}
		this.views.order.setAttribute("aria-pressed", String(!this.flow));
		this.views.flow.setAttribute("aria-pressed", String(this.flow));
		this.mark();
	}

	private mark(): void {
		const wanted = this.search.value.trim().toLowerCase();
		const resources = new Set(this.facts.resources.filter((resource) => wanted && resource.name.toLowerCase().includes(wanted)).map((resource) => resource.index));
		let found = 0;
		const pass = this.facts.byIndex.get(this.selected);
		const used = new Set(this.resource >= 0 ? [this.resource] : pass?.uses.map((use) => use.resource) ?? []);
		for (const node of this.view.querySelectorAll<SVGElement>("[data-pass]")) {
			const of = this.facts.byIndex.get(Number(node.dataset.pass))!;
			const text = [of.name, of.shader, of.effect, of.owner].join(" ").toLowerCase();
			const match = wanted !== "" && (text.includes(wanted) || of.uses.some((use) => resources.has(use.resource)));
			node.classList.toggle("match", match);
			node.classList.toggle("selected", of.index === this.selected);
			found += Number(match);
		}
		for (const node of this.view.querySelectorAll<SVGElement>("[data-resource]")) {
			const index = Number(node.dataset.resource);
			node.classList.toggle("match", resources.has(index));
			node.classList.toggle("used", used.has(index));
		}
		for (const edge of this.view.querySelectorAll<SVGElement>(".edge")) {
			edge.classList.toggle("in", Number(edge.dataset.to) === this.selected);
			edge.classList.toggle("out", Number(edge.dataset.from) === this.selected);
		}
		this.view.classList.toggle("searching", wanted !== "");
		this.found.textContent = wanted ? `${found} of ${this.facts.passes.length} passes` : "";
	}
}
