// Makes elements, and shows the page's one hint: what data-tip says of the element under the pointer or in focus.

type Child = Node | string | number | null | undefined | false;
type Value = string | number | boolean | undefined | ((event: any) => void);

const svgTags = new Set(["svg", "g", "rect", "circle", "line", "path", "text", "title", "polyline", "pattern", "defs"]);

/** Attributes that are functions are listeners ("onclick"); true is an empty attribute, false and undefined none. */
export function el<T extends Element = HTMLElement>(
	tag: string,
	attributes: Record<string, Value> = {},
	...children: (Child | Child[])[]
): T {
	const element = svgTags.has(tag)
		? document.createElementNS("http://www.w3.org/2000/svg", tag)
		: document.createElement(tag);
	for (const [name, value] of Object.entries(attributes)) {
		if (typeof value === "function") {
			element.addEventListener(name.slice(2), value);
		} else if (value !== undefined && value !== false) {
			element.setAttribute(name, value === true ? "" : String(value));
		}
	}
	element.append(...(children.flat().filter((child) => child !== null && child !== undefined && child !== false) as Node[]).map(
		(child) => (child instanceof Node ? child : String(child))));
	return element as unknown as T;
}

const filled = new WeakMap<Element, string>();

/** Fills an element anew where the data of its children changed; else focus and what is open stay. */
export function refill(box: Element, data: unknown, make: () => Node[]): void {
	const key = JSON.stringify(data);
	if (filled.get(box) !== key) {
		filled.set(box, key);
		box.replaceChildren(...make());
	}
}

export function section(id: string, title: string, note: string, ...children: Child[]): HTMLElement {
	return el("section", { id, "aria-labelledby": id + "-title" },
		el("header", {}, el("h2", { id: id + "-title" }, title), note ? el("p", { class: "note" }, note) : null),
		...children);
}

/** A phone's width. */
export const narrow = matchMedia("(max-width: 760px)");

/** Folded in a narrow window, to be opened; in a wide one its parts stand there without a fold. */
export function fold(title: string, ...children: Child[]): HTMLElement {
	const details = el<HTMLDetailsElement>("details", { class: "fold" }, el("summary", {}, title), ...children);
	const follow = () => (details.open = !narrow.matches);
	narrow.addEventListener("change", follow);
	follow();
	return details;
}

export interface Column<T> {
	title: string;
	number?: boolean;
	wide?: boolean; // left out where a row is a card
	cell: (row: T) => Child | Child[];
}

export function table<T>(columns: Column<T>[], rows: T[], attributes: (row: T) => Record<string, Value> = () => ({})): HTMLElement {
	const css = (column: Column<T>) => ({ class: [column.number ? "number" : "", column.wide ? "wide" : ""].join(" ").trim() || undefined });
	return el("div", { class: "table" }, el("table", {},
		el("thead", {}, el("tr", {}, columns.map((column) => el(column.title ? "th" : "td", { scope: column.title ? "col" : undefined, ...css(column) }, column.title)))),
		el("tbody", {}, rows.map((row) => el("tr", attributes(row),
			columns.map((column) => el("td", { ...css(column), "data-title": column.title }, ...[column.cell(row)].flat())))))));
}

function isDark(): boolean {
	const chosen = document.documentElement.dataset.theme;
	return chosen ? chosen === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
}

/** The button for light or dark. */
export function makeTheme(after: () => void): HTMLElement {
	return el("button", { type: "button", id: "theme", "data-tip": "Light or dark (key T)", onclick: () => {
		document.documentElement.dataset.theme = isDark() ? "light" : "dark";
		after();
	} }, "Light / dark");
}

export function installTips(): void {
	const tip = el("div", { id: "tip", role: "tooltip" });
	document.body.append(tip);
	const show = (event: Event) => {
		const target = (event.target as Element).closest?.("[data-tip]");
		tip.hidden = !target;
		if (!target) {
			return;
		}
		tip.textContent = target.getAttribute("data-tip");
		const box = target.getBoundingClientRect();
		const at = event instanceof PointerEvent ? { x: event.clientX, y: event.clientY + 14 } : { x: box.left, y: box.bottom + 4 };
		const room = { x: innerWidth - tip.offsetWidth - 8, y: innerHeight - tip.offsetHeight - 8 };
		tip.style.left = Math.max(4, Math.min(at.x, room.x)) + "px";
		tip.style.top = (at.y > room.y ? Math.max(4, at.y - tip.offsetHeight - 24) : at.y) + "px";
	};
	tip.hidden = true;
	addEventListener("pointermove", show);
	addEventListener("pointerdown", show); // of a finger, which does not hover
	addEventListener("focusin", show);
	addEventListener("scroll", () => (tip.hidden = true), true);
	addEventListener("keydown", (event) => {
		if (event.key === "Escape") {
			tip.hidden = true;
		}
	});
}
